#version 150
// Outputs the visible triangles, once per visible side.
layout(points) in;
layout(points, max_vertices = 2) out;

flat in uint triangleOfPoint[];
flat in int sides[];
flat out uint visible;

void main()
{
  if ((sides[0] & 1) != 0)
  {
    visible = triangleOfPoint[0] << 1;
    EmitVertex();
    EndPrimitive();
  }
  if ((sides[0] & 2) != 0)
  {
    visible = triangleOfPoint[0] << 1 | 1u;
    EmitVertex();
    EndPrimitive();
  }
}
