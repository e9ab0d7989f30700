#version 150
// Outputs the one or two triangles of a tetrahedron on which the value is the isovalue. Each vertex
// is a row: two points, the position between them, and the tetrahedron. Vertices are distinguished
// by comparisons only, because some compilers generate wrong code for geometry shaders that index
// arrays with computed values.
layout(points) in;
layout(points, max_vertices = 6) out;

uniform float isovalue;

flat in uvec4 pointsOfTetrahedron[];
flat in vec4 values[];
flat in uint tetrahedron[];
flat out uvec4 corner;

void emit(uint a, float valueOfA, uint b, float valueOfB)
{
  // From the point with the smaller id, so that all cells at an edge compute the same position.
  bool isSwapped = b < a;
  uint first = isSwapped ? b : a;
  uint second = isSwapped ? a : b;
  float firstValue = isSwapped ? valueOfB : valueOfA;
  float secondValue = isSwapped ? valueOfA : valueOfB;
  float where = clamp((isovalue - firstValue) / (secondValue - firstValue), 0.0, 1.0);
  corner = uvec4(first, second, uint(where * 16777216.0), tetrahedron[0]);
  EmitVertex();
  EndPrimitive();
}

void main()
{
  uvec4 p = pointsOfTetrahedron[0];
  vec4 v = values[0];
  bool a = v.x >= isovalue;
  bool b = v.y >= isovalue;
  bool c = v.z >= isovalue;
  bool d = v.w >= isovalue;
  int above = int(a) + int(b) + int(c) + int(d);
  // NaN is on neither side.
  if (above == 0 || above == 4 || !(v.x == v.x && v.y == v.y && v.z == v.z && v.w == v.w) ||
    max(max(v.x, v.y), max(v.z, v.w)) >= 3.0e38)
  {
    return;
  }
  if (above == 1 || above == 3)
  {
    // The vertex that is alone on its side comes first.
    bool side = above == 1;
    if (b == side)
    {
      p = p.yxzw;
      v = v.yxzw;
    }
    else if (c == side)
    {
      p = p.zxyw;
      v = v.zxyw;
    }
    else if (d == side)
    {
      p = p.wxyz;
      v = v.wxyz;
    }
    emit(p.x, v.x, p.y, v.y);
    emit(p.x, v.x, p.z, v.z);
    emit(p.x, v.x, p.w, v.w);
    return;
  }
  // Two vertices on each side: the one on the side of the first comes second.
  if (c == a)
  {
    p = p.xzyw;
    v = v.xzyw;
  }
  else if (d == a)
  {
    p = p.xwyz;
    v = v.xwyz;
  }
  emit(p.x, v.x, p.z, v.z);
  emit(p.x, v.x, p.w, v.w);
  emit(p.y, v.y, p.w, v.w);
  emit(p.x, v.x, p.z, v.z);
  emit(p.y, v.y, p.w, v.w);
  emit(p.y, v.y, p.z, v.z);
}
