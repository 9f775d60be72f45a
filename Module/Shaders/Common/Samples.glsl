// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// Samples.glsl: multi-sampling by coverage masks (Yang et al. 2010; Salvi 2011, section 4.2).
//
// A fragment is shaded and stored once for all samples of a pixel that it covers. Resolves run first for the whole
// pixel. If not all of its fragments cover all samples, a short list is blended once a sample
// (ABuffer/ResolveShort.glsl); a longer one is left to LEVEL_EACH_SAMPLE and goes through the technique's resolves once
// for each sample, where fragments that do not cover the sample are transparent.
//
// Needs: SAMPLES.  Gives: resolveSample, atSample, samplesAgree.
#ifndef Samples_glsl
#define Samples_glsl
#include "Common/Fragment.glsl"
#include "Common/Tile.glsl"

#if SAMPLES > 1
uniform int resolveSample; // negative: the whole pixel
uint samplesInAll = ALL_SAMPLES; // those that every fragment read so far covers
#endif

// A fragment as the sample sees it that is being resolved.
Fragment atSample(Fragment fragment)
{
#if SAMPLES > 1
  samplesInAll &= fragment.coverage;
  bool covers = resolveSample < 0 || ((fragment.coverage >> uint(resolveSample)) & 1u) != 0u;
  fragment.color = covers ? fragment.color : PackedColor(0u);
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
