#version 150
// Runs once per triangle: finds from which of its two cells it is visible.
uniform usamplerBuffer triangleTable;
uniform usamplerBuffer faceTable;
uniform usamplerBuffer keepTable;
// 1: cells of other processes count as not drawn, 0: as drawn if their neighbor is.
uniform int bordersAreOpen;
// 0: faces of one drawn cell, 1: faces between two drawn cells, 2: all faces of drawn cells, 3: as
// 1, for both cells
uniform int facesToDraw;

flat out uint triangleOfPoint;
flat out int sides; // value 1: visible from the first cell, value 2: from the second

void main()
{
  uvec2 cells = texelFetch(faceTable, int(texelFetch(triangleTable, gl_VertexID).w >> 3)).xy;
  uint first = texelFetch(keepTable, int(cells.x)).x;
  uint second = 0u;
  bool isFirstElsewhere = cells.y == 0xfffffffdu;
  if (isFirstElsewhere || cells.y == 0xfffffffeu)
  {
    bool isOpen = bordersAreOpen == 1 && facesToDraw == 0;
    second = isOpen ? 0u : (first & 1u) | 2u;
  }
  else if (cells.y != 0xffffffffu)
  {
    second = texelFetch(keepTable, int(cells.y)).x;
  }
  bool isFirst = (first & 1u) == 1u;
  bool isSecond = (second & 1u) == 1u;
  bool isInterior = isFirst && isSecond;
  bool areSeen = facesToDraw == 2 || isInterior == (facesToDraw != 0);
  sides = 0;
  if (areSeen && isFirst && (first & 2u) == 0u && !(isFirstElsewhere && facesToDraw == 1))
  {
    sides += 1;
  }
  if (areSeen && isSecond && (second & 2u) == 0u && facesToDraw != 1)
  {
    sides += 2;
  }
  triangleOfPoint = uint(gl_VertexID);
  gl_Position = vec4(0.0);
}
