// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What a pixel's colour should be, computed on the CPU in double precision, straight from Salvi et al. 2011, "Adaptive
 * Transparency". Written for being easily checked against the paper; shares nothing with the shaders that it judges.
 *
 * Fragments are given in the order in which they are drawn. Of two fragments of equal depth, the one drawn later is in
 * front.
 */
#ifndef Reference_h
#define Reference_h

#include <array>
#include <functional>
#include <map>
#include <utility>
#include <vector>

namespace Reference
{
using Color = std::array<double, 3>;

struct Fragment
{
  double Depth;
  Color Rgb; // not multiplied by Alpha
  double Alpha;
};

struct Pixel
{
  Color Rgb{ { 0, 0, 0 } }; // multiplied by what hides it; to be added to Transmittance times what lies behind
  double Transmittance = 1;

  /// The pixel in front of something opaque.
  Color Over(const Color& opaque) const;
};

enum class Removal
{
  Underestimate,
  Overestimate,
  Mixed
};

struct Node
{
  double Depth;
  double Transmittance; // behind Depth, up to the next node
};

/**
 * vis(z) of section 3: a step function of at most NodeCount nodes, front to back.
 */
class VisibilityFunction
{
public:
  /// Corrected: as with alpha correction, each rectangle that a removal may lose counts as wider by 1/256 of the
  /// distance from the first node to the last.
  VisibilityFunction(int nodeCount, Removal removal, bool corrected = true, std::vector<Node> nodes = {});

  /// Multiplies with the step of a fragment (Eq. 5), behind the nodes of the same depth; removes a node (Eq. 7) if
  /// there are then too many.
  void Insert(double depth, double alpha);

  /// Rounds the nodes' transmittances to multiples of 1 / levels.
  void RoundTransmittances(double levels);

  /// The transmittance before all nodes at this depth or farther (Eq. 6).
  double Before(double depth) const;

  /// As Before, for the fragments of one depth one after the other in the order of their insertion: each but the first
  /// has a node of that depth more in front of it.
  double BeforeNext(double depth);

  /// As BeforeNext, but for a fragment without a node of its own: the geometric mean of the transmittances before and
  /// behind the node in front of it, but no less than behind it without the fragment itself, and no more than before
  /// it.
  double MeanBeforeNext(double depth, double alpha);

  /// The areas that removals have lost, over the distance between the nearest and the farthest fragment inserted; at
  /// most 1.
  double EstimateError() const;

  const std::vector<Node>& GetNodes() const { return this->Nodes; }

private:
  void RemoveOne();
  double AfterNodes(std::size_t count) const;
  std::pair<std::size_t, bool> PassNext(double depth);

  std::size_t NodeCount;
  Removal Rule;
  bool Corrected;
  std::vector<Node> Nodes;
  double Lost = 0;
  double Nearest = 1;
  double Farthest = 0;
  std::map<double, std::size_t> Asked; // fragments of a depth that BeforeNext has answered
};

/// What a fragment of that opacity is seen through that is one of several without an order, from the transmittances
/// before and behind them.
double MeanOf(double before, double behind, double alpha);

/// Eq. 3: sort back to front, then blend one over the other.
Pixel CompositeExact(std::vector<Fragment> fragments);

/// Eq. 2 and 4: weight each with the product of what all in front of it let through.
Pixel CompositeIterative(const std::vector<Fragment>& fragments);

/// How much of the absorbance at one relative depth, 0 to 1, is taken to be in front of another.
using Share = std::function<double(double at, double before)>;

/// The integral of a peak's Fourier series of so many pairs (Jansen and Bavoil 2010), with a margin of half a period of
/// the next pair at both ends.
double FourierShare(int coefficients, double at, double before);

/// All, if the peak's slice lies before; within it, the part of the slice that does (Kim and Neumann 2001).
double SliceShare(int slices, double at, double before);

/// Interpolated between a step's means over 2^(rank + 1) intervals, from middle to middle, and from 0 at 0
/// (Aizenshtein, Smal, McGuire 2021, 2.3).
double WaveletShare(int rank, double at, double before);

/// The visibility of each of a pixel's fragments, from their relative depths and their opacities.
using Visibilities =
  std::function<std::vector<double>(const std::vector<double>& depths, const std::vector<double>& alphas)>;

/// By the absorbance of all other fragments, each by its share.
Visibilities VisibilitiesOf(const Share& share);

/// Eq. 2 with these visibilities. Depths are relative to a range, or to that of the fragments if it is empty.
/// Corrected: scaled so that the weights add up to what is hidden.
Pixel CompositeAbsorbance(const std::vector<Fragment>& fragments, const Visibilities& visibilities,
  const std::vector<double>& range, bool corrected);

/// Eq. 2 with the compressed visibility of section 3, into which the fragment drawn last is inserted first. Corrected:
/// if there are more fragments than nodes, by means if the rule is Underestimate, and scaled so that the weights add up
/// to what is hidden. levels, if not 0, rounds transmittances after each insertion to multiples of 1 / levels.
Pixel CompositeAdaptive(
  const std::vector<Fragment>& fragments, int nodeCount, Removal removal, bool corrected = true, double levels = 0);

/// The same for those fragments and with the number of nodes, of that many and twice as many each time up to 64, with
/// which the estimated error is no more than tolerance; exactly where there is none, or where fragments coincide.
/// nodes, if not null, becomes that number, or 64 for exactly.
Pixel CompositeToTolerance(
  const std::vector<Fragment>& fragments, int nodeCount, Removal removal, double tolerance, int* nodes = nullptr);

enum class Tail
{
  Merge,
  Drop,
  Average
};

/// The nearest fragments exactly, of each moment of the drawing; what was too much then is merged into the farthest of
/// them (Salvi and Vaidyanathan 2014), dropped (Bavoil et al. 2007) or averaged (Maule et al. 2013). In bytes, a
/// layer's colour and opacity are rounded to 1/255 when it comes, and when it is merged.
Pixel CompositeLayers(const std::vector<Fragment>& fragments, int layers, Tail tail, bool bytes = false);

/// Meshkin 2007: sums, of which the transmittance can't be less than 0 in a framebuffer of bytes.
Pixel CompositeWeightedSum(const std::vector<Fragment>& fragments);

/// Bavoil and Myers 2008.
Pixel CompositeWeightedAverage(const std::vector<Fragment>& fragments);

/// McGuire and Bavoil 2013, with a weight for each depth.
Pixel CompositeWeightedBlended(const std::vector<Fragment>& fragments, const std::function<double(double)>& weight);
}

#endif
