// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// ResolveSquares.glsl: the vertex shader of every resolve: a point as large as a square of pixels, from gl_VertexID
// alone.
//
// Points, not pairs of triangles: a driver shades small blocks of pixels, and those on the diagonal of a square twice,
// for each of its triangles. On squares of 16 x 16 that is a quarter more work. OpenGL's viewport is the tile, rounded
// up to whole squares: a point whose centre is outside would be clipped.
//
// A square is drawn by the resolve whose range its number of fragments falls into, resolveFewer < n <= resolveMost, and
// by those to whose level a pixel of it was left. Squares in which nothing is stored are not drawn; and none is where
// fragments did not fit: the application asks for that after the resolves, and then draws the tile again.
//
// Needs: SAMPLES, UNITS_ARE_FRAGMENTS.  Gives: main.
#include "Common/Bindings.glsl"
#include "Common/Frame.glsl"
#include "Storage/SquareFragments.glsl"
#ifndef SAMPLES
#error "ResolveSquares.glsl needs SAMPLES"
#endif

uniform usamplerBuffer statisticsTexels; // of Statistics.glsl's block

uniform int resolveLevel;
uniform int resolveFewer;
uniform int resolveMost;
#if SAMPLES > 1
uniform int resolveAmong; // if not negative: only squares left to this level, too
#endif

void main()
{
  int square = gl_VertexID;
  ivec2 squares = (frameTile.zw + RESOLVE_SQUARE - 1) / RESOLVE_SQUARE;
  ivec2 at = ivec2(square % squares.x, square / squares.x);
  int expected = int(squareFragments(frameTile.xy + at * RESOLVE_SQUARE));
  uint levels = texelFetch(statisticsTexels, STATISTICS_WORDS + square).x;
  bool left = (levels & (1u << resolveLevel)) != 0u;
  bool fitted = texelFetch(statisticsTexels, STATISTICS_TILE).x == 0u; // cellsOverflowed
  bool drawn = fitted && (left || (expected > resolveFewer && expected <= resolveMost));
#if SAMPLES > 1
  drawn = drawn && (resolveAmong < 0 || (levels & (1u << resolveAmong)) != 0u);
#endif

  vec2 position = vec2(2 * at + 1) / vec2(squares) - 1.0;
  gl_Position = drawn ? vec4(position, 0.0, 1.0) : vec4(2.0, 2.0, 2.0, 1.0);
  gl_PointSize = float(RESOLVE_SQUARE);
}
