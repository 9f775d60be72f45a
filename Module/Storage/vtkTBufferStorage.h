// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTBufferStorage
 * @brief   the T-buffer: sections of fragments for those pixels that hold any
 *
 * After the T-buffer's paper (section 3.2): a start-section table with an entry a pixel, null where the pixel
 * holds nothing; sections of SectionLength fragments, which any pixel may take; a next-section table with an entry a
 * section. Pixels without translucent fragments cost their entry, and nothing else.
 *
 * Bytes per pixel: 4; a section takes SectionLength times 12 bytes (8 with RGBA8) and 4, and a pixel as many sections
 * as its fragments fill, the last one in part.
 *
 * The paper's chains begin with a pixel's first section; here the entry names the one that is being filled
 * (Shaders/Storage/SectionPlaces.glsl).
 */
#ifndef vtkTBufferStorage_h
#define vtkTBufferStorage_h

#include "vtkSectionStorage.h"

VTK_ABI_NAMESPACE_BEGIN
class VTKRENDERINGTRANSLUCENCY_EXPORT vtkTBufferStorage : public vtkSectionStorage
{
public:
  static vtkTBufferStorage* New();
  vtkTypeMacro(vtkTBufferStorage, vtkSectionStorage);

  const char* GetName() const override { return "t-buffer"; }

protected:
  vtkTBufferStorage() = default;
  ~vtkTBufferStorage() override = default;

private:
  vtkTBufferStorage(const vtkTBufferStorage&) = delete;
  void operator=(const vtkTBufferStorage&) = delete;
};
VTK_ABI_NAMESPACE_END

#endif
