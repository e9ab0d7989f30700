// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "TetGenReading.h"

#include "Intake/CellMesh/CellGrid.h"
#include "Intake/Pieces/ReadMappedFile.h"
#include "TetGenFacets.h"
#include "TetGenMidpoints.h"
#include "TetGenNeighbors.h"

#include "vtkFieldData.h"
#include "vtkUnstructuredGrid.h"

#include <set>
#include <string>

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
// Assembles a mesh, or a piece of it, from its files. A file may be read in several passes, each of
// them within ReadText.
class TetGenAssembly
{
public:
  TetGenAssembly(const PieceRequest& request, vtkUnstructuredGrid* grid, vtkIdType chunk,
    Warnings& warnings, ScanError& error)
    : Request(request)
    , Grid(grid)
    , Chunk(chunk)
    , Messages(warnings)
    , Error(error)
  {
  }

  /// Finds the companions of a file and reads the mesh.
  bool Read(const MappedFile& file, const std::string& path, const Progress& progress)
  {
    const bool good = this->ReadFiles(file, path, progress);
    return this->NodeFile.IsUnchanged(this->Error) && this->ElementFile.IsUnchanged(this->Error) &&
      good;
  }

private:
  bool ReadFiles(const MappedFile& file, const std::string& path, const Progress& progress);
  /// Reads points, each of which becomes a cell.
  bool ReadCloud(const MappedFile& nodes, const Progress& progress);
  /// Reads cells of one type, and their neighbors if that file is given.
  bool ReadTable(const MappedFile& cells, TetGenKind kind, const MappedFile& nodes,
    const MappedFile* neighbors, const Progress& progress);
  /// Reads facets, or segments in 2D; @a nodes may be the same file.
  bool ReadComplex(
    const MappedFile& file, bool isSmesh, const MappedFile& nodes, const Progress& progress);
  template <typename Read>
  bool ReadFile(const MappedFile& file, const Progress& progress, Read&& read)
  {
    return ReadText(file, '#', this->Chunk, this->Error, progress, read);
  }
  bool IsWhole() const { return this->Request.NumberOfPieces <= 1; }
  bool ReadNodes(const MappedFile& file, bool isLast, const Progress& progress);
  bool ReadNeighbors(const MappedFile& file, const TetGenCells& cells, const Progress& progress);
  void OrderMidpoints(CellMesh& mesh, int corners);
  bool Fill(const MappedFile& nodes, CellMesh& mesh, int corners, const Progress& progress);
  bool FillCloud(const MappedFile& nodes, const Progress& progress);
  bool FinishTable(
    TetGenCells& cells, const MappedFile& nodes, bool hasNeighbors, const Progress& progress);
  bool FindMore(TextScanner& scanner, const MappedFile& file);

  PieceRequest Request;
  vtkUnstructuredGrid* Grid;
  vtkIdType Chunk;
  Warnings& Messages;
  ScanError& Error;
  MappedFile NodeFile, ElementFile; ///< companions
  TetGenNodes Nodes;
  TetGenNeighbors Neighbors;
  CellMeshPiece Piece;
  std::ptrdiff_t EndOfNodes = 0; ///< in their file
  std::set<std::string> More;    ///< names of files with data after the end
};

//------------------------------------------------------------------------------
// Keeps the name of a file with more data than was read, for a warning.
bool TetGenAssembly::FindMore(TextScanner& scanner, const MappedFile& file)
{
  if (scanner.SkipSpace())
  {
    this->More.insert(file.GetName());
  }
  return true;
}

//------------------------------------------------------------------------------
bool TetGenAssembly::ReadNodes(const MappedFile& file, bool isLast, const Progress& progress)
{
  this->Piece.SetPoints(
    [this, &file](const PieceOfSpace::Visit& visit)
    {
      return this->ReadFile(file, Progress(),
        [&](TextScanner& scanner, const TextLines* lines, const Progress& part)
        { return this->Nodes.ForEach(scanner, lines, visit, part); });
    });
  return this->ReadFile(file, progress,
    [&](TextScanner& scanner, const TextLines* lines, const Progress& part)
    {
      if (!this->Nodes.Read(scanner, lines, this->IsWhole(), part))
      {
        return false;
      }
      this->EndOfNodes = scanner.GetPosition() - file.begin();
      return !isLast || this->FindMore(scanner, file);
    });
}

//------------------------------------------------------------------------------
bool TetGenAssembly::ReadNeighbors(
  const MappedFile& file, const TetGenCells& cells, const Progress& progress)
{
  IdMap ids;
  ids.Build(cells.GetAllIds().data(), cells.GetAllIds().size());
  return this->ReadFile(file, progress,
    [&](TextScanner& scanner, const TextLines* lines, const Progress& part)
    { return this->Neighbors.Read(scanner, lines, cells, this->Piece, ids, part); });
}

//------------------------------------------------------------------------------
void TetGenAssembly::OrderMidpoints(CellMesh& mesh, int corners)
{
  double x[10][3]; // of the nodes of a quadratic tetrahedron
  this->Nodes.GetAnswer(x);
  TetGenMidpointOrder order;
  if (!FindMidpointOrder(corners, x, order) && this->Request.Piece == 0)
  {
    this->Messages.Add(
      "the midside nodes of the first element are far from the middle of its edges in any order; "
      "the order of TetGen 1.5 and Triangle is assumed");
  }
  camaron::OrderMidpoints(mesh, corners, order);
}

//------------------------------------------------------------------------------
// Reads the nodes that the piece needs and builds the grid, without cell arrays. If corners is
// positive, midside nodes are reordered; the nodes of the first cell have been requested for that.
bool TetGenAssembly::Fill(
  const MappedFile& nodes, CellMesh& mesh, int corners, const Progress& progress)
{
  if (!this->IsWhole() &&
    !this->ReadFile(nodes, progress.Part(0, 0.7),
      [&](TextScanner& scanner, const TextLines* lines, const Progress& part)
      { return this->Nodes.ReadValues(scanner, lines, this->Piece, part); }))
  {
    return false;
  }
  if (corners > 0)
  {
    this->OrderMidpoints(mesh, corners);
  }
  const auto points = this->Nodes.TakePoints();
  if (this->Request.Piece == 0)
  {
    this->Nodes.Warn(this->Messages);
    this->Piece.WarnOfRepeatedPoints(mesh, this->Messages, progress.Part(0.7, 0.9));
    for (const std::string& file : this->More)
    {
      this->Messages.Add("there is more data after the end of " + file);
    }
  }
  FillGrid(mesh, this->Piece, points, this->Grid);
  this->Nodes.AddArrays(this->Grid, this->Piece);
  return !progress.IsStopped();
}

//------------------------------------------------------------------------------
bool TetGenAssembly::FillCloud(const MappedFile& nodes, const Progress& progress)
{
  CellMesh mesh;
  return MakeCloud(this->Nodes.GetCount(), this->Request, this->Piece, mesh) &&
    this->Fill(nodes, mesh, 0, progress);
}

//------------------------------------------------------------------------------
bool TetGenAssembly::ReadCloud(const MappedFile& nodes, const Progress& progress)
{
  return this->ReadNodes(nodes, true, progress.Part(0, 0.6)) &&
    this->FillCloud(nodes, progress.Part(0.6, 1));
}

//------------------------------------------------------------------------------
bool TetGenAssembly::ReadTable(const MappedFile& file, TetGenKind kind, const MappedFile& nodes,
  const MappedFile* neighbors, const Progress& progress)
{
  TetGenCells cells(kind);
  if (neighbors)
  {
    cells.KeepAllIds();
  }
  if (!this->ReadNodes(nodes, true, progress.Part(0, 0.3)) ||
    !this->ReadFile(file, progress.Part(0.3, 0.7),
      [&](TextScanner& scanner, const TextLines* lines, const Progress& part)
      {
        return cells.Read(scanner, lines, this->Nodes, this->Request, this->Piece, part) &&
          this->FindMore(scanner, file);
      }))
  {
    return false;
  }
  if (kind == TetGenKind::Ele && cells.GetCount() == 0)
  {
    return this->FillCloud(nodes, progress.Part(0.7, 1));
  }
  return (!neighbors || this->ReadNeighbors(*neighbors, cells, progress.Part(0.7, 0.8))) &&
    this->FinishTable(cells, nodes, neighbors != nullptr, progress.Part(0.8, 1));
}

//------------------------------------------------------------------------------
bool TetGenAssembly::FinishTable(
  TetGenCells& cells, const MappedFile& nodes, bool hasNeighbors, const Progress& progress)
{
  const int corners = cells.GetNumberOfCorners();
  const bool hasOrder = cells.IsQuadratic() && corners > 2 && cells.GetCount() > 0;
  if (hasOrder)
  {
    this->Nodes.Ask(cells.GetFirstCell());
  }
  if (!this->Fill(nodes, cells.GetMesh(), hasOrder ? corners : 0, progress))
  {
    return false;
  }
  if (this->Request.Piece == 0)
  {
    cells.Warn(this->Messages);
  }
  cells.AddArrays(this->Grid);
  if (hasNeighbors)
  {
    this->Neighbors.AddArrays(this->Grid);
  }
  return true;
}

//------------------------------------------------------------------------------
bool TetGenAssembly::ReadComplex(
  const MappedFile& file, bool isSmesh, const MappedFile& nodes, const Progress& progress)
{
  const bool isOwn = &nodes == &file;
  if (!this->ReadNodes(nodes, !isOwn, progress.Part(0, 0.3)))
  {
    return false;
  }
  const bool isFlat = this->Nodes.GetDimension() == 2 && !isSmesh;
  const auto skipNodes = [&](TextScanner& scanner)
  {
    if (isOwn)
    {
      scanner.SetPosition(file.begin() + this->EndOfNodes);
      return true;
    }
    TetGenNodes::Header header;
    return TetGenNodes::ReadHeader(scanner, header);
  };
  TetGenCells segments(TetGenKind::Edge);
  TetGenFacets facets;
  TetGenSeeds seeds;
  if (!this->ReadFile(file, progress.Part(0.3, 0.6),
        [&](TextScanner& scanner, const TextLines* lines, const Progress& part)
        {
          return skipNodes(scanner) &&
            (isFlat ? segments.Read(scanner, lines, this->Nodes, this->Request, this->Piece, part,
                        ErrorKind::Syntax)
                    : facets.Read(scanner, lines, this->Nodes, isSmesh, part)) &&
            seeds.Read(scanner, this->Nodes.GetDimension()) && this->FindMore(scanner, file);
        }))
  {
    return false;
  }
  if (isFlat)
  {
    if (!this->FinishTable(segments, nodes, false, progress.Part(0.7, 1)))
    {
      return false;
    }
  }
  else
  {
    CellMesh& mesh = facets.GetMesh();
    if (!this->Piece.Select(mesh, this->Request, progress.Part(0.6, 0.7)))
    {
      return false;
    }
    KeepPiece(mesh, this->Piece);
    if (!this->Fill(nodes, mesh, 0, progress.Part(0.7, 1)))
    {
      return false;
    }
    if (this->Request.Piece == 0)
    {
      facets.Warn(this->Messages);
    }
    facets.AddArrays(this->Grid, this->Piece);
    facets.AddFields(this->Grid->GetFieldData());
  }
  seeds.AddFields(this->Grid->GetFieldData());
  return true;
}

//------------------------------------------------------------------------------
bool TetGenAssembly::ReadFiles(
  const MappedFile& file, const std::string& path, const Progress& progress)
{
  ScanError& error = this->Error;
  MappedFile &nodes = this->NodeFile, &elements = this->ElementFile;
  if (IsTetGenVoronoi(path))
  {
    error = { ErrorKind::Unsupported,
      file.GetName() +
        ": expected a mesh, found a part of a Voronoi diagram of TetGen; of its files, only "
        ".v.node (its points) can be read" };
    return false;
  }
  constexpr char Nodes[] = "nodes";
  TetGenKind kind = GetTetGenKind(path);
  switch (kind)
  {
    case TetGenKind::Node:
      if (!HasTetGenCompanion(path, TetGenKind::Ele))
      {
        return this->ReadCloud(file, progress);
      }
      return OpenTetGenCompanion(path, TetGenKind::Ele, "elements", elements, error) &&
        this->ReadTable(elements, TetGenKind::Ele, file, nullptr, progress);
    case TetGenKind::Ele:
    case TetGenKind::Face:
    case TetGenKind::Edge:
      return OpenTetGenCompanion(path, TetGenKind::Node, Nodes, nodes, error) &&
        this->ReadTable(file, kind, nodes, nullptr, progress);
    case TetGenKind::Neigh:
      return OpenTetGenCompanion(path, TetGenKind::Ele, "elements", elements, error) &&
        OpenTetGenCompanion(path, TetGenKind::Node, Nodes, nodes, error) &&
        this->ReadTable(elements, TetGenKind::Ele, nodes, &file, progress);
    case TetGenKind::Poly:
    case TetGenKind::Smesh:
    {
      TextScanner scanner(file.GetName(), file.begin(), file.end(), '#');
      TetGenNodes::Header header;
      if (!TetGenNodes::ReadHeader(scanner, header))
      {
        error = scanner.GetError();
        return false;
      }
      const bool isSmesh = kind == TetGenKind::Smesh;
      return header.Count > 0 ? this->ReadComplex(file, isSmesh, file, progress)
                              : OpenTetGenCompanion(path, TetGenKind::Node, Nodes, nodes, error) &&
          this->ReadComplex(file, isSmesh, nodes, progress);
    }
    case TetGenKind::None:
      break;
  }
  error = { ErrorKind::NotThisFormat,
    file.GetName() +
      ": expected a TetGen or Triangle file, whose name ends with .node, .ele, .face, .edge, "
      ".neigh, .poly or .smesh" };
  return false;
}
}

//------------------------------------------------------------------------------
bool IsTetGen(const std::string& path)
{
  const TetGenKind kind = GetTetGenKind(path);
  if (kind == TetGenKind::None || IsTetGenVoronoi(path))
  {
    return false;
  }
  const MappedFile file(path);
  TextScanner scanner("", file.begin(), file.end(), '#');
  switch (kind)
  {
    case TetGenKind::Node:
    case TetGenKind::Poly:
    case TetGenKind::Smesh:
    {
      TetGenNodes::Header header;
      return TetGenNodes::ReadHeader(scanner, header) &&
        (header.Count == 0 ||
          IsTetGenRow(scanner, 1, header.Dimension + header.Columns.Attributes));
    }
    case TetGenKind::Neigh:
    {
      TetGenNeighbors::Header header;
      return TetGenNeighbors::ReadHeader(scanner, header);
    }
    default:
    {
      TetGenCells::Header header;
      return TetGenCells::ReadHeader(scanner, kind, header) &&
        (header.Count == 0 ||
          IsTetGenRow(scanner, 1 + header.NumberOfNodes, header.Columns.Attributes));
    }
  }
}

//------------------------------------------------------------------------------
bool ReadTetGen(const std::string& path, const PieceRequest& request, vtkUnstructuredGrid* grid,
  Warnings& warnings, ScanError& error, const Progress& progress, vtkIdType chunk)
{
  TetGenAssembly assembly(request, grid, chunk, warnings, error);
  return ReadMappedFile(path, request, grid, warnings, error, progress,
    [&](const MappedFile& file, const Progress& rest)
    { return assembly.Read(file, path, rest) && !rest.IsStopped(); });
}
}
