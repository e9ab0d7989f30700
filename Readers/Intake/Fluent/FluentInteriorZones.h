// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::FluentInteriorZones
 * @brief The zones of interior faces, if there are several.
 *
 * Meshes of cells do not store interior faces. Usually their zone follows from the zones of the
 * cells on both sides, or from these and the number of nodes. A table in the field data keeps this
 * information when filters change the mesh, so that the writer can restore the zones.
 */
#ifndef camaron_FluentInteriorZones_h
#define camaron_FluentInteriorZones_h

#include "Intake/Fluent/FluentCells.h"
#include "Intake/Fluent/FluentFaces.h"

#include <algorithm> // for sorted keys
#include <array>     // for keys
#include <map>       // for the table
#include <mutex>     // for threads

class vtkFieldData;

namespace camaron
{
class FluentInteriorZones
{
public:
  /// Name of the array: zone, smaller and greater zone of the cells, number of nodes.
  static constexpr const char* ArrayName = "InteriorZones";

  /// Determines whether there are several zones; if not, nothing is added.
  void Find(const FluentFaces& faces);

  /// Adds faces of a run from @a begin on, which must begin a block, if it is one of several
  /// interior zones. Thread-safe; the order does not matter.
  void Add(const FluentFaces::Run& run, vtkIdType begin, vtkIdType end, const FluentCells& cells);

  ///@{
  /// The zone of a face, from the array of a mesh that was read; 0 if unknown.
  void Load(vtkFieldData* fieldData);
  int GetZone(int cellZone, int otherCellZone, std::int32_t nodes) const
  {
    const auto zone = this->Zones.find(MakeKey(cellZone, otherCellZone, nodes));
    return zone != this->Zones.end() ? zone->second : 0;
  }
  ///@}

  /// Adds the array, without combinations that occur in several zones.
  void AddTo(vtkFieldData* fieldData) const;

private:
  static constexpr int Ambiguous = -1;
  using Key = std::array<int, 3>;
  static Key MakeKey(int cellZone, int otherCellZone, std::int32_t nodes)
  {
    return { std::min(cellZone, otherCellZone), std::max(cellZone, otherCellZone), nodes };
  }

  std::map<Key, int> Zones;
  bool Several = false;
  std::mutex Mutex;
};
}

#endif
