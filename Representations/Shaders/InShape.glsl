// Whether a point, relative to the middle of the mesh, is inside the convex shape of the cut.
uniform int numberOfPlanes; // 0: the shape is a sphere
uniform vec4 planes[64];    // inside where dot(plane, (x, y, z, 1)) <= 0, for all of them
uniform mat4 toUnitSphere;  // transforms the sphere to the unit sphere

bool isInShape(vec3 position)
{
  if (numberOfPlanes == 0)
  {
    vec3 unit = (toUnitSphere * vec4(position, 1.0)).xyz;
    return dot(unit, unit) <= 1.0;
  }
  for (int i = 0; i < numberOfPlanes; ++i)
  {
    if (dot(planes[i], vec4(position, 1.0)) > 0.0)
    {
      return false;
    }
  }
  return true;
}
