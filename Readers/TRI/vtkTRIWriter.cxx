// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTRIWriter.h"

#include "Intake/CellMesh/CellConversion.h"
#include "Intake/CellMesh/OutputMesh.h"
#include "Intake/CellMesh/OutputWarnings.h"
#include "Intake/Write/RealFormat.h"
#include "Intake/Write/WriteRows.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkObjectFactory.h"

#include <cmath>

namespace camaron
{
namespace
{
}
}

using namespace camaron;

vtkStandardNewMacro(vtkTRIWriter);

//------------------------------------------------------------------------------
// Cart3D files count ids from 1, and contain the components of triangles if the mesh has the cell
// array "Component".
bool vtkTRIWriter::WriteMesh(const std::string& path, vtkDataSet* mesh, camaron::Warnings& warnings,
  camaron::ScanError& error, const camaron::Progress& progress)
{
  const bool isCart3D = this->Dialect == CART3D;
  vtkDataArray* components = isCart3D ? mesh->GetCellData()->GetArray("Component") : nullptr;
  if (components && components->GetNumberOfComponents() != 1)
  {
    components = nullptr;
  }
  if (components)
  {
    Tally odd;
    for (vtkIdType cell = 0; cell < components->GetNumberOfTuples(); ++cell)
    {
      const double value = components->GetComponent(cell, 0);
      if (!(value >= INT32_MIN && value <= INT32_MAX && value == std::floor(value)))
      {
        odd.Add(cell);
      }
    }
    warnings.Add(
      odd, "cell", "cells", "whose Component is not a 32-bit integer, as Cart3D files require");
    components = odd.Count > 0 ? nullptr : components;
  }
  WrittenArrays written;
  if (components)
  {
    written.Cells.emplace_back("Component");
  }
  WarnOfArrays(mesh, "TRI", warnings, written);

  const CellConversion how{ "TRI", { VTK_TRIANGLE }, this->GetOtherCells(),
    this->GetSurfaceFaces() };
  OutputMesh output;
  if (!ConvertCells(mesh, how, path, output, warnings, error, progress.Part(0, 0.3)))
  {
    return false;
  }
  const vtkIdType base = isCart3D ? 1 : 0;
  const vtkIdType points = output.GetNumberOfPoints(), triangles = output.GetNumberOfCells();

  OutputFile file(path);
  const std::string lastCount = std::to_string(triangles) + "\n";
  file.Write(std::to_string(points) + (isCart3D ? " " + lastCount : "\n"));
  const RealFormat format = RealFormat::Shortest(output.HasFloatPoints());
  bool good = WriteRows(file, points, progress.Part(0.3, 0.7),
    [&](vtkIdType point, std::string& text)
    {
      double x[3];
      output.GetPoint(point, x);
      format.AppendRow(text, x, 3);
    });
  // A file without the number of triangles is a point cloud.
  if (!isCart3D && triangles > 0)
  {
    file.Write(lastCount);
  }
  good = good &&
    WriteRows(file, triangles, progress.Part(0.7, 0.95),
      [&](vtkIdType triangle, std::string& text)
      {
        const IndexRange corners = output.GetCellPoints(triangle);
        for (vtkIdType i = 0; i < 3; ++i)
        {
          AppendNumber(text, corners[i] + base);
          text += i < 2 ? ' ' : '\n';
        }
      });
  if (components)
  {
    good = good &&
      WriteRows(file, triangles, progress.Part(0.95, 1),
        [&](vtkIdType triangle, std::string& text)
        {
          const double component = components->GetComponent(output.GetInputCell(triangle), 0);
          AppendNumber(text, static_cast<vtkIdType>(component));
          text += '\n';
        });
  }
  return file.Finish(good, error);
}

//------------------------------------------------------------------------------
void vtkTRIWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Dialect: " << this->Dialect << "\n";
}
