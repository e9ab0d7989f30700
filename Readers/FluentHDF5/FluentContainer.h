// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::FluentContainer
 * @brief The sections of a Fluent file in HDF5, one per zone.
 *
 * Data sets stay compressed in the file. Faces, types of cells and coordinates are loaded batch by
 * batch, whenever they are visited, in the form of a binary Fluent file, and all ids are checked.
 * Functions throw ScanError. See Readers/FluentHDF5/README.md for the layout.
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
  /// @a file remains open.
  explicit FluentContainer(HDF5File& file)
    : FluentFile(file.GetName(), nullptr, nullptr)
    , File(file)
  {
  }

  /// Finds the sections, or only the zones; false if aborted.
  bool Open(const Progress& progress, bool zonesOnly = false);
  /// The names of all zones except interior ones, each once.
  std::vector<std::string> GetZoneNames() const;
  /// Leaves out all zones with other names than these, after Open; warns about names of none.
  void Choose(const std::vector<std::string>& zones, Warnings& warnings);
  /// Warns about what is in the file and is not used.
  void WarnOfUnused(Warnings& warnings) const;

  void LoadStored(const FluentSection& section, std::int64_t first, std::int64_t count,
    Buffer<std::int32_t>& values) override;
  void LoadStored(const FluentSection& section, std::int64_t first, std::int64_t count,
    Buffer<double>& values) override;

private:
  static constexpr int NoType = -1, Fluid = 1, Solid = 17; // types of zones
  struct ZoneRow
  {
    int Id;
    std::int64_t First, Last;
    int Type; ///< Fluent's number, or NoType
    std::string Name;
    std::string TypeName;                             ///< in the settings; empty if unknown
    std::int32_t LeastSize = INT32_MAX, MostSize = 0; ///< numbers of nodes of faces
  };

  std::string Locate(const char*) const override { return this->Name + ": meshes/1"; }
  std::string LocateCell(std::int64_t face, int side) const override
  {
    const std::string place = this->Sides[side].Locate(face);
    return place.empty() ? "" : " (" + place + ")";
  }

  void ReadTypeNames(const HDF5Object& root);
  std::vector<ZoneRow> ReadZones(
    const HDF5Object& group, const char* what, std::int64_t last, int usualType);
  void OpenCells(const HDF5Object& cells);

  ///@{
  /// In FluentContainerFaces.cxx.
  void OpenFaces(const HDF5Object& faces, const Progress& progress, bool zonesOnly);
  void MeasureFaces(std::vector<ZoneRow>& zones, const Progress& progress);
  void AddFaces(const HDF5Object& faces, const ZoneRow& zone);
  void OpenTrees(const HDF5Object& faces);
  void OpenInterfaces(const HDF5Object& faces);
  void LoadFaces(
    std::int64_t id, std::int64_t count, std::int32_t size, Buffer<std::int32_t>& values);
  ///@}

  HDF5File& File;
  HDF5Column Coordinates{ this->File }, Types{ this->File }, Sizes{ this->File },
    Lists{ this->File }, Sides[2] = { this->File, this->File };
  std::vector<std::int64_t> Offsets;            ///< node ids before every 1024th face
  std::map<int, std::string> TypeNames;         ///< of zones
  std::vector<std::vector<std::int32_t>> Trees; ///< words of the sections of split faces
};
}

#endif
