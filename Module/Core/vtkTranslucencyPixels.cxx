// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTranslucencyPixels.h"

#include "Common/Bindings.glsl"

#include <numeric>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
constexpr vtkTypeInt64 WordBytes = 4;
constexpr int WordsOfTarget = 4;

// Words in each of the colours.
std::vector<int> Divide(int words)
{
  std::vector<int> targets(words / WordsOfTarget, WordsOfTarget);
  const int left = words % WordsOfTarget;
  if (left > 0)
  {
    targets.push_back(left == 3 ? WordsOfTarget : left);
  }
  return targets;
}
}

//------------------------------------------------------------------------------
vtkTranslucencyPixels::Size vtkTranslucencyPixels::GetSize(
  const std::array<int, 4>& tile, int samples, int words, bool locks)
{
  const vtkTypeInt64 across = (tile[2] + PIXEL_BLOCK_WIDTH - 1) / PIXEL_BLOCK_WIDTH;
  const vtkTypeInt64 down = (tile[3] + PIXEL_BLOCK_HEIGHT - 1) / PIXEL_BLOCK_HEIGHT;
  const vtkTypeInt64 pixels = across * down * PIXEL_BLOCK_WIDTH * PIXEL_BLOCK_HEIGHT;
  Size size;
  size.Counts = pixels * samples * WordBytes;
  size.Records = size.Counts * words;
  size.Locks = locks ? pixels * WordBytes : 0;
  return size;
}

//------------------------------------------------------------------------------
bool vtkTranslucencyPixels::Begin(const Size& size, bool zeroed)
{
  this->Targets.Release();
  if (size.Locks == 0)
  {
    this->Locks.Release();
  }
  if (!this->Counts.Reserve(size.Counts) || !this->Records.Reserve(size.Records) ||
    (size.Locks > 0 && !this->Locks.Reserve(size.Locks)))
  {
    this->Release();
    return false;
  }
  this->Counts.Clear(size.Counts);
  if (zeroed)
  {
    this->Records.Clear(size.Records);
  }
  this->Counts.BindStorage(STORAGE_BINDING_TABLE);
  this->Records.BindStorage(STORAGE_BINDING_FRAGMENTS);
  if (size.Locks > 0)
  {
    this->Locks.Clear(size.Locks);
    this->Locks.BindStorage(STORAGE_BINDING_COUNTERS);
  }
  return true;
}

//------------------------------------------------------------------------------
int vtkTranslucencyPixels::CountTargets(int words)
{
  return static_cast<int>(Divide(words).size());
}

//------------------------------------------------------------------------------
vtkTypeInt64 vtkTranslucencyPixels::GetTargetBytes(int width, int height, int words)
{
  const std::vector<int> targets = Divide(words);
  return WordBytes * std::accumulate(targets.begin(), targets.end(), 0) * width * height;
}

//------------------------------------------------------------------------------
bool vtkTranslucencyPixels::BeginTargets(int width, int height, int words)
{
  this->Counts.Release();
  this->Records.Release();
  this->Locks.Release();
  std::vector<vtkTranslucencyTargets::Format> formats;
  for (int count : Divide(words))
  {
    formats.push_back(vtkTranslucencyTargets::Words(count));
  }
  return this->Targets.Reserve(width, height, 1, formats);
}

//------------------------------------------------------------------------------
vtkTypeInt64 vtkTranslucencyPixels::GetBytes() const
{
  return this->Counts.GetBytes() + this->Records.GetBytes() + this->Locks.GetBytes() + this->Targets.GetBytes();
}

//------------------------------------------------------------------------------
void vtkTranslucencyPixels::Release(bool contextAlive)
{
  this->Counts.Release(contextAlive);
  this->Records.Release(contextAlive);
  this->Locks.Release(contextAlive);
  this->Targets.Release(contextAlive);
}
VTK_ABI_NAMESPACE_END
