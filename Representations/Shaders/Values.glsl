// For faces, inputs that vary come from the vertex shader; for caps, Cap.glsl computes them.
#ifdef IS_CAP
#define VARYING
#else
#define VARYING in
#endif

// The value that colors the cell or point; NaN if it is undefined.
#ifdef HAS_CELL_VALUES
uniform samplerBuffer valueTable;
float getValue() { return texelFetch(valueTable, int(cellOfFace)).x; }
#elif defined(HAS_POINT_VALUES)
VARYING float valueOfPoint;
float getValue() { return valueOfPoint; }
#endif
