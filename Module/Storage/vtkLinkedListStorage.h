// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkLinkedListStorage
 * @brief   one linked list of fragments a pixel
 *
 * After Yang et al. 2010, "Real-Time Concurrent Linked List Construction on the GPU":
 *
 * - table, 4 bytes per pixel: the head of the pixel's list, 0 if it is empty
 * - fragments, 16 bytes (HalfFloat) or 12 (RGBA8) each: one node, which is next, depth and colour; 4 more with
 * transmission colours
 *
 * A list is in the reverse order of drawing: the last drawn first. In multi-sampled windows a fragment may join the
 * node before it (Shaders/Common/MergeSamples.glsl). The paper takes all nodes from one counter; vtkCellStorage says
 * why this does not.
 *
 * A software rasterizer draws the fragments of a pixel in order and one at a time. There a pixel takes four nodes at
 * once, side by side: a quarter of the atomic operations, and resolves read four fragments at a time
 * (Shaders/Storage/LinkedListInOrder.glsl). What is left of the last four is empty.
 *
 * Bytes per pixel: 4, and 16 (or 12) for each fragment, with an eighth more; on a software rasterizer for each of four,
 * if only one of them is there.
 */
#ifndef vtkLinkedListStorage_h
#define vtkLinkedListStorage_h

#include "vtkCellStorage.h"

VTK_ABI_NAMESPACE_BEGIN
class VTKRENDERINGTRANSLUCENCY_EXPORT vtkLinkedListStorage : public vtkCellStorage
{
public:
  static vtkLinkedListStorage* New();
  vtkTypeMacro(vtkLinkedListStorage, vtkCellStorage);

  const char* GetName() const override { return "linked-list"; }

protected:
  vtkLinkedListStorage() = default;
  ~vtkLinkedListStorage() override = default;

  const char* GetFileName() const override;
  std::vector<Layout> GetLayouts() const override;
  int GetUnitFragments() const override;
  bool UnitsAreFragments() const override { return !this->GetKeepsDrawOrder(); }
  unsigned int CountFree(const unsigned int* entries, int count) const override;
  vtkTypeInt64 GetMostUnits(const Rectangle& tile) const override;

private:
  vtkLinkedListStorage(const vtkLinkedListStorage&) = delete;
  void operator=(const vtkLinkedListStorage&) = delete;
};
VTK_ABI_NAMESPACE_END

#endif
