// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// Background/Change.glsl: the opaque picture as surfaces displace, disperse and blur it, before they are drawn over
// it.
//
// Dispersion takes the place of one sample by five along a segment in the direction of the displacement, whose colours
// are weighted by the spectrum (Aizenshtein et al. 2021, section 3): red is bent least. The weights of a channel add up
// to one, here by construction: each is divided by their sum.
//
// A blur is a Gaussian's: BLUR_TAPS samples, each for the same share of it, on a spiral of golden angles, from a level
// of the picture whose pixels are as wide as they are apart. What is nearer than the surface is not seen through it,
// and left out; where it blurs, a pixel of that level may still hold some of it.
//
// Needs: TARGET_SAMPLES, SHADES_SAMPLES.
#include "Common/Target.glsl"
#include "Common/Tile.glsl"

#define SPECTRAL_TAPS 5
#define BLUR_TAPS 16

uniform Target backgroundBend; // displacement, variance of the blur, length of the segment
uniform Target backgroundDepth;
uniform sampler2D backgroundPicture; // of the viewport
uniform vec4 backgroundViewport;     // in window pixels: x, y, width, height
uniform sampler2D translucencyOpaqueDepth;

out vec4 fragOutput0;

// Between edges in falling order, which GLSL's own does not define.
vec3 spectralWeight(int tap)
{
  float t = (float(tap) + 0.5) / float(SPECTRAL_TAPS);
  float red = 1.0 - smoothstep(1.0 / 3.0, 0.5, t);
  float blue = smoothstep(0.5, 2.0 / 3.0, t);
  return vec3(red, 1.0 - red - blue, blue);
}

vec2 withinViewport(vec2 place)
{
  return clamp(place, backgroundViewport.xy + 0.5, backgroundViewport.xy + backgroundViewport.zw - 0.5);
}

// 0 where something nearer is there.
float seenAt(vec2 place, float depth)
{
  return texelFetch(translucencyOpaqueDepth, ivec2(place), 0).r < depth ? 0.0 : 1.0;
}

// Between the four pixels around a place, of which those with something nearer are left out.
vec4 sharpAt(vec2 place, float depth, out float weight)
{
  vec2 corner = floor(place - 0.5);
  vec2 share = place - 0.5 - corner;
  vec4 sum = vec4(0.0);
  weight = 0.0;
  for (int i = 0; i < 4; ++i)
  {
    vec2 step = vec2(i & 1, i >> 1);
    vec2 pixel = withinViewport(corner + step + 0.5);
    vec2 parts = mix(1.0 - share, share, step);
    float part = parts.x * parts.y * seenAt(pixel, depth);
    sum += part * texelFetch(backgroundPicture, ivec2(pixel - backgroundViewport.xy), 0);
    weight += part;
  }
  return sum / max(weight, 1e-6);
}

// sigma is the Gaussian's, in pixels.
vec4 blurredAt(vec2 place, float sigma, float depth, out float weight)
{
  const float goldenAngle = 2.399963;
  if (sigma == 0.0)
  {
    return sharpAt(place, depth, weight);
  }
  float level = max(log2(0.6 * sigma), 0.0);
  vec4 sum = vec4(0.0);
  weight = 0.0;
  for (int tap = 0; tap < BLUR_TAPS; ++tap)
  {
    float radius = sigma * sqrt(-2.0 * log(1.0 - (float(tap) + 0.5) / float(BLUR_TAPS)));
    float angle = goldenAngle * float(tap);
    vec2 at = withinViewport(place + radius * vec2(cos(angle), sin(angle)));
    float seen = seenAt(at, depth);
    sum += seen * textureLod(backgroundPicture, (at - backgroundViewport.xy) / backgroundViewport.zw, level);
    weight += seen;
  }
  return sum / max(weight, 1.0);
}

// What hides all that is behind the surface there is seen where it is not displaced.
vec4 behindAt(vec2 place, vec2 pixel, float sigma, float depth)
{
  float weight;
  vec4 color = blurredAt(place, sigma, depth, weight);
  return weight > 0.0 ? color : sharpAt(pixel, 0.0, weight);
}

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec4 bend = fetchTarget(backgroundBend, pixel);
  if (!inTile(pixel) || bend == vec4(0.0))
  {
    discard;
  }
  vec2 middle = vec2(pixel) + 0.5;
  float depth = fetchTarget(backgroundDepth, pixel).r;
  float sigma = sqrt(bend.z);
  if (bend.w == 0.0)
  {
    fragOutput0 = behindAt(middle + bend.xy, middle, sigma, depth);
    return;
  }
  vec2 direction = bend.xy / max(length(bend.xy), 1e-6);
  vec4 color = vec4(0.0);
  vec3 whole = vec3(0.0);
  for (int tap = 0; tap < SPECTRAL_TAPS; ++tap)
  {
    float along = float(tap) / float(SPECTRAL_TAPS - 1) - 0.5;
    vec4 seen = behindAt(middle + bend.xy + along * bend.w * direction, middle, sigma, depth);
    vec3 weight = spectralWeight(tap);
    color += seen * vec4(weight, 1.0 / float(SPECTRAL_TAPS));
    whole += weight;
  }
  fragOutput0 = color / vec4(whole, 1.0);
}
