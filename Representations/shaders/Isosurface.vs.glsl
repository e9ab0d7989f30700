#version 150
// One run for each tetrahedron.
uniform usamplerBuffer tetrahedronTable; // points below bit 30
uniform usamplerBuffer cellOfTetrahedronTable;
uniform usamplerBuffer markTable;
uniform samplerBuffer valueTable;

flat out uvec4 pointsOfTetrahedron;
flat out vec4 values;
flat out uint cell;

void main()
{
  pointsOfTetrahedron = texelFetch(tetrahedronTable, gl_VertexID) & 0x3fffffffu;
  for (int i = 0; i < 4; ++i)
  {
    values[i] = texelFetch(valueTable, int(pointsOfTetrahedron[i])).x;
  }
  cell = texelFetch(cellOfTetrahedronTable, gl_VertexID).x >> 4;
  // Cells of another piece, and hidden ones, have no part: no value is as large as this one.
  if ((texelFetch(markTable, int(cell)).x & 3u) != 0u)
  {
    values = vec4(3.0e38);
  }
  gl_Position = vec4(0.0);
}
