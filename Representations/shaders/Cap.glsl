// Where the line of sight meets the boundary of the shape, and what there is in the tetrahedron at that place.
// (InShape.glsl, the modes and Inputs.glsl go before.)
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

// Of the two places where the line from the eye goes into the shape and out of it, the one that can be seen.
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

// How weights change by a step, the part of it along the cut.
vec4 ratesAlong(vec3 way, vec3 normal)
{
  vec3 others = toWeights * (way - dot(way, normal) * normal);
  return vec4(-others.x - others.y - others.z, others);
}

void findLines()
{
#ifdef HAS_LINES
  // The weight of a corner is 0 on the face opposite; the rate at which it grows makes it pixels. Steps to the
  // next pixel are in the cut to the last digit: along a face beside the cut, the weight does not grow.
  vec3 normal = normalize(hitNormal);
  vec4 right = ratesAlong(dFdx(hitPlace), normal);
  vec4 up = ratesAlong(dFdy(hitPlace), normal);
  vec4 rates = sqrt(right * right + up * up);
  vec4 pixels = abs(hitWeights) / max(rates, 1.0e-30);
  pixelsToWall = 1.0e9;
  for (int i = 0; i < 4; ++i)
  {
    pixelsToWall = (walls >> i & 1u) == 1u ? min(pixelsToWall, pixels[i]) : pixelsToWall;
  }
#endif
}
