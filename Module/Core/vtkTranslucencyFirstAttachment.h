// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTranslucencyFirstAttachment
 *
 * While this object lives, what is drawn goes to the first colour attachment of the framebuffer that is bound, whatever
 * passes around have made of it.
 *
 * vtkSSAOPass draws positions and normals besides colours: it hooks props, to add outputs to their shaders and to make
 * three attachments those that are drawn to, before each drawing. A shader without these outputs leaves undefined
 * values there, and in a framebuffer of ours they are not there at all. So the other attachments are not drawn to, and
 * the props go without such hooks. Hooks that shade, such as shadows, stay.
 */
#ifndef vtkTranslucencyFirstAttachment_h
#define vtkTranslucencyFirstAttachment_h

#include "vtkTranslucencyABINamespace.h"

#include <utility>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkObjectBase;
class vtkProp;
class vtkRenderState;

class vtkTranslucencyFirstAttachment
{
public:
  explicit vtkTranslucencyFirstAttachment(const vtkRenderState* state);
  ~vtkTranslucencyFirstAttachment();

  vtkTranslucencyFirstAttachment(const vtkTranslucencyFirstAttachment&) = delete;
  vtkTranslucencyFirstAttachment& operator=(const vtkTranslucencyFirstAttachment&) = delete;

private:
  std::vector<unsigned int> DrawBuffers;                               // as found, if there are several
  std::vector<std::pair<vtkProp*, std::vector<vtkObjectBase*>>> Hooks; // as found, of props from which some were taken
};
VTK_ABI_NAMESPACE_END

#endif
