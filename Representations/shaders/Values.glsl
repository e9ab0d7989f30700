// The value that the cell or point is coloured by: a number, or not one where it is null.
#ifdef HAS_CELL_VALUES
uniform samplerBuffer valueTable;
float getValue() { return texelFetch(valueTable, int(cellOfFace)).x; }
#elif defined(HAS_POINT_VALUES)
in float valueOfPoint;
float getValue() { return valueOfPoint; }
#endif
