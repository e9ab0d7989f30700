// Draws edges of faces in the same pass, by the distance to the nearest edge in pixels.
#ifdef IS_CAP
float pixelsToWall;
#else
flat in vec3 lines[3];
flat in vec3 strengths;
uniform vec2 viewportOrigin;
#endif
uniform float edgeWidth;
uniform vec3 edgesColor;
uniform float edgesOpacity;
uniform int hasFaces;            // 0: only edges are drawn
uniform int edgesOfSelectedOnly; // 1: only edges of selected cells

void wireframe(inout vec3 ambient, inout vec3 diffuse, inout float opacity)
{
#ifdef IS_CAP
  float amount = clamp(0.5 * edgeWidth + 0.5 - pixelsToWall, 0.0, 1.0);
#else
  vec3 pixel = vec3(gl_FragCoord.xy - viewportOrigin, 1.0);
  vec3 distances = abs(vec3(dot(lines[0], pixel), dot(lines[1], pixel), dot(lines[2], pixel)));
  vec3 amounts = clamp(0.5 * edgeWidth + 0.5 - distances, 0.0, 1.0);
  amounts *= hasFaces == 1 ? strengths : vec3(1.0);
  float amount = max(max(amounts.x, amounts.y), amounts.z);
#endif
  if (edgesOfSelectedOnly == 1 && (cellMarks & 4u) == 0u)
  {
    amount = 0.0;
  }
  if (hasFaces == 0)
  {
    if (amount < 0.5)
    {
      discard;
    }
    amount = 1.0;
  }
  amount *= hasFaces == 1 ? edgesOpacity : 1.0;
  ambient = mix(ambient, edgesColor, amount);
  diffuse = mix(diffuse, vec3(0.0), amount);
}
