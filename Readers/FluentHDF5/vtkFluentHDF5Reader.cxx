// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFluentHDF5Reader.h"

#include "FluentHDF5Reading.h"

#include "vtkDataArraySelection.h"
#include "vtkObjectFactory.h"

#include <algorithm>

vtkStandardNewMacro(vtkFluentHDF5Reader);

namespace
{
//------------------------------------------------------------------------------
// The names that are on.
std::vector<std::string> FindChosen(vtkDataArraySelection* selection)
{
  std::vector<std::string> found;
  for (int i = 0; i < selection->GetNumberOfArrays(); ++i)
  {
    if (selection->GetArraySetting(i) != 0)
    {
      found.emplace_back(selection->GetArrayName(i));
    }
  }
  return found;
}

//------------------------------------------------------------------------------
// Whether the user has chosen some of the names.
bool AreSomeOff(vtkDataArraySelection* selection)
{
  return selection->GetNumberOfArraysEnabled() < selection->GetNumberOfArrays();
}

//------------------------------------------------------------------------------
// Lists names, of which new ones are on or off. What the user has chosen stays, although a file,
// such as another time step, does not have it.
void List(std::vector<std::string> names, bool areOn, vtkDataArraySelection* selection)
{
  for (const std::string& chosen : FindChosen(selection))
  {
    if (!areOn && std::find(names.begin(), names.end(), chosen) == names.end())
    {
      names.push_back(chosen);
    }
  }
  std::vector<const char*> texts;
  for (const std::string& name : names)
  {
    texts.push_back(name.c_str());
  }
  selection->SetArraysWithDefault(texts.data(), static_cast<int>(texts.size()), areOn ? 1 : 0);
}
}

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
  os << indent << "Zones: " << this->Zones->GetNumberOfArraysEnabled() << '\n';
}

//------------------------------------------------------------------------------
vtkDataArraySelection* vtkFluentHDF5Reader::GetCellArraySelection()
{
  return this->CellArrays;
}

//------------------------------------------------------------------------------
vtkDataArraySelection* vtkFluentHDF5Reader::GetZoneSelection()
{
  return this->Zones;
}

//------------------------------------------------------------------------------
vtkMTimeType vtkFluentHDF5Reader::GetMTime()
{
  return std::max(
    { this->Superclass::GetMTime(), this->CellArrays->GetMTime(), this->Zones->GetMTime() });
}

//------------------------------------------------------------------------------
int vtkFluentHDF5Reader::RequestInformation(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const std::string file = this->GetFileName() ? this->GetFileName() : "";
  this->FindFields(file);
  List(camaron::ListFluentFields(this->Fields->Path), false, this->CellArrays);
  // Of another file, none is read that has not been chosen.
  List(
    camaron::ListFluentZones(file), !this->HasListedZones || !AreSomeOff(this->Zones), this->Zones);
  this->HasListedZones = true;
  return this->Superclass::RequestInformation(request, inputVector, outputVector);
}

//------------------------------------------------------------------------------
void vtkFluentHDF5Reader::FindFields(const std::string& path)
{
  this->Fields->IsRequired = this->DataFile && *this->DataFile;
  this->Fields->Path = this->Fields->IsRequired ? this->DataFile : camaron::GetFluentDataPath(path);
  this->Fields->Names = FindChosen(this->CellArrays);
}

//------------------------------------------------------------------------------
bool vtkFluentHDF5Reader::ReadZones(const std::string& path, const camaron::PieceRequest& request,
  vtkUnstructuredGrid* grid, vtkMultiBlockDataSet* boundaries, camaron::Warnings& warnings,
  camaron::ScanError& error, const camaron::Progress& progress)
{
  this->FindFields(path);
  const std::vector<std::string> zones = FindChosen(this->Zones);
  return camaron::ReadFluentHDF5(path, request, grid, boundaries,
    AreSomeOff(this->Zones) ? &zones : nullptr, *this->Fields, warnings, error, progress);
}
