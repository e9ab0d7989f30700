#version 150
// Runs once per tetrahedron.
uniform usamplerBuffer tetrahedronTable; // points below bit 30; bit 30 of the fourth: negative
uniform usamplerBuffer cellOfTetrahedronTable;
uniform usamplerBuffer markTable;
uniform samplerBuffer valueTable;

flat out uvec4 pointsOfTetrahedron;
flat out vec4 values;
flat out uint tetrahedron;

void main()
{
  tetrahedron = uint(gl_VertexID);
  uvec4 stored = texelFetch(tetrahedronTable, gl_VertexID);
  pointsOfTetrahedron = stored & 0x3fffffffu;
  for (int i = 0; i < 4; ++i)
  {
    values[i] = texelFetch(valueTable, int(pointsOfTetrahedron[i])).x;
  }
  // Skip cells of other pieces, hidden cells and negative tetrahedra: no value is this large.
  uint cell = texelFetch(cellOfTetrahedronTable, gl_VertexID).x >> 4;
  if ((texelFetch(markTable, int(cell)).x & 3u) != 0u || (stored.w >> 30) != 0u)
  {
    values = vec4(3.0e38);
  }
  gl_Position = vec4(0.0);
}
