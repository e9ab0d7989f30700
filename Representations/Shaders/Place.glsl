// Position at which a point is drawn as a vertex of a cell.
uniform samplerBuffer pointTable; // coordinates relative to the middle of the mesh on this process
#ifdef HAS_CENTROIDS
uniform samplerBuffer centroidTable;
uniform float shrinkFactor;  // 1: full size, 0: shrunk to the centroid
uniform float explodeFactor; // 0: not moved, 1: twice as far from the center
uniform vec3 explodeCenter;  // the middle of the mesh of all processes
#endif

vec3 move(vec3 position, uint cell)
{
#ifdef HAS_CENTROIDS
  vec3 center = texelFetch(centroidTable, int(cell)).xyz;
  position = mix(center, position, shrinkFactor) + explodeFactor * (center - explodeCenter);
#endif
  return position;
}

// The largest coordinate of three edges of a tetrahedron. In this unit, products of three lengths fit into float.
float sizeOf(mat3 edges)
{
  mat3 sizes = mat3(abs(edges[0]), abs(edges[1]), abs(edges[2]));
  vec3 largest = max(max(sizes[0], sizes[1]), sizes[2]);
  return max(max(largest.x, largest.y), largest.z);
}

mat3 inverseOf(mat3 edges)
{
  float size = sizeOf(edges);
  return inverse(edges / size) / size;
}

vec4 place(uint point, uint cell)
{
  return vec4(move(texelFetch(pointTable, int(point)).xyz, cell), 1.0);
}
