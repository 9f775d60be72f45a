// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// Absorbance/StoredTerms.glsl: the terms of a pixel, or a sample of it, in words that fragments add to by atomic
// operations (Aizenshtein, Smal, McGuire 2021, 2.3.3), in any order. A word is a term: of one channel a float, of three
// 9 bits each with an exponent of 5 (Common/SharedExponent.glsl). Words begin as 0, which is zero in both.
//
// A fragment touches the words of the terms only that it adds to: of Haar wavelets one a level, and one.
//
// An invocation that only serves derivatives gets undefined results from atomic operations, and would try for ever.
//
// Needs: TERM_VECTORS, TRANSMITTANCE_CHANNELS, SAMPLES, RECORD_TARGETS 0, GL_ARB_ES3_1_compatibility.  Gives:
// fetchTerms, addTerms.
#ifndef StoredTerms_glsl
#define StoredTerms_glsl
#ifndef GL_ARB_ES3_1_compatibility
#error "Absorbance/StoredTerms.glsl needs GL_ARB_ES3_1_compatibility, to know helper invocations"
#endif
#include "Absorbance/Terms.glsl"
#define PIXEL_WORDS (4 * TERM_VECTORS)
#include "Common/Pixels.glsl"

#if TRANSMITTANCE_CHANNELS == 3
#include "Common/SharedExponent.glsl"
#define wordOf packShared
#define termOf unpackShared
#define TERM_OF(terms, i, j) vec3(terms.sums[i][0][j], terms.sums[i][1][j], terms.sums[i][2][j])
#define SET_TERM(terms, i, j, term) \
  { \
    vec3 channels = term; \
    terms.sums[i][0][j] = channels.r; \
    terms.sums[i][1][j] = channels.g; \
    terms.sums[i][2][j] = channels.b; \
  }
#else
#define wordOf floatBitsToUint
#define termOf uintBitsToFloat
#define TERM_OF(terms, i, j) terms.sums[i][j]
#define SET_TERM(terms, i, j, term) terms.sums[i][j] = term;
#endif

PixelRecord recordOfSample(ivec2 pixel)
{
#if SAMPLES > 1
  return pixelRecord(pixel, gl_SampleID);
#else
  return pixelRecord(pixel, 0);
#endif
}

void fetchTerms(ivec2 pixel, out Terms terms)
{
  PixelRecord record = recordOfSample(pixel);
#define FETCH_TERM(i, j) SET_TERM(terms, i, j, termOf(recordWord(record, 4 * (i) + (j))))
#define FETCH_VECTOR(i) FETCH_TERM(i, 0) FETCH_TERM(i, 1) FETCH_TERM(i, 2) FETCH_TERM(i, 3)
  EACH_VECTOR(FETCH_VECTOR)
}

void addTerm(PixelRecord record, int term, Channels amount)
{
  uint at = record.words + uint(term) * PIXELS_OF_BLOCK;
  uint found = pixelRecords[at];
  bool done = gl_HelperInvocation || amount == Channels(0.0);
  while (!done)
  {
    uint expected = found;
    found = atomicCompSwap(pixelRecords[at], expected, wordOf(termOf(expected) + amount));
    done = found == expected;
  }
}

void addTerms(ivec2 pixel, vec4 density[TERM_VECTORS], Channels absorbance)
{
  PixelRecord record = recordOfSample(pixel);
#define ADD_TERM(i, j) addTerm(record, 4 * (i) + (j), density[i][j] * absorbance);
#define ADD_VECTOR(i) ADD_TERM(i, 0) ADD_TERM(i, 1) ADD_TERM(i, 2) ADD_TERM(i, 3)
  EACH_VECTOR(ADD_VECTOR)
}

#endif
