// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkStorageCountPass
 * @brief   draws the exact picture and counts the accesses to its fragment storage
 *
 * 1. Gather: all translucent fragments into the storage, as vtkABufferPass does, by shaders that count what they
 * access.
 * 2. Count: a resolve (Shaders/Storage/CountAccesses.glsl) reads all fragments once.
 * 3. Resolve: as vtkABufferPass does, without counting.
 *
 * So each fragment is stored once and read once, whatever techniques would do with it; vtkStorageAccounting says what
 * counts, and expects the same numbers from nothing but how many pixels hold how many fragments. Volumes' fragments are
 * inserted behind the R-buffer's passes: stored, but not among its reads and what these access.
 *
 * The storage's properties are the pass's, as for all techniques. The counts are those of the last frame, and -1 before
 * the first one and where it was drawn by a fallback.
 */
#ifndef vtkStorageCountPass_h
#define vtkStorageCountPass_h

#include "vtkABufferPass.h"
#include "vtkStorageAccounting.h"  // for the histogram
#include "vtkTranslucencyBuffer.h" // for PixelFragments

VTK_ABI_NAMESPACE_BEGIN
class VTKRENDERINGTRANSLUCENCY_EXPORT vtkStorageCountPass : public vtkABufferPass
{
public:
  static vtkStorageCountPass* New();
  vtkTypeMacro(vtkStorageCountPass, vtkABufferPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Accesses to the storage, as shaders have counted them.
   */
  vtkTypeInt64 GetStores() const { return this->Count(this->Accesses.Stores); }
  vtkTypeInt64 GetReads() const { return this->Count(this->Accesses.Reads); }
  vtkTypeInt64 GetTableAccesses() const { return this->Count(this->Accesses.Table); }
  vtkTypeInt64 GetSecondDepthAccesses() const { return this->Count(this->Accesses.SecondDepth); }
  vtkTypeInt64 GetFrameBufferAccesses() const { return this->Count(this->Accesses.FrameBuffer); }
  vtkTypeInt64 GetAccesses() const { return this->Count(this->Accesses.GetTotal()); }
  ///@}

  /**
   * Bytes that hardware built for the design would take for these fragments (vtkStorageAccounting, with its own
   * packing); -1 of designs that it does not know.
   */
  vtkGetMacro(PackedBytes, double);

  /**
   * Fragments in a section of the storage, 1 where it has none.
   */
  vtkTypeInt64 GetSectionFragments() const { return this->Count(this->SectionFragments); }

  /**
   * Pixels that hold that many fragments, 1 or more.
   */
  vtkTypeInt64 GetPixelsHolding(vtkTypeInt64 fragments) const;

  const vtkStorageAccounting::Histogram& GetHistogram() const { return this->Histogram; }

protected:
  vtkStorageCountPass() = default;
  ~vtkStorageCountPass() override;

  void RenderTranslucent(const vtkRenderState* state, vtkRenderPass* volumetricPass) override;
  bool UseLists(vtkTranslucencyFrame& frame) override;
  vtkTypeInt64 GetTechniqueBytes() override;
  void ReleaseTechniqueResources(bool contextAlive) override;

private:
  vtkStorageCountPass(const vtkStorageCountPass&) = delete;
  void operator=(const vtkStorageCountPass&) = delete;

  vtkTypeInt64 Count(vtkTypeInt64 number) const { return this->SectionFragments > 0 ? number : -1; }
  void Reset();

  vtkStorageAccounting::Histogram Histogram;
  vtkStorageAccounting::Accesses Accesses;
  int SectionFragments = 0; // 0 where nothing was counted
  double PackedBytes = -1;
  vtkTranslucencyBuffer PixelFragments; // a word a pixel of the tile
};
VTK_ABI_NAMESPACE_END

#endif
