// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkM3DWriter.h"

#include "Base/Text.h"
#include "Intake/CellMesh/CellConversion.h"
#include "Intake/CellMesh/OutputMesh.h"
#include "Intake/CellMesh/OutputWarnings.h"
#include "Intake/Write/RealFormat.h"
#include "Intake/Write/WriteRows.h"
#include "M3DElements.h"

#include "vtkAbstractArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkFieldData.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
// Formats the material of elements.
class MaterialText
{
public:
  explicit MaterialText(vtkDataSet* mesh)
    : Cells(FindArray(mesh->GetCellData()))
  {
    vtkDataArray* all = this->Cells ? nullptr : FindArray(mesh->GetFieldData());
    this->IsOfField = all && all->GetNumberOfTuples() == 1;
    if (this->IsOfField)
    {
      this->Common.clear();
      AppendTuple(this->Common, all, 0);
    }
  }

  /// Whether all elements have the same material, from field data.
  bool IsCommon() const { return this->IsOfField; }

  void Append(std::string& text, vtkIdType cell) const
  {
    if (this->Cells)
    {
      AppendTuple(text, this->Cells, cell);
    }
    else
    {
      text += this->Common;
    }
  }
  /// The array of materials, if there is one.
  static vtkDataArray* FindArray(vtkFieldData* data)
  {
    vtkDataArray* array = data->GetArray(MaterialName);
    return array && array->GetNumberOfComponents() == MaterialSize ? array : nullptr;
  }

private:
  static void AppendTuple(std::string& text, vtkDataArray* array, vtkIdType tuple)
  {
    for (int c = 0; c < MaterialSize; ++c)
    {
      text += ' ';
      const std::size_t begin = text.size();
      AppendNumber(text, array->GetComponent(tuple, c));
      // Generators write 1000.0, not 1000.
      text += text.find_first_not_of("-0123456789", begin) == std::string::npos ? ".0" : "";
    }
  }

  vtkDataArray* Cells;
  std::string Common = " 1000.0 0.45 1.0"; // default of mesh generators
  bool IsOfField = false;
};

//------------------------------------------------------------------------------
// Warns about arrays named like materials that cannot be written as such.
void WarnOfOtherMaterials(vtkDataSet* mesh, Warnings& warnings)
{
  const std::string name = MaterialName, size = std::to_string(MaterialSize);
  vtkAbstractArray* const ofCells = mesh->GetCellData()->GetAbstractArray(MaterialName);
  if (ofCells && !MaterialText::FindArray(mesh->GetCellData()))
  {
    warnings.Add("not written: the array " + name + ": materials need " + size +
      " components, this array has " + std::to_string(ofCells->GetNumberOfComponents()));
  }
  if (mesh->GetPointData()->HasArray(MaterialName))
  {
    warnings.Add("not written: the array " + name + " of points: materials belong to elements");
  }
}
}
}

using namespace camaron;

vtkStandardNewMacro(vtkM3DWriter);

//------------------------------------------------------------------------------
// The material of elements comes from the cell array or the field data "Material" with three
// components, else the default of mesh generators is written. All nodes get code 1.
bool vtkM3DWriter::WriteMesh(const std::string& path, vtkDataSet* mesh, camaron::Warnings& warnings,
  camaron::ScanError& error, const camaron::Progress& progress)
{
  const bool isM2D = path.size() >= 4 && EqualsInAnyCase(path.substr(path.size() - 4), ".m2d");
  const MaterialText material(mesh);
  WarnOfOtherMaterials(mesh, warnings);
  WrittenArrays written;
  written.Points = written.Cells = { MaterialName }; // warned about above
  if (material.IsCommon())
  {
    written.Fields = { MaterialName };
  }
  const CellConversion how = isM2D
    ? CellConversion{ "M2D", { VTK_TRIANGLE, VTK_QUAD }, this->GetOtherCells() }
    : CellConversion{ "M3D", { VTK_TETRA, VTK_PYRAMID, VTK_WEDGE, VTK_HEXAHEDRON },
        this->GetOtherCells() };
  WarnOfArrays(mesh, how.Format.c_str(), warnings, written);
  OutputMesh output;
  if (!ConvertCells(mesh, how, path, output, warnings, error, progress.Part(0, 0.3)))
  {
    return false;
  }
  const int digits = this->Digits > 0 ? this->Digits : ChooseDigits(mesh, output);
  WarnOfDigits(mesh, output, digits, warnings);
  const std::string points = std::to_string(output.GetNumberOfPoints());
  const std::string cells = std::to_string(output.GetNumberOfCells());

  OutputFile file(path);
  file.Write("[Nodes, ARRAY1<STRING>]\n" + points + "\n\n");
  const RealFormat format = RealFormat::Exponent(digits - 1, 'E', true);
  bool good = WriteRows(file, output.GetNumberOfPoints(), progress.Part(0.3, 0.7),
    [&](vtkIdType point, std::string& text)
    {
      double x[3];
      output.GetPoint(point, x);
      text += "1 ";
      format.AppendRow(text, x, 3);
    });
  file.Write("\n[Elements, ARRAY1<STRING>]\n" + cells + "\n\n");
  good = good &&
    WriteRows(file, output.GetNumberOfCells(), progress.Part(0.7, 1),
      [&](vtkIdType cell, std::string& text)
      {
        const unsigned char type = output.GetCellType(cell);
        const ElementKind* const kind =
          FindElementKind([type](const ElementKind& one) { return one.Type == type; });
        const IndexRange nodes = output.GetCellPoints(cell);
        const int* const order = kind->GetOrder();
        text += kind->Letter;
        for (int i = 0; i < kind->NumberOfNodes; ++i)
        {
          text += ' ';
          AppendNumber(text, nodes[order[i]]);
        }
        material.Append(text, output.GetInputCell(cell));
        text += '\n';
      });
  return file.Finish(good, error);
}

//------------------------------------------------------------------------------
void vtkM3DWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Digits: " << this->Digits << "\n";
}
