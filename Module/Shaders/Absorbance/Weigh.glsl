// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// Absorbance/Weigh.glsl: what the resolves of lists do with each fragment.
//
// A Range grows to the nearest and the farthest depth; the terms take the fragments; and their colours are summed,
// weighted with vis(z) and opacity. Fragments that don't cover the sample have opacity 0 and change nothing.
//
// Needs: Basis, basisAt, prepareTerms, absorbanceInFront, ABSORBANCE_BOUNDS, ALPHA_CORRECTION.  Gives:
// Sums, clearSums, isThere, bound, absorb, weigh, colorOf, and what Absorbance/Range.glsl gives.
#ifndef Weigh_glsl
#define Weigh_glsl
#include "Absorbance/Range.glsl"
#include "Absorbance/Visibility.glsl"
#include "Common/AlphaCorrection.glsl"
#include "Common/Fragment.glsl"

struct Sums
{
  vec2 range; // nearest and farthest depth
  Terms terms;
  Channels transmittance;
  WeightedSums weighted;
};

void clearSums(out Sums sums)
{
#if ABSORBANCE_BOUNDS == ABSORBANCE_BOUNDS_PROPS
  sums.range = propsRange();
#else
  sums.range = vec2(1.0, 0.0);
#endif
  clearTerms(sums.terms);
  sums.transmittance = Channels(1.0);
  clearWeights(sums.weighted);
}

// Whether the fragment covers the sample: it hides something, or adds light.
bool isThere(Surface surface)
{
#if TRANSMITTANCE_CHANNELS == 3
  return surface.opacity != vec3(0.0) || surface.color != vec3(0.0);
#else
  return surface.opacity > 0.0;
#endif
}

void bound(inout Sums sums, float depth, Surface surface)
{
  float z = spreadDepth(depth);
  sums.range = isThere(surface) ? vec2(min(sums.range.x, z), max(sums.range.y, z)) : sums.range;
}

void absorb(inout Sums sums, float depth, Channels alpha)
{
  Basis basis;
  basisAt(relativeDepth(spreadDepth(depth), sums.range), basis);
  addToTerms(sums.terms, basis, absorbanceOf(alpha));
  sums.transmittance *= 1.0 - alpha;
}

void weigh(inout Sums sums, float depth, Surface surface)
{
  Basis basis;
  basisAt(relativeDepth(spreadDepth(depth), sums.range), basis);
  Channels visibility = visibilityOf(sums.terms, basis, absorbanceOf(surface.opacity));
  addWeighted(sums.weighted, surface.color, surface.opacity, visibility);
}

vec3 colorOf(Sums sums)
{
  return correctedColor(sums.weighted, sums.transmittance);
}

#endif
