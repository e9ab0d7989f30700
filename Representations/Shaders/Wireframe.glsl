// Draws edges of faces in the same pass, by the distance to the nearest edge in pixels.
#ifdef IS_CAP
float pixelsToWall;
#else
flat in vec3 lines[3];
flat in float pixelsOfFace;
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
  float nearest = pixelsToWall;
#else
  vec3 pixel = vec3(gl_FragCoord.xy - viewportOrigin, 1.0);
  float nearest = min(abs(dot(lines[0], pixel)), min(abs(dot(lines[1], pixel)), abs(dot(lines[2], pixel))));
#endif
  float amount = clamp(0.5 * edgeWidth + 0.5 - nearest, 0.0, 1.0);
#ifndef IS_CAP
  // Edges of tiny faces would hide the colors: those of triangles, of which polygons consist, fade
  // below 10 pixels, and are gone below 2.
  amount *= hasFaces == 1 ? clamp((pixelsOfFace - 2.0) / 8.0, 0.0, 1.0) : 1.0;
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
