// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkBucketPeeling.h"

#include "vtkTranslucencyFrame.h"

VTK_ABI_NAMESPACE_BEGIN
namespace
{
// Shaders/Peel/Buckets.glsl
constexpr int NumberOfBuckets = 8;
constexpr int BucketSize = 4;

int WordsOfRecord(int channels)
{
  return 7 + channels + NumberOfBuckets * BucketSize * (channels == 3 ? 4 : 3);
}
}

//------------------------------------------------------------------------------
bool vtkBucketPeeling::Render(vtkTranslucencyFrame& frame, const vtkPeelingSettings& settings, double memoryLimit)
{
  const vtkTranslucencyFrame::Defines buckets{ { "BUCKETS", std::to_string(NumberOfBuckets) },
    { "BUCKET_SIZE", std::to_string(BucketSize) } };
  vtkTranslucencyFrame::Gathering gathering{ "Peel/GatherBuckets.glsl", buckets };
  gathering.Values["PEEL_TAIL"] = settings.Layers > 0 && settings.AveragesTail ? "1" : "0";
  gathering.Critical = true;
  gathering.Rejects = true;
  vtkTranslucencyFrame::Defines merge = gathering.Values;
  merge["PEEL_LAYERS"] = std::to_string(settings.Layers);

  bool left = true;
  int drawings = 0;
  bool good = frame.UsePixels(this->Buckets, WordsOfRecord(frame.GetChannels()), memoryLimit) &&
    frame.DrawScreen("Peel/StartBuckets.glsl", buckets, {});
  while (left && good)
  {
    good = (drawings++ < vtkPeelingSettings::MostLayers || frame.Fail(vtkPeelingSettings::GetTooMany())) &&
      frame.Draw(gathering, {}) && frame.DrawScreen("Peel/MergeBuckets.glsl", merge, {}, &left);
  }
  return good && frame.Composite("Peel/ResolveBuckets.glsl", buckets, {});
}
VTK_ABI_NAMESPACE_END
