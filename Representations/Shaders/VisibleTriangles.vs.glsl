#version 150
// One run for each triangle: from which of its two cells it is seen.
uniform usamplerBuffer triangleTable;
uniform usamplerBuffer faceTable;
uniform usamplerBuffer keepTable;
uniform int bordersAreOpen; // 1: what another process has counts as not drawn, 0: as drawn with its neighbor
uniform int wallsToDraw; // 0: between drawn and not drawn, 1: between two drawn cells, 2: all of drawn cells, 3: as 1, of both

flat out uint triangleOfPoint;
flat out int sides; // bit 1: seen from the first cell, bit 2: from the second

void main()
{
  uvec2 cells = texelFetch(faceTable, int(texelFetch(triangleTable, gl_VertexID).w >> 3)).xy;
  uint first = texelFetch(keepTable, int(cells.x)).x;
  uint second = 0u;
  bool isFirstElsewhere = cells.y == 0xfffffffdu;
  if (isFirstElsewhere || cells.y == 0xfffffffeu)
  {
    bool isOpen = bordersAreOpen == 1 && wallsToDraw == 0;
    second = isOpen ? 0u : (first & 1u) | 2u;
  }
  else if (cells.y != 0xffffffffu)
  {
    second = texelFetch(keepTable, int(cells.y)).x;
  }
  bool isFirst = (first & 1u) == 1u;
  bool isSecond = (second & 1u) == 1u;
  bool isWall = isFirst && isSecond;
  bool areSeen = wallsToDraw == 2 || isWall == (wallsToDraw != 0);
  sides = 0;
  if (areSeen && isFirst && (first & 2u) == 0u && !(isFirstElsewhere && wallsToDraw == 1))
  {
    sides += 1;
  }
  if (areSeen && isSecond && (second & 2u) == 0u && wallsToDraw != 1)
  {
    sides += 2;
  }
  triangleOfPoint = uint(gl_VertexID);
  gl_Position = vec4(0.0);
}
