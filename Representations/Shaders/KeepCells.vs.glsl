// Runs once per cell: decides whether it is drawn. Value 1 of the result: it is drawn; value 2: it
// is a ghost cell, drawn by another piece of the mesh. Preceded by InShape.glsl.
uniform usamplerBuffer markTable;
uniform samplerBuffer pointTable;
uniform samplerBuffer centroidTable;
uniform usamplerBuffer cellOffsetTable;
uniform usamplerBuffer cellPointTable;
uniform int cutBy;      // 0: no cut, 1: centroid, 2: any vertex, 3: all vertices
uniform int keepInside; // 0: keep the cells outside
uniform int cellsToDraw; // 0: all, 1: selected cells, 2: the others

flat out uint keep;

bool isCellInShape()
{
  if (cutBy == 1)
  {
    return isInShape(texelFetch(centroidTable, gl_VertexID).xyz);
  }
  int begin = int(texelFetch(cellOffsetTable, gl_VertexID).x);
  int end = int(texelFetch(cellOffsetTable, gl_VertexID + 1).x);
  bool any = cutBy == 2;
  for (int i = begin; i < end; ++i)
  {
    uint point = texelFetch(cellPointTable, i).x;
    if (isInShape(texelFetch(pointTable, int(point)).xyz) == any)
    {
      return any;
    }
  }
  return !any && end > begin;
}

void main()
{
  uint marks = texelFetch(markTable, gl_VertexID).x;
  bool isSelected = (marks & 4u) != 0u;
  bool isKept = (marks & 2u) == 0u && (cellsToDraw == 0 || isSelected == (cellsToDraw == 1));
  if (isKept && cutBy != 0)
  {
    isKept = isCellInShape() == (keepInside == 1);
  }
  keep = (isKept ? 1u : 0u) | ((marks & 1u) << 1);
  gl_Position = vec4(0.0);
}
