// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPVSamplesPass
 * @brief   has what is below it drawn with several samples per pixel
 *
 * ParaView's windows have one sample, and what it reads from them (parts of ranks, depths for a picker) could not be
 * read if they had more. So the samples are in a framebuffer of this pass: it takes what the bound framebuffer holds,
 * has its delegate draw, and gives colour (the mean of the samples) and depth (of one of them) back. FXAA, which can't
 * read several samples and has no edges to smooth then, has to be off (vtkPVTranslucency sees to it).
 *
 * It takes 8 bytes per sample and pixel, and 12 where a vtkPVRanksPass has the parts of ranks put together.
 */
#ifndef vtkPVSamplesPass_h
#define vtkPVSamplesPass_h

#include "vtkPVFramebuffer.h"

#include "vtkRenderPass.h"
#include "vtkSmartPointer.h"

class vtkOpenGLRenderWindow;

class vtkPVSamplesPass : public vtkRenderPass
{
public:
  static vtkPVSamplesPass* New();
  vtkTypeMacro(vtkPVSamplesPass, vtkRenderPass);

  void Render(const vtkRenderState* state) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

  /// What draws.
  void SetDelegate(vtkRenderPass* pass) { this->Delegate = pass; }

  /// Samples per pixel; 1, the default, has the delegate draw as it would without this pass. A driver that has fewer
  /// draws with as many as it has, after a warning.
  void SetSamples(int samples) { this->Samples = samples; }

protected:
  vtkPVSamplesPass() = default;
  ~vtkPVSamplesPass() override = default;

private:
  vtkPVSamplesPass(const vtkPVSamplesPass&) = delete;
  void operator=(const vtkPVSamplesPass&) = delete;

  unsigned int Allocate(vtkOpenGLRenderWindow* window, int width, int height);

  vtkSmartPointer<vtkRenderPass> Delegate;
  int Samples = 1;
  bool Warned = false;
  vtkPVFramebuffer Framebuffer; // in the formats of the one that is bound
};

#endif
