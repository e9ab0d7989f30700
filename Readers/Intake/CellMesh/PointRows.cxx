// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Intake/CellMesh/PointRows.h"

#include "vtkDoubleArray.h"

namespace camaron
{
//------------------------------------------------------------------------------
bool PointRows::Skip(TextScanner& scanner, const Progress& progress)
{
  const bool good = SkipRows(
    scanner, this->Lines, this->Count, progress,
    [this](vtkIdType, TextRow& row)
    {
      double x[3];
      return row.ReadPoint(x, this->What);
    },
    RowLayout::OneLine);
  this->End = scanner.GetPosition();
  return good;
}

//------------------------------------------------------------------------------
bool PointRows::ForEach(const PieceOfSpace::Visit& visit, const Progress& progress) const
{
  TextScanner scanner = this->Start;
  return ReadRowsOnce(
    scanner, this->Lines, this->Count, progress,
    [&](vtkIdType i, TextRow& row)
    {
      double x[3];
      const bool good = row.ReadPoint(x, this->What);
      if (good)
      {
        visit(i, x);
      }
      return good;
    },
    RowLayout::OneLine);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkDataArray> PointRows::Read(
  const CellMeshPiece& piece, const Progress& progress) const
{
  Buffer<double> coordinates(3 * piece.GetNumberOfPoints());
  TextScanner scanner = this->Start;
  const bool good = ReadRows(
    scanner, this->Lines, this->Count, progress,
    [&](vtkIdType i, TextRow& row)
    {
      double unused[3];
      const vtkIdType point = piece.FindPoint(i);
      return row.ReadPoint(point < 0 ? unused : coordinates.data() + 3 * point, this->What);
    },
    RowLayout::OneLine);
  if (!good || scanner.GetPosition() != this->End)
  {
    return nullptr;
  }
  return coordinates.TakeArray<vtkDoubleArray>(3);
}
}
