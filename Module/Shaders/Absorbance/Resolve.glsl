// Absorbance/Resolve.glsl: visibility from sums, from lists of all fragments (Salvi 2011, section 4.1). The technique's file includes it last.
//
// Walks over a pixel's list: for the bounds of its depths, for the terms, and for the fragments weighted by their visibility. Pixels whose
// loops the driver ends are left to UNFINISHED_LEVEL, which sorts.
//
// Needs: basisAt and what Absorbance/Terms.glsl gives, ABSORBANCE_BOUNDS, ALPHA_CORRECTION, UNFINISHED_LEVEL, COLOR_FORMAT.
#ifndef UNFINISHED_LEVEL
#error "Absorbance/Resolve.glsl needs UNFINISHED_LEVEL"
#endif
#include "Absorbance/Correct.glsl"
#include "Absorbance/Range.glsl"
#include "Common/FinishPixel.glsl"
#include "Common/Fragment.glsl"
#include "Common/Statistics.glsl"
#include "Storage/Selected.glsl"

#if ABSORBANCE_BOUNDS == ABSORBANCE_BOUNDS_FRAGMENTS
vec2 listRange(ivec2 pixel, inout uint unread)
{
  vec2 bounds = vec2(2.0, -1.0);
  Fragment fragment;
  uint cursor = firstFragment(pixel);
  while (nextFragment(cursor, fragment))
  {
    float z = linearDepth(fragment.depth);
    bool covers = unpackColor(fragment.color).a > 0.0;
    bounds = covers ? vec2(min(bounds.x, z), max(bounds.y, z)) : bounds;
  }
  unread |= cursor;
  return bounds;
}
#endif

bool resolvePixel(ivec2 pixel, inout vec3 color, inout float transmittance)
{
  uint unread = 0u;
#if ABSORBANCE_BOUNDS == ABSORBANCE_BOUNDS_FRAGMENTS
  vec2 range = listRange(pixel, unread);
#else
  vec2 range = propsRange();
#endif
  int count = 0;
  Terms terms;
  Basis basis;
  Fragment fragment;
  clearTerms(terms);
  uint cursor = firstFragment(pixel);
  while (nextFragment(cursor, fragment))
  {
    float alpha = unpackColor(fragment.color).a;
    basisAt(relativeDepth(linearDepth(fragment.depth), range), basis);
    addToTerms(terms, basis, absorbanceOf(alpha));
    transmittance *= 1.0 - alpha;
    count += alpha > 0.0 ? 1 : 0;
  }
  unread |= cursor;
  float weights = 0.0;
  cursor = firstFragment(pixel);
  while (nextFragment(cursor, fragment))
  {
    vec4 shaded = unpackColor(fragment.color);
    basisAt(relativeDepth(linearDepth(fragment.depth), range), basis);
    float weight = visibilityOf(terms, basis, absorbanceOf(shaded.a)) * shaded.a;
    color += weight * shaded.rgb;
    weights += weight;
  }
  if (unread != 0u || cursor != 0u)
  {
    leaveToLevel(pixel, UNFINISHED_LEVEL);
    return false;
  }
  color = correctedColor(color, weights, transmittance);
  finishPixel(pixel, uint(count));
  return count > 0;
}

#include "Common/Resolve.glsl"
