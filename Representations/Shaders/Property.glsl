// Applies the color of the cell or point from the transfer function. With HAS_COLOR_COORDINATES,
// VTK's own code looks up the color texture.
#ifdef HAS_CELL_COLORS
uniform samplerBuffer colorTable;
#endif
#ifdef HAS_COLOR_COORDINATES
VARYING vec2 colorTCoordVCVSOutput;
uniform sampler2D colortexture;
#endif
#ifdef HAS_POINT_COLORS
VARYING vec4 colorOfPoint;
#endif

void property(inout vec3 ambient, inout vec3 diffuse, inout float opacity)
{
#if defined(HAS_CELL_COLORS) || defined(HAS_POINT_COLORS)
#ifdef HAS_CELL_COLORS
  vec4 color = texelFetch(colorTable, int(cellOfFace));
#else
  vec4 color = colorOfPoint;
#endif
  ambient = ambientIntensity * color.rgb;
  diffuse = diffuseIntensity * color.rgb;
  opacity = opacityUniform * color.a;
#endif
}
