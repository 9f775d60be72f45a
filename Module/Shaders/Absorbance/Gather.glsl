// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// Absorbance/Gather.glsl: visibility from sums, in a fixed amount of memory (Salvi 2011, section 4). The technique's
// file includes it last.
//
// gatherStage
// - 0, with ABSORBANCE_BOUNDS_FRAGMENTS: outputs[0] is (-depth, depth), of which blending keeps the largest: minus the
//   nearest depth of the pixel, and the farthest.
// - 1 and 3: outputs[i] is what the fragment adds to the terms, the first eight vectors of them and those behind. With
//   TERM_PRECISION_SHARED_EXPONENT it is added to words, in stage 1.
// - 2: outputs[0] is vis(z) * opacity * colour, with the opacity in alpha, by which blending multiplies the total
//   transmittance; outputs[1] is vis(z) * opacity. With three channels their alphas, and that of outputs[2], which is
//   light, hidden or not, have the opacity of one channel each.
//
// Needs: Basis, basisAt, prepareTerms, absorbanceInFront, ABSORBANCE_BOUNDS, GATHER_OUTPUTS, TARGET_SAMPLES.  Gives:
// gatherFragment.
#ifndef GATHER_OUTPUTS
#error "Absorbance/Gather.glsl needs GATHER_OUTPUTS"
#endif
#include "Absorbance/Terms.glsl"
#if TERM_PRECISION == TERM_PRECISION_SHARED_EXPONENT
#include "Absorbance/StoredTerms.glsl"
#else
#include "Absorbance/FetchTerms.glsl"
#endif
#include "Absorbance/Range.glsl"
#include "Absorbance/Visibility.glsl"
#include "Common/Opacity.glsl"
#include "Common/Target.glsl"
#include "Common/Tile.glsl"

uniform int gatherStage;
#if ABSORBANCE_BOUNDS == ABSORBANCE_BOUNDS_FRAGMENTS
uniform Target depthBounds;
#endif

void gatherFragment(vec4 color, float depth, out vec4 outputs[GATHER_OUTPUTS])
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  float z = spreadDepth(depth);
#if ABSORBANCE_BOUNDS == ABSORBANCE_BOUNDS_FRAGMENTS
  vec2 range = vec2(-1.0, 1.0) * fetchTarget(depthBounds, pixel).xy;
#else
  vec2 range = propsRange();
#endif
  Basis basis;
  basisAt(relativeDepth(z, range), basis);
  Channels opacity = opacityOf(color);
  Channels absorbance = absorbanceOf(opacity);
#if TERM_PRECISION == TERM_PRECISION_SHARED_EXPONENT
  if (gatherStage == 1)
  {
    if (inTile(pixel))
    {
      addTerms(pixel, basis.density, absorbance);
    }
  }
#else
#define FIRST_OUTPUT(i) ((i) < GATHER_OUTPUTS ? (i) : (i) - GATHER_OUTPUTS)
  if (gatherStage == 1 || gatherStage == 3)
  {
#define WRITE_TERMS(i) \
    if ((i < GATHER_OUTPUTS) == (gatherStage == 1)) \
    { \
      outputs[FIRST_OUTPUT(i)] = absorbance * basis.density[i]; \
    }
    EACH_VECTOR(WRITE_TERMS)
  }
#endif
  else if (gatherStage == 2)
  {
    Terms terms;
    fetchTerms(pixel, terms);
    prepareTerms(terms);
    Channels visibility = visibilityOf(terms, basis, absorbance);
    vec3 light = color.a * color.rgb;
#if TRANSMITTANCE_CHANNELS == 3
    outputs[0] = vec4(visibility * light, opacity.r);
    outputs[1] = vec4(visibility * opacity, opacity.g);
    outputs[2] = vec4(light, opacity.b);
#else
    outputs[0] = vec4(visibility * light, opacity);
    outputs[1] = vec4(visibility * opacity);
#endif
  }
  else
  {
    outputs[0] = vec4(-z, z, 0.0, 0.0);
  }
}
