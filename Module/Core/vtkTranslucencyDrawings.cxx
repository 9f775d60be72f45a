// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTranslucencyDrawings.h"

#include "vtkTranslucencyBlending.h"
#include "vtkTranslucencyCapabilities.h"
#include "vtkTranslucencyVTKVersion.h"

VTK_ABI_NAMESPACE_BEGIN
namespace
{
// Lets one sample of each pixel through, and puts the mask back as it was.
class ScopedSample
{
public:
  explicit ScopedSample(int sample)
    : Enabled(glIsEnabled(GL_SAMPLE_MASK) == GL_TRUE)
  {
    glGetIntegeri_v(GL_SAMPLE_MASK_VALUE, 0, &this->Mask);
    glEnable(GL_SAMPLE_MASK);
    glSampleMaski(0, 1u << sample);
  }
  ~ScopedSample()
  {
    glSampleMaski(0, static_cast<GLbitfield>(this->Mask));
    (this->Enabled ? glEnable : glDisable)(GL_SAMPLE_MASK);
  }
  ScopedSample(const ScopedSample&) = delete;
  ScopedSample& operator=(const ScopedSample&) = delete;

private:
  bool Enabled;
  GLint Mask = 0;
};
}

//------------------------------------------------------------------------------
void vtkTranslucencyDrawings::Each(vtkOpenGLState* state, const vtkTranslucencyStage& stage,
  const vtkTranslucencyCapabilities& capabilities, int samples,
  const std::function<void(const vtkTranslucencyStage& drawn, int sample)>& draw)
{
  // Masks don't outlive a drawing: what follows asks for others through the cache, which knows that of one buffer.
  const auto drawUnderMask = [&](const vtkTranslucencyStage& drawn, int sample)
  {
    draw(drawn, sample);
    vtkTranslucencyBlending::Unmask(state, drawn);
  };
  const auto drawSamples = [&](const vtkTranslucencyStage& drawn)
  {
    if (samples == 1 || capabilities.ShadesSamples)
    {
      drawUnderMask(drawn, 0);
      return;
    }
    for (int sample = 0; sample < samples; ++sample)
    {
      const ScopedSample only(sample);
      drawUnderMask(drawn, sample);
    }
  };
  if (capabilities.BlendsBuffersApart || stage.Differing.empty())
  {
    drawSamples(stage);
    return;
  }
  for (const vtkTranslucencyStage& part : vtkTranslucencyBlending::Split(stage))
  {
    drawSamples(part);
  }
}
VTK_ABI_NAMESPACE_END
