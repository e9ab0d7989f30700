// The colour of the cell or point by the transfer function. Coordinates of a colour texture (HAS_COLOR_COORDINATES)
// are VTK's business.
#ifdef HAS_CELL_COLORS
uniform samplerBuffer colorTable;
#endif
#ifdef HAS_POINT_COLORS
in vec4 colorOfPoint;
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
