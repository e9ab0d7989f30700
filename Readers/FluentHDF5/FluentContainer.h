// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::FluentContainer
 * @brief The sections of a Fluent file in HDF5, one per zone.
 *
 * Data sets stay compressed in the file. Faces, types of cells and coordinates are loaded batch by
 * batch, whenever they are visited, in the form of a binary Fluent file, and all ids are checked.
 * See Readers/FluentHDF5/README.md for the layout.
 */
#ifndef camaron_FluentContainer_h
#define camaron_FluentContainer_h

#include "HDF5Column.h"
#include "Intake/Fluent/FluentFile.h"

#include <map>    // for names of types
#include <string> // for names
#include <vector> // for zones

namespace camaron
{
class FluentContainer : public FluentFile
{
public:
  /// Opens bytes that remain where they are. @throw HDF5Error
  FluentContainer(const std::string& name, const char* begin, const char* end)
    : FluentFile(name, begin, end)
    , File(name, begin, end)
  {
  }

  /// Finds the sections; false if aborted. @throw HDF5Error
  bool Open(const Progress& progress);
  /// The names of all zones except interior ones, each once, from their tables alone.
  /// @throw HDF5Error
  std::vector<std::string> ListZones();
  /// Leaves out the zones with these names, after Open.
  void LeaveOut(const std::vector<std::string>& zones);
  /// What is in the file and is not used, as paths.
  const std::vector<std::string>& GetUnused() const { return this->Unused; }

  ///@{
  /// @throw HDF5Error
  bool LoadStored(const FluentSection& section, std::int64_t first, std::int64_t count,
    Buffer<std::int32_t>& values) override;
  bool LoadStored(const FluentSection& section, std::int64_t first, std::int64_t count,
    Buffer<double>& values) override;
  ///@}

private:
  static constexpr int NoType = -1, Fluid = 1, Solid = 17; // types of zones
  struct ZoneRow
  {
    int Id;
    std::int64_t First, Last;
    int Type; ///< Fluent's number, or NoType
    std::string Name;
    std::int32_t LeastSize = INT32_MAX, MostSize = 0; ///< numbers of nodes of faces
  };

  std::string Locate(const char*) const override { return this->Name + ": meshes/1"; }
  std::string LocateCell(std::int64_t face, int side) const override;

  void ReadTotals(const HDF5Object& mesh);
  void ReadTypeNames(const HDF5Object& root);
  std::vector<ZoneRow> ReadZones(
    const HDF5Object& group, const char* what, std::int64_t last, int usualType);
  void AddZone(const ZoneRow& zone, const std::string& usualType);
  void OpenNodes(const HDF5Object& group);
  void OpenCells(const HDF5Object& cells);
  std::int32_t GetElement(const ZoneRow& zone) const;
  void FindUnused(const HDF5Object& root);
  void LoadTypes(std::int64_t id, std::int64_t count, Buffer<std::int32_t>& values);

  ///@{
  /// In FluentContainerFaces.cxx.
  void OpenFaces(const HDF5Object& faces, const Progress& progress);
  void OpenSides(const HDF5Object& faces);
  void MeasureFaces(const HDF5Object& group, std::vector<ZoneRow>& zones, const Progress& progress);
  int GetBoundaryType(const ZoneRow& zone) const;
  void AddFaces(const HDF5Object& faces, const ZoneRow& zone);
  void OpenTrees(const HDF5Object& faces);
  void OpenInterfaces(const HDF5Object& faces);
  void LoadFaces(
    std::int64_t id, std::int64_t count, std::int32_t size, Buffer<std::int32_t>& values);
  [[noreturn]] void FailAtFace(std::int64_t id, const std::int32_t* nodes, std::int32_t size,
    std::int64_t list, const std::int32_t* cells);
  ///@}

  HDF5File File;
  HDF5Column Coordinates, Types, Sizes, Lists, Sides[2];
  std::vector<std::int64_t> Offsets;            ///< node ids before every 1024th face
  std::map<int, std::string> TypeNames;         ///< of zones
  std::vector<std::vector<std::int32_t>> Trees; ///< words of the sections of split faces
  std::vector<std::string> Unused;
};
}

#endif
