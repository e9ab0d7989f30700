// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::MAPDLMesh
 * @brief The nodes and cells of a deck.
 *
 * Rows are read in parallel, and repeatedly instead of being stored: first the ids of nodes, then
 * elements, to check them and to find the piece, then what the piece needs. If the piece is the
 * whole mesh, cells are stored at once.
 */
#ifndef camaron_MAPDLMesh_h
#define camaron_MAPDLMesh_h

#include "Base/FunctionRef.h" // for nodes and cells
#include "Intake/CellMesh/CellMeshPiece.h"
#include "Intake/CellMesh/CellRows.h"
#include "Intake/Ids/IdMap.h"
#include "MAPDLDeck.h"
#include "MAPDLReading.h"

#include <unordered_map> // for midpoints

class vtkUnstructuredGrid;

namespace camaron
{
class MAPDLMesh
{
public:
  MAPDLMesh(const MAPDLDeck& deck, const MAPDLOptions& options)
    : Deck(deck)
    , Options(options)
  {
  }

  /// Determines a piece and reads its cells; false with the error in Fault, or if aborted.
  bool Read(const PieceRequest& request, CellMeshPiece& piece, const Progress& progress);
  /// Coordinates of the points of a piece as x, y, z; empty after a fault.
  Buffer<double> ReadPoints(const CellMeshPiece& piece, const Progress& progress);
  /// Adds the arrays of a piece to its grid.
  void AddArrays(const CellMeshPiece& piece, vtkUnstructuredGrid* grid);

  /**
   * Adds an array of 0 and 1 per component to the points or cells of a piece, and lists the names
   * in the string arrays NodeComponents and ElementComponents of the field data. Of components with
   * the same name the last is used.
   * @param textSize bytes of the file; bounds the memory that damaged components can request
   */
  bool AddComponents(const CellMeshPiece& piece, std::size_t textSize, vtkUnstructuredGrid* grid,
    Warnings& warnings, const Progress& progress);
  void Warn(Warnings& warnings) const;

  CellMesh Cells; ///< of the piece
  MAPDLFault Fault;

private:
  ///@{
  /// Numbers in the whole deck.
  vtkIdType GetNumberOfPoints() const
  {
    return this->NodeIds.size() + static_cast<vtkIdType>(this->Midpoints.size());
  }
  vtkIdType GetNumberOfCells() const { return this->ElementIds.size(); }
  ///@}
  /// Rows that are read in one task.
  struct Batch
  {
    std::size_t Block;
    std::size_t Chunk;
    vtkIdType FirstRow; ///< of all rows
    vtkIdType NumberOfRows;
    vtkIdType FirstCommand;  ///< if they come from commands, else -1
    vtkIdType FirstCell = 0; ///< of elements, if all have been read
  };
  /// An edge whose mid-side node is missing.
  struct MissingNode
  {
    vtkIdType Row;
    std::int32_t
      Ends[2]; ///< ascending, so that they are the same for all cells that share the edge
    std::uint64_t GetKey() const
    {
      return std::uint64_t(this->Ends[0]) << 32 | static_cast<std::uint32_t>(this->Ends[1]);
    }
  };
  /// What was found in a batch of elements.
  struct Finding
  {
    std::vector<MissingNode> Missing;
    std::map<int, vtkIdType> Unknown; ///< numbers of elements that are not cells
    vtkIdType Undefined = 0;
    vtkIdType WithoutNodes = 0;
    MAPDLFault Fault;
  };
  using VisitNode = FunctionRef<void(vtkIdType row, std::int32_t id, const double* x)>;
  using VisitElement = FunctionRef<bool(const char* place, vtkIdType row, const MAPDLElement&)>;
  /// Gets a cell with the indices of its points, which are only complete without missing nodes.
  using VisitCell = FunctionRef<void(
    vtkIdType row, vtkIdType cell, const MAPDLElement&, const MAPDLCell&, bool isComplete)>;

  template <typename Block>
  static vtkIdType MakeBatches(const std::vector<Block>& blocks, std::vector<Batch>& batches);
  bool ForEachBatch(const std::vector<Batch>& batches, const Progress& progress,
    FunctionRef<void(std::size_t batch, MAPDLFault& fault)> read);
  /// Index of the node of a row, -1 if it is left out.
  vtkIdType GetNode(vtkIdType row) const
  {
    return this->NodeOfRow.size() > 0 ? this->NodeOfRow[row] : row;
  }
  /// Passes ids, or coordinates.
  bool ForEachNode(bool withIds, const Progress& progress, VisitNode visit);
  void ForEachElement(const Batch& batch, MAPDLFault& fault, VisitElement visit) const;
  void ForEachCell(const Batch& batch, Finding& finding, VisitCell visit) const;
  bool FindPoints(const char* place, vtkIdType row, MAPDLCell& cell, Finding& finding) const;

  bool ReadNodeIds(const Progress& progress);
  bool CheckCells(CellMeshPiece& piece, const Progress& progress);
  bool VisitCells(CellMeshPiece& piece, const Progress& progress);
  bool StoreCells(const CellMeshPiece& piece, const Progress& progress);
  void Allocate(vtkIdType cells);
  void Store(vtkIdType cell, const MAPDLElement& element, const MAPDLCell& points, CellSink& sink);
  bool Fill();
  void LeaveOutElements();
  void AddMidpoints();

  const MAPDLDeck& Deck;
  MAPDLOptions Options;
  std::vector<Batch> NodeBatches, ElementBatches;
  std::vector<Finding> Findings;            ///< of element batches
  std::vector<CellSink> Sinks;              ///< cells of the piece, likewise
  Buffer<std::int32_t> NodeIds, ElementIds; ///< of all nodes and cells, in order
  Buffer<std::int32_t> NodeOfRow; ///< -1 for rows that are left out; empty if all are kept
  IdSet LeftOut; ///< rows of elements that are no cells, or are defined again later
  IdMap Nodes;
  std::vector<MissingNode> Midpoints;
  std::unordered_map<std::uint64_t, std::int32_t> MidpointOfEdge;
  Buffer<int> Ids, Materials, Types, Reals, Sections; ///< of the cells of the piece
  vtkIdType ReplacedNodes = 0, ReplacedElements = 0;
};
}

#endif
