// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFluentHDF5Reader.h"

#include "FluentFields.h"
#include "FluentHDF5Reading.h"

#include "vtkDataArraySelection.h"
#include "vtkObjectFactory.h"

#include <algorithm>

vtkStandardNewMacro(vtkFluentHDF5Reader);

//------------------------------------------------------------------------------
vtkFluentHDF5Reader::vtkFluentHDF5Reader()
  : vtkFluentReader(camaron::IsFluentHDF5)
  , Fields(std::make_unique<camaron::FluentFieldRequest>())
{
}

//------------------------------------------------------------------------------
vtkFluentHDF5Reader::~vtkFluentHDF5Reader()
{
  this->SetDataFile(nullptr);
}

//------------------------------------------------------------------------------
void vtkFluentHDF5Reader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "DataFile: " << (this->DataFile ? this->DataFile : "(none)") << '\n';
  os << indent << "CellArrays: " << this->CellArrays->GetNumberOfArraysEnabled() << '\n';
}

//------------------------------------------------------------------------------
vtkDataArraySelection* vtkFluentHDF5Reader::GetCellArraySelection()
{
  return this->CellArrays;
}

//------------------------------------------------------------------------------
vtkMTimeType vtkFluentHDF5Reader::GetMTime()
{
  return std::max(this->Superclass::GetMTime(), this->CellArrays->GetMTime());
}

//------------------------------------------------------------------------------
// What is chosen stays, although a file, such as another time step, does not have it.
int vtkFluentHDF5Reader::RequestInformation(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const char* const file = this->GetFileName();
  this->FindFields(file ? file : "");
  std::vector<std::string> names = camaron::ListFluentFields(this->Fields->Path);
  for (const std::string& chosen : this->Fields->Names)
  {
    if (std::find(names.begin(), names.end(), chosen) == names.end())
    {
      names.push_back(chosen);
    }
  }
  std::vector<const char*> texts;
  for (const std::string& name : names)
  {
    texts.push_back(name.c_str());
  }
  this->CellArrays->SetArraysWithDefault(texts.data(), static_cast<int>(texts.size()), 0);
  return this->Superclass::RequestInformation(request, inputVector, outputVector);
}

//------------------------------------------------------------------------------
void vtkFluentHDF5Reader::FindFields(const std::string& path)
{
  this->Fields->IsRequired = this->DataFile && *this->DataFile;
  this->Fields->Path = this->Fields->IsRequired ? this->DataFile : camaron::GetFluentDataPath(path);
  this->Fields->Names.clear();
  for (int i = 0; i < this->CellArrays->GetNumberOfArrays(); ++i)
  {
    if (this->CellArrays->GetArraySetting(i) != 0)
    {
      this->Fields->Names.emplace_back(this->CellArrays->GetArrayName(i));
    }
  }
}

//------------------------------------------------------------------------------
bool vtkFluentHDF5Reader::ReadZones(const std::string& path, const camaron::PieceRequest& request,
  vtkUnstructuredGrid* grid, vtkMultiBlockDataSet* boundaries, camaron::Warnings& warnings,
  camaron::ScanError& error, const camaron::Progress& progress)
{
  this->FindFields(path);
  return camaron::ReadFluentHDF5(
    path, request, grid, boundaries, *this->Fields, warnings, error, progress);
}
