//VTK::System::Dec

// Which triangle is seen in a pixel: 1 + (triangle << 1 | side).
flat in uint entryOfTriangle;
out uint pixel;

//Camaron::CutExactly::Dec

void main()
{
  //Camaron::CutExactly::Impl
  pixel = entryOfTriangle + 1u;
}
