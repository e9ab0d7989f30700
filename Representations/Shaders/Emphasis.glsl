// Grays out values inside the range, so that the others stand out; undefined values also keep their
// color.
uniform vec2 acceptableRange;
uniform float dimming; // 0: none, 1: all the same gray

void emphasis(inout vec3 ambient, inout vec3 diffuse, inout float opacity)
{
  float value = getValue();
  if (value >= acceptableRange.x && value <= acceptableRange.y)
  {
    const vec3 gray = vec3(0.8);
    ambient = mix(ambient, ambientIntensity * gray, dimming);
    diffuse = mix(diffuse, diffuseIntensity * gray, dimming);
  }
}
