// Interior faces that a cut exposes have their own color.
uniform vec3 cutColor;

void cutFaces(inout vec3 ambient, inout vec3 diffuse, inout float opacity)
{
  if (isCutFace == 1)
  {
    ambient = ambientIntensity * cutColor;
    diffuse = diffuseIntensity * cutColor;
  }
}
