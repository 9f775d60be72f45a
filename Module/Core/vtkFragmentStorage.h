// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkFragmentStorage
 * @brief   where the fragments of all pixels lie on the GPU
 *
 * Knows no technique. Core drives it, tile by tile (a tile is the viewport, or a part of it):
 *
 * 1. Begin: buffers of the size that the last frames needed, emptied and bound.
 * 2. The geometry is drawn; the shaders call storeFragment (see Shaders/README.md for the contract).
 * 3. The technique's resolve reads the fragments. It draws nothing if they did not all fit.
 * 4. End: reads what was allocated. Nothing is ever dropped: if fragments did not fit, the storage has grown and the
 * tile is drawn again, or, where it would pass the memory limit, the tile is cut into parts.
 *
 * End waits for the GPU. Where it has to know before the resolve, or GetSummary gives no shader, it comes before that.
 */
#ifndef vtkFragmentStorage_h
#define vtkFragmentStorage_h

#include "vtkObject.h"
#include "vtkRenderingTranslucencyModule.h" // for the export macro
#include "vtkTranslucencyABINamespace.h"

#include <array>  // for Rectangle
#include <map>    // for GetDefines
#include <string> // for GetDefines
#include <vector> // for GetOptions

VTK_ABI_NAMESPACE_BEGIN
class vtkTranslucencyBuffer;
struct vtkTranslucencyCapabilities;
struct vtkTranslucencyOption;

class VTKRENDERINGTRANSLUCENCY_EXPORT vtkFragmentStorage : public vtkObject
{
public:
  vtkTypeMacro(vtkFragmentStorage, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum ColorFormatType
  {
    HalfFloat = 0,
    RGBA8 = 1
  };

  ///@{
  /**
   * How a fragment's colour and opacity are kept: HalfFloat (the default, 8 bytes: keeps opacities below 1/255 and
   * colours above 1) or RGBA8 (4 bytes: each channel rounded to 1/255). Where props have transmission colours there are
   * three opacities, which take 4 bytes more. Another value is an error and changes nothing.
   */
  void SetColorFormat(int format);
  vtkGetMacro(ColorFormat, int);
  ///@}

  ///@{
  /**
   * The most graphics memory that the storage may take, in MiB; more fragments than fit are drawn in tiles. 0 (the
   * default) means a quarter of what the driver reports, or 2048 where it reports nothing. A negative value is an error
   * and changes nothing; a limit that does not hold one row of pixels with one fragment each is an error when drawing.
   */
  void SetMemoryLimit(double mebibytes);
  vtkGetMacro(MemoryLimit, double);
  ///@}

  std::vector<vtkTranslucencyOption> GetOptions();

  /// A rectangle of window pixels: x, y, width, height.
  using Rectangle = std::array<int, 4>;

  enum class Outcome
  {
    Complete,    // all fragments of the tile are stored
    Grown,       // not all fitted; the storage has grown: draw the tile again
    TooLarge,    // they do not fit into the limit: cut the tile
    OutOfMemory, // the driver has no memory, even for less than the limit
  };

  /// How many opacities a fragment has, 1 or 3 (Shaders/Common/Channels.glsl), and a pixel samples, from the next tile
  /// on. Core's to set.
  void SetChannelsAndSamples(int channels, int samples)
  {
    this->Channels = channels;
    this->Samples = samples;
  }

  /// As the option storage has it.
  virtual const char* GetName() const = 0;

  /// "Name" stands for the file Storage/Name.glsl of Module/Shaders; shaders include it as Storage/Selected.glsl.
  virtual std::string GetShaderName() const = 0;

  /// What shaders that store or read fragments need defined.
  virtual std::map<std::string, std::string> GetDefines() const;

  /// What those that store need defined besides: all others are the same programs whatever it is.
  virtual std::map<std::string, std::string> GetStoringDefines() const { return {}; }

  /// Empty if the storage can serve a viewport of this size under the limit, else why not.
  virtual std::string GetObstacle(const Rectangle& viewport, const vtkTranslucencyCapabilities& capabilities) const = 0;

  /// Where a prop lies: left, bottom, right, top in window pixels.
  using Box = std::array<double, 4>;

  /// Before the first tile of a frame: what shaders need defined may change here, and nowhere else but by setting
  /// properties. The boxes of the props that will be drawn tell how much room to begin with, and whether the view
  /// moves.
  virtual void BeginFrame(const std::vector<Box>& boxes, const vtkTranslucencyCapabilities& capabilities) = 0;

  /// Makes ready for a tile: OutOfMemory or Complete.
  virtual Outcome Begin(const Rectangle& tile, const vtkTranslucencyCapabilities& capabilities) = 0;

  /// After the geometry of the tile was drawn, and again after volumes were: reads all counters.
  virtual Outcome End() = 0;

  /// What a tile holds, as a shader has added it up.
  struct Sum
  {
    bool Overflowed = false; // not all fragments fitted
    vtkTypeInt64 Fragments = 0;
    vtkTypeInt64 Units = 0;
    vtkTypeInt64 FullestCell = 0; // fragments
  };

  /// The same by that, which is less to wait for. Counters are read when the next tile begins.
  virtual Outcome End(const Sum& vtkNotUsed(sum)) { return this->End(); }

  /// What adds it up, after the geometry was drawn: a file of Module/Shaders that is drawn, an invocation for each of
  /// GetCells; null where the counters alone don't tell.
  virtual const char* GetSummary() const { return nullptr; }

  /// Cells across and down the current tile.
  virtual std::array<int, 2> GetCells() const = 0;

  /// After TooLarge: how many parts of this tile would fit, if fragments were spread evenly; at least 2.
  virtual int GetPartsNeeded() const = 0;

  /// What is run before fragments can be read: a file of Module/Shaders that is drawn, an invocation for each of
  /// GetCells, until it discards them all; null where nothing is to be run.
  virtual const char* GetRetrieval() const { return nullptr; }
  virtual void BeginRetrieval() {}

  /// The most drawings that it may take.
  virtual vtkTypeInt64 GetMostRetrievals() const { return 0; }

  /// Of storages whose fragments have no links: whether they have got some in this tile, because their order is
  /// changed.
  enum class Links
  {
    None = 0,
    Made = 1,  // the next shader changes the order, for the first time
    Mixed = 2, // it has been changed, of some, or there are several samples, for which one shader is to do
  };

  /// Before a shader that changes the order of fragments (Shaders/Storage/SortList.glsl): false if there is no memory
  /// for that.
  virtual bool ReserveLinks() { return true; }

  /// What shaders that change no fragments may fetch as texels: a buffer, by the name of its sampler.
  struct Texels
  {
    const char* Sampler;
    vtkTranslucencyBuffer* Buffer;
    int Words; // of a texel
  };
  virtual std::vector<Texels> GetTexels() = 0;

  /// After a shader that may have.
  virtual void FinishLinks() {}
  virtual Links GetLinks() const { return Links::None; }

  /// Fragments of the tile, after Complete.
  virtual vtkTypeInt64 GetFragments() const = 0;

  /// The most that the shaders' squareFragments gives for a square of the tile, after Complete.
  virtual int GetMostExpected() const = 0;

  /// Units of room that they take; and whether that many units of a viewport would be taken in one tile.
  virtual vtkTypeInt64 GetUnits() const = 0;
  virtual bool Fits(
    vtkTypeInt64 units, const Rectangle& viewport, const vtkTranslucencyCapabilities& capabilities) const = 0;

  /// Bytes as allocated.
  virtual vtkTypeInt64 GetBytes() const = 0;

  /// Frees the buffers; the context must be current, unless it is gone.
  virtual void Release(bool contextAlive) = 0;

protected:
  vtkFragmentStorage() = default;
  ~vtkFragmentStorage() override = default;

  /// The limit in force, in bytes.
  double GetLimitBytes(const vtkTranslucencyCapabilities& capabilities) const;

  int ColorFormat = HalfFloat;
  double MemoryLimit = 0;
  int Channels = 1;
  int Samples = 1;

private:
  vtkFragmentStorage(const vtkFragmentStorage&) = delete;
  void operator=(const vtkFragmentStorage&) = delete;
};
VTK_ABI_NAMESPACE_END

#endif
