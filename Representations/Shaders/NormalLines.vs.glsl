//VTK::System::Dec
//Camaron::Defines
//Camaron::Place

// Lines along the normals of the visible faces or, with HAS_POINT_NORMALS, of the points of outer
// faces, as quads with a constant width in pixels: six vertices per line.

uniform usamplerBuffer visibleTable;  // as in Faces.vs.glsl
uniform usamplerBuffer triangleTable;
uniform usamplerBuffer faceTable;
uniform usamplerBuffer markTable;
uniform int isListed;
uniform float normalLength;
uniform float normalWidth; // pixels
uniform vec2 viewportSize;
#ifdef HAS_POINT_NORMALS
uniform samplerBuffer normalTable;
#endif

// Inputs of modes; no mode is on.
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

// Start and direction of the line of a face; length 0: no line. The first triangle of a face draws
// its line.
void findLine(int first, uint cell, out vec3 start, out vec3 normal)
{
  uint face = texelFetch(triangleTable, first).w >> 3;
  start = normal = vec3(0.0);
  if (first > 0 && texelFetch(triangleTable, first - 1).w >> 3 == face)
  {
    return;
  }
  float size = 0.0;
  float scale = max(normalLength, 1.0e-30); // squares of large coordinates overflow float
  int end = textureSize(triangleTable);
  for (int i = first; i < end; ++i)
  {
    uvec4 triangle = texelFetch(triangleTable, i);
    if (triangle.w >> 3 != face)
    {
      break;
    }
    vec3 a = place(triangle[0], cell).xyz;
    vec3 b = place(triangle[1], cell).xyz;
    vec3 c = place(triangle[2], cell).xyz;
    vec3 area = cross((b - a) / scale, (c - a) / scale);
    normal += area;
    start += length(area) * (a + b + c) / 3.0;
    size += length(area);
  }
  start /= max(size, 1.0e-30);
}

void main()
{
  int line = gl_VertexID / 6;
  int corner = gl_VertexID - 6 * line;
#ifdef HAS_POINT_NORMALS
  int row = line / 3;
#else
  int row = line;
#endif
  uint entry = isListed == 1 ? texelFetch(visibleTable, row).x : uint(row) << 1;
  int side = int(entry & 1u);
  int index = int(entry >> 1);
  uvec4 triangle = texelFetch(triangleTable, index);
  uvec2 cells = texelFetch(faceTable, int(triangle.w >> 3)).xy;
  uint cell = cells[side];
  cellOfFace = cell;
  cellMarks = texelFetch(markTable, int(cell)).x;
  isCutFace = 0;

  vec3 start, normal;
#ifdef HAS_POINT_NORMALS
  uint point = triangle[line - 3 * row];
  start = place(point, cell).xyz;
  bool isOutside = isListed == 0 || cells[1] == 0xffffffffu;
  normal = isOutside ? texelFetch(normalTable, int(point)).xyz : vec3(0.0);
#else
  findLine(index, cell, start, normal);
  normal = side == 1 ? -normal : normal;
#endif
  float size = (cellMarks & 2u) != 0u ? 0.0 : length(normal);
  vec3 end = start + normal * (normalLength / max(size, 1.0e-30));
  bool isEnd = corner == 1 || corner == 2 || corner == 4;
  vertexMC = vec4(isEnd ? end : start, 1.0);
#ifdef HAS_POSITION
  positionOfFragment = start; // lines are never cut
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

  vec4 first = MCDCMatrix * vec4(start, 1.0);
  vec4 last = MCDCMatrix * vec4(end, 1.0);
  if (!(size > 0.0) || first.w <= 0.0 || last.w <= 0.0)
  {
    gl_Position = vec4(0.0, 0.0, 2.0, 1.0); // draw nothing
    return;
  }
  vec2 along = (last.xy / last.w - first.xy / first.w) * viewportSize;
  vec2 across = dot(along, along) > 1.0e-12 ? normalize(vec2(-along.y, along.x)) : vec2(1.0, 0.0);
  float way = corner == 2 || corner == 4 || corner == 5 ? 1.0 : -1.0;
  gl_Position = isEnd ? last : first;
  gl_Position.xy += way * normalWidth / viewportSize * across * gl_Position.w;
}
