// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkRBufferStorage
 * @brief   the R-buffer: a first-in first-out buffer of fragments with their pixel
 *
 * After Wittenbrink 2001, "R-Buffer: A Pointerless A-Buffer Hardware Architecture", as the T-buffer's paper describes
 * it (section 2.3.1). Fragments are appended to a queue as they are drawn. Reading them takes as many passes as the
 * deepest pixel has fragments: each takes the farthest fragment of every pixel out of the queue and puts the others
 * back; a second depth buffer holds its depth, a state of three bits a pixel whether it is of this pass. So fragments
 * leave in the order of depth, and techniques read them from the nearest on, whatever the order of drawing was.
 *
 * - fragments, 16 bytes (HalfFloat) or 12 (RGBA8) each: link, depth, colour; 4 more with transmission colours
 * - pixels, 4 bytes per fragment: the fragment's pixel
 * - second depths, 8 bytes per pixel: state and number of the fragment that leaves, and its depth
 * - table, 4 bytes per pixel: the nearest fragment that has left; techniques go from one to the next
 *
 * The paper's queue is one for the whole picture, and its hardware goes through it alone. Here each cell of 16 x 16
 * pixels has one (vtkCellStorage), and an invocation that goes through it (Shaders/Storage/Retrieve.glsl): the same
 * passes for each pixel, the same reads, and no two invocations at one pixel. The work is the sum of i (i + 1) / 2 for
 * pixels of i fragments: a storage to compare with, not one for deep scenes.
 */
#ifndef vtkRBufferStorage_h
#define vtkRBufferStorage_h

#include "vtkCellStorage.h"

VTK_ABI_NAMESPACE_BEGIN
class VTKRENDERINGTRANSLUCENCY_EXPORT vtkRBufferStorage : public vtkCellStorage
{
public:
  static vtkRBufferStorage* New();
  vtkTypeMacro(vtkRBufferStorage, vtkCellStorage);

  const char* GetName() const override { return "r-buffer"; }
  const char* GetRetrieval() const override;
  void BeginRetrieval() override;
  vtkTypeInt64 GetMostRetrievals() const override;
  std::map<std::string, std::string> GetDefines() const override;

  ///@{
  /**
   * How many fragments of its queue an invocation reads in one drawing, 32768 by default. A pass over a longer queue
   * takes several drawings: on a GPU one thread reads a few hundred thousand fragments a second, and drivers end a
   * drawing that takes seconds. A value below 1 is an error and changes nothing.
   */
  void SetQueueReads(int fragments);
  vtkGetMacro(QueueReads, int);
  ///@}

protected:
  vtkRBufferStorage() = default;
  ~vtkRBufferStorage() override = default;

  const char* GetFileName() const override;
  std::vector<Layout> GetLayouts() const override;
  vtkTypeInt64 GetMostUnits(const Rectangle& tile) const override;
  bool UnitsAreFragments() const override { return true; }

private:
  vtkRBufferStorage(const vtkRBufferStorage&) = delete;
  void operator=(const vtkRBufferStorage&) = delete;

  int QueueReads = 32768;
};
VTK_ABI_NAMESPACE_END

#endif
