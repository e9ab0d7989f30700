// Applies the color and opacity of a block that has its own.
flat in vec4 lookOfBlock;

void blocks(inout vec3 ambient, inout vec3 diffuse, inout float opacity)
{
  if (lookOfBlock.r >= 0.0)
  {
    ambient = ambientIntensity * lookOfBlock.rgb;
    diffuse = diffuseIntensity * lookOfBlock.rgb;
    opacity = opacityUniform;
  }
  if (lookOfBlock.a >= 0.0)
  {
    opacity = lookOfBlock.a;
  }
}
