// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::FluentCells
 * @brief Types and zones of the cells declared in a Fluent file, and which of them are in use.
 *
 * Refined cells remain in the file as parents; they, dead cells, and those of zones that are left
 * out, are not part of the mesh. The others, the leaves, are numbered by position, in the order of
 * their ids.
 */
#ifndef camaron_FluentCells_h
#define camaron_FluentCells_h

#include "Intake/Fluent/FluentFile.h"

#include "vtkCellType.h" // for the types of cells

#include <algorithm> // for finding runs
#include <vector>    // for runs

namespace camaron
{
/// Cell types by their number in files.
enum class FluentElement : unsigned char
{
  Unknown = 0, ///< not declared, or of another dimension
  Triangle = 1,
  Tetrahedron = 2,
  Quadrilateral = 3,
  Hexahedron = 4,
  Pyramid = 5,
  Wedge = 6,
  Polyhedron = 7 ///< or polygon
};

/// The cell of VTK of a declared type; VTK_EMPTY_CELL if unknown.
struct FluentShape
{
  unsigned char Type = VTK_EMPTY_CELL;
  int Nodes = 0; ///< 0 if the type does not determine it
  int Faces = 0;
  int Dimension = 0; ///< 0 for any
};
FluentShape GetFluentShape(FluentElement element, int dimension);

class FluentCells
{
public:
  /// Loads the cells of a file; false with the error in it. @a maxCells is an upper limit for their
  /// number.
  bool Load(FluentFile& file, std::int64_t maxCells);

  /// Number of ids.
  std::int64_t GetCount() const { return this->Count; }
  vtkIdType GetNumberOfLeaves() const { return this->NumberOfLeaves; }
  /// Whether there are cells that are not leaves.
  bool HasOtherCells() const { return this->NumberOfLeaves != this->Count; }
  /// Whether the ids of leaves are not consecutive.
  bool HasGaps() const
  {
    return this->NumberOfLeaves > 0 &&
      this->GetId(this->NumberOfLeaves - 1) != this->NumberOfLeaves;
  }
  vtkIdType GetNumberOfUndeclared() const { return this->Undeclared; }

  /// The leaf with an id from 1 to GetCount(), or -1.
  vtkIdType GetLeaf(std::int64_t id) const
  {
    if (!this->HasOtherCells())
    {
      return id - 1;
    }
    const auto run = std::upper_bound(this->Runs.begin(), this->Runs.end(), id - 1,
      [](std::int64_t cell, const Run& candidate) { return cell < candidate.End; });
    return run->IsOfLeaves ? run->Leaf + (id - 1 - run->Begin) : -1;
  }
  /// The leaf with an arbitrary id, or -1.
  vtkIdType FindLeaf(std::int64_t id) const
  {
    return id > 0 && id <= this->Count ? this->GetLeaf(id) : -1;
  }
  /// The id of a leaf.
  std::int64_t GetId(vtkIdType leaf) const
  {
    if (!this->HasOtherCells())
    {
      return leaf + 1;
    }
    const Run& run = this->GetRunOfLeaf(leaf);
    return run.Begin + (leaf - run.Leaf) + 1;
  }
  FluentElement GetElement(vtkIdType leaf) const
  {
    const Run& run = this->GetRunOfLeaf(leaf);
    return run.Elements.empty() ? run.Element
                                : run.Elements[static_cast<std::size_t>(leaf - run.Leaf)];
  }
  int GetZone(vtkIdType leaf) const { return this->GetRunOfLeaf(leaf).Zone; }
  /// Whether consecutive leaves, at least one, have the same type.
  bool HaveOneElement(vtkIdType begin, vtkIdType end) const
  {
    const Run& run = this->GetRunOfLeaf(begin);
    return run.Elements.empty() && &run == &this->GetRunOfLeaf(end - 1);
  }

private:
  struct Run
  {
    std::int64_t Begin = 0, End = 0; ///< ids minus 1
    bool IsOfLeaves = true;
    vtkIdType Leaf = 0; ///< the first leaf, or the next one after the run
    int Zone = 0;
    FluentElement Element = FluentElement::Unknown;
    std::vector<FluentElement> Elements; ///< if they differ
  };

  const Run& GetRunOfLeaf(vtkIdType leaf) const
  {
    // The last run that begins no later has the leaf, as others have no leaves.
    return this->Runs.size() == 1
      ? this->Runs.front()
      : *(std::upper_bound(this->Runs.begin(), this->Runs.end(), leaf,
            [](vtkIdType value, const Run& run) { return value < run.Leaf; }) -
          1);
  }
  bool AddRun(FluentFile& file, const FluentSection& section);
  bool ReadElements(FluentFile& file, const FluentSection& section, Run& run);

  std::vector<Run> Runs;
  std::int64_t Count = 0;
  vtkIdType NumberOfLeaves = 0;
  vtkIdType Undeclared = 0;
};
}

#endif
