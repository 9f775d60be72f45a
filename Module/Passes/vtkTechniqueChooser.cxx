// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTechniqueChooser.h"

#include <algorithm>
#include <numeric>
#include <sstream>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
constexpr double MiB = 1024.0 * 1024.0;

double Median(const std::deque<double>& times)
{
  std::vector<double> sorted(times.begin(), times.end());
  const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
  std::nth_element(sorted.begin(), middle, sorted.end());
  return *middle;
}

std::string Text(double number, const char* unit)
{
  std::ostringstream out;
  out.precision(3);
  out << number << " " << unit;
  return out.str();
}
}

//------------------------------------------------------------------------------
vtkTechniqueChooser::vtkTechniqueChooser(const std::vector<Candidate>& candidates)
  : Candidates(candidates)
{
  this->SetBudget({});
}

//------------------------------------------------------------------------------
void vtkTechniqueChooser::SetBudget(const Budget& budget)
{
  this->Limits = budget;
  this->Chosen = -1;
  this->Reason.clear();
  this->Measurements.assign(this->Candidates.size(), {});
  this->Order.resize(this->Candidates.size());
  std::iota(this->Order.begin(), this->Order.end(), 0);
  std::stable_sort(this->Order.begin(), this->Order.end(),
    [this](int a, int b)
    {
      const Candidate& one = this->Candidates[a];
      const Candidate& other = this->Candidates[b];
      const bool oneIsGood = one.Error <= this->Limits.Tolerance;
      const bool otherIsGood = other.Error <= this->Limits.Tolerance;
      if (oneIsGood != otherIsGood)
      {
        return oneIsGood;
      }
      return oneIsGood ? one.RelativeTime < other.RelativeTime : one.Error < other.Error;
    });
}

//------------------------------------------------------------------------------
int vtkTechniqueChooser::Choose(const View& view)
{
  this->Seen = view;
  if (view.Changed || this->Chosen < 0)
  {
    this->Refused.assign(this->Candidates.size(), Refusal::None);
    this->Settled = false;
  }
  if (this->Chosen < 0)
  {
    this->Start();
    return this->Chosen;
  }
  std::string excess;
  const Refusal refusal = this->Settled ? Refusal::None : this->GetExcess(excess);
  if (refusal != Refusal::None)
  {
    this->Refused[this->Chosen] = refusal;
    this->StepDown(excess);
  }
  else if (!this->Settled)
  {
    this->StepUp();
  }
  return this->Chosen;
}

//------------------------------------------------------------------------------
void vtkTechniqueChooser::Observe(const Cost& cost)
{
  this->Last = cost;
  this->Fragments = cost.Fragments;
  if (this->Limits.Milliseconds > 0 && cost.Steady)
  {
    this->Times.push_back(cost.Milliseconds);
    if (this->Times.size() > MedianFrames)
    {
      this->Times.pop_front();
    }
    if (this->Times.size() == MedianFrames)
    {
      this->Measurements[this->Chosen] = { Median(this->Times), cost.Fragments };
    }
  }
}

//------------------------------------------------------------------------------
double vtkTechniqueChooser::GetBytes(int candidate, const View& view) const
{
  // Where none were counted yet, one a pixel: what lists make room for to begin with.
  const double fragments = this->Fragments < 0 ? view.Pixels : this->Fragments;
  const Candidate& one = this->Candidates[candidate];
  const double bytesPerSample = one.BytesPerSample + (view.Samples > 1 ? one.BytesOfSamples : 0);
  return one.BytesPerFragment * fragments + (one.BytesPerPixel + bytesPerSample * view.Samples) * view.Pixels;
}

//------------------------------------------------------------------------------
// In proportion to the fragments, if it was measured; else in proportion to the chosen one. 0 if nothing is known.
double vtkTechniqueChooser::GetMilliseconds(int candidate) const
{
  const Measured& own = this->Measurements[candidate];
  if (own.Milliseconds > 0)
  {
    return own.Fragments > 0 ? own.Milliseconds * this->Fragments / own.Fragments : own.Milliseconds;
  }
  const bool known = candidate != this->Chosen && this->Measurements[this->Chosen].Milliseconds > 0;
  return known ? this->GetMilliseconds(this->Chosen) * this->Candidates[candidate].RelativeTime /
      this->Candidates[this->Chosen].RelativeTime
               : 0;
}

//------------------------------------------------------------------------------
bool vtkTechniqueChooser::FitsMemory(int candidate, double margin) const
{
  return this->Refused[candidate] != Refusal::Memory &&
    (this->Limits.Mebibytes <= 0 || this->GetBytes(candidate, this->Seen) <= margin * this->Limits.Mebibytes * MiB);
}

//------------------------------------------------------------------------------
bool vtkTechniqueChooser::Promises(int candidate, double margin) const
{
  return this->Refused[candidate] == Refusal::None && this->FitsMemory(candidate, margin) &&
    (this->Limits.Milliseconds <= 0 || this->GetMilliseconds(candidate) <= margin * this->Limits.Milliseconds);
}

//------------------------------------------------------------------------------
vtkTechniqueChooser::Refusal vtkTechniqueChooser::GetExcess(std::string& what) const
{
  const std::string& name = this->Candidates[this->Chosen].Name;
  const std::string memory = "the memory budget of " + Text(this->Limits.Mebibytes, "MiB");
  if (this->Limits.Mebibytes > 0 && this->Last.Tiles > 1)
  {
    what = name + " took " + std::to_string(this->Last.Tiles) + " tiles to stay within " + memory;
    return Refusal::Memory;
  }
  if (this->Limits.Mebibytes > 0 && this->Last.Bytes > this->Limits.Mebibytes * MiB)
  {
    what = name + " took " + Text(this->Last.Bytes / MiB, "MiB") + ", over " + memory;
    return Refusal::Memory;
  }
  if (this->Limits.Milliseconds > 0 && this->Times.size() == MedianFrames &&
    Median(this->Times) > this->Limits.Milliseconds)
  {
    what = name + " took " + Text(Median(this->Times), "ms") + ", over the time budget of " +
      Text(this->Limits.Milliseconds, "ms");
    return Refusal::Time;
  }
  return Refusal::None;
}

//------------------------------------------------------------------------------
// Of several the best, or, while fragments are only guessed, the last one, whose memory does not depend on them.
int vtkTechniqueChooser::FindSmallest() const
{
  int smallest = this->Order.front();
  for (int candidate : this->Order)
  {
    const double bytes = this->GetBytes(candidate, this->Seen);
    const double least = this->GetBytes(smallest, this->Seen);
    if (bytes < least || (bytes == least && this->Fragments < 0))
    {
      smallest = candidate;
    }
  }
  return smallest;
}

//------------------------------------------------------------------------------
// What the budgets have to do with a candidate, with its numbers.
std::string vtkTechniqueChooser::Expect(int candidate) const
{
  std::string text;
  if (this->Limits.Mebibytes > 0)
  {
    text = Text(this->GetBytes(candidate, this->Seen) / MiB, "MiB") + " expected for a memory budget of " +
      Text(this->Limits.Mebibytes, "MiB");
  }
  if (this->Limits.Milliseconds > 0)
  {
    const double expected = this->GetMilliseconds(candidate);
    text += text.empty() ? "" : ", ";
    text += (expected > 0 ? Text(expected, "ms") + " expected" : "nothing measured yet") + " for a time budget of " +
      Text(this->Limits.Milliseconds, "ms");
  }
  return text.empty() ? "there is no budget" : text;
}

//------------------------------------------------------------------------------
void vtkTechniqueChooser::Take(int candidate)
{
  this->Chosen = candidate;
  this->Times.clear();
}

//------------------------------------------------------------------------------
void vtkTechniqueChooser::Start()
{
  for (int candidate : this->Order)
  {
    if (this->FitsMemory(candidate, 1))
    {
      this->Take(candidate);
      const bool good = this->Candidates[candidate].Error <= this->Limits.Tolerance && this->Limits.Tolerance > 0;
      this->Reason =
        (good ? "the fastest within the tolerance of " + Text(this->Limits.Tolerance, "RMSE") : "the best") +
        " that may fit: " + this->Expect(candidate);
      return;
    }
  }
  this->Take(this->FindSmallest());
  this->Reason = "nothing fits, this takes the least memory: " + this->Expect(this->Chosen);
}

//------------------------------------------------------------------------------
void vtkTechniqueChooser::StepDown(const std::string& excess)
{
  bool later = false; // than the chosen one
  for (int candidate : this->Order)
  {
    later = later || candidate == this->Chosen;
    if (this->Promises(candidate, later ? 1 : Margin))
    {
      this->Reason = excess + "; the next one: " + this->Expect(candidate);
      this->Take(candidate);
      return;
    }
  }
  int fastest = -1;
  for (int candidate : this->Order)
  {
    if (this->FitsMemory(candidate, 1) &&
      (fastest < 0 || this->GetMilliseconds(candidate) < this->GetMilliseconds(fastest)))
    {
      fastest = candidate;
    }
  }
  if (fastest < 0)
  {
    const int smallest = this->FindSmallest();
    this->Reason = excess + "; nothing fits, this takes the least memory: " + this->Expect(smallest);
    this->Take(smallest);
    this->Settled = true;
    return;
  }
  // Quality is not given up for hardly any time; and it takes less to stay than to return.
  later = false;
  int next = fastest;
  for (int candidate : this->Order)
  {
    later = later || candidate == this->Chosen;
    const double slower = later ? 1 / Margin : (1 + 1 / Margin) / 2;
    if (this->FitsMemory(candidate, 1) && this->GetMilliseconds(candidate) <= slower * this->GetMilliseconds(fastest))
    {
      next = candidate;
      break;
    }
  }
  this->Settled = this->Refused[next] != Refusal::None;
  this->Reason = excess + "; no technique is expected to fit, the best of the fast ones: " + this->Expect(next);
  if (next != this->Chosen)
  {
    this->Take(next);
  }
}

//------------------------------------------------------------------------------
void vtkTechniqueChooser::StepUp()
{
  if (this->Limits.Milliseconds > 0 && this->Times.size() < MedianFrames)
  {
    return;
  }
  for (int candidate : this->Order)
  {
    if (candidate == this->Chosen)
    {
      return;
    }
    if (this->Promises(candidate, Margin))
    {
      this->Reason = "better than " + this->Candidates[this->Chosen].Name + ", and it fits: " + this->Expect(candidate);
      this->Take(candidate);
      return;
    }
  }
}
VTK_ABI_NAMESPACE_END
