//VTK::System::Dec

// Writes the triangle that is visible in the pixel: 1 + (triangle << 1 | side).
flat in uint entryOfTriangle;
out uint pixel;

//Camaron::CutExactly::Dec

void main()
{
  //Camaron::CutExactly::Impl
  pixel = entryOfTriangle + 1u;
}
