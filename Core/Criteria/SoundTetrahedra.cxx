// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Criteria/SoundTetrahedra.h"

#include <cmath>
#include <limits>

namespace camaron
{
namespace
{
// Squares, for which no root has to be taken, and products of which are numbers.
constexpr double LargestLength = 1e40, LargestVolume = 1e120, SmallestVolume = 1e-120;
constexpr double Margin = 4; // CellGeometry may round otherwise

//------------------------------------------------------------------------------
// All of a block, whose points follow each other.
bool AreTetrahedra(const MeshView& mesh, vtkIdType first)
{
  constexpr int size = SoundTetrahedra::Size;
  bool are = true;
  for (int cell = 0; cell < size; ++cell)
  {
    are &= mesh.GetCellType(first + cell) == VTK_TETRA;
  }
  return are &&
    mesh.GetCellPoints(first + size - 1).Begin - mesh.GetCellPoints(first).Begin == 4 * (size - 1);
}
}

//------------------------------------------------------------------------------
int SoundTetrahedra::Load(
  const MeshView& mesh, vtkIdType first, int numberOfCells, const EvaluationOptions& options)
{
  int numberOfTetrahedra = 0;
  mesh.VisitCoordinates([&](const auto* points)
    { numberOfTetrahedra = this->LoadPoints(mesh, points, first, numberOfCells); });
  return numberOfTetrahedra > 0 ? this->FindSound(mesh, options) : 0;
}

//------------------------------------------------------------------------------
template <typename Coordinate>
int SoundTetrahedra::LoadPoints(
  const MeshView& mesh, const Coordinate* points, vtkIdType first, int numberOfCells)
{
  if (numberOfCells == Size && AreTetrahedra(mesh, first))
  {
    // One after the other, as in nearly all of most meshes.
    const IndexRange ids = mesh.GetCellPoints(first);
    const auto load = [&](const auto* corners)
    {
      for (int cell = 0; cell < Size; ++cell)
      {
        this->LoadCell(cell, points, corners + 4 * cell);
      }
    };
    ids.Values.Values32 ? load(ids.Values.Values32 + ids.Begin)
                        : load(ids.Values.Values64 + ids.Begin);
    return Size;
  }
  int numberOfTetrahedra = 0;
  for (int cell = 0; cell < Size; ++cell)
  {
    if (cell >= numberOfCells || mesh.GetCellType(first + cell) != VTK_TETRA)
    {
      this->Places[cell] = std::numeric_limits<double>::quiet_NaN();
      this->AreSound[cell] = 0;
      continue;
    }
    ++numberOfTetrahedra;
    this->LoadCell(cell, points, mesh.GetCellPoints(first + cell));
  }
  return numberOfTetrahedra;
}

//------------------------------------------------------------------------------
template <typename Coordinate, typename Ids>
void SoundTetrahedra::LoadCell(int cell, const Coordinate* points, const Ids& ids)
{
  const Coordinate* const origin = points + 3 * static_cast<vtkIdType>(ids[0]);
  const double x = origin[0], y = origin[1], z = origin[2];
  this->Places[cell] = std::abs(x) + std::abs(y) + std::abs(z);
  for (int i = 0; i < 3; ++i)
  {
    const Coordinate* const point = points + 3 * static_cast<vtkIdType>(ids[i + 1]);
    this->Block.X[i][cell] = point[0] - x;
    this->Block.Y[i][cell] = point[1] - y;
    this->Block.Z[i][cell] = point[2] - z;
  }
}

//------------------------------------------------------------------------------
// Of this cell and the next.
void SoundTetrahedra::Measure(int cell)
{
  const TetrahedronPair pair(this->Block, cell);
  const VectorPair a = pair.GetPoint(1), b = pair.GetPoint(2), c = pair.GetPoint(3);
  StorePair(Dot(a, Cross(b, c)) / MakePair(6, 6), this->Block.Volumes + cell);
  const Pair squares[] = { Norm2(a), Norm2(c - a), Norm2(c), Norm2(b - a), Norm2(c - b), Norm2(b) };
  for (int edge = 0; edge < 6; ++edge)
  {
    StorePair(squares[edge], this->Block.SquaredLengths[edge] + cell);
  }
  const Pair longest =
    Max(Max(Max(squares[0], squares[1]), Max(squares[2], squares[3])), Max(squares[4], squares[5]));
  StorePair(longest, this->Block.MaxSquaredLengths + cell);
}

//------------------------------------------------------------------------------
// A volume well above zero leaves no room for an edge or a face that is zero.
int SoundTetrahedra::FindSound(const MeshView& mesh, const EvaluationOptions& options)
{
  // The zero length is the larger of two that grow with the diameter, and with it and the place; here they are squared,
  // and (a + b)^2 <= 2 (a^2 + b^2).
  const double tolerance = camaron::GetZeroLength(options, 1, 0);
  const double precision =
    options.DegeneracyTolerance > 0 ? 0 : GetAbsoluteTolerance(1, mesh.HasFloatPoints());
  const auto both = [](double value) { return MakePair(value, value); };
  const Pair relative = both(Margin * tolerance * tolerance), absolute = both(2 * Margin * precision * precision);
  const Pair none = both(0);
  Pair sum = none;
  for (int cell = 0; cell < Size; cell += 2)
  {
    this->Measure(cell);
    const TetrahedronPair pair(this->Block, cell);
    const Pair length = pair.GetMaxSquaredLength(), place = LoadPair(this->Places + cell);
    const Pair zero = Max(relative * length, absolute * (place * place + length));
    const Pair volume = pair.GetVolume() * pair.GetVolume();
    // Above zero where all is well. A volume is no number or infinite where a coordinate is; where one of two
    // values is no number, Min and Max are the second one.
    const Pair room = Min(Min(both(LargestLength) - length, both(LargestVolume) - volume),
      volume - Max(both(SmallestVolume), zero * length * length));
    const Pair isSound = SelectLess(none, room, both(1), none);
    StorePair(isSound, this->AreSound + cell);
    sum = sum + isSound;
  }
  return static_cast<int>(sum[0] + sum[1]);
}
}
