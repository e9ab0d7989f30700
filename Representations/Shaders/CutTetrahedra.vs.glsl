// Runs once per tetrahedron: finds whether the boundary of the shape may cross it. Tetrahedra that
// the boundary touches only from outside count; negative tetrahedra, and those touched only from
// inside, do not. Preceded by InShape.glsl.
uniform usamplerBuffer tetrahedronTable; // points below bit 30; bit 30 of the fourth: negative
// cell << 4 | bits: its faces that lie in faces of the cell
uniform usamplerBuffer cellOfTetrahedronTable;
uniform usamplerBuffer markTable;
uniform samplerBuffer pointTable;
uniform int cellsToDraw; // as in KeepCells.vs.glsl
uniform int cellsMove;   // 1: cells are moved, so their positions are unknown here

flat out uint tetrahedron;
flat out int isCut;

bool isCrossed(uvec4 points)
{
  vec3 corners[4];
  for (int i = 0; i < 4; ++i)
  {
    corners[i] = texelFetch(pointTable, int(points[i])).xyz;
  }
  if (numberOfPlanes == 0)
  {
    vec3 center = vec3(0.0);
    for (int i = 0; i < 4; ++i)
    {
      corners[i] = (toUnitSphere * vec4(corners[i], 1.0)).xyz;
      center += 0.25 * corners[i];
    }
    float farthest = 0.0;
    float size = 0.0;
    for (int i = 0; i < 4; ++i)
    {
      farthest = max(farthest, length(corners[i]));
      size = max(size, distance(corners[i], center));
    }
    return farthest > 1.0 && length(center) <= 1.0 + size;
  }
  bool isInside = true;
  for (int plane = 0; plane < numberOfPlanes; ++plane)
  {
    int outside = 0;
    for (int i = 0; i < 4; ++i)
    {
      outside += dot(planes[plane], vec4(corners[i], 1.0)) > 0.0 ? 1 : 0;
    }
    if (outside == 4)
    {
      return false;
    }
    isInside = isInside && outside == 0;
  }
  return !isInside;
}

void main()
{
  tetrahedron = uint(gl_VertexID);
  uint marks = texelFetch(markTable, int(texelFetch(cellOfTetrahedronTable, gl_VertexID).x >> 4)).x;
  bool isSelected = (marks & 4u) != 0u;
  bool isDrawn = (marks & 3u) == 0u && (cellsToDraw == 0 || isSelected == (cellsToDraw == 1));
  uvec4 stored = texelFetch(tetrahedronTable, gl_VertexID);
  isDrawn = isDrawn && (stored.w >> 30) == 0u;
  isCut = isDrawn && (cellsMove == 1 || isCrossed(stored & 0x3fffffffu)) ? 1 : 0;
  gl_Position = vec4(0.0);
}
