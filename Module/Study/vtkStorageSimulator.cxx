// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkStorageSimulator.h"

#include <algorithm>
#include <limits>
#include <memory>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
using Accounting = vtkStorageAccounting;
using Fragment = vtkStorageSimulator::Fragment;

// What every design does with a frame.
class Storage
{
public:
  Storage(const Accounting::Layout& layout, vtkStorageSimulator::Result& result)
    : Built(layout)
    , Given(result)
    , PixelCount(static_cast<std::size_t>(layout.Width) * layout.Height)
  {
  }
  virtual ~Storage() = default;
  Storage(const Storage&) = delete;
  Storage& operator=(const Storage&) = delete;

  virtual void Store(const Fragment& fragment) = 0;
  virtual void ReadAll() = 0;

  double GetBytes() const { return this->Bits / 8; }

protected:
  void GiveOut(double count, double bits) { this->Bits += count * bits; }
  double GetFragmentBits() const { return this->Built.Bits.Depth + this->Built.Bits.Color; }
  std::size_t PixelOf(const Fragment& fragment) const
  {
    return static_cast<std::size_t>(fragment.Y) * this->Built.Width + fragment.X;
  }

  // Addresses are numbers of sections from 1 on; 0 is none.
  void CheckAddress(std::size_t address)
  {
    if (this->Built.Bits.Address < 63 && address >> this->Built.Bits.Address != 0)
    {
      this->Given.Error = "section " + std::to_string(address) + " has no address, expected more than " +
        std::to_string(this->Built.Bits.Address) + " bits for it";
    }
  }

  const Accounting::Layout& Built;
  vtkStorageSimulator::Result& Given;
  const std::size_t PixelCount;

private:
  double Bits = 0;
};

// A node is a section of one fragment, that is put before those of its pixel.
class LinkedList : public Storage
{
public:
  LinkedList(const Accounting::Layout& layout, vtkStorageSimulator::Result& result)
    : Storage(layout, result)
    , Heads(this->PixelCount, 0)
  {
    this->GiveOut(static_cast<double>(this->PixelCount), layout.Bits.Address);
  }

  void Store(const Fragment& fragment) override
  {
    std::size_t& head = this->Heads[this->PixelOf(fragment)];
    this->Nodes.push_back({ fragment, head });
    head = this->Nodes.size();
    this->CheckAddress(head);
    this->GiveOut(1, this->GetFragmentBits() + this->Built.Bits.Address);
    ++this->Given.Cost.Sections;
    ++this->Given.Cost.Count.Stores;
  }

  void ReadAll() override
  {
    for (const std::size_t head : this->Heads)
    {
      this->Given.Cost.Count.Table += head == 0 ? 0 : 1;
      for (std::size_t address = head; address != 0; address = this->Nodes[address - 1].Next)
      {
        this->Given.Read.push_back(this->Nodes[address - 1].Kept);
        ++this->Given.Cost.Count.Reads;
      }
    }
  }

private:
  struct Node
  {
    Fragment Kept;
    std::size_t Next;
  };
  std::vector<std::size_t> Heads;
  std::vector<Node> Nodes;
};

// Sections of several fragments, and the address of the next one of each.
class Sections : public Storage
{
protected:
  using Storage::Storage;

  std::size_t AddSection()
  {
    this->Kept.emplace_back();
    this->NextSection.push_back(0);
    this->GiveOut(
      1, static_cast<double>(this->Built.SectionLength) * this->GetFragmentBits() + this->Built.Bits.Address);
    ++this->Given.Cost.Sections;
    return this->Kept.size() - 1;
  }

  bool IsFull(std::size_t section) const
  {
    return static_cast<std::int64_t>(this->Kept[section].size()) == this->Built.SectionLength;
  }

  void Put(std::size_t section, const Fragment& fragment)
  {
    this->Kept[section].push_back(fragment);
    ++this->Given.Cost.Count.Stores;
  }

  void ReadSection(std::size_t section)
  {
    for (const Fragment& fragment : this->Kept[section])
    {
      this->Given.Read.push_back(fragment);
      ++this->Given.Cost.Count.Reads;
    }
  }

  std::vector<std::vector<Fragment>> Kept;
  std::vector<std::size_t> NextSection; // addresses
};

// Section 3.2: the start-section table, the next-section table, and sections that any pixel can have.
class TBuffer : public Sections
{
public:
  TBuffer(const Accounting::Layout& layout, vtkStorageSimulator::Result& result)
    : Sections(layout, result)
    , StartSection(this->PixelCount, 0)
    , LastSection(this->PixelCount, 0)
  {
    this->GiveOut(static_cast<double>(this->PixelCount), layout.Bits.Address);
  }

  void Store(const Fragment& fragment) override
  {
    const std::size_t pixel = this->PixelOf(fragment);
    std::size_t& last = this->LastSection[pixel];
    if (last == 0 || this->IsFull(last - 1))
    {
      const std::size_t address = this->AddSection() + 1;
      this->CheckAddress(address);
      (last == 0 ? this->StartSection[pixel] : this->NextSection[last - 1]) = address;
      last = address;
    }
    this->Put(last - 1, fragment);
  }

  void ReadAll() override
  {
    for (const std::size_t start : this->StartSection)
    {
      this->Given.Cost.Count.Table += start == 0 ? 0 : 1;
      for (std::size_t address = start; address != 0; address = this->NextSection[address - 1])
      {
        this->ReadSection(address - 1);
      }
    }
  }

private:
  std::vector<std::size_t> StartSection; // addresses
  std::vector<std::size_t> LastSection;  // the simulator's, which the tables would lead to, section by section
};

// Section 2.3.2: pixel i has section i; further sections lie behind those of all pixels, and pointers count from there.
class MBuffer : public Sections
{
public:
  MBuffer(const Accounting::Layout& layout, vtkStorageSimulator::Result& result)
    : Sections(layout, result)
    , LastSection(this->PixelCount)
  {
    for (std::size_t& last : this->LastSection)
    {
      last = this->AddSection();
    }
  }

  void Store(const Fragment& fragment) override
  {
    std::size_t& last = this->LastSection[this->PixelOf(fragment)];
    if (this->IsFull(last))
    {
      const std::size_t section = this->AddSection();
      const std::size_t address = section - this->PixelCount + 1;
      this->CheckAddress(address);
      this->NextSection[last] = address;
      last = section;
    }
    this->Put(last, fragment);
  }

  void ReadAll() override
  {
    for (std::size_t pixel = 0; pixel < this->PixelCount; ++pixel)
    {
      std::size_t section = pixel;
      this->ReadSection(section);
      while (this->NextSection[section] != 0)
      {
        section = this->PixelCount + this->NextSection[section] - 1;
        this->ReadSection(section);
      }
    }
  }

private:
  std::vector<std::size_t> LastSection; // sections, not addresses; the simulator's, as above
};

// Section 2.3.1: what is read from the FIFO is either its pixel's farthest fragment, and blended, or goes into the FIFO
// again. The depth of the farthest is known when a pass begins, and that of the next one when it ends: the two depth
// buffers of the hardware change their roles. The first is the one that every design has; to begin with it holds what
// was the farthest when fragments were stored.
class RBuffer : public Storage
{
public:
  RBuffer(const Accounting::Layout& layout, vtkStorageSimulator::Result& result)
    : Storage(layout, result)
    , Farthest(this->PixelCount, Nothing)
    , SecondDepth(this->PixelCount, Nothing)
    , States(this->PixelCount, State::Waiting)
  {
    this->GiveOut(static_cast<double>(this->PixelCount), layout.Bits.Depth);
    this->GiveOut(static_cast<double>(this->PixelCount), layout.Bits.State);
  }

  void Store(const Fragment& fragment) override
  {
    float& farthest = this->Farthest[this->PixelOf(fragment)];
    farthest = std::max(farthest, fragment.Depth);
    this->Fifo.push_back(fragment);
    this->GiveOut(1, this->GetFragmentBits() + 2 * this->Built.Bits.Coordinate);
    ++this->Given.Cost.Count.Stores;
  }

  void ReadAll() override
  {
    while (!this->Fifo.empty())
    {
      this->Pass();
    }
  }

private:
  enum class State : unsigned char
  {
    Waiting,
    Left // its farthest fragment, in this pass
  };

  void Pass()
  {
    Accounting::Accesses& count = this->Given.Cost.Count;
    auto back = this->Fifo.begin(); // where what goes in again is put: behind it is what was not read yet
    for (const Fragment& fragment : this->Fifo)
    {
      const std::size_t pixel = this->PixelOf(fragment);
      ++count.Reads;
      ++count.SecondDepth;
      if (this->States[pixel] == State::Waiting && fragment.Depth == this->Farthest[pixel])
      {
        this->States[pixel] = State::Left;
        this->Given.Read.push_back(fragment);
        ++count.FrameBuffer;
      }
      else
      {
        this->SecondDepth[pixel] = std::max(this->SecondDepth[pixel], fragment.Depth);
        *back++ = fragment;
      }
    }
    this->Fifo.erase(back, this->Fifo.end());
    std::swap(this->Farthest, this->SecondDepth);
    std::fill(this->SecondDepth.begin(), this->SecondDepth.end(), Nothing);
    std::fill(this->States.begin(), this->States.end(), State::Waiting);
  }

  static constexpr float Nothing = -std::numeric_limits<float>::infinity();

  std::vector<Fragment> Fifo;
  std::vector<float> Farthest;
  std::vector<float> SecondDepth;
  std::vector<State> States;
};

std::unique_ptr<Storage> NewStorage(const Accounting::Layout& layout, vtkStorageSimulator::Result& result)
{
  switch (layout.Kind)
  {
    case Accounting::Design::LinkedList:
      return std::make_unique<LinkedList>(layout, result);
    case Accounting::Design::TBuffer:
      return std::make_unique<TBuffer>(layout, result);
    case Accounting::Design::RBuffer:
      return std::make_unique<RBuffer>(layout, result);
    case Accounting::Design::MBuffer:
      break;
  }
  return std::make_unique<MBuffer>(layout, result);
}
}

//------------------------------------------------------------------------------
vtkStorageSimulator::Result vtkStorageSimulator::Run(
  const Accounting::Layout& layout, const std::vector<Fragment>& fragments)
{
  Result result;
  const auto storage = NewStorage(layout, result);
  for (std::size_t i = 0; i < fragments.size() && result.Error.empty(); ++i)
  {
    const Fragment& fragment = fragments[i];
    const bool inside = fragment.X >= 0 && fragment.X < layout.Width && fragment.Y >= 0 && fragment.Y < layout.Height;
    if (!inside || !(fragment.Depth >= 0 && fragment.Depth <= 1))
    {
      result.Error = "fragment " + std::to_string(i) + " is at " + std::to_string(fragment.X) + ", " +
        std::to_string(fragment.Y) + " and depth " + std::to_string(fragment.Depth) + ", expected a pixel of " +
        std::to_string(layout.Width) + "x" + std::to_string(layout.Height) + " and a depth of 0 to 1";
      break;
    }
    storage->Store(fragment);
    ++result.Cost.Fragments;
  }
  if (result.Error.empty())
  {
    storage->ReadAll();
    result.Cost.Bytes = storage->GetBytes();
  }
  return result;
}

//------------------------------------------------------------------------------
vtkStorageAccounting::Histogram vtkStorageSimulator::Count(
  int width, int height, const std::vector<Fragment>& fragments)
{
  std::vector<std::int64_t> depths(static_cast<std::size_t>(width) * height, 0);
  for (const Fragment& fragment : fragments)
  {
    ++depths[static_cast<std::size_t>(fragment.Y) * width + fragment.X];
  }
  Accounting::Histogram histogram{ width, height, {} };
  for (const std::int64_t depth : depths)
  {
    if (depth > 0)
    {
      ++histogram.Pixels[depth];
    }
  }
  return histogram;
}
VTK_ABI_NAMESPACE_END
