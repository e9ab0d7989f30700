// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::FluentFaceBatches
 * @brief Visits the faces of a Fluent file in the order of their ids, some at a time.
 *
 * Faces of text that are not kept are read from the file, so that there is never more of them in
 * memory than one batch. Only faces of up to four nodes can be visited, and only text with one face
 * per line; what else there is, is left to FluentFaces.
 */
#ifndef camaron_FluentFaceBatches_h
#define camaron_FluentFaceBatches_h

#include "FluentCellFaces.h"

#include <functional> // for visitors

namespace camaron
{
class FluentFaceBatches
{
public:
  struct Face
  {
    static constexpr std::int32_t MaxSize = 4;
    std::int32_t Size;
    std::int32_t Cells[2];       ///< of the piece, -1 for none
    std::int32_t Nodes[MaxSize]; ///< ids of the file, from 1
  };

  /**
   * @param nodes the largest id of a node
   * @param chunk bytes of text that are read as one piece
   */
  FluentFaceBatches(
    const FluentFile& file, const FluentMesh& mesh, std::int64_t nodes, vtkIdType chunk)
    : File(file)
    , Mesh(mesh)
    , Nodes(nodes)
    , Chunk(chunk)
  {
  }

  /**
   * Calls visit(run, faces, count) for all faces that bound cells, until it returns false. False if
   * it did, if some faces are larger or wrong or laid out otherwise, or if stopped.
   */
  bool ForEach(const Progress& progress,
    const std::function<bool(const FluentFaces::Run&, const Face*, vtkIdType)>& visit);

private:
  using Run = FluentFaces::Run;
  using VisitBatch = std::function<bool(vtkIdType, vtkIdType)>;
  bool VisitText(const Run& run, const VisitBatch& visit);
  bool VisitKept(const Run& run, const VisitBatch& visit);
  bool Copy(const Run& run, vtkIdType begin, vtkIdType end);
  bool ReadLine(const Run& run, const char* text, const char* end, Face& face) const;
  bool Copy(const FluentFace& face, bool bounds, Face& copy) const;

  const FluentFile& File;
  const FluentMesh& Mesh;
  std::int64_t Nodes;
  vtkIdType Chunk;
  vtkIdType BatchSize = 0;
  Buffer<Face> Batch;
};
}

#endif
