//VTK::System::Dec
//Camaron::Defines
//Camaron::Place

// Vertices of the visible triangles, as in Faces.vs.glsl, for VisiblePixels.fs.glsl.
uniform usamplerBuffer visibleTable;
uniform usamplerBuffer triangleTable;
uniform usamplerBuffer faceTable;
uniform usamplerBuffer markTable;
uniform int isListed;
uniform mat4 toDisplay;

flat out uint entryOfTriangle;
#ifdef HAS_POSITION
out vec3 positionOfFragment;
#endif

void main()
{
  int row = gl_VertexID / 3;
  int corner = gl_VertexID - 3 * row;
  entryOfTriangle = isListed == 1 ? texelFetch(visibleTable, row).x : uint(row) << 1;
  int side = int(entryOfTriangle & 1u);
  uvec4 triangle = texelFetch(triangleTable, int(entryOfTriangle >> 1));
  uvec2 cells = texelFetch(faceTable, int(triangle.w >> 3)).xy;
  uint cell = cells[side];
  vec4 vertex = place(triangle[side == 1 ? 2 - corner : corner], cell);
#ifdef HAS_POSITION
  positionOfFragment = vertex.xyz;
#endif
  gl_Position = toDisplay * vertex;
  if ((texelFetch(markTable, int(cell)).x & 2u) != 0u)
  {
    gl_Position = vec4(0.0, 0.0, 2.0, 1.0); // of a hidden block: draw nothing
  }
}
