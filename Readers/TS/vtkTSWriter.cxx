// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTSWriter.h"

#include "Intake/CellMesh/CellConversion.h"
#include "Intake/CellMesh/OutputMesh.h"
#include "Intake/CellMesh/OutputWarnings.h"
#include "Intake/Write/RealFormat.h"
#include "Intake/Write/WriteRows.h"
#include "TSurf.h"

#include "vtkCellType.h"
#include "vtkObjectFactory.h"

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
}

using namespace camaron;

vtkStandardNewMacro(vtkTSWriter);

//------------------------------------------------------------------------------
bool vtkTSWriter::WriteMesh(const std::string& path, vtkDataSet* mesh, camaron::Warnings& warnings,
  camaron::ScanError& error, const camaron::Progress& progress)
{
  const bool isGOCAD = this->Dialect == GOCAD;
  const CellConversion how = isGOCAD
    ? CellConversion{ "TSurf", { VTK_TRIANGLE }, this->GetOtherCells(), this->GetSurfaceFaces() }
    : CellConversion{ "TS", { VTK_TETRA }, this->GetOtherCells() };
  OutputMesh output;
  if (!ConvertCells(mesh, how, path, output, warnings, error, progress.Part(0, 0.3)))
  {
    return false;
  }
  OutputFile file(path);
  bool good;
  if (isGOCAD)
  {
    good = WriteTSurf(file, mesh, output, warnings, progress.Part(0.3, 1));
  }
  else
  {
    WarnOfArrays(mesh, "TS", warnings);
    good = WriteTetrahedra(file, output, progress.Part(0.3, 1));
  }
  return file.Finish(good, error);
}

//------------------------------------------------------------------------------
void vtkTSWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Dialect: " << this->Dialect << "\n";
}
