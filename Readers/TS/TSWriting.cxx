// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "TSWriting.h"

#include "Intake/CellMesh/OutputMesh.h"
#include "Intake/CellMesh/OutputWarnings.h"
#include "Intake/Write/RealFormat.h"
#include "Intake/Write/WriteRows.h"
#include "TSurfWriting.h"

#include "vtkCellType.h"

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
bool WriteTetrahedra(OutputFile& file, const OutputMesh& mesh, const Progress& progress)
{
  const vtkIdType points = mesh.GetNumberOfPoints(), cells = mesh.GetNumberOfCells();
  const RealFormat format = RealFormat::Shortest(mesh.HasFloatPoints());
  file.Write(std::to_string(points) + " " + std::to_string(cells) + "\n");
  return WriteRows(file, points, progress.Part(0, 0.5),
           [&](vtkIdType point, std::string& text)
           {
             double x[3];
             mesh.GetPoint(point, x);
             format.AppendRow(text, x, 3, ' ');
             text += "1.0\n"; // as Camarón writes it
           }) &&
    WriteRows(file, cells, progress.Part(0.5, 1),
      [&](vtkIdType cell, std::string& text)
      {
        const IndexRange corners = mesh.GetCellPoints(cell);
        for (vtkIdType i = 0; i < 4; ++i)
        {
          AppendNumber(text, corners[i]);
          text += i < 3 ? ' ' : '\n';
        }
      });
}
}

//------------------------------------------------------------------------------
bool WriteTS(const std::string& path, vtkDataSet* mesh, const TSOptions& options,
  Warnings& warnings, ScanError& error, const Progress& progress)
{
  const bool isGOCAD = options.Dialect == TSDialect::GOCAD;
  const CellConversion how = isGOCAD
    ? CellConversion{ "TSurf", { VTK_TRIANGLE }, options.Others, options.Surface }
    : CellConversion{ "TS", { VTK_TETRA }, options.Others };
  OutputMesh output;
  if (!ConvertCells(mesh, how, path, output, warnings, error, progress.Part(0, 0.3)))
  {
    return false;
  }
  OutputFile file(path);
  bool good;
  if (isGOCAD)
  {
    TSurfWriting writing(mesh, output);
    writing.Warn(warnings);
    good = writing.Write(file, progress.Part(0.3, 1));
  }
  else
  {
    WarnOfArrays(mesh, "TS", warnings);
    good = WriteTetrahedra(file, output, progress.Part(0.3, 1));
  }
  return file.Finish(good, error);
}
}
