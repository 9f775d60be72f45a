// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkCellStorage
 * @brief   a storage that gives room to cells of pixels
 *
 * Units of room, a node, a run of them or a section, are taken by atomic operations while the geometry is drawn. One
 * counter for all of them is what the gather would wait for: two threads alone lose more time to it than to everything
 * else. Here each cell of 16 x 16 pixels has a counter (64 bytes) and a range of units of its own (vtkCellRoom).
 *
 * Where a range is too small, the frame is still counted to its end and then drawn again with ranges that fit.
 *
 * Resolves that change no fragments fetch them as texels of their buffer (Shaders/Storage/Cells.glsl): it has as many
 * units at most as the driver can fetch.
 */
#ifndef vtkCellStorage_h
#define vtkCellStorage_h

#include "vtkFragmentStorage.h"
#include "vtkStorageDesign.h"      // for GetAccesses
#include "vtkTranslucencyBuffer.h" // for the buffers

#include <memory> // for the room and the counter

VTK_ABI_NAMESPACE_BEGIN
class vtkCellRoom;
class vtkFragmentCounter;

class VTKRENDERINGTRANSLUCENCY_EXPORT vtkCellStorage : public vtkFragmentStorage
{
public:
  vtkTypeMacro(vtkCellStorage, vtkFragmentStorage);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * How many fragments there is room for in the first frame. 0 (the default) means as many as the boxes of the props
   * let expect, and one per pixel at least. Later frames have as much room as the ones before needed. A negative value
   * is an error and changes nothing.
   */
  void SetInitialFragments(vtkTypeInt64 fragments);
  vtkGetMacro(InitialFragments, vtkTypeInt64);
  ///@}

  /// Of those that have sections: how many fragments one holds; else 1.
  virtual int GetSectionFragments() const { return 1; }

  ///@{
  /**
   * Whether shaders count what they access, from the next tile on. Off by default: fragments are then stored by other
   * shaders. For vtkStorageCountPass.
   */
  vtkSetMacro(CountAccesses, bool);
  vtkGetMacro(CountAccesses, bool);
  ///@}

  /// What they have counted in the tile, after Shaders/Storage/CountAccesses.glsl has read all fragments once.
  vtkStorageDesign::Accesses GetAccesses();

  std::string GetShaderName() const override;
  std::map<std::string, std::string> GetDefines() const override;
  std::map<std::string, std::string> GetStoringDefines() const override;
  void BeginFrame(const std::vector<Box>& boxes, const vtkTranslucencyCapabilities& capabilities) override;
  std::string GetObstacle(const Rectangle& viewport, const vtkTranslucencyCapabilities& capabilities) const override;
  Outcome Begin(const Rectangle& tile, const vtkTranslucencyCapabilities& capabilities) override;
  Outcome End() override;
  Outcome End(const Sum& sum) override;
  const char* GetSummary() const override;
  std::array<int, 2> GetCells() const override;
  int GetPartsNeeded() const override;
  vtkTypeInt64 GetFragments() const override;
  int GetMostExpected() const override;
  vtkTypeInt64 GetUnits() const override;
  bool Fits(
    vtkTypeInt64 units, const Rectangle& viewport, const vtkTranslucencyCapabilities& capabilities) const override;
  bool ReserveLinks() override;
  std::vector<Texels> GetTexels() override;
  void FinishLinks() override;
  Links GetLinks() const override;
  vtkTypeInt64 GetBytes() const override;
  void Release(bool contextAlive) override;

protected:
  vtkCellStorage();
  ~vtkCellStorage() override;

  enum class Use
  {
    Written,
    Cleared, // 0 before the geometry is drawn
    Links    // only there where the order of fragments is changed
  };

  /// One of the buffers of a storage.
  struct Layout
  {
    unsigned int Binding; // Shaders/Common/Bindings.glsl
    int PixelWords;       // of 4 bytes, a pixel of the tile
    int UnitWords;        // a unit
    Use Used = Use::Written;
    const char* Sampler = nullptr; // the name of the texels that it can be fetched as,
    int TexelWords = 0;            // and the words of one
  };

  /// "Name" stands for the file Storage/Name.glsl of Module/Shaders, and Storage/NameInOrder.glsl, which is used where
  /// the driver keeps the order of drawing, as software rasterizers do.
  virtual const char* GetFileName() const = 0;

  virtual std::vector<Layout> GetLayouts() const = 0;

  /// Fragments that a unit has room for.
  virtual int GetUnitFragments() const { return 1; }

  /// Fragments that a pixel has room for before any unit is taken.
  virtual int GetPixelFragments() const { return 0; }

  /// Units that shaders can tell apart.
  virtual vtkTypeInt64 GetMostUnits(const Rectangle& tile) const = 0;

  /// Whether a unit is a fragment, and none is taken in vain.
  virtual bool UnitsAreFragments() const { return false; }

  /// See vtkFragmentCounter.
  virtual unsigned int CountFree(const unsigned int* vtkNotUsed(entries), int vtkNotUsed(count)) const { return 0; }

  /// After a tile was stored: the words of all its cells.
  virtual void Learn(const std::vector<unsigned int>& vtkNotUsed(cells)) {}

  /// The buffer of a storage whose units are nodes (Shaders/Storage/Nodes.glsl).
  Layout GetNodes() const;

  /// Words of a fragment's colour.
  int GetColorWords() const;

  /// Whether fragments of a pixel reach the storage in the order of drawing, one at a time.
  bool GetKeepsDrawOrder() const { return this->KeepsDrawOrder; }

  /// Units are others than in the frames before.
  void ForgetUnits();

  /// Makes all pixels' entries 0.
  void ClearTable();

private:
  vtkCellStorage(const vtkCellStorage&) = delete;
  void operator=(const vtkCellStorage&) = delete;

  /// The counters as they are when the shaders so far have ended.
  void CopyCells();
  std::vector<unsigned int> ReadCells() const;

  /// From the copy of the counters: what the tile holds.
  Outcome Count();

  /// The same of a tile that was ended by its sum.
  void CountSummed();
  void ReleaseBuffers(bool contextAlive = true);

  void CountFragments(std::vector<unsigned int>& cells);

  /// Units that a cell has needed.
  vtkTypeInt64 CountUnits(const unsigned int* cell) const;
  vtkTypeInt64 GetLayoutBytes(const Layout& layout, const Rectangle& tile, vtkTypeInt64 units) const;

  /// Under the limit; -1 if not even a tile without any does.
  vtkTypeInt64 GetUnitsAllowed(const Rectangle& tile, const vtkTranslucencyCapabilities& capabilities) const;

  /// Makes the buffers large enough for the tile, and gives back what would pass the limit; false if there is no
  /// memory. Where units have to grow they grow to room, if there is memory.
  bool ReserveBuffers(vtkTypeInt64 units, vtkTypeInt64 room, const vtkTranslucencyCapabilities& capabilities);

  std::map<unsigned int, vtkTranslucencyBuffer> Buffers; // by their binding
  vtkTranslucencyBuffer Counters;
  vtkTranslucencyBuffer CountersRead; // a copy of them
  bool Summed = false;                // the last tile was ended by its sum, and is yet to be counted
  vtkTranslucencyBuffer LayoutBlock;

  vtkTypeInt64 InitialFragments = 0;
  bool CountAccesses = false;
  std::unique_ptr<vtkCellRoom> Room;
  std::unique_ptr<vtkFragmentCounter> Counter;
  Rectangle Tile{ { 0, 0, 0, 0 } };
  double LimitBytes = 0;
  double BlockBytes = 0;
  vtkTypeInt64 UnitsAllowed = 0;
  vtkTypeInt64 Units = 0; // that were needed
  vtkTypeInt64 Fragments = 0;
  vtkTypeInt64 FullestCell = 0; // fragments
  bool KeepsDrawOrder = false;
  Links Linked = Links::None; // in the current tile
};
VTK_ABI_NAMESPACE_END

#endif
