// The normal between those of the corners, where they have one.
in vec3 normalOfCorners;

void smoothNormals(inout vec3 normal)
{
  float size = length(normalOfCorners);
  if (size > 1.0e-6)
  {
    vec3 between = normalOfCorners / size;
    normal = dot(between, normal) < 0.0 ? -between : between; // as the face, towards the eye
  }
}
