// Interpolates between two colors: by the value (HAS_..._VALUES), or with HAS_DISTANCE by the
// distance from a plane, which the vertex shader computes as a fraction of the range.
uniform vec3 lowColor;
uniform vec3 highColor;
#ifdef HAS_DISTANCE
VARYING float distancePart;
#else
uniform vec3 undefinedColor;
uniform vec2 rampRange;
#endif

void ramp(inout vec3 ambient, inout vec3 diffuse, inout float opacity)
{
#ifdef HAS_DISTANCE
  vec3 color = mix(lowColor, highColor, clamp(distancePart, 0.0, 1.0));
#else
  float value = getValue();
  float part = (value - rampRange.x) / max(rampRange.y - rampRange.x, 1.0e-30);
  vec3 color = isnan(value) ? undefinedColor : mix(lowColor, highColor, clamp(part, 0.0, 1.0));
#endif
  ambient = ambientIntensity * color;
  diffuse = diffuseIntensity * color;
}
