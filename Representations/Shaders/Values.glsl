// Modes take what changes over a face from the vertex shader; of a cap, Cap.glsl finds it.
#ifdef IS_CAP
#define VARYING
#else
#define VARYING in
#endif

// The value that the cell or point is colored by: a number, or not one where it is null.
#ifdef HAS_CELL_VALUES
uniform samplerBuffer valueTable;
float getValue() { return texelFetch(valueTable, int(cellOfFace)).x; }
#elif defined(HAS_POINT_VALUES)
VARYING float valueOfPoint;
float getValue() { return valueOfPoint; }
#endif
