// A color between two: by the value (HAS_..._VALUES) or by the distance from a plane, which the vertex shader
// tells in parts of the range (HAS_DISTANCE).
uniform vec3 lowColor;
uniform vec3 highColor;
#ifdef HAS_DISTANCE
VARYING float distancePart;
#else
uniform vec3 nullColor;
uniform vec2 rampRange;
#endif

void ramp(inout vec3 ambient, inout vec3 diffuse, inout float opacity)
{
#ifdef HAS_DISTANCE
  vec3 color = mix(lowColor, highColor, clamp(distancePart, 0.0, 1.0));
#else
  float value = getValue();
  float part = (value - rampRange.x) / max(rampRange.y - rampRange.x, 1.0e-30);
  vec3 color = isnan(value) ? nullColor : mix(lowColor, highColor, clamp(part, 0.0, 1.0));
#endif
  ambient = ambientIntensity * color;
  diffuse = diffuseIntensity * color;
}
