// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// Absorbance/FetchTerms.glsl: the terms of a pixel, or a sample of it, as the targets hold them.
//
// One sampler a vector: arrays of samplers want constant indices, which a loop's counter is not.
//
// Needs: TERM_VECTORS, TARGET_SAMPLES.  Gives: fetchTerms.
#ifndef FetchTerms_glsl
#define FetchTerms_glsl
#include "Absorbance/Terms.glsl"
#include "Common/Target.glsl"

uniform Target terms0;
#if TERM_VECTORS > 1
uniform Target terms1;
#endif
#if TERM_VECTORS > 2
uniform Target terms2;
#endif
#if TERM_VECTORS > 3
uniform Target terms3;
#endif
#if TERM_VECTORS > 4
uniform Target terms4;
#endif
#if TERM_VECTORS > 5
uniform Target terms5;
#endif
#if TERM_VECTORS > 6
uniform Target terms6;
#endif
#if TERM_VECTORS > 7
uniform Target terms7;
#endif
#if TERM_VECTORS > 8
uniform Target terms8;
uniform Target terms9;
uniform Target terms10;
uniform Target terms11;
uniform Target terms12;
uniform Target terms13;
uniform Target terms14;
uniform Target terms15;
#endif

void fetchTerms(ivec2 pixel, out Terms terms)
{
  terms.sums[0] = fetchTarget(terms0, pixel);
#if TERM_VECTORS > 1
  terms.sums[1] = fetchTarget(terms1, pixel);
#endif
#if TERM_VECTORS > 2
  terms.sums[2] = fetchTarget(terms2, pixel);
#endif
#if TERM_VECTORS > 3
  terms.sums[3] = fetchTarget(terms3, pixel);
#endif
#if TERM_VECTORS > 4
  terms.sums[4] = fetchTarget(terms4, pixel);
#endif
#if TERM_VECTORS > 5
  terms.sums[5] = fetchTarget(terms5, pixel);
#endif
#if TERM_VECTORS > 6
  terms.sums[6] = fetchTarget(terms6, pixel);
#endif
#if TERM_VECTORS > 7
  terms.sums[7] = fetchTarget(terms7, pixel);
#endif
#if TERM_VECTORS > 8
  terms.sums[8] = fetchTarget(terms8, pixel);
  terms.sums[9] = fetchTarget(terms9, pixel);
  terms.sums[10] = fetchTarget(terms10, pixel);
  terms.sums[11] = fetchTarget(terms11, pixel);
  terms.sums[12] = fetchTarget(terms12, pixel);
  terms.sums[13] = fetchTarget(terms13, pixel);
  terms.sums[14] = fetchTarget(terms14, pixel);
  terms.sums[15] = fetchTarget(terms15, pixel);
#endif
}

#endif
