// Encodes the ids for the current pass of a hardware selection as a color; see vtkHardwareSelector.
flat in uint pickedPoint;
flat in uvec2 pickedOwner;

vec4 colorOfId(uint id)
{
  return vec4(float(id & 255u), float((id >> 8) & 255u), float((id >> 16) & 255u), 255.0) / 255.0;
}
