#include "vtkTranslucencyPixels.h"

#include "Common/Bindings.glsl"

//------------------------------------------------------------------------------
vtkTranslucencyPixels::Size vtkTranslucencyPixels::GetSize(
  const std::array<int, 4>& tile, int samples, int words, bool locks)
{
  constexpr vtkTypeInt64 wordBytes = 4;
  const vtkTypeInt64 across = (tile[2] + PIXEL_BLOCK_WIDTH - 1) / PIXEL_BLOCK_WIDTH;
  const vtkTypeInt64 down = (tile[3] + PIXEL_BLOCK_HEIGHT - 1) / PIXEL_BLOCK_HEIGHT;
  const vtkTypeInt64 pixels = across * down * PIXEL_BLOCK_WIDTH * PIXEL_BLOCK_HEIGHT;
  Size size;
  size.Counts = pixels * samples * wordBytes;
  size.Records = size.Counts * words;
  size.Locks = locks ? pixels * wordBytes : 0;
  return size;
}

//------------------------------------------------------------------------------
bool vtkTranslucencyPixels::Begin(const Size& size)
{
  if (!this->Counts.Reserve(size.Counts) || !this->Records.Reserve(size.Records) ||
    (size.Locks > 0 && !this->Locks.Reserve(size.Locks)))
  {
    this->Release();
    return false;
  }
  this->Counts.Clear(size.Counts);
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
vtkTypeInt64 vtkTranslucencyPixels::GetBytes() const
{
  return this->Counts.GetBytes() + this->Records.GetBytes() + this->Locks.GetBytes();
}

//------------------------------------------------------------------------------
void vtkTranslucencyPixels::Release(bool contextAlive)
{
  this->Counts.Release(contextAlive);
  this->Records.Release(contextAlive);
  this->Locks.Release(contextAlive);
}
