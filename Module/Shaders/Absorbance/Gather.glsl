// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// Absorbance/Gather.glsl: visibility from sums, in a fixed amount of memory (Salvi 2011, section 4). The technique's
// file includes it last.
//
// gatherStage
// - 0, with ABSORBANCE_BOUNDS_FRAGMENTS: outputs[0] is (-depth, depth), of which blending keeps the largest: minus the
//   nearest depth of the pixel, and the farthest.
// - 1 and 3: outputs[i] is what the fragment adds to the terms, the first eight vectors of them and those behind.
// - 2: outputs[0] is vis(z) * opacity * colour, with the opacity in alpha, by which blending multiplies the total
//   transmittance; outputs[1] is vis(z) * opacity.
//
// Needs: Basis, basisAt, prepareTerms, absorbanceInFront, ABSORBANCE_BOUNDS, GATHER_OUTPUTS, TARGET_SAMPLES.  Gives:
// gatherFragment.
#ifndef GATHER_OUTPUTS
#error "Absorbance/Gather.glsl needs GATHER_OUTPUTS"
#endif
#include "Absorbance/FetchTerms.glsl"
#include "Absorbance/Range.glsl"
#include "Absorbance/Visibility.glsl"

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
  float absorbance = absorbanceOf(color.a);
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
  else if (gatherStage == 2)
  {
    Terms terms;
    fetchTerms(pixel, terms);
    prepareTerms(terms);
    float weight = visibilityOf(terms, basis, absorbance) * color.a;
    outputs[0] = vec4(weight * color.rgb, color.a);
    outputs[1] = vec4(weight);
  }
  else
  {
    outputs[0] = vec4(-z, z, 0.0, 0.0);
  }
}
