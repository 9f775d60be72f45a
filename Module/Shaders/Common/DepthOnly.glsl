// DepthOnly.glsl: a fragment shader for draws of which only the depth test counts.
//
// Needs: nothing.  Gives: main.

void main()
{
}
