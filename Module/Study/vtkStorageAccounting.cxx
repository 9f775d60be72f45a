// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkStorageAccounting.h"

#include <algorithm>
#include <cmath>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
using Design = vtkStorageAccounting::Design;

std::int64_t SectionsOf(std::int64_t fragments, std::int64_t length)
{
  return (fragments + length - 1) / length;
}

// The sections that addresses point to, of a frame: those that pixels of the M-buffer have from the start need none.
std::int64_t CountAddressed(Design design, const vtkStorageAccounting::Histogram& frame, std::int64_t length)
{
  const std::int64_t without = design == Design::MBuffer ? 1 : 0;
  std::int64_t sections = 0;
  for (const auto& pixels : design == Design::RBuffer ? std::map<std::int64_t, std::int64_t>() : frame.Pixels)
  {
    sections += pixels.second * (SectionsOf(pixels.first, length) - without);
  }
  return sections;
}

// Of an address that tells so many sections, and none, apart.
int BitsFor(std::int64_t sections)
{
  int bits = 1;
  while (bits < 63 && sections >> bits > 0)
  {
    ++bits;
  }
  return bits;
}

std::string CheckRange(const std::string& what, std::int64_t value, std::int64_t least, std::int64_t most)
{
  return value >= least && value <= most
    ? std::string()
    : what + " is " + std::to_string(value) + ", expected " + std::to_string(least) + " to " + std::to_string(most);
}

std::string CheckFrame(const vtkStorageAccounting::Histogram& frame, const std::string& name, int coordinateBits)
{
  const std::int64_t side = coordinateBits < 31 ? std::int64_t(1) << coordinateBits : 0x7fffffff;
  std::vector<std::string> errors{ CheckRange(name + ": width", frame.Width, 1, side),
    CheckRange(name + ": height", frame.Height, 1, side) };
  for (std::string& error : errors)
  {
    error += error.empty() ? "" : ", with coordinates of " + std::to_string(coordinateBits) + " bits";
  }
  std::int64_t left = static_cast<std::int64_t>(frame.Width) * frame.Height;
  std::int64_t fragments = vtkStorageAccounting::MostFragments;
  for (const auto& pixels : frame.Pixels)
  {
    const std::string depth = std::to_string(pixels.first);
    errors.push_back(CheckRange(name + ": fragments of a pixel", pixels.first, 1, vtkStorageAccounting::MostFragments));
    errors.push_back(CheckRange(name + ": pixels of " + depth + " fragments", pixels.second, 0, left));
    if (!errors[errors.size() - 2].empty() || !errors.back().empty())
    {
      break;
    }
    left -= pixels.second;
    errors.push_back(pixels.second > fragments / pixels.first ? name + " has more than " +
          std::to_string(vtkStorageAccounting::MostFragments) + " fragments, expected at most as many"
                                                              : std::string());
    if (!errors.back().empty())
    {
      break;
    }
    fragments -= pixels.first * pixels.second;
  }
  const auto first =
    std::find_if(errors.begin(), errors.end(), [](const std::string& error) { return !error.empty(); });
  return first == errors.end() ? std::string() : *first;
}
}

//------------------------------------------------------------------------------
std::int64_t vtkStorageAccounting::Histogram::GetFragments() const
{
  std::int64_t sum = 0;
  for (const auto& pixels : this->Pixels)
  {
    sum += pixels.first * pixels.second;
  }
  return sum;
}

//------------------------------------------------------------------------------
std::int64_t vtkStorageAccounting::Histogram::GetPixels() const
{
  std::int64_t sum = 0;
  for (const auto& pixels : this->Pixels)
  {
    sum += pixels.second;
  }
  return sum;
}

//------------------------------------------------------------------------------
vtkStorageAccounting::vtkStorageAccounting(const Settings& settings, const std::vector<Histogram>& frames)
  : Given(settings)
  , Frames(frames)
  , Error(this->FindError())
{
}

//------------------------------------------------------------------------------
std::string vtkStorageAccounting::FindError() const
{
  const Packing& bits = this->Given.Bits;
  for (const std::string& error : { CheckRange("coordinate bits", bits.Coordinate, 1, 64),
         CheckRange("depth bits", bits.Depth, 1, 64), CheckRange("colour bits", bits.Color, 1, 64),
         CheckRange("state bits", bits.State, 1, 64), CheckRange("address bits", bits.Address, 0, 64),
         CheckRange("the T-buffer's section length", this->Given.TSectionLength, 1, 64),
         CheckRange("the M-buffer's section length", this->Given.MSectionLength, 0, 64) })
  {
    if (!error.empty())
    {
      return error;
    }
  }
  for (std::size_t i = 0; i < this->Frames.size(); ++i)
  {
    const std::string error = CheckFrame(this->Frames[i], "frame " + std::to_string(i), bits.Coordinate);
    if (!error.empty())
    {
      return error;
    }
  }
  for (const Design design : vtkStorageDesign::GetAll())
  {
    const std::int64_t addressed = this->GetAddressed(design);
    if (bits.Address > 0 && bits.Address < BitsFor(addressed))
    {
      return "address bits are " + std::to_string(bits.Address) + ", expected at least " +
        std::to_string(BitsFor(addressed)) + " for the " + std::to_string(addressed) + " sections of the " +
        vtkStorageDesign::GetName(design);
    }
  }
  return "";
}

//------------------------------------------------------------------------------
std::int64_t vtkStorageAccounting::GetSectionLength(Design design, const Histogram& frame) const
{
  if (design == Design::TBuffer)
  {
    return this->Given.TSectionLength;
  }
  if (design != Design::MBuffer)
  {
    return 1;
  }
  const double pixels = static_cast<double>(std::max<std::int64_t>(1, frame.GetPixels()));
  const std::int64_t mean = std::llround(static_cast<double>(frame.GetFragments()) / pixels);
  return this->Given.MSectionLength > 0 ? this->Given.MSectionLength : std::max<std::int64_t>(1, mean);
}

//------------------------------------------------------------------------------
std::int64_t vtkStorageAccounting::GetAddressed(Design design) const
{
  std::int64_t most = 0;
  for (const Histogram& frame : this->Frames)
  {
    most = std::max(most, CountAddressed(design, frame, this->GetSectionLength(design, frame)));
  }
  return most;
}

//------------------------------------------------------------------------------
vtkStorageAccounting::Layout vtkStorageAccounting::GetLayout(Design design, std::size_t frame) const
{
  const Histogram& pixels = this->Frames.at(frame);
  Layout layout{ design, pixels.Width, pixels.Height, this->GetSectionLength(design, pixels), this->Given.Bits };
  layout.Bits.Address = layout.Bits.Address > 0 ? layout.Bits.Address : BitsFor(this->GetAddressed(design));
  return layout;
}

//------------------------------------------------------------------------------
vtkStorageAccounting::Cost vtkStorageAccounting::GetCost(Design design, std::size_t frame) const
{
  const Histogram& pixels = this->Frames.at(frame);
  const Layout layout = this->GetLayout(design, frame);
  const Packing& field = layout.Bits;
  const double all = static_cast<double>(pixels.Width) * pixels.Height;
  const double fragmentBits = field.Depth + field.Color;
  const double sectionBits = static_cast<double>(layout.SectionLength) * fragmentBits + field.Address;
  const std::int64_t addressed = CountAddressed(design, pixels, layout.SectionLength);
  const std::int64_t fragments = pixels.GetFragments();

  Cost cost;
  cost.Fragments = fragments;
  cost.Count.Stores = fragments;
  cost.Count.Reads = fragments;
  switch (design)
  {
    case Design::LinkedList:
    case Design::TBuffer:
      cost.Sections = addressed;
      cost.Bytes = (all * field.Address + static_cast<double>(addressed) * sectionBits) / 8;
      cost.Count.Table = pixels.GetPixels();
      break;
    case Design::RBuffer:
      cost.Bytes =
        (static_cast<double>(fragments) * (fragmentBits + 2 * field.Coordinate) + all * (field.Depth + field.State)) /
        8;
      cost.Count.Reads = 0;
      for (const auto& deep : pixels.Pixels)
      {
        cost.Count.Reads +=
          deep.second * (deep.first * (deep.first + 1) / 2); // pass p reads what p - 1 passes have left
      }
      cost.Count.SecondDepth = cost.Count.Reads;
      cost.Count.FrameBuffer = fragments;
      break;
    case Design::MBuffer:
      cost.Sections = static_cast<std::int64_t>(pixels.Width) * pixels.Height + addressed;
      cost.Bytes = static_cast<double>(cost.Sections) * sectionBits / 8;
      break;
  }
  return cost;
}

//------------------------------------------------------------------------------
vtkStorageAccounting::Saving vtkStorageAccounting::GetSaving(Design design, Design other) const
{
  Saving sum;
  double frames = 0;
  for (std::size_t i = 0; i < this->Frames.size(); ++i)
  {
    const Cost one = this->GetCost(design, i);
    const Cost another = this->GetCost(other, i);
    if (one.Fragments > 0)
    {
      sum.Storage += 1 - one.Bytes / another.Bytes;
      sum.Accesses += 1 - static_cast<double>(one.Count.GetTotal()) / static_cast<double>(another.Count.GetTotal());
      ++frames;
    }
  }
  return frames > 0 ? Saving{ sum.Storage / frames, sum.Accesses / frames } : Saving();
}
VTK_ABI_NAMESPACE_END
