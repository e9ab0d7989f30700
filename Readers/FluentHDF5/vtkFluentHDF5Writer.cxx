// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFluentHDF5Writer.h"

#include "Base/Text.h"
#include "HDF5File.h"
#include "Intake/Fluent/FluentWriting.h"

#include "vtkObjectFactory.h"

#include "vtk_hdf5.h"

#include <algorithm>
#include <functional>
#include <map>
#include <new>

namespace camaron
{
namespace
{
/// Values and nodes per chunk, 128 kB each: small, as readers need memory for a chunk of each data
/// set, and large enough to be compressed well.
constexpr hsize_t ChunkValues = 32768, ChunkNodes = 5461;

//------------------------------------------------------------------------------
// The file is in memory, so what fails is memory.
HDF5Id Check(std::int64_t id)
{
  if (id < 0)
  {
    throw std::bad_alloc();
  }
  return HDF5Id(id);
}

//------------------------------------------------------------------------------
// A mesh in the layout of Fluent Meshing.
class Storing
{
public:
  explicit Storing(const FluentOutput& mesh)
    : Mesh(mesh)
  {
    constexpr std::size_t Increment = std::size_t(1) << 20; // of memory
    const HDF5Id access = Check(H5Pcreate(H5P_FILE_ACCESS));
    H5Pset_fapl_core(access, Increment, false);
    this->File = Check(H5Fcreate("mesh", H5F_ACC_TRUNC, H5P_DEFAULT, access));
    for (const FluentZone& zone : mesh.GetZones())
    {
      this->Zones[zone.Id] = zone;
      std::string& name = this->Zones[zone.Id].Name;
      this->Renamed += name.find(';') != std::string::npos;
      std::replace(name.begin(), name.end(), ';', '-'); // which separates names
    }
  }

  int GetNumberOfRenamed() const { return this->Renamed; }

  /// False if aborted.
  bool Write(const Progress& progress)
  {
    this->WriteTotals();
    return this->WriteNodes(progress.Part(0, 0.3)) && this->WriteCells(progress.Part(0.3, 0.4)) &&
      this->WriteFaces(progress.Part(0.4, 1));
  }

  std::string GetBytes() const
  {
    H5Fflush(this->File, H5F_SCOPE_GLOBAL);
    const auto size = H5Fget_file_image(this->File, nullptr, 0);
    std::string bytes(static_cast<std::size_t>(std::max<decltype(size)>(size, 0)), '\0');
    Check(H5Fget_file_image(this->File, bytes.data(), bytes.size()));
    return bytes;
  }

private:
  using Section = FluentOutput::Section;

  void AddGroup(const std::string& path) const
  {
    const HDF5Id links = Check(H5Pcreate(H5P_LINK_CREATE));
    H5Pset_create_intermediate_group(links, 1);
    Check(H5Gcreate2(this->File, path.c_str(), links, H5P_DEFAULT, H5P_DEFAULT));
  }
  void SetNumber(
    const std::string& path, const char* name, std::int64_t type, long long value) const
  {
    const HDF5Id object = Check(H5Oopen(this->File, path.c_str(), H5P_DEFAULT));
    const hsize_t one = 1;
    const HDF5Id space = Check(H5Screate_simple(1, &one, nullptr));
    const HDF5Id attribute = Check(H5Acreate2(object, name, type, space, H5P_DEFAULT, H5P_DEFAULT));
    H5Awrite(attribute, H5T_NATIVE_LLONG, &value);
  }
  void SetRange(const std::string& path, vtkIdType begin, vtkIdType end) const
  {
    this->SetNumber(path, "minId", H5T_STD_U64LE, begin + 1);
    this->SetNumber(path, "maxId", H5T_STD_U64LE, end);
  }
  void AddText(const std::string& path, const std::string& text) const
  {
    const HDF5Id type = Check(H5Tcopy(H5T_C_S1));
    H5Tset_size(type, std::max<std::size_t>(text.size(), 1));
    const hsize_t one = 1;
    const HDF5Id space = Check(H5Screate_simple(1, &one, nullptr));
    const HDF5Id properties = Check(H5Pcreate(H5P_DATASET_CREATE));
    H5Pset_obj_track_times(properties, false);
    const HDF5Id data = Check(
      H5Dcreate2(this->File, path.c_str(), type, space, H5P_DEFAULT, properties, H5P_DEFAULT));
    Check(H5Dwrite(data, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, text.c_str()));
    constexpr int Version = 3; // of Fluent's texts
    this->SetNumber(path, "version", H5T_STD_I32LE, Version);
  }

  /// Adds a data set of rows and calls fill(row, values) for each, chunk by chunk; false if
  /// aborted.
  template <typename Value, typename Fill>
  bool AddData(const std::string& path, std::int64_t type, std::int64_t valueType, vtkIdType count,
    int columns, bool shuffles, const Progress& progress, Fill&& fill) const
  {
    const int dimensions = columns > 1 ? 2 : 1;
    const hsize_t size[2] = { static_cast<hsize_t>(count), static_cast<hsize_t>(columns) };
    const hsize_t most = columns > 1 ? ChunkNodes : ChunkValues;
    const hsize_t chunk[2] = { std::max<hsize_t>(std::min(size[0], most), 1), size[1] };
    const HDF5Id space = Check(H5Screate_simple(dimensions, size, nullptr));
    const HDF5Id properties = Check(H5Pcreate(H5P_DATASET_CREATE));
    constexpr unsigned int Fastest = 1;        // others compress ids hardly better
    H5Pset_obj_track_times(properties, false); // the file depends on the mesh alone
    H5Pset_chunk(properties, dimensions, chunk);
    if (shuffles)
    {
      H5Pset_shuffle(properties);
    }
    H5Pset_deflate(properties, Fastest);
    const HDF5Id data = Check(
      H5Dcreate2(this->File, path.c_str(), type, space, H5P_DEFAULT, properties, H5P_DEFAULT));
    std::vector<Value> values(chunk[0] * chunk[1]);
    for (hsize_t begin[2] = { 0, 0 }; begin[0] < size[0]; begin[0] += chunk[0])
    {
      const hsize_t part[2] = { std::min(chunk[0], size[0] - begin[0]), chunk[1] };
      const hsize_t total = part[0] * part[1];
      for (hsize_t row = 0; row < part[0]; ++row)
      {
        fill(static_cast<vtkIdType>(begin[0] + row), values.data() + row * part[1]);
      }
      const HDF5Id memory = Check(H5Screate_simple(1, &total, nullptr));
      H5Sselect_hyperslab(space, H5S_SELECT_SET, begin, nullptr, part, nullptr);
      Check(H5Dwrite(data, valueType, memory, space, H5P_DEFAULT, values.data()));
      if (!progress.Report(static_cast<double>(begin[0]) / static_cast<double>(size[0])))
      {
        return false;
      }
    }
    return true;
  }
  template <typename Fill>
  bool AddIntegers(const std::string& path, std::int64_t type, vtkIdType count,
    const Progress& progress, Fill&& fill, bool shuffles = false) const
  {
    return this->AddData<std::int32_t>(path, type, H5T_NATIVE_INT32, count, 1, shuffles, progress,
      [&fill](vtkIdType row, std::int32_t* value)
      { *value = static_cast<std::int32_t>(fill(row)); });
  }

  void WriteTotals() const
  {
    this->AddGroup("meshes/1");
    constexpr int Version = 2; // of the layout
    this->SetNumber("meshes/1", "version", H5T_STD_I32LE, Version);
    this->SetNumber("meshes/1", "dimension", H5T_STD_I32LE, this->Mesh.GetDimension());
    const std::pair<const char*, vtkIdType> numbers[] = { { "nodeCount",
                                                            this->Mesh.GetNumberOfPoints() },
      { "faceCount", static_cast<vtkIdType>(this->Mesh.GetFaces().size()) },
      { "cellCount", this->Mesh.GetNumberOfCells() }, { "edgeCount", 0 }, { "nodeOffset", 0 },
      { "faceOffset", 0 }, { "cellOffset", 0 } };
    for (const auto& number : numbers)
    {
      this->SetNumber("meshes/1", number.first, H5T_STD_U64LE, number.second);
    }
    std::string types = "\n(0 \"Zone variables:\")\n";
    for (const auto& zone : this->Zones)
    {
      types += "(39 (" + std::to_string(zone.first) + " " + zone.second.Type + " " +
        zone.second.Name + " 1)(\n))\n";
    }
    this->AddGroup("settings");
    this->AddText("settings/Origin", "Camaron");
    this->AddText("settings/Solver", "ANSYS_FLUENT_MESHING");
    this->AddText("settings/Version", "22.1"); // whose layout this is
    this->AddText("settings/Thread Variables", types);
  }

  struct Column
  {
    const char* Name;
    std::function<vtkIdType(const Section&)> Get;
    std::int64_t Type = H5T_STD_I32LE;
  };
  /// Adds a table of zones, with these columns and those that all have.
  void AddZones(const std::string& path, const std::vector<Section>& sections,
    const std::string& names, std::vector<Column> columns) const
  {
    this->AddGroup(path);
    const auto count = static_cast<vtkIdType>(sections.size());
    this->SetNumber(path, "nZones", H5T_STD_U64LE, count);
    std::string fields;
    for (const Column& column : columns)
    {
      fields += std::string(column.Name) + ";";
    }
    const int dimension = this->Mesh.GetDimension();
    columns.insert(columns.end(),
      { { "id", [](const Section& section) { return section.Zone; } },
        { "minId", [](const Section& section) { return section.Begin + 1; }, H5T_STD_U64LE },
        { "maxId", [](const Section& section) { return section.End; }, H5T_STD_U64LE },
        { "dimension", [dimension](const Section&) { return dimension; }, H5T_STD_U64LE } });
    for (const Column& column : columns)
    {
      this->AddIntegers(path + "/" + column.Name, column.Type, count, Progress(),
        [&](vtkIdType row) { return column.Get(sections[static_cast<std::size_t>(row)]); });
    }
    this->AddText(path + "/name", names);
    this->AddText(path + "/fields", fields);
  }
  /// Adds a group for sections that are named by their numbers.
  void AddSections(const std::string& path, const std::vector<Section>& sections) const
  {
    this->AddGroup(path);
    this->SetNumber(path, "nSections", H5T_STD_U64LE, static_cast<long long>(sections.size()));
  }
  std::string JoinNames(const std::vector<Section>& sections) const
  {
    std::string names;
    for (const Section& section : sections)
    {
      names += (names.empty() ? "" : ";") + this->Zones.at(section.Zone).Name;
    }
    return names;
  }
  static int GetNone(const Section&) { return 0; }

  bool WriteNodes(const Progress& progress) const
  {
    const vtkIdType count = this->Mesh.GetNumberOfPoints();
    const Section all{ 1, 1, 0, count };
    this->AddGroup("meshes/1/nodes/coords");
    this->AddZones("meshes/1/nodes/zoneTopology", { all }, "node-1",
      { { "zoneType", [](const Section& section) { return section.Type; } } });
    const int dimension = this->Mesh.GetDimension();
    const bool good = this->AddData<double>("meshes/1/nodes/coords/1", H5T_IEEE_F64LE,
      H5T_NATIVE_DOUBLE, count, dimension, true, progress,
      [&](vtkIdType row, double* values)
      {
        double x[3];
        this->Mesh.GetMesh().GetPoint(this->Mesh.GetMeshPoint(row), x);
        std::copy_n(x, dimension, values);
      });
    this->SetRange("meshes/1/nodes/coords/1", 0, count);
    return good;
  }

  bool WriteCells(const Progress& progress) const
  {
    const std::vector<Section>& sections = this->Mesh.GetCellSections();
    this->AddSections("meshes/1/cells/ctype", sections);
    this->AddZones("meshes/1/cells/zoneTopology", sections, this->JoinNames(sections),
      { { "cellType", [](const Section& section) { return section.Element; } },
        { "childZoneId", GetNone } });
    for (const Section& section : sections)
    {
      const std::string path =
        "meshes/1/cells/ctype/" + std::to_string(&section - sections.data() + 1);
      this->AddGroup(path);
      this->SetRange(path, section.Begin, section.End);
      this->SetNumber(path, "elementType", H5T_STD_I16LE, section.Element);
      if (section.Element == 0 &&
        !this->AddIntegers(path + "/cell-types", H5T_STD_I16LE, section.End - section.Begin,
          progress, [&](vtkIdType row) { return this->Mesh.GetElement(section.Begin + row); }))
      {
        return false;
      }
    }
    return true;
  }

  bool WriteFaces(const Progress& progress) const
  {
    const std::vector<Section>& sections = this->Mesh.GetFaceSections();
    const std::string path = "meshes/1/faces/";
    for (const char* name : { "nodes", "c0", "c1" })
    {
      this->AddSections(path + name, sections);
    }
    this->AddZones(path + "zoneTopology", sections, this->JoinNames(sections),
      { { "childZoneId", GetNone },
        { "faceType", [](const Section& section) { return section.Element; } },
        { "flags", GetNone }, // of case files, without which ParaView's reader fails
        { "shadowZoneId", GetNone },
        { "zoneType", [](const Section& section) { return section.Type; } } });
    const auto total = static_cast<double>(this->Mesh.GetFaces().size()) + 1;
    for (const Section& section : sections)
    {
      const Progress part = progress.Part(
        static_cast<double>(section.Begin) / total, static_cast<double>(section.End) / total);
      if (!this->WriteSection(section, path, std::to_string(&section - sections.data() + 1), part))
      {
        return false;
      }
    }
    return true;
  }

  bool WriteSection(const Section& section, const std::string& path, const std::string& name,
    const Progress& progress) const
  {
    const vtkIdType count = section.End - section.Begin;
    const auto getFace = [&](vtkIdType row) -> const FluentOutput::Face&
    { return this->Mesh.GetFaces()[static_cast<std::size_t>(section.Begin + row)]; };
    const std::string nodes = path + "nodes/" + name;
    this->AddGroup(nodes);
    this->SetRange(nodes, section.Begin, section.End);
    vtkIdType size = 0, face = 0; // of all lists, and the next face
    std::int32_t most = 0;
    for (vtkIdType row = 0; row < count; ++row)
    {
      size += getFace(row).Size;
      most = std::max(most, getFace(row).Size);
    }
    std::vector<vtkIdType> list;
    std::size_t next = 0; // in the list of the last face
    const auto getNode = [&](vtkIdType)
    {
      while (next == list.size())
      {
        this->Mesh.GetNodes(getFace(face++), list);
        next = 0;
      }
      return this->Mesh.GetFilePoint(list[next++]) + 1;
    };
    const auto addSide = [&](int side)
    {
      const std::string data = path + "c" + std::to_string(side) + "/" + name;
      const bool good = this->AddIntegers(data, H5T_STD_U32LE, count, progress.Part(1, 1),
        [&](vtkIdType row) { return getFace(row).Cells[side] + 1; });
      this->SetRange(data, section.Begin, section.End);
      return good;
    };
    return this->AddIntegers(nodes + "/nnodes", most > INT16_MAX ? H5T_STD_I32LE : H5T_STD_I16LE,
             count, progress.Part(0, 0.1), [&](vtkIdType row) { return getFace(row).Size; }) &&
      this->AddIntegers(
        nodes + "/nodes", H5T_STD_U32LE, size, progress.Part(0.1, 1), getNode, true) &&
      addSide(0) && addSide(1);
  }

  const FluentOutput& Mesh;
  std::map<int, FluentZone> Zones;
  int Renamed = 0; ///< zones whose name the format cannot store
  HDF5Id File;
};
}
}

vtkStandardNewMacro(vtkFluentHDF5Writer);

//------------------------------------------------------------------------------
bool vtkFluentHDF5Writer::WriteMesh(const std::string& path, vtkDataSet* mesh,
  camaron::Warnings& warnings, camaron::ScanError& error, const camaron::Progress& progress)
{
  return camaron::WriteFluent(path, mesh, this->GetOtherCells(), warnings, error, progress,
    [&](
      const camaron::FluentOutput& output, camaron::OutputFile& file, const camaron::Progress& part)
    {
      const camaron::HDF5Silence silence;
      camaron::Storing storing(output);
      if (storing.GetNumberOfRenamed() > 0)
      {
        warnings.Add(camaron::CountOf(storing.GetNumberOfRenamed(), "zone", "zones") +
          " with ; in the name, written as \"-\"");
      }
      const bool isWritten = storing.Write(part);
      file.Write(isWritten ? storing.GetBytes() : std::string());
      return isWritten;
    });
}
