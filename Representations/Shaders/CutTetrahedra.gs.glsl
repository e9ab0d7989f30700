#version 150
// Outputs the tetrahedra that are cut.
layout(points) in;
layout(points, max_vertices = 1) out;

flat in uint tetrahedron[];
flat in int isCut[];
flat out uint cut;

void main()
{
  if (isCut[0] == 1)
  {
    cut = tetrahedron[0];
    EmitVertex();
    EndPrimitive();
  }
}
