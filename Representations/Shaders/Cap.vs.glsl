//VTK::System::Dec
//Camaron::Defines
//Camaron::Place
//Camaron::Shape

// Draws the far faces of the tetrahedra that the boundary of the shape crosses: twelve vertices per
// tetrahedron. For every pixel of these faces, Cap.glsl finds where the line of sight meets the
// boundary in the tetrahedron.

uniform usamplerBuffer cutTable;
// Points; bits 30 and 31 of the first three: edges; bit 30 of the fourth: negative.
uniform usamplerBuffer tetrahedronTable;
// cell << 4 | bits: its faces that lie in faces of the cell
uniform usamplerBuffer cellOfTetrahedronTable;
uniform usamplerBuffer markTable;
uniform vec4 eye; // a position (w is 1), or the direction to it (w is 0)
#ifdef IS_PICKING
uniform usamplerBuffer ownerTable;
flat out uint pickedPoint;
flat out uvec2 pickedOwner;
#endif

#ifdef HAS_LOOKS
uniform usamplerBuffer leafTable; // as in Faces.vs.glsl
uniform samplerBuffer lookTable;
flat out vec4 lookOfBlock;
#endif

flat out uint cellOfFace;
flat out uint cellMarks;
flat out int isCutFace;

flat out uvec4 corners;
flat out uint walls;
flat out vec3 firstCorner;
// From a position relative to the first vertex to the weights of the others.
flat out mat3 toWeights;
out vec3 farPlace;

vec4 vertexMC;

//VTK::CustomUniforms::Dec
//VTK::PositionVC::Dec
//VTK::Normal::Dec
//VTK::Light::Dec
//VTK::TCoord::Dec
//VTK::Color::Dec
//VTK::Clip::Dec
//VTK::Camera::Dec
//VTK::PrimID::Dec
//VTK::ValuePass::Dec
//VTK::Picking::Dec

#ifdef HAS_LINES
uniform float faceClearance; // distance by which the shape was moved away from faces of cells

// If the shape almost coincides with a face of the cell, the adjacent faces are cut in other
// tetrahedra, in strips too narrow to see. Then the edges of the face are drawn instead, and the
// face itself gets no line. Edges: bits of the lines between vertices (0, 1), (0, 2), (0, 3), (1,
// 2), (1, 3), (2, 3).
void showEdgesOfWall(uint edges, vec3 places[4])
{
  uint besides = 0u;
  uint lines = 0u;
  for (int plane = 0; plane < numberOfPlanes; ++plane)
  {
    int numberBeside = 0;
    bool isBeside[4];
    for (int i = 0; i < 4; ++i)
    {
      isBeside[i] = abs(dot(planes[plane], vec4(places[i], 1.0))) < 2.0 * faceClearance;
      numberBeside += isBeside[i] ? 1 : 0;
    }
    if (numberBeside != 3)
    {
      continue; // true for nearly all tetrahedra
    }
    for (int wall = 0; wall < 4; ++wall)
    {
      if (isBeside[wall] || (walls >> wall & 1u) == 0u)
      {
        continue;
      }
      besides |= 1u << wall;
      for (int i = 0; i < 4; ++i)
      {
        // To the vertex opposite the face.
        int line = min(i, wall) == 0 ? max(i, wall) - 1 : i + wall;
        if (i != wall && (edges >> (5 - line) & 1u) == 1u)
        {
          lines |= 1u << i;
        }
      }
    }
  }
  walls = (walls & ~besides) | lines; // near two planes, one face is at the edge of the other
}
#endif

void main()
{
  int row = gl_VertexID / 12;
  int corner = gl_VertexID - 12 * row;
  int opposite = corner / 3; // the vertex that is not on the face
  int tetrahedron = int(texelFetch(cutTable, row).x);
  uvec4 stored = texelFetch(tetrahedronTable, tetrahedron);
  corners = stored & 0x3fffffffu;
  uint owner = texelFetch(cellOfTetrahedronTable, tetrahedron).x;
  walls = owner & 15u;
  cellOfFace = owner >> 4;
  cellMarks = texelFetch(markTable, int(cellOfFace)).x;
  isCutFace = 1;

  vec3 places[4];
  for (int i = 0; i < 4; ++i)
  {
    places[i] = place(corners[i], cellOfFace).xyz;
  }
#ifdef HAS_LINES
  uvec4 upper = stored >> 30;
  showEdgesOfWall(upper[0] | upper[1] << 2 | upper[2] << 4, places);
#endif
  firstCorner = places[0];
  mat3 edges =
    mat3(places[1] - firstCorner, places[2] - firstCorner, places[3] - firstCorner);
  toWeights = inverseOf(edges);
  farPlace = places[(opposite + 1 + corner - 3 * opposite) % 4];
  vertexMC = vec4(farPlace, 1.0);
#ifdef HAS_LOOKS
  lookOfBlock = texelFetch(lookTable, int(texelFetch(leafTable, int(cellOfFace)).x));
#endif
#ifdef IS_PICKING
  pickedPoint = corners[0];
  pickedOwner = texelFetch(ownerTable, int(cellOfFace)).xy;
#endif

  //VTK::CustomBegin::Impl
  //VTK::Color::Impl
  //VTK::Normal::Impl
  //VTK::TCoord::Impl
  //VTK::Clip::Impl
  //VTK::PrimID::Impl
  //VTK::PositionVC::Impl
  //VTK::ValuePass::Impl
  //VTK::Light::Impl
  //VTK::Picking::Impl
  //VTK::CustomEnd::Impl

  vec3 start = places[(opposite + 1) % 4];
  float size = sizeOf(edges);
  vec3 normal = cross(
    (places[(opposite + 2) % 4] - start) / size, (places[(opposite + 3) % 4] - start) / size);
  normal = dot(normal, (places[opposite] - start) / size) > 0.0 ? -normal : normal;
  if (dot(normal, eye.xyz - eye.w * start) > 0.0)
  {
    gl_Position = vec4(0.0, 0.0, 2.0, 1.0); // a near face: draw nothing
  }
}
