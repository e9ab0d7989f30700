// Uses the interpolated normal of the vertices if they have one.
in vec3 normalOfCorners;

void smoothNormals(inout vec3 normal)
{
  float size = length(normalOfCorners);
  if (size > 1.0e-6)
  {
    vec3 between = normalOfCorners / size;
    // On the same side as that of the face, towards the eye.
    normal = dot(between, normal) < 0.0 ? -between : between;
  }
}
