// If the first point of a cell does not see the whole cell, its tetrahedra overlap and extend
// beyond the cell. A position is in the cell, and drawn as part of this tetrahedron, if there is no
// negative tetrahedron between it and the tetrahedron's face of the cell, as seen from the first
// point (see CellTetrahedra.h). Preceded by Place.glsl.
uniform usamplerBuffer tetrahedronTable; // points below bit 30; bit 30 of the fourth: negative
// cell << 4 | bits: its faces that lie in faces of the cell
uniform usamplerBuffer cellOfTetrahedronTable;
uniform usamplerBuffer firstNegativeTable;
uniform samplerBuffer negativeBoxTable; // lower end, next; upper end, last: see CellTetrahedra.h
const float width = 1.0e-4; // tolerance around a tetrahedron; as in Cap.glsl

#if defined(IS_CAP) && defined(HAS_LINES)
float reachOfLines(); // distance from faces within which lines are drawn
void addWalls(uint bits, vec4 weights, mat3 weightsOfOthers);
#endif

bool isMet(vec3 low, vec3 high, vec3 start, vec3 way)
{
  vec3 toLow = (low - start) / way;
  vec3 toHigh = (high - start) / way;
  vec3 into = min(toLow, toHigh);
  vec3 out_ = max(toLow, toHigh);
  return max(max(into.x, into.y), max(into.z, 0.0)) <= min(min(out_.x, out_.y), min(out_.z, 1.0));
}

bool isNegative(uvec4 stored)
{
  return (stored.w >> 30 & 1u) == 1u;
}

// Gradients of the weights of all points except the first in a tetrahedron of the cell.
mat3 getRates(uvec4 stored, vec3 first)
{
  vec3 a = place(stored.y & 0x3fffffffu, cellOfFace).xyz - first;
  vec3 b = place(stored.z & 0x3fffffffu, cellOfFace).xyz - first;
  vec3 c = place(stored.w & 0x3fffffffu, cellOfFace).xyz - first;
  return inverseOf(mat3(a, b, c));
}

vec4 getWeights(vec3 fromFirst, mat3 rates)
{
  vec3 others = rates * fromFirst;
  return vec4(1.0 - others.x - others.y - others.z, others);
}

// Where faces touch, and at their edges, distances are inconclusive. A position in the cell is in
// one more tetrahedron that is not negative than in negative ones.
bool isInMore(vec3 fromFirst, vec3 first, int row)
{
  int sum = 0;
  for (; row < textureSize(tetrahedronTable); ++row)
  {
    if (texelFetch(cellOfTetrahedronTable, row).x >> 4 != cellOfFace)
    {
      break;
    }
    uvec4 stored = texelFetch(tetrahedronTable, row);
    bool isIn = all(greaterThanEqual(getWeights(fromFirst, getRates(stored, first)), vec4(-width)));
    sum += isIn ? (isNegative(stored) ? -1 : 1) : 0;
  }
  return sum > 0;
}

// Whether a position is in the cell. weightOfFirst: weight of the first point there, in the current
// tetrahedron.
bool isInCell(vec3 where, float weightOfFirst)
{
  uvec2 starts = texelFetch(firstNegativeTable, int(cellOfFace)).xy;
  if (starts.x == 0xffffffffu)
  {
    return true;
  }
  const float digits = 1.0e-5;
  int begin = int(starts.x);
  vec3 first = place(texelFetch(tetrahedronTable, begin).x & 0x3fffffffu, cellOfFace).xyz;
  vec3 fromFirst = where - first;
  vec3 toFace = fromFirst * (weightOfFirst / max(1.0 - weightOfFirst, digits));
  toFace += vec3(lessThan(abs(toFace), vec3(1.0e-30))) * 1.0e-30; // not parallel to a side of boxes
  vec3 slack = vec3(10.0 * digits * length(fromFirst + toFace));
  bool isClear = true;
  int end = begin + int(texelFetch(negativeBoxTable, 2 * int(starts.y) + 1).w);
  int node = 0;
  for (int row = begin; row < end;)
  {
    vec4 low = texelFetch(negativeBoxTable, 2 * (int(starts.y) + node));
    vec4 high = texelFetch(negativeBoxTable, 2 * (int(starts.y) + node) + 1);
    vec3 margin = slack + width * (high.xyz - low.xyz);
    low.xyz = move(low.xyz, cellOfFace);
    high.xyz = move(high.xyz, cellOfFace);
    bool isWanted = isMet(low.xyz - margin, high.xyz + margin, where, toFace);
#if defined(IS_CAP) && defined(HAS_LINES)
    float reach = reachOfLines();
    isWanted = isWanted || (all(lessThan(low.xyz - reach, where)) && all(lessThan(where, high.xyz + reach)));
#endif
    int last = begin + int(high.w);
    bool isLeaf = int(low.w) == node + 1;
    node = isWanted ? node + 1 : int(low.w);
    if (!isWanted)
    {
      row = last;
    }
    for (; isWanted && isLeaf && row < last; ++row)
    {
      uvec4 stored = texelFetch(tetrahedronTable, row);
      mat3 rates = getRates(stored, first);
      vec4 weights = getWeights(fromFirst, rates);
      if (all(greaterThanEqual(weights, vec4(0.0, -width, -width, -width))) && weights.x < weightOfFirst + digits)
      {
        if (weights.x < weightOfFirst - digits)
        {
          return false;
        }
        isClear = false;
      }
#if defined(IS_CAP) && defined(HAS_LINES)
      addWalls(texelFetch(cellOfTetrahedronTable, row).x, weights, rates);
#endif
    }
  }
  return isClear || isInMore(fromFirst, first, begin);
}

#ifdef IS_ISOSURFACE
in vec3 placeOfFragment;
in float weightOfFirst;

void leaveOutside()
{
  if (!isInCell(placeOfFragment, weightOfFirst))
  {
    discard;
  }
}
#endif
