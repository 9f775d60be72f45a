// ResolveSquares.glsl: the vertex shader of every resolve: two triangles a square of pixels, from gl_VertexID alone.
//
// A square is drawn by the resolve whose range its number of fragments falls into, resolveFewer < n <= resolveMost, and by
// those to whose level a pixel of it was left. Squares in which nothing is stored are not drawn.
//
// Needs: what the storage needs.  Gives: main.
#include "Common/Frame.glsl"
#include "Common/Statistics.glsl"
#include "Storage/Selected.glsl"

uniform int resolveLevel;
uniform int resolveFewer;
uniform int resolveMost;

void main()
{
  int square = gl_VertexID / 6;
  int corner = gl_VertexID % 6;
  int squaresAcross = (frameTile.z + RESOLVE_SQUARE - 1) / RESOLVE_SQUARE;
  ivec2 at = ivec2(square % squaresAcross, square / squaresAcross);
  int expected = int(squareFragments(frameTile.xy + at * RESOLVE_SQUARE));
  bool left = (squareLevels[square] & (1u << resolveLevel)) != 0u;
  bool drawn = left || (expected > resolveFewer && expected <= resolveMost);

  at += ivec2(corner == 1 || corner == 2 || corner == 4, corner == 2 || corner == 4 || corner == 5);
  vec2 pixel = vec2(frameTile.xy + at * RESOLVE_SQUARE - frameViewport.xy);
  vec2 position = 2.0 * pixel / vec2(frameViewport.zw) - 1.0;
  gl_Position = drawn ? vec4(position, 0.0, 1.0) : vec4(2.0, 2.0, 2.0, 1.0);
}
