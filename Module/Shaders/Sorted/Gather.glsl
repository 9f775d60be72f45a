// Sorted/Gather.glsl: a fragment's colour, multiplied by its opacity, as the over and under operators blend it.
//
// Where an object's back faces are drawn before its front faces, gatherPart is 1 for these, 2 for those and else 0
// (vtkTranslucencyFrame::Faces). Polygons are culled; lines and points, which can't be, count as front faces.
//
// Gives: gatherFragment.

uniform int gatherPart;

void gatherFragment(vec4 color, float depth, out vec4 outputs[1])
{
  if (gatherPart == (gl_FrontFacing ? 1 : 2))
  {
    discard;
  }
  outputs[0] = vec4(color.a * color.rgb, color.a);
}
