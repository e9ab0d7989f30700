// Values in the range become grey, so that the others stand out; null ones keep their colour, too.
uniform vec2 acceptableRange;
uniform float dimming; // 0: not at all, 1: all the same grey

void emphasis(inout vec3 ambient, inout vec3 diffuse, inout float opacity)
{
  float value = getValue();
  if (value >= acceptableRange.x && value <= acceptableRange.y)
  {
    const vec3 grey = vec3(0.8);
    ambient = mix(ambient, ambientIntensity * grey, dimming);
    diffuse = mix(diffuse, diffuseIntensity * grey, dimming);
  }
}
