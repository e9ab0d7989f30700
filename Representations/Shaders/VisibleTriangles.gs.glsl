#version 150
// Keeps the triangles that are seen, once for each side.
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
