// Grays out values inside or outside of the range, so that the others stand out. Undefined values
// count as outside.
uniform vec2 acceptableRange;
uniform int emphasizesInside;
uniform float dimming; // 0: none, 1: all the same gray
uniform vec4 accent;   // a color of the others, and its share

void emphasis(inout vec3 ambient, inout vec3 diffuse, inout float opacity)
{
  float value = getValue();
  bool isInside = value >= acceptableRange.x && value <= acceptableRange.y;
  if (isInside != (emphasizesInside == 1))
  {
    const vec3 gray = vec3(0.8);
    ambient = mix(ambient, ambientIntensity * gray, dimming);
    diffuse = mix(diffuse, diffuseIntensity * gray, dimming);
  }
  else
  {
    ambient = mix(ambient, ambientIntensity * accent.rgb, accent.a);
    diffuse = mix(diffuse, diffuseIntensity * accent.rgb, accent.a);
  }
}
