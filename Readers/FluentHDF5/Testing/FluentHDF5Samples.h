// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// Fluent files in HDF5 for tests: of the samples of the tests of text, in several layouts, and with
// changes.
#ifndef camaron_FluentHDF5Samples_h
#define camaron_FluentHDF5Samples_h

#include "FluentMesh/Testing/FluentMeshSamples.h"
#include "HDF5File.h"
#include "vtkFluentHDF5Reader.h"

#include "vtkCompositeDataSet.h"
#include "vtkDataArraySelection.h"
#include "vtkInformation.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtk_hdf5.h"

#include <functional>
#include <map>
#include <string>
#include <vector>

namespace camaron
{
namespace testing
{
/// How a program stores a mesh.
struct ContainerLayout
{
  int Sections = 1;           ///< of each kind of data, independent of zones
  bool ReversesNames = false; ///< whether the names of sections are in another order than their ids
  bool TrimsSides = false;    ///< whether faces without a second cell at both ends are left out
  bool HasZoneTypes = true;
  bool HasTypeNames = true; ///< whether the settings name the types of zones
  bool IsSingle = false;    ///< whether coordinates have single precision
  int ChunkSize = 0;        ///< rows; 0 for one chunk
  bool IsShuffled = false;
  bool HasMoreFilters = false; ///< also those that only HDF5 reverses
};

/// Writes groups, attributes and data sets; any failure ends the test by an exception.
class ContainerWriting
{
public:
  explicit ContainerWriting(const ContainerLayout& layout = {})
    : Layout(layout)
  {
    const HDF5Id access(H5Pcreate(H5P_FILE_ACCESS)), properties(H5Pcreate(H5P_FILE_CREATE));
    H5Pset_fapl_core(access, 1 << 16, false);
    // Small tables, so that small meshes are small files.
    H5Pset_meta_block_size(access, 0);
    H5Pset_sym_k(properties, 2, 2);
    H5Pset_istore_k(properties, 2);
    this->File = Check(H5Fcreate("sample", H5F_ACC_TRUNC, properties, access));
  }
  /// Opens the content of a file, to change it.
  explicit ContainerWriting(const std::string& bytes)
  {
    std::string copy = bytes;
    this->File = Check(H5LTopen_file_image(copy.data(), copy.size(), H5LT_FILE_IMAGE_OPEN_RW));
  }
  std::string GetBytes() const
  {
    H5Fflush(this->File, H5F_SCOPE_LOCAL);
    std::string bytes(static_cast<std::size_t>(H5Fget_file_image(this->File, nullptr, 0)), '\0');
    H5Fget_file_image(this->File, bytes.data(), bytes.size());
    return bytes;
  }
  std::int64_t GetFile() const { return this->File; }

  void Group(const std::string& path) const
  {
    const HDF5Id links(H5Pcreate(H5P_LINK_CREATE));
    H5Pset_create_intermediate_group(links, 1);
    Check(H5Gcreate2(this->File, path.c_str(), links, H5P_DEFAULT, H5P_DEFAULT));
  }
  /// Sets an attribute, which may exist.
  void Number(const std::string& path, const char* name, long long value) const
  {
    const HDF5Id object = Check(H5Oopen(this->File, path.c_str(), H5P_DEFAULT));
    if (H5Aexists(object, name) > 0)
    {
      H5Adelete(object, name);
    }
    const hsize_t one = 1;
    const HDF5Id space(H5Screate_simple(1, &one, nullptr));
    const HDF5Id attribute =
      Check(H5Acreate2(object, name, H5T_STD_I64LE, space, H5P_DEFAULT, H5P_DEFAULT));
    H5Awrite(attribute, H5T_NATIVE_LLONG, &value);
  }
  /// Adds a data set with rows of values, or replaces it.
  template <typename Value>
  void Data(const std::string& path, const std::vector<Value>& values, std::int64_t fileType,
    std::int64_t memoryType, hsize_t columns = 1) const
  {
    this->Remove(path);
    const hsize_t sizes[2] = { values.size() / columns, columns };
    const int dimensions = columns > 1 ? 2 : 1;
    const HDF5Id space(H5Screate_simple(dimensions, sizes, nullptr));
    const HDF5Id properties(H5Pcreate(H5P_DATASET_CREATE)), links(H5Pcreate(H5P_LINK_CREATE));
    H5Pset_create_intermediate_group(links, 1);
    hsize_t chunk[2] = { std::max<hsize_t>(sizes[0], 1), columns };
    chunk[0] = this->Layout.ChunkSize > 0
      ? std::min(chunk[0], static_cast<hsize_t>(this->Layout.ChunkSize))
      : chunk[0];
    H5Pset_chunk(properties, dimensions, chunk);
    if (this->Layout.IsShuffled || this->Layout.HasMoreFilters)
    {
      H5Pset_shuffle(properties);
    }
    H5Pset_deflate(properties, 6);
    if (this->Layout.HasMoreFilters)
    {
      H5Pset_fletcher32(properties);
    }
    const HDF5Id data =
      Check(H5Dcreate2(this->File, path.c_str(), fileType, space, links, properties, H5P_DEFAULT));
    H5Dwrite(data, memoryType, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
  }
  void Integers(const std::string& path, const std::vector<long long>& values,
    std::int64_t fileType, hsize_t columns = 1) const
  {
    this->Data(path, values, fileType, H5T_NATIVE_LLONG, columns);
  }
  void Text(const std::string& path, const std::string& text) const
  {
    this->Remove(path);
    const HDF5Id type(H5Tcopy(H5T_C_S1)), links(H5Pcreate(H5P_LINK_CREATE));
    H5Tset_size(type, std::max<std::size_t>(text.size(), 1));
    H5Pset_create_intermediate_group(links, 1);
    const hsize_t one = 1;
    const HDF5Id space(H5Screate_simple(1, &one, nullptr));
    const HDF5Id data =
      Check(H5Dcreate2(this->File, path.c_str(), type, space, links, H5P_DEFAULT, H5P_DEFAULT));
    H5Dwrite(data, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, text.c_str());
  }
  std::vector<long long> Read(const std::string& path) const
  {
    const HDF5Id data = Check(H5Dopen2(this->File, path.c_str(), H5P_DEFAULT));
    const HDF5Id space(H5Dget_space(data));
    std::vector<long long> values(static_cast<std::size_t>(H5Sget_simple_extent_npoints(space)));
    H5Dread(data, H5T_NATIVE_LLONG, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
    return values;
  }
  void SetEntry(const std::string& path, std::size_t index, long long value) const
  {
    std::vector<long long> values = this->Read(path);
    values.at(index) = value;
    const HDF5Id data = Check(H5Dopen2(this->File, path.c_str(), H5P_DEFAULT));
    H5Dwrite(data, H5T_NATIVE_LLONG, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
  }
  void Remove(const std::string& path) const
  {
    H5E_BEGIN_TRY // it may not exist
    {
      H5Ldelete(this->File, path.c_str(), H5P_DEFAULT);
    }
    H5E_END_TRY
  }

  static HDF5Id Check(std::int64_t id)
  {
    if (id < 0)
    {
      throw std::runtime_error("a function of HDF5 failed");
    }
    return HDF5Id(id);
  }

private:
  ContainerLayout Layout;
  HDF5Id File;
};

//------------------------------------------------------------------------------
/// Adds data of consecutive ids as sections, with names from 1 on.
class ContainerSections
{
public:
  ContainerSections(const ContainerWriting& writing, const ContainerLayout& layout)
    : Writing(writing)
    , Layout(layout)
  {
  }
  /// Calls write(path, begin, end) for the sections of a group; ids are from begin + 1 to end.
  template <typename Write>
  void Add(const std::string& group, std::size_t begin, std::size_t end, Write&& write) const
  {
    this->Writing.Group(group);
    const auto most = static_cast<std::size_t>(this->Layout.Sections);
    const std::size_t count = std::max<std::size_t>(std::min(most, end - begin), 1);
    for (std::size_t i = 0; i < count; ++i)
    {
      const std::size_t name = this->Layout.ReversesNames ? count - i : i + 1;
      const std::string path = group + "/" + std::to_string(name);
      const std::size_t first = begin + (end - begin) * i / count;
      const std::size_t last = begin + (end - begin) * (i + 1) / count;
      write(path, first, last);
      this->Writing.Number(path, "minId", static_cast<long long>(first) + 1);
      this->Writing.Number(path, "maxId", static_cast<long long>(last));
    }
    this->Writing.Number(group, "nSections", static_cast<long long>(count));
  }

private:
  const ContainerWriting& Writing;
  const ContainerLayout& Layout;
};

/// The rows of a table of zones.
struct ContainerZones
{
  std::vector<long long> Ids, Firsts, Lasts, Types;
  std::string Names;
  void Add(int id, std::size_t begin, std::size_t end, int type, const std::string& name)
  {
    this->Names += (this->Ids.empty() ? "" : ";") + name;
    this->Ids.push_back(id);
    this->Firsts.push_back(static_cast<long long>(begin) + 1);
    this->Lasts.push_back(static_cast<long long>(end));
    this->Types.push_back(type);
  }
  void Write(const ContainerWriting& writing, const std::string& group, bool hasTypes) const
  {
    const std::string path = group + "/zoneTopology/";
    writing.Integers(path + "id", this->Ids, H5T_STD_I32LE);
    writing.Integers(path + "minId", this->Firsts, H5T_STD_U64LE);
    writing.Integers(path + "maxId", this->Lasts, H5T_STD_U64LE);
    if (hasTypes)
    {
      writing.Integers(path + "zoneType", this->Types, H5T_STD_I32LE);
    }
    writing.Text(path + "name", this->Names);
    writing.Number(group + "/zoneTopology", "nZones", static_cast<long long>(this->Ids.size()));
  }
};

/// The file of a sample, with the zones and names that Encode gives it in text.
inline std::string EncodeContainer(const FluentSample& mesh, const ContainerLayout& layout = {})
{
  const ContainerWriting writing(layout);
  const ContainerSections sections(writing, layout);
  const std::map<int, std::string> names = { { 2, "water" }, { 3, "inside" }, { 4, "skin" } };
  const auto getName = [&names](int zone)
  { return names.count(zone) ? names.at(zone) : "zone-" + std::to_string(zone); };
  writing.Group("meshes/1");
  writing.Number("meshes/1", "dimension", mesh.Dimension);
  writing.Number("meshes/1", "nodeCount", static_cast<long long>(mesh.Points.size()));
  writing.Number("meshes/1", "cellCount", static_cast<long long>(mesh.Cells.size()));
  writing.Number("meshes/1", "faceCount", static_cast<long long>(mesh.Faces.size()));

  sections.Add("meshes/1/nodes/coords", 0, mesh.Points.size(),
    [&](const std::string& path, std::size_t begin, std::size_t end)
    {
      std::vector<double> values;
      for (std::size_t i = begin; i < end; ++i)
      {
        values.insert(
          values.end(), mesh.Points[i].begin(), mesh.Points[i].begin() + mesh.Dimension);
      }
      writing.Data(path, values, layout.IsSingle ? H5T_IEEE_F32LE : H5T_IEEE_F64LE,
        H5T_NATIVE_DOUBLE, static_cast<hsize_t>(mesh.Dimension));
    });

  sections.Add("meshes/1/cells/ctype", 0, mesh.Cells.size(),
    [&](const std::string& path, std::size_t begin, std::size_t end)
    {
      std::vector<long long> values;
      for (std::size_t i = begin; i < end; ++i)
      {
        values.push_back(mesh.Cells[i].Element);
      }
      const bool isUniform = !values.empty() && values[0] != 0 &&
        std::count(values.begin(), values.end(), values[0]) == std::ptrdiff_t(end - begin);
      writing.Group(path);
      writing.Number(path, "elementType", isUniform ? values[0] : 0);
      if (!isUniform)
      {
        writing.Integers(path + "/cell-types", values, H5T_STD_I16LE);
      }
    });
  ContainerZones cellZones;
  for (std::size_t begin = 0; begin < mesh.Cells.size();)
  {
    std::size_t end = begin;
    while (end < mesh.Cells.size() && mesh.Cells[end].Zone == mesh.Cells[begin].Zone)
    {
      ++end;
    }
    cellZones.Add(mesh.Cells[begin].Zone, begin, end, 1, getName(mesh.Cells[begin].Zone));
    begin = end;
  }
  cellZones.Write(writing, "meshes/1/cells", layout.HasZoneTypes);

  std::map<int, std::vector<const FluentSample::Face*>> groups;
  for (const FluentSample::Face& face : mesh.Faces)
  {
    groups[face.Zone > 0 ? face.Zone : face.Cells[1] >= 0 ? 3 : 4].push_back(&face);
  }
  ContainerZones faceZones;
  std::vector<const FluentSample::Face*> faces;
  std::string types = "\n(0 \"Zone variables:\")\n(39 (2 fluid water 1)(\n))\n";
  for (const auto& group : groups)
  {
    const int zone = group.first;
    const auto type = mesh.BoundaryTypes.find(zone);
    const int number = type != mesh.BoundaryTypes.end() ? type->second : zone == 3 ? 2 : 3;
    faceZones.Add(zone, faces.size(), faces.size() + group.second.size(), number, getName(zone));
    types += "(39 (" + std::to_string(zone) +
      (number == 2       ? " interior "
          : number == 31 ? " parent-face "
                         : " wall ") +
      getName(zone) + " 1)(\n))\n";
    faces.insert(faces.end(), group.second.begin(), group.second.end());
  }
  faceZones.Write(writing, "meshes/1/faces", layout.HasZoneTypes);
  if (layout.HasTypeNames)
  {
    writing.Text("settings/Thread Variables", types);
  }
  sections.Add("meshes/1/faces/nodes", 0, faces.size(),
    [&](const std::string& path, std::size_t begin, std::size_t end)
    {
      std::vector<long long> sizes, nodes;
      for (std::size_t i = begin; i < end; ++i)
      {
        sizes.push_back(static_cast<long long>(faces[i]->Nodes.size()));
        for (const int node : faces[i]->Nodes)
        {
          nodes.push_back(node + 1);
        }
      }
      writing.Integers(path + "/nnodes", sizes, H5T_STD_I16LE);
      writing.Integers(path + "/nodes", nodes, H5T_STD_U32LE);
    });
  for (int side = 0; side < 2; ++side)
  {
    std::size_t first = 0, last = faces.size();
    while (layout.TrimsSides && side == 1 && first < last && faces[first]->Cells[1] < 0)
    {
      ++first;
    }
    while (layout.TrimsSides && side == 1 && first < last && faces[last - 1]->Cells[1] < 0)
    {
      --last;
    }
    if (first == last)
    {
      continue;
    }
    sections.Add("meshes/1/faces/c" + std::to_string(side), first, last,
      [&](const std::string& path, std::size_t begin, std::size_t end)
      {
        std::vector<long long> cells;
        for (std::size_t i = begin; i < end; ++i)
        {
          cells.push_back(faces[i]->Cells[side] + 1);
        }
        writing.Integers(path, cells, H5T_STD_U32LE);
      });
  }
  return writing.GetBytes();
}

/// The content of a file after a change.
inline std::string ChangeContainer(
  const std::string& bytes, const std::function<void(const ContainerWriting&)>& change)
{
  const ContainerWriting writing(bytes);
  change(writing);
  return writing.GetBytes();
}

/// The data file of a mesh: SV_P is 100 + id, SV_T 0.5 + id in the cells 2 to 4, in single
/// precision, SV_Y both of these, SV_VOF of phase 2 is -id.
inline std::string EncodeResults(std::size_t cells, const ContainerLayout& layout = {})
{
  const ContainerWriting writing(layout);
  const ContainerSections sections(writing, layout);
  const auto add = [&](const std::string& name, std::size_t begin, std::size_t end, bool isSingle,
                     const std::vector<std::pair<double, double>>& columns)
  {
    sections.Add("results/1/" + name, begin, end,
      [&](const std::string& path, std::size_t first, std::size_t last)
      {
        std::vector<double> values;
        for (std::size_t i = first; i < last; ++i)
        {
          for (const auto& column : columns)
          {
            values.push_back(column.first + column.second * static_cast<double>(i + 1));
          }
        }
        writing.Data(path, values, isSingle ? H5T_IEEE_F32LE : H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE,
          columns.size());
      });
  };
  writing.Text("results/1/phase-1/cells/fields", "SV_P;SV_T;SV_Y;");
  add("phase-1/cells/SV_P", 0, cells, false, { { 100, 1 } });
  add("phase-1/cells/SV_T", 1, std::min<std::size_t>(cells, 4), true, { { 0.5, 1 } });
  add("phase-1/cells/SV_Y", 0, cells, false, { { 100, 1 }, { 0.5, 1 } });
  writing.Text("results/1/phase-1/cells/other", "data that are not a field");
  add("phase-2/cells/SV_VOF", 0, cells, false, { { 0, -1 } });
  return writing.GetBytes();
}

/// Reads fields of a data file beside a case file.
inline Result ReadResults(const std::string& mesh, const std::string& data,
  const std::vector<std::string>& fields, int piece = 0, int pieces = 1, int ghosts = 0)
{
  const File first(mesh, "test.cas.h5"), second(data, "test.dat.h5");
  return ReadWith<vtkFluentHDF5Reader>(first.Path, piece, pieces, ghosts,
    [&fields](vtkFluentHDF5Reader* reader)
    {
      for (const std::string& field : fields)
      {
        reader->GetCellArraySelection()->SetArraySetting(field.c_str(), 1);
      }
    });
}

inline Result ReadContainer(const std::string& bytes, int piece = 0, int pieces = 1, int ghosts = 0)
{
  return ReadWith<vtkFluentHDF5Reader>(File(bytes, "test.msh.h5").Path, piece, pieces, ghosts);
}

//------------------------------------------------------------------------------
/// Both outputs in words: everything that users can see.
template <typename Reader>
inline std::string Describe(
  const std::string& bytes, const std::string& name, int piece = 0, int pieces = 1, int ghosts = 0)
{
  const File file(bytes, name);
  vtkNew<Reader> reader;
  reader->SetFileName(file.Path.c_str());
  std::vector<std::string> errors;
  Observe(reader, vtkCommand::ErrorEvent, errors);
  reader->UpdatePiece(piece, pieces, ghosts);
  std::ostringstream text;
  text.precision(17);
  for (const std::string& error : errors)
  {
    text << error << "\n";
  }
  if (!errors.empty())
  {
    return text.str();
  }
  vtkUnstructuredGrid* const grid = reader->GetOutput();
  const auto addArrays = [&text](vtkFieldData* data)
  {
    std::set<std::string> lines;
    for (int i = 0; i < data->GetNumberOfArrays(); ++i)
    {
      vtkAbstractArray* const array = data->GetAbstractArray(i);
      std::ostringstream line;
      line.precision(17);
      line << array->GetName() << ":";
      for (vtkIdType value = 0; value < array->GetNumberOfValues(); ++value)
      {
        line << " " << array->GetVariantValue(value).ToString();
      }
      lines.insert(line.str());
    }
    for (const std::string& line : lines)
    {
      text << line << "\n";
    }
  };
  const auto addPoints = [&text](vtkPointSet* mesh)
  {
    for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
    {
      double x[3];
      mesh->GetPoint(i, x);
      text << x[0] << " " << x[1] << " " << x[2] << "\n";
    }
  };
  addPoints(grid);
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    text << grid->GetCellType(cell) << ":";
    const IndexRange points = MeshView(grid).GetCellPoints(cell);
    for (vtkIdType i = 0; i < points.Size; ++i)
    {
      text << " " << points[i];
    }
    for (const std::vector<vtkIdType>& face : GetFaceSet(grid, cell))
    {
      text << " /";
      for (const vtkIdType point : face)
      {
        text << " " << point;
      }
    }
    text << "\n";
  }
  addArrays(grid->GetCellData());
  addArrays(grid->GetPointData());
  auto* const blocks = vtkMultiBlockDataSet::SafeDownCast(reader->GetOutputDataObject(1));
  for (unsigned int i = 0; i < blocks->GetNumberOfBlocks(); ++i)
  {
    auto* const surface = vtkPolyData::SafeDownCast(blocks->GetBlock(i));
    text << blocks->GetMetaData(i)->Get(vtkCompositeDataSet::NAME()) << "\n";
    addPoints(surface);
    for (vtkIdType cell = 0; cell < surface->GetNumberOfCells(); ++cell)
    {
      vtkNew<vtkIdList> points;
      surface->GetCellPoints(cell, points);
      for (const vtkIdType point : *points)
      {
        text << " " << point;
      }
      text << "\n";
    }
    addArrays(surface->GetCellData());
    addArrays(surface->GetPointData());
  }
  // Zones, in the order of their ids.
  vtkFieldData* const data = grid->GetFieldData();
  std::set<std::string> zones;
  for (vtkIdType i = 0; i < data->GetArray("ZoneIds")->GetNumberOfTuples(); ++i)
  {
    std::string zone;
    for (const char* array : { "ZoneIds", "ZoneNames", "ZoneTypes", "ZoneBoundaryTypes" })
    {
      zone += data->GetAbstractArray(array)->GetVariantValue(i).ToString() + " ";
    }
    zones.insert(zone);
  }
  for (const std::string& zone : zones)
  {
    text << zone << "\n";
  }
  return text.str();
}
}
}

#endif
