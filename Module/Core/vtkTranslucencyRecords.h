// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTranslucencyRecords
 *
 * Where a frame's records of pixels lie: in buffers, or in colours that fragments fetch (vtkTranslucencyPixels).
 */
#ifndef vtkTranslucencyRecords_h
#define vtkTranslucencyRecords_h

#include "vtkTranslucencyPixels.h"
#include "vtkTranslucencyStage.h"

#include <string>

VTK_ABI_NAMESPACE_BEGIN
class vtkTranslucencyFrameShaders;
class vtkTranslucencyTiles;
struct vtkTranslucencyCapabilities;

class vtkTranslucencyRecords
{
public:
  vtkTranslucencyRecords(
    const vtkTranslucencyCapabilities& capabilities, vtkTranslucencyTiles& tiles, vtkTranslucencyFrameShaders& shaders);

  /// What vtkTranslucencyFrame::UsePixels does, in colours only if they may be. Gives what is wrong, empty if nothing
  /// is.
  std::string Reserve(vtkTranslucencyPixels& pixels, int words, double memoryLimit,
    const vtkTranslucencyPixels::Fetched& fetched, bool mayFetch, bool zeroed);

  bool AreFetched() const { return this->Fetched != nullptr; }

  /// Whether shaders store to them.
  bool AreStored() const { return this->Stored; }

  /// The stage that draws to the colours in which they lie.
  vtkTranslucencyStage GetStage(const vtkTranslucencyStage& stage) const;

  /// Those colours, as a shader of the screen reads them; none where they lie in buffers.
  std::vector<vtkTranslucencyStage::Input> GetInputs() const;

private:
  bool Fetch(vtkTranslucencyPixels& pixels, int words, vtkTypeInt64 limit) const;

  const vtkTranslucencyCapabilities& Capabilities;
  vtkTranslucencyTiles& Tiles;
  vtkTranslucencyFrameShaders& Shaders;
  bool Stored = false;
  vtkTranslucencyTargets* Fetched = nullptr;
  int EmptyWords = 0; // of those fetched, in the beginning
};
VTK_ABI_NAMESPACE_END

#endif
