// Inputs of modes that vary over the drawn object. For faces, the vertex shader computes them at
// the vertices (Faces.vs.glsl). For caps, the fragment shader computes them at each pixel
// (Cap.glsl), as variables, not outputs.
#ifdef IS_CAP
#define INPUT(declaration)
#else
#define INPUT(declaration) out declaration;
#endif

#if defined(HAS_POINT_COLORS) || defined(HAS_COLOR_COORDINATES)
uniform samplerBuffer colorTable;
#endif
#ifdef HAS_POINT_COLORS
INPUT(vec4 colorOfPoint)
#endif
#ifdef HAS_COLOR_COORDINATES
INPUT(vec2 colorTCoordVCVSOutput)
#endif
#ifdef HAS_POINT_VALUES
uniform samplerBuffer valueTable;
INPUT(float valueOfPoint)
#endif
#ifdef HAS_DISTANCE
uniform vec4 distanceRamp;
INPUT(float distancePart)
#endif
#ifdef HAS_ISOLINES
uniform samplerBuffer levelTable;
INPUT(float level)
#endif

// The row of a point table at the current position: that of a point, or interpolated between
// several.
vec4 ofPlace(samplerBuffer table);

void findInputs(vec4 place)
{
#ifdef HAS_POINT_COLORS
  colorOfPoint = ofPlace(colorTable);
#endif
#ifdef HAS_COLOR_COORDINATES
  colorTCoordVCVSOutput = ofPlace(colorTable).xy;
#endif
#ifdef HAS_POINT_VALUES
  valueOfPoint = ofPlace(valueTable).x;
#endif
#ifdef HAS_DISTANCE
  distancePart = dot(distanceRamp, place);
#endif
#ifdef HAS_ISOLINES
  level = ofPlace(levelTable).x;
#endif
}
