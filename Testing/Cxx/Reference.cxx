// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Reference.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

namespace Reference
{
//------------------------------------------------------------------------------
Color Pixel::Over(const Color& opaque) const
{
  Color result;
  for (std::size_t c = 0; c < 3; ++c)
  {
    result[c] = this->Rgb[c] + this->Transmittance * opaque[c];
  }
  return result;
}

//------------------------------------------------------------------------------
VisibilityFunction::VisibilityFunction(int nodeCount, Removal removal, bool corrected, std::vector<Node> nodes)
  : NodeCount(static_cast<std::size_t>(nodeCount))
  , Rule(removal)
  , Corrected(corrected)
  , Nodes(std::move(nodes))
{
}

//------------------------------------------------------------------------------
double VisibilityFunction::AfterNodes(std::size_t count) const
{
  return count == 0 ? 1 : this->Nodes[count - 1].Transmittance;
}

//------------------------------------------------------------------------------
void VisibilityFunction::Insert(double depth, double alpha)
{
  const auto at = std::upper_bound(
    this->Nodes.begin(), this->Nodes.end(), depth, [](double z, const Node& node) { return z < node.Depth; });
  const std::size_t index = static_cast<std::size_t>(at - this->Nodes.begin());
  this->Nearest = std::min(this->Nearest, depth);
  this->Farthest = std::max(this->Farthest, depth);
  this->Nodes.insert(at, { depth, this->AfterNodes(index) });
  for (std::size_t behind = index; behind < this->Nodes.size(); ++behind)
  {
    this->Nodes[behind].Transmittance *= 1 - alpha;
  }
  if (this->Nodes.size() > this->NodeCount)
  {
    this->RemoveOne();
  }
}

//------------------------------------------------------------------------------
void VisibilityFunction::RemoveOne()
{
  const std::size_t last = this->Nodes.size() - 1;
  const double wider = this->Corrected ? (this->Nodes[last].Depth - this->Nodes[0].Depth) / 256 : 0;
  double least = std::numeric_limits<double>::infinity();
  double area = 0;
  std::size_t removed = 0;
  bool lowersPrevious = false;
  const auto consider = [&](double step, double width, std::size_t node, bool lowers)
  {
    const double loss = step * (width + wider);
    if (loss < least)
    {
      least = loss;
      area = step * width;
      removed = node;
      lowersPrevious = lowers;
    }
  };
  for (std::size_t j = 0; j <= last; ++j)
  {
    const double step = this->AfterNodes(j) - this->Nodes[j].Transmittance;
    if (this->Rule != Removal::Overestimate && j > 0)
    {
      consider(step, this->Nodes[j].Depth - this->Nodes[j - 1].Depth, j, true);
    }
    if (this->Rule != Removal::Underestimate && j < last)
    {
      consider(step, this->Nodes[j + 1].Depth - this->Nodes[j].Depth, j, false);
    }
  }
  this->Lost += area;
  if (lowersPrevious)
  {
    this->Nodes[removed - 1].Transmittance = this->Nodes[removed].Transmittance;
  }
  this->Nodes.erase(this->Nodes.begin() + static_cast<std::ptrdiff_t>(removed));
}

//------------------------------------------------------------------------------
void VisibilityFunction::RoundTransmittances(double levels)
{
  for (Node& node : this->Nodes)
  {
    node.Transmittance = std::round(levels * node.Transmittance) / levels;
  }
}

//------------------------------------------------------------------------------
double VisibilityFunction::EstimateError() const
{
  return this->Lost > 0 ? std::min(1.0, this->Lost / (this->Farthest - this->Nearest)) : 0;
}

//------------------------------------------------------------------------------
double VisibilityFunction::Before(double depth) const
{
  std::size_t nearer = 0;
  while (nearer < this->Nodes.size() && this->Nodes[nearer].Depth < depth)
  {
    ++nearer;
  }
  return this->AfterNodes(nearer);
}

//------------------------------------------------------------------------------
double VisibilityFunction::BeforeNext(double depth)
{
  return this->AfterNodes(this->PassNext(depth).first);
}

//------------------------------------------------------------------------------
double VisibilityFunction::MeanBeforeNext(double depth, double alpha)
{
  const auto [inFront, hasNode] = this->PassNext(depth);
  return hasNode || inFront == 0 ? this->AfterNodes(inFront)
                                 : MeanOf(this->AfterNodes(inFront - 1), this->AfterNodes(inFront), alpha);
}

//------------------------------------------------------------------------------
double MeanOf(double before, double behind, double alpha)
{
  const double withoutItself = alpha < 1 ? behind / (1 - alpha) : 0;
  return std::min(std::max(std::sqrt(before * behind), withoutItself), before);
}

//------------------------------------------------------------------------------
// How many nodes are in front of the next fragment of a depth, and whether another one has that depth.
std::pair<std::size_t, bool> VisibilityFunction::PassNext(double depth)
{
  std::size_t inFront = 0;
  bool hasNode = false;
  std::size_t passed = this->Asked[depth]++;
  for (const Node& node : this->Nodes)
  {
    if (node.Depth < depth)
    {
      ++inFront;
    }
    else if (node.Depth == depth && passed > 0)
    {
      ++inFront;
      --passed;
    }
    else if (node.Depth == depth)
    {
      hasNode = true;
    }
  }
  return { inFront, hasNode };
}

//------------------------------------------------------------------------------
Pixel CompositeExact(std::vector<Fragment> fragments)
{
  // Stable: of equal depths, the one drawn first is blended first, and so is behind.
  std::stable_sort(
    fragments.begin(), fragments.end(), [](const Fragment& a, const Fragment& b) { return a.Depth > b.Depth; });
  Pixel pixel;
  for (const Fragment& fragment : fragments)
  {
    for (std::size_t c = 0; c < 3; ++c)
    {
      pixel.Rgb[c] = fragment.Alpha * fragment.Rgb[c] + (1 - fragment.Alpha) * pixel.Rgb[c];
    }
    pixel.Transmittance *= 1 - fragment.Alpha;
  }
  return pixel;
}

//------------------------------------------------------------------------------
Pixel CompositeIterative(const std::vector<Fragment>& fragments)
{
  Pixel pixel;
  for (std::size_t i = 0; i < fragments.size(); ++i)
  {
    double visibility = 1;
    for (std::size_t j = 0; j < fragments.size(); ++j)
    {
      const bool inFront =
        fragments[j].Depth < fragments[i].Depth || (fragments[j].Depth == fragments[i].Depth && j > i);
      visibility *= inFront ? 1 - fragments[j].Alpha : 1;
    }
    for (std::size_t c = 0; c < 3; ++c)
    {
      pixel.Rgb[c] += visibility * fragments[i].Alpha * fragments[i].Rgb[c];
    }
    pixel.Transmittance *= 1 - fragments[i].Alpha;
  }
  return pixel;
}

//------------------------------------------------------------------------------
static void Correct(Pixel& pixel, double weights)
{
  for (double& channel : pixel.Rgb)
  {
    channel *= weights > 0 ? (1 - pixel.Transmittance) / weights : 1;
  }
}

//------------------------------------------------------------------------------
Pixel CompositeAdaptive(
  const std::vector<Fragment>& fragments, int nodeCount, Removal removal, bool corrected, double levels)
{
  VisibilityFunction visibility(nodeCount, removal, corrected);
  for (auto fragment = fragments.rbegin(); fragment != fragments.rend(); ++fragment)
  {
    visibility.Insert(fragment->Depth, fragment->Alpha);
    if (levels > 0)
    {
      visibility.RoundTransmittances(levels);
    }
  }
  const bool correct = corrected && fragments.size() > static_cast<std::size_t>(nodeCount);
  const bool byMeans = correct && removal == Removal::Underestimate;
  Pixel pixel;
  double weights = 0;
  for (auto fragment = fragments.rbegin(); fragment != fragments.rend(); ++fragment)
  {
    const double before =
      byMeans ? visibility.MeanBeforeNext(fragment->Depth, fragment->Alpha) : visibility.BeforeNext(fragment->Depth);
    const double weight = before * fragment->Alpha;
    for (std::size_t c = 0; c < 3; ++c)
    {
      pixel.Rgb[c] += weight * fragment->Rgb[c];
    }
    weights += weight;
    pixel.Transmittance *= 1 - fragment->Alpha;
  }
  if (correct)
  {
    Correct(pixel, weights);
  }
  return pixel;
}

//------------------------------------------------------------------------------
Pixel CompositeToTolerance(
  const std::vector<Fragment>& fragments, int nodeCount, Removal removal, double tolerance, int* nodes)
{
  constexpr int mostNodes = 64;
  std::set<double> depths;
  for (const Fragment& fragment : fragments)
  {
    depths.insert(fragment.Depth);
  }
  for (int count = nodeCount; depths.size() == fragments.size(); count = std::min(2 * count, mostNodes))
  {
    VisibilityFunction visibility(count, removal);
    for (auto fragment = fragments.rbegin(); fragment != fragments.rend(); ++fragment)
    {
      visibility.Insert(fragment->Depth, fragment->Alpha);
    }
    if (visibility.EstimateError() <= tolerance)
    {
      if (nodes)
      {
        *nodes = static_cast<int>(visibility.GetNodes().size());
      }
      return CompositeAdaptive(fragments, count, removal);
    }
    if (count == mostNodes)
    {
      break;
    }
  }
  if (nodes)
  {
    *nodes = mostNodes;
  }
  return CompositeExact(fragments);
}

//------------------------------------------------------------------------------
static Pixel RoundToBytes(const Pixel& content)
{
  const auto rounded = [](double value) { return std::round(255 * std::min(value, 1.0)) / 255; };
  const double opacity = 1 - content.Transmittance;
  Pixel pixel;
  pixel.Transmittance = 1 - rounded(opacity);
  for (std::size_t c = 0; c < 3; ++c)
  {
    pixel.Rgb[c] = opacity > 0 ? rounded(opacity) * rounded(content.Rgb[c] / opacity) : 0;
  }
  return pixel;
}

//------------------------------------------------------------------------------
Pixel CompositeLayers(const std::vector<Fragment>& fragments, int layers, Tail tail, bool bytes)
{
  struct Layer
  {
    double Depth;
    Pixel Content;
  };
  const auto addBehind = [](Pixel& front, const Pixel& back)
  {
    for (std::size_t c = 0; c < 3; ++c)
    {
      front.Rgb[c] += front.Transmittance * back.Rgb[c];
    }
    front.Transmittance *= back.Transmittance;
  };
  std::vector<Layer> kept; // front to back
  Pixel averaged;
  double opacities = 0;
  for (const Fragment& fragment : fragments)
  {
    const auto place =
      std::find_if(kept.begin(), kept.end(), [&](const Layer& layer) { return fragment.Depth <= layer.Depth; });
    const Pixel content = CompositeExact({ fragment });
    kept.insert(place, { fragment.Depth, bytes ? RoundToBytes(content) : content });
    if (static_cast<int>(kept.size()) <= layers)
    {
      continue;
    }
    const Pixel last = kept.back().Content;
    kept.pop_back();
    if (tail == Tail::Merge)
    {
      Pixel& merged = kept.back().Content;
      addBehind(merged, last);
      merged = bytes ? RoundToBytes(merged) : merged;
    }
    else if (tail == Tail::Average)
    {
      for (std::size_t c = 0; c < 3; ++c)
      {
        averaged.Rgb[c] += last.Rgb[c];
      }
      averaged.Transmittance *= last.Transmittance;
      opacities += 1 - last.Transmittance;
    }
  }
  Pixel pixel;
  for (const Layer& layer : kept)
  {
    addBehind(pixel, layer.Content);
  }
  for (double& channel : averaged.Rgb)
  {
    channel *= opacities > 0 ? (1 - averaged.Transmittance) / opacities : 0;
  }
  addBehind(pixel, averaged);
  return pixel;
}

//------------------------------------------------------------------------------
Pixel CompositeWeightedSum(const std::vector<Fragment>& fragments)
{
  Pixel pixel;
  for (const Fragment& fragment : fragments)
  {
    for (std::size_t c = 0; c < 3; ++c)
    {
      pixel.Rgb[c] += fragment.Alpha * fragment.Rgb[c];
    }
    pixel.Transmittance -= fragment.Alpha;
  }
  pixel.Transmittance = std::max(0.0, pixel.Transmittance);
  return pixel;
}

//------------------------------------------------------------------------------
Pixel CompositeWeightedAverage(const std::vector<Fragment>& fragments)
{
  Pixel pixel;
  double opacities = 0;
  for (const Fragment& fragment : fragments)
  {
    opacities += fragment.Alpha;
  }
  const auto count = static_cast<double>(fragments.size());
  pixel.Transmittance = fragments.empty() ? 1 : std::pow(1 - opacities / count, count);
  for (const Fragment& fragment : fragments)
  {
    for (std::size_t c = 0; c < 3; ++c)
    {
      pixel.Rgb[c] += (1 - pixel.Transmittance) * fragment.Alpha / opacities * fragment.Rgb[c];
    }
  }
  return pixel;
}

//------------------------------------------------------------------------------
Pixel CompositeWeightedBlended(const std::vector<Fragment>& fragments, const std::function<double(double)>& weight)
{
  Pixel pixel;
  double weights = 0;
  for (const Fragment& fragment : fragments)
  {
    const double weighted = weight(fragment.Depth) * fragment.Alpha;
    weights += weighted;
    pixel.Transmittance *= 1 - fragment.Alpha;
    for (std::size_t c = 0; c < 3; ++c)
    {
      pixel.Rgb[c] += weighted * fragment.Rgb[c];
    }
  }
  for (double& channel : pixel.Rgb)
  {
    channel *= weights > 0 ? (1 - pixel.Transmittance) / weights : 0;
  }
  return pixel;
}

//------------------------------------------------------------------------------
double FourierShare(int coefficients, double at, double before)
{
  const double pi = std::acos(-1.0);
  const double margin = 0.5 / (coefficients + 1);
  const double from = margin + (1 - 2 * margin) * at;
  const double to = margin + (1 - 2 * margin) * before;
  double share = to;
  for (int k = 1; k <= coefficients; ++k)
  {
    // The integral of 2 cos(2 pi k (x - from)) from 0 to `to`.
    share += (std::sin(2 * pi * k * (to - from)) + std::sin(2 * pi * k * from)) / (pi * k);
  }
  return share;
}

//------------------------------------------------------------------------------
double SliceShare(int slices, double at, double before)
{
  const double slice = std::min(std::floor(slices * at), slices - 1.0);
  return std::clamp(slices * before - slice, 0.0, 1.0);
}

//------------------------------------------------------------------------------
double WaveletShare(int rank, double at, double before)
{
  const int intervals = 2 << rank;
  // Of the step at `at`, over an interval.
  const auto mean = [=](int interval) { return std::clamp(interval + 1 - intervals * at, 0.0, 1.0); };
  const double fromMiddle = intervals * before - 0.5; // of the first one
  if (fromMiddle < 0)
  {
    return 2 * intervals * before * mean(0);
  }
  const int interval = static_cast<int>(fromMiddle);
  const double passed = fromMiddle - interval;
  return (1 - passed) * mean(interval) + passed * mean(std::min(interval + 1, intervals - 1));
}

//------------------------------------------------------------------------------
Visibilities VisibilitiesOf(const Share& share)
{
  return [share](const std::vector<double>& depths, const std::vector<double>& alphas)
  {
    std::vector<double> visibilities;
    for (std::size_t i = 0; i < depths.size(); ++i)
    {
      double inFront = 0;
      for (std::size_t j = 0; j < depths.size(); ++j)
      {
        const double absorbance = -std::log(std::max(1 - alphas[j], 1.0 / 1024));
        inFront += j == i ? 0 : absorbance * share(depths[j], depths[i]);
      }
      visibilities.push_back(std::exp(-std::max(inFront, 0.0)));
    }
    return visibilities;
  };
}

//------------------------------------------------------------------------------
Pixel CompositeAbsorbance(const std::vector<Fragment>& fragments, const Visibilities& visibilities,
  const std::vector<double>& range, bool corrected)
{
  double nearest = range.empty() ? 1 : range.front();
  double farthest = range.empty() ? 0 : range.back();
  for (const Fragment& fragment : fragments)
  {
    nearest = range.empty() ? std::min(nearest, fragment.Depth) : nearest;
    farthest = range.empty() ? std::max(farthest, fragment.Depth) : farthest;
  }
  std::vector<double> depths;
  std::vector<double> alphas;
  for (const Fragment& fragment : fragments)
  {
    depths.push_back(farthest > nearest ? (fragment.Depth - nearest) / (farthest - nearest) : 0.5);
    alphas.push_back(fragment.Alpha);
  }
  const std::vector<double> seen = visibilities(depths, alphas);

  Pixel pixel;
  double weights = 0;
  for (std::size_t i = 0; i < fragments.size(); ++i)
  {
    const double weight = seen[i] * fragments[i].Alpha;
    for (std::size_t c = 0; c < 3; ++c)
    {
      pixel.Rgb[c] += weight * fragments[i].Rgb[c];
    }
    weights += weight;
    pixel.Transmittance *= 1 - fragments[i].Alpha;
  }
  if (corrected)
  {
    Correct(pixel, weights);
  }
  return pixel;
}
}
