// Absorbance/Weigh.glsl: what the resolves of lists do with each fragment.
//
// A Range grows to the nearest and the farthest depth; the terms take the fragments; and their colours are summed, weighted with vis(z) and opacity.
// Fragments that don't cover the sample have opacity 0 and change nothing.
//
// Needs: basisAt and what Absorbance/Terms.glsl gives, ABSORBANCE_BOUNDS, ALPHA_CORRECTION.  Gives: Sums, clearSums, bound, absorb, weigh,
// and what Absorbance/Range.glsl and Absorbance/Correct.glsl give.
#ifndef Weigh_glsl
#define Weigh_glsl
#include "Absorbance/Correct.glsl"
#include "Absorbance/Range.glsl"
#include "Common/Fragment.glsl"

struct Sums
{
  vec2 range; // nearest and farthest depth
  Terms terms;
  float transmittance;
  vec3 color;
  float weights;
};

void clearSums(out Sums sums)
{
#if ABSORBANCE_BOUNDS == ABSORBANCE_BOUNDS_PROPS
  sums.range = propsRange();
#else
  sums.range = vec2(1.0, 0.0);
#endif
  clearTerms(sums.terms);
  sums.transmittance = 1.0;
  sums.color = vec3(0.0);
  sums.weights = 0.0;
}

void bound(inout Sums sums, float depth, float alpha)
{
  float z = linearDepth(depth);
  sums.range = alpha > 0.0 ? vec2(min(sums.range.x, z), max(sums.range.y, z)) : sums.range;
}

void absorb(inout Sums sums, float depth, float alpha)
{
  Basis basis;
  basisAt(relativeDepth(linearDepth(depth), sums.range), basis);
  addToTerms(sums.terms, basis, absorbanceOf(alpha));
  sums.transmittance *= 1.0 - alpha;
}

void weigh(inout Sums sums, float depth, Surface surface)
{
  Basis basis;
  basisAt(relativeDepth(linearDepth(depth), sums.range), basis);
  float visibility = visibilityOf(sums.terms, basis, absorbanceOf(surface.opacity));
  sums.color += visibility * surface.color;
  sums.weights += visibility * surface.opacity;
}

#endif
