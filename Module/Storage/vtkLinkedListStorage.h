/**
 * @class   vtkLinkedListStorage
 * @brief   one linked list of fragments a pixel
 *
 * After Yang et al. 2010, "Real-Time Concurrent Linked List Construction on the GPU":
 *
 * | buffer    | bytes                        | holds                                                                |
 * | --------- | ---------------------------- | -------------------------------------------------------------------- |
 * | table     | 4 a pixel                    | the head of the pixel's list, 0 if it is empty                       |
 * | fragments | 16 (HalfFloat), 12 (RGBA8)   | one node: next, depth, colour; 4 more with transmission colours      |
 * | counters  | 64 a cell                    | the next node of the cell of 16 x 16 pixels                          |
 *
 * A list is in the reverse order of drawing: the last drawn first. In multi-sampled windows a fragment may join the node before it
 * (Shaders/Common/MergeSamples.glsl).
 *
 * The paper takes all nodes from one counter. That counter is what the gather waits for: two threads alone lose more time to it
 * than to everything else. Here each cell has a counter and a range of nodes of its own, as large as what the cell held in the
 * last frame and an eighth more. After a frame in which that was not enough (the view moves), ranges are for a while as large as
 * the fullest of a cell and its neighbours within two cells.
 *
 * Where a range is too small, the frame is still counted to its end and then drawn again with ranges that fit. Bytes per pixel:
 * 4, and 16 (or 12) for each fragment, with an eighth more.
 */
#ifndef vtkLinkedListStorage_h
#define vtkLinkedListStorage_h

#include "vtkFragmentStorage.h"
#include "vtkTranslucencyBuffer.h" // for the buffers

class VTKRENDERINGTRANSLUCENCY_EXPORT vtkLinkedListStorage : public vtkFragmentStorage
{
public:
  static vtkLinkedListStorage* New();
  vtkTypeMacro(vtkLinkedListStorage, vtkFragmentStorage);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  const char* GetShaderName() const override;
  std::string GetObstacle(
    const Rectangle& viewport, const vtkTranslucencyCapabilities& capabilities) const override;
  Outcome Begin(const Rectangle& tile, const vtkTranslucencyCapabilities& capabilities) override;
  Outcome End() override;
  int GetPartsNeeded() const override;
  vtkTypeInt64 GetFragments() const override;
  int GetMostExpected() const override;
  bool Fits(vtkTypeInt64 fragments, const Rectangle& viewport,
    const vtkTranslucencyCapabilities& capabilities) const override;
  vtkTypeInt64 GetBytes() const override;
  void Release(bool contextAlive) override;

protected:
  vtkLinkedListStorage() = default;
  ~vtkLinkedListStorage() override = default;

private:
  vtkLinkedListStorage(const vtkLinkedListStorage&) = delete;
  void operator=(const vtkLinkedListStorage&) = delete;

  vtkTypeInt64 GetNodeBytes() const;
  vtkTypeInt64 GetNodesAllowed(
    const Rectangle& tile, const vtkTranslucencyCapabilities& capabilities) const;

  /// Makes the buffers large enough for the tile, and gives back what would pass the limit; false if there is no memory. Where the
  /// nodes' buffer has to grow it grows to roomBytes, if there is memory.
  bool ReserveBuffers(
    vtkTypeInt64 nodeBytes, vtkTypeInt64 roomBytes, const vtkTranslucencyCapabilities& capabilities);

  struct TileLayout
  {
    int CellShift = 0; // a cell is 2^CellShift pixels wide and high
    int CellsPerRow = 0;
    int Rows = 0;
    int FramesMoving = 0;             // how long ranges are still sized after their neighbours, too
    std::vector<vtkTypeInt64> Counts; // nodes that each cell took in the last frame; empty before the first
  };

  /// The nodes that each cell may take.
  std::vector<vtkTypeInt64> GetRanges(const TileLayout& layout) const;

  vtkTranslucencyBuffer Counters;
  vtkTranslucencyBuffer Table;
  vtkTranslucencyBuffer Nodes;
  vtkTranslucencyBuffer Layout;

  std::map<Rectangle, TileLayout> Layouts; // of the tiles of the last frames
  Rectangle Tile{ { 0, 0, 0, 0 } };
  vtkTypeInt64 NodesAllowed = 0;
  std::vector<vtkTypeInt64> Ranges; // of the current tile
  vtkTypeInt64 Fragments = 0;
  vtkTypeInt64 FullestCell = 0;
};

#endif
