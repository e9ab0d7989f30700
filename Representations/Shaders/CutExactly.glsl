// What is on the other side of the boundary of the shape is not drawn.
uniform int keepInside;
in vec3 positionOfFragment;

void cutExactly()
{
  if (isInShape(positionOfFragment) != (keepInside == 1))
  {
    discard;
  }
}
