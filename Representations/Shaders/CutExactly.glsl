// Discards pixels on the side of the boundary that is cut away.
uniform int keepInside;
in vec3 positionOfFragment;

void cutExactly()
{
  if (isInShape(positionOfFragment) != (keepInside == 1))
  {
    discard;
  }
}
