// Weighted/Resolve.glsl: a pixel's colour from its sums (Gather.glsl).
//
// The sum (survey, "Weighted Sum") can let through less than nothing of what lies behind: blending takes that for nothing.
// The average lets through what its mean opacity does, applied once a fragment: u = (1 - mean)^n. Blended weights let through what is
// right.
//
// Needs: WEIGHTED_METHOD, TARGET_SAMPLES.
#ifndef WEIGHTED_METHOD
#error "Weighted/Resolve.glsl needs WEIGHTED_METHOD"
#endif
#include "Common/Target.glsl"
#include "Weighted/Methods.glsl"

uniform Target weightedColors;
uniform Target weightedCounts;

bool resolvePixel(ivec2 pixel, inout vec3 color, inout float transmittance)
{
  vec4 sums = fetchTarget(weightedColors, pixel);
  float count = fetchTarget(weightedCounts, pixel).r;
#if WEIGHTED_METHOD == WEIGHTED_SUM
  color = sums.rgb;
  transmittance = 1.0 - sums.a;
#elif WEIGHTED_METHOD == WEIGHTED_AVERAGE
  transmittance = pow(max(0.0, 1.0 - sums.a / max(count, 1.0)), count);
  color = (1.0 - transmittance) * sums.rgb / max(sums.a, 1e-30);
#else
  transmittance = sums.a;
  color = (1.0 - transmittance) * sums.rgb / max(count, 1e-30);
#endif
  return count > 0.0;
}

#include "Common/Composite.glsl"
