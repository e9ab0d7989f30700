// What modes take from the place that is drawn: of a face the vertex shader finds it at the corners (Faces.vs.glsl),
// of a cap the fragment shader at each pixel (Cap.glsl), which has it in variables instead of outputs.
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

// The row of a table of points for the place: that of a point, or between several.
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
