// Samples.glsl: multi-sampling by coverage masks (Yang et al. 2010; Salvi 2011, section 4.2).
//
// A fragment is shaded and stored once for all samples of a pixel that it covers. Resolves run first for the whole pixel. If not all of
// its fragments cover all samples, a short list is blended once a sample (ABuffer/ResolveShort.glsl); a longer one is left to
// LEVEL_EACH_SAMPLE and goes through the technique's resolves once for each sample, where fragments that do not cover the sample are
// transparent.
//
// Needs: SAMPLES (1 to 8).  Gives: ALL_SAMPLES, resolveSample, inTile, atSample, samplesAgree.
#ifndef Samples_glsl
#define Samples_glsl
#include "Common/Fragment.glsl"
#include "Common/Frame.glsl"
#ifndef SAMPLES
#error "Samples.glsl needs SAMPLES"
#endif

#define ALL_SAMPLES ((1u << SAMPLES) - 1u)

#if SAMPLES > 1
uniform int resolveSample; // negative: the whole pixel
uint samplesInAll = ALL_SAMPLES; // those that every fragment read so far covers
#endif

// Whether a pixel belongs to the tile. The scissor test should see to it; with several samples llvmpipe also shades pixels beside the
// rectangle, whose fragments would end up in other pixels' lists.
bool inTile(ivec2 pixel)
{
#if SAMPLES > 1
  ivec2 at = pixel - frameTile.xy;
  return all(greaterThanEqual(at, ivec2(0))) && all(lessThan(at, frameTile.zw));
#else
  return true;
#endif
}

// A fragment as the sample sees it that is being resolved.
Fragment atSample(Fragment fragment)
{
#if SAMPLES > 1
  samplesInAll &= fragment.coverage;
  bool covers = resolveSample < 0 || ((fragment.coverage >> uint(resolveSample)) & 1u) != 0u;
  fragment.color = covers ? fragment.color : uvec2(0u);
#endif
  return fragment;
}

// Whether what has been read gives one colour for all samples that are being resolved.
bool samplesAgree()
{
#if SAMPLES > 1
  return resolveSample >= 0 || samplesInAll == ALL_SAMPLES;
#else
  return true;
#endif
}

#endif
