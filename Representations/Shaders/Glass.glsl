// Faces seen at grazing angles are more opaque, like a thin shell of glass.
uniform float glassStrength;

void glass(inout float opacity, vec3 normal, vec3 position)
{
  vec3 toEye = cameraParallel == 1 ? vec3(0.0, 0.0, 1.0) : -normalize(position);
  float facing = abs(dot(normalize(normal), toEye));
  opacity *= glassStrength * mix(1.0, 0.15, facing);
}
