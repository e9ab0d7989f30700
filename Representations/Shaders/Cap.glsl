// Finds the point where the line of sight meets the boundary of the shape, and its position in the
// tetrahedron. Preceded by InShape.glsl, the modes and Inputs.glsl.
flat in uvec4 corners;
flat in uint walls;
flat in vec3 firstCorner;
flat in mat3 toWeights;
in vec3 farPlace;
uniform vec4 eye;
uniform int keepInside;
uniform mat4 MCDCMatrix;
uniform mat4 MCVCMatrix;
uniform mat3 normalMatrix;

vec3 hitPlace;
vec3 hitNormal;
vec4 hitWeights;

// The line from the eye enters and leaves the shape: finds the visible one of these two points.
bool findHit()
{
  vec3 along = eye.w == 1.0 ? farPlace - eye.xyz : -eye.xyz;
  float into = -1.0e30;
  float out_ = 1.0e30;
  vec3 normalIn = vec3(0.0);
  vec3 normalOut = vec3(0.0);
  if (numberOfPlanes == 0)
  {
    mat3 linear = mat3(toUnitSphere);
    vec3 start = (toUnitSphere * vec4(farPlace, 1.0)).xyz;
    vec3 way = linear * along;
    float a = dot(way, way);
    float b = dot(start, way);
    float root = b * b - a * (dot(start, start) - 1.0);
    if (!(root > 0.0 && a > 0.0))
    {
      hitPlace = farPlace;
      return false;
    }
    into = (-b - sqrt(root)) / a;
    out_ = (-b + sqrt(root)) / a;
    normalIn = transpose(linear) * (start + into * way);
    normalOut = transpose(linear) * (start + out_ * way);
  }
  for (int i = 0; i < numberOfPlanes; ++i)
  {
    float height = dot(planes[i], vec4(farPlace, 1.0));
    float slope = dot(planes[i].xyz, along);
    float where = -height / slope;
    if (slope < 0.0 && where > into)
    {
      into = where;
      normalIn = planes[i].xyz;
    }
    else if (slope > 0.0 && where < out_)
    {
      out_ = where;
      normalOut = planes[i].xyz;
    }
    else if (slope == 0.0 && height > 0.0)
    {
      out_ = -1.0e30;
    }
  }
  float hit = keepInside == 1 ? into : out_;
  hitPlace = farPlace + hit * along;
  hitNormal = keepInside == 1 ? normalIn : -normalOut;
  hitWeights.yzw = toWeights * (hitPlace - firstCorner);
  hitWeights.x = 1.0 - hitWeights.y - hitWeights.z - hitWeights.w;
  return into < out_ && (eye.w == 0.0 || hit > -1.0) &&
    all(greaterThanEqual(hitWeights, vec4(-1.0e-4)));
}

vec4 ofPlace(samplerBuffer table)
{
  vec4 sum = vec4(0.0);
  for (int i = 0; i < 4; ++i)
  {
    sum += hitWeights[i] * texelFetch(table, int(corners[i]));
  }
  return sum;
}

#ifdef HAS_LINES
// Steps to the next pixel, projected to the cut. The projection is exact to the last digit, because
// along a face close to the cut the weight of the opposite vertex does not change.
vec3 stepRight;
vec3 stepUp;

vec3 alongCut(vec3 way)
{
  vec3 normal = normalize(hitNormal);
  return way - dot(way, normal) * normal;
}

// Change of the weights by a step.
vec4 ratesAlong(vec3 way, mat3 weightsOfOthers)
{
  vec3 others = weightsOfOthers * way;
  return vec4(-others.x - others.y - others.z, others);
}

// Distances to the faces in pixels: the weight of a vertex is 0 on the opposite face; divide it by
// its rate of change.
vec4 pixelsToFaces(vec4 weights, mat3 weightsOfOthers)
{
  vec4 right = ratesAlong(stepRight, weightsOfOthers);
  vec4 up = ratesAlong(stepUp, weightsOfOthers);
  return abs(weights) / max(sqrt(right * right + up * up), 1.0e-30);
}
#endif

void findLines()
{
#ifdef HAS_LINES
  stepRight = alongCut(dFdx(hitPlace));
  stepUp = alongCut(dFdy(hitPlace));
  vec4 pixels = pixelsToFaces(hitWeights, toWeights);
  pixelsToWall = 1.0e9;
  for (int i = 0; i < 4; ++i)
  {
    pixelsToWall = (walls >> i & 1u) == 1u ? min(pixelsToWall, pixels[i]) : pixelsToWall;
  }
#endif
}

#ifdef HAS_NEGATIVES
#ifdef HAS_LINES
float reachOfLines()
{
  return (edgeWidth + 2.0) * max(length(stepRight), length(stepUp));
}

// Adds the faces of a negative tetrahedron if the point is directly behind one: then only one
// weight is below 0.
void addWalls(uint bits, vec4 weights, mat3 weightsOfOthers)
{
  vec4 pixels = pixelsToFaces(weights, weightsOfOthers);
  for (int i = 0; i < 4; ++i)
  {
    vec4 others = weights;
    others[i] = 0.0;
    if ((bits >> i & 1u) == 1u && weights[i] < 0.0 && all(greaterThanEqual(others, vec4(0.0))))
    {
      pixelsToWall = min(pixelsToWall, pixels[i]);
    }
  }
}
#endif

void leaveOutside()
{
  if (!isInCell(hitPlace, hitWeights.x))
  {
    discard;
  }
}
#endif
