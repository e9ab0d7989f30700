// Colors edges that are drawn as lines, without faces.
uniform vec3 edgesColor;
uniform int edgesOfSelectedOnly; // 1: only edges of selected cells

void edgesAlone(inout vec3 ambient, inout vec3 diffuse)
{
  if (edgesOfSelectedOnly == 1 && (cellMarks & 4u) == 0u)
  {
    discard;
  }
  ambient = edgesColor;
  diffuse = vec3(0.0);
}
