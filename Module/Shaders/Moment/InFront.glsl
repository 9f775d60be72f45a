// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// Moment/InFront.glsl: what lies in front of a fragment, from moments without its own.
//
// Valid C++, too.
//
// Needs: Basis, absorbanceBefore, PLACE_OF (a Basis's depth), LAST_OF (the moment in the last vector, if there is one
// by itself), LAST_VECTOR.  Gives: absorbanceInFront.
#ifndef InFront_glsl
#define InFront_glsl

#if TRANSMITTANCE_CHANNELS == 3
#define MOMENTS_LEFT(i, channel) (terms.sums[i][channel] - absorbance[channel] * basis.density[i])
#define BEFORE(channel) \
  absorbanceBefore(MOMENTS_LEFT(0, channel), MOMENTS_LEFT(1, channel), LAST_OF(MOMENTS_LEFT(LAST_VECTOR, channel)), \
    terms.sums[0][channel].x, PLACE_OF(basis))
Channels absorbanceInFront(INOUT(Terms) terms, INOUT(Basis) basis, Channels absorbance)
{
  return Channels(BEFORE(0), BEFORE(1), BEFORE(2));
}
#else
#define MOMENTS_LEFT(i) (terms.sums[i] - absorbance * basis.density[i])
Channels absorbanceInFront(INOUT(Terms) terms, INOUT(Basis) basis, Channels absorbance)
{
  return absorbanceBefore(MOMENTS_LEFT(0), MOMENTS_LEFT(1), LAST_OF(MOMENTS_LEFT(LAST_VECTOR)), terms.sums[0].x,
    PLACE_OF(basis));
}
#endif

#endif
