//VTK::System::Dec
//Camaron::Defines
//Camaron::Place
//Camaron::Inputs

// Vertices of the visible triangles or, with ARE_EDGES, of quads with a constant width in pixels
// along their edges, six vertices per edge. There are no vertex attributes: everything is read from
// tables by gl_VertexID.

#ifdef IS_ISOSURFACE
uniform usamplerBuffer cornerTable;   // two points, position between them (times 2^24), tetrahedron
// cell << 4 | bits: its faces that lie in faces of the cell
uniform usamplerBuffer cellOfTetrahedronTable;
#endif
#ifdef HAS_NEGATIVES
uniform usamplerBuffer tetrahedronTable; // points below bit 30
out vec3 placeOfFragment;
out float weightOfFirst; // weight of the tetrahedron's first point
#endif
uniform usamplerBuffer visibleTable;  // triangle << 1 | side, per visible triangle
uniform usamplerBuffer triangleTable; // three points, face << 3 | edge bits
uniform usamplerBuffer faceTable;     // the two cells of a face
uniform usamplerBuffer markTable;     // bits of a cell: 1 ghost, 2 hidden, 4 selected
uniform int isListed;                 // 0: all triangles in the table are visible

#ifdef HAS_LOOKS
uniform usamplerBuffer leafTable; // the block of a cell
uniform samplerBuffer lookTable;  // per block: color and opacity, below 0 if not set
flat out vec4 lookOfBlock;
#endif
#ifdef HAS_NORMALS
uniform samplerBuffer normalTable;
uniform mat3 normalMatrix;
uniform float smoothCosine; // limit of the angle between the normals of point and face
out vec3 normalOfCorners;
#endif
uniform vec2 viewportSize;
#ifdef HAS_LINES
flat out vec3 lines[3]; // |dot(line, (x, y, 1))| is the distance in pixels
flat out vec3 strengths; // of the lines, from 0 to 1
uniform float partsOfEdge; // of curved faces that are subdivided
#endif
#ifdef HAS_LIMITS
uniform samplerBuffer valueTable;
uniform vec2 colorLimits; // of the values of acceptable cells
#endif
#ifdef ARE_EDGES
uniform float edgeWidth;
#endif
#if defined(ARE_NODES) || defined(HAS_LINES)
uniform int numberOfNodes; // points of the mesh, before those that subdivide curved faces
#endif
#ifdef IS_PICKING
uniform usamplerBuffer ownerTable; // process and block of a cell
flat out uint pickedPoint;
flat out uvec2 pickedOwner;
#endif

flat out uint cellOfFace;
flat out uint cellMarks;
flat out int isCutFace;

#ifdef HAS_POSITION
out vec3 positionOfFragment;
#endif

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
float largest(vec3 a)
{
  return max(max(abs(a.x), abs(a.y)), abs(a.z));
}

// The line through two vertices, in pixels. Without division, so that vertices behind the eye are
// no problem.
vec3 lineThrough(vec4 a, vec4 b)
{
  vec3 p = vec3((a.xy + a.w) * 0.5 * viewportSize, a.w);
  vec3 q = vec3((b.xy + b.w) * 0.5 * viewportSize, b.w);
  // Scaled to size 1, because squares of large coordinates overflow float.
  vec3 line = cross(p / largest(p), q / largest(q));
  return line / length(line.xy);
}

#endif

#if defined(HAS_LINES) || defined(HAS_LIMITS)
// A triangle on the screen, in pixels.
struct Outline
{
  vec2 corners[3];
  float longest; // length of its longest side
  float area;    // negative if the corners are clockwise
  bool isSeen;   // false if it reaches behind the eye
};

Outline findOutline(vec4 a, vec4 b, vec4 c)
{
  vec2 size = 0.5 * viewportSize;
  vec2 p = (a.xy / a.w + 1.0) * size, q = (b.xy / b.w + 1.0) * size, r = (c.xy / c.w + 1.0) * size;
  vec2 u = q - p, v = r - p, w = r - q;
  Outline outline;
  outline.corners = vec2[3](p, q, r);
  outline.longest = max(sqrt(max(max(dot(u, u), dot(v, v)), dot(w, w))), 1.0e-9);
  outline.area = 0.5 * (u.x * v.y - u.y * v.x);
  outline.isSeen = min(min(a.w, b.w), c.w) > 0.0;
  return outline;
}
#endif

#ifdef HAS_LIMITS
// Faces of cells beyond a limit are at least so many pixels wide, and a little in front of their
// neighbors: they are found at a glance in any mesh.
const float leastWidth = 4.0;
const float leastNearer = 2.0e-4;

// How far the sides of a triangle move outwards for that, in pixels.
float findGrowth(Outline outline, uint cell)
{
  float value = texelFetch(valueTable, int(cell)).x;
  bool isBeyond = value < colorLimits.x || value > colorLimits.y;
  float width = 2.0 * abs(outline.area) / outline.longest;
  return isBeyond && outline.isSeen ? max(0.5 * (leastWidth - width), 0.0) : 0.0;
}

// Moves a corner of a triangle outwards of its two sides.
vec2 moveCorner(Outline outline, int corner, float growth)
{
  vec2 before = outline.corners[corner] - outline.corners[(corner + 2) % 3];
  vec2 after = outline.corners[(corner + 1) % 3] - outline.corners[corner];
  vec2 along = before / max(length(before), 1.0e-9) + after / max(length(after), 1.0e-9);
  return (outline.area < 0.0 ? -growth : growth) * vec2(along.y, -along.x);
}
#endif

// The current vertex: at a point of the mesh, or between two of them.
uint firstPoint = 0u;
uint secondPoint = 0u;
float between = 0.0;

vec4 ofPlace(samplerBuffer table)
{
  vec4 first = texelFetch(table, int(firstPoint));
  return between == 0.0 ? first : mix(first, texelFetch(table, int(secondPoint)), between);
}

#ifdef ARE_EDGES
// Offset of the vertex from the edge, in display coordinates.
vec2 sideOfEdge = vec2(0.0);
bool isEdgeSeen;

// Finds the end of the edge at which a vertex of its quad is; clips the edge at the near plane of
// the camera.
void findEnd(uint cell, int corner)
{
  bool isEnd = corner == 1 || corner == 2 || corner == 4;
  vec4 first = MCDCMatrix * place(firstPoint, cell);
  vec4 last = MCDCMatrix * place(secondPoint, cell);
  float before = first.z + first.w;
  float after = last.z + last.w;
  float crossing = before / (before - after);
  float start = before < 0.0 ? crossing : 0.0;
  float end = after < 0.0 ? crossing : 1.0;
  between = isEnd ? end : start;
  isEdgeSeen = before > 0.0 || after > 0.0;

  vec4 from = mix(first, last, start);
  vec4 to = mix(first, last, end);
  vec2 along = (to.xy / to.w - from.xy / from.w) * viewportSize;
  along = dot(along, along) > 1.0e-12 ? normalize(along) : vec2(1.0, 0.0);
  vec2 across = (corner == 2 || corner == 4 || corner == 5 ? 1.0 : -1.0) * vec2(-along.y, along.x);
  // Extended at the ends, so that lines join.
  sideOfEdge = edgeWidth / viewportSize * (across + (isEnd ? along : -along));
}
#endif

void main()
{
#ifdef IS_ISOSURFACE
  uvec4 corner = texelFetch(cornerTable, gl_VertexID);
  uint cell = texelFetch(cellOfTetrahedronTable, int(corner.w)).x >> 4;
  firstPoint = corner.x;
  secondPoint = corner.y;
  between = float(corner.z) / 16777216.0;
  isCutFace = 0;
#else
#ifdef ARE_EDGES
  int edge = gl_VertexID / 6;
  int row = edge / 3;
#else
  int row = gl_VertexID / 3;
#endif
  uint entry = isListed == 1 ? texelFetch(visibleTable, row).x : uint(row) << 1;
  int side = int(entry & 1u);
  uvec4 triangle = texelFetch(triangleTable, int(entry >> 1));
  uvec2 cells = texelFetch(faceTable, int(triangle.w >> 3)).xy;
  uint cell = cells[side];
  // For the second cell, the orientation of the face is reversed.
#ifdef ARE_EDGES
  int corner = edge - 3 * row;
  firstPoint = triangle[corner];
  secondPoint = triangle[corner == 2 ? 0 : corner + 1];
  findEnd(cell, gl_VertexID - 6 * edge);
  // Diagonals of polygons are not edges.
  isEdgeSeen = isEdgeSeen && (triangle.w >> corner & 1u) == 1u;
#else
  int corner = gl_VertexID - 3 * row;
  firstPoint = triangle[side == 1 ? 2 - corner : corner];
  secondPoint = firstPoint;
  between = 0.0;
#endif
  isCutFace = isListed == 1 && cells[1] != 0xffffffffu ? 1 : 0;
#endif
  vertexMC = mix(place(firstPoint, cell), place(secondPoint, cell), between);
#ifdef HAS_POSITION
  positionOfFragment = vertexMC.xyz;
#endif
#ifdef HAS_NEGATIVES
  uint apex = texelFetch(tetrahedronTable, int(corner.w)).x & 0x3fffffffu;
  placeOfFragment = vertexMC.xyz;
  weightOfFirst = firstPoint == apex ? 1.0 - between : secondPoint == apex ? between : 0.0;
#endif
  cellOfFace = cell;
  cellMarks = texelFetch(markTable, int(cell)).x;

#ifdef HAS_LOOKS
  lookOfBlock = texelFetch(lookTable, int(texelFetch(leafTable, int(cell)).x));
#endif
  findInputs(vertexMC);
#ifdef HAS_NORMALS
  vec3 origin = texelFetch(pointTable, int(triangle[0])).xyz;
  vec3 flatNormal = normalize(cross(normalize(texelFetch(pointTable, int(triangle[1])).xyz - origin),
    normalize(texelFetch(pointTable, int(triangle[2])).xyz - origin)));
  vec3 normal = texelFetch(normalTable, int(firstPoint)).xyz;
  // Also if the point has no normal.
  normal = dot(normal, flatNormal) >= smoothCosine ? normal : flatNormal;

  // Interior faces are not part of the smooth surface.
  normalOfCorners = isCutFace == 1 ? vec3(0.0) : normalMatrix * normal;
#endif
#if defined(HAS_LINES) || defined(HAS_LIMITS)
  vec4 a = MCDCMatrix * place(triangle[0], cell);
  vec4 b = MCDCMatrix * place(triangle[1], cell);
  vec4 c = MCDCMatrix * place(triangle[2], cell);
  Outline outline = findOutline(a, b, c);
#endif
#ifdef HAS_LIMITS
  float growth = findGrowth(outline, cell);
#endif
#ifdef HAS_LINES
  // Diagonals of polygons are not edges: place them far away.
  const vec3 nowhere = vec3(0.0, 0.0, 1.0e9);
  lines[0] = (triangle.w & 1u) != 0u ? lineThrough(a, b) : nowhere;
  lines[1] = (triangle.w & 2u) != 0u ? lineThrough(b, c) : nowhere;
  lines[2] = (triangle.w & 4u) != 0u ? lineThrough(c, a) : nowhere;
  // Pixels from a line to the next. Polygons consist of triangles; those at their corners are
  // narrower than they are.
  const float narrower = 3.0;
  vec3 heights = abs(vec3(dot(lines[0], vec3(outline.corners[2], 1.0)),
    dot(lines[1], vec3(outline.corners[0], 1.0)), dot(lines[2], vec3(outline.corners[1], 1.0))));
  vec3 spaces = min(vec3(outline.longest), narrower * heights);
  uint last = max(max(triangle.x, triangle.y), triangle.z);
  spaces *= int(last) >= numberOfNodes ? partsOfEdge : 1.0;
  // Where lines are close, they would hide the colors: a line of a pixel fades where it would cover
  // more than an eighth of the faces, and is gone where it would cover half of them.
  const float wide = 16.0, narrow = 4.0;
  strengths = outline.isSeen ? clamp((spaces - narrow) / (wide - narrow), 0.0, 1.0) : vec3(1.0);
#ifdef HAS_LIMITS
  strengths = growth > 0.0 ? vec3(0.0) : strengths;
#endif
#endif
#ifdef IS_PICKING
  pickedPoint = between < 0.5 ? firstPoint : secondPoint;
  pickedOwner = texelFetch(ownerTable, int(cell)).xy;
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

  if ((cellMarks & 2u) != 0u)
  {
    gl_Position = vec4(0.0, 0.0, 2.0, 1.0); // of a hidden block: draw nothing
  }

#ifdef ARE_EDGES
  gl_Position.xy += sideOfEdge * gl_Position.w;
  if (!isEdgeSeen)
  {
    gl_Position = vec4(0.0, 0.0, 2.0, 1.0);
  }
#endif
#if defined(HAS_LIMITS) && !defined(ARE_NODES)
  if (growth > 0.0)
  {
    vec2 move = moveCorner(outline, side == 1 ? 2 - corner : corner, growth);
    gl_Position.xy += 2.0 * move / viewportSize * gl_Position.w;
    gl_Position.z -= leastNearer * gl_Position.w;
  }
#endif
#ifdef ARE_POINTS
  gl_Position.z -= 1.0e-4 * gl_Position.w; // in front of the adjacent faces
#endif
#ifdef ARE_NODES
  if (int(firstPoint) >= numberOfNodes)
  {
    gl_Position = vec4(0.0, 0.0, 2.0, 1.0);
  }
#endif
}
