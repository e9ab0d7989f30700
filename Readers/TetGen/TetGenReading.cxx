// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "TetGenReading.h"

#include "Intake/Pieces/ReadMappedFile.h"
#include "TetGenAssembly.h"

#include "vtkUnstructuredGrid.h"

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
// Finds the companion files and reads the mesh.
bool ReadFiles(const MappedFile& file, MappedFile& nodes, MappedFile& elements,
  const std::string& path, TetGenAssembly& assembly, ScanError& error, const Progress& progress)
{
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
        return assembly.ReadCloud(file, progress);
      }
      return OpenTetGenCompanion(path, TetGenKind::Ele, "elements", elements, error) &&
        assembly.ReadTable(elements, TetGenKind::Ele, file, nullptr, progress);
    case TetGenKind::Ele:
    case TetGenKind::Face:
    case TetGenKind::Edge:
      return OpenTetGenCompanion(path, TetGenKind::Node, Nodes, nodes, error) &&
        assembly.ReadTable(file, kind, nodes, nullptr, progress);
    case TetGenKind::Neigh:
      return OpenTetGenCompanion(path, TetGenKind::Ele, "elements", elements, error) &&
        OpenTetGenCompanion(path, TetGenKind::Node, Nodes, nodes, error) &&
        assembly.ReadTable(elements, TetGenKind::Ele, nodes, &file, progress);
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
      return header.Count > 0 ? assembly.ReadComplex(file, isSmesh, file, progress)
                              : OpenTetGenCompanion(path, TetGenKind::Node, Nodes, nodes, error) &&
          assembly.ReadComplex(file, isSmesh, nodes, progress);
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

//------------------------------------------------------------------------------
bool ReadMesh(const MappedFile& file, const std::string& path, TetGenAssembly& assembly,
  ScanError& error, const Progress& progress)
{
  MappedFile nodes, elements;
  const bool good = ReadFiles(file, nodes, elements, path, assembly, error, progress);
  return nodes.IsUnchanged(error) && elements.IsUnchanged(error) && good;
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
    { return ReadMesh(file, path, assembly, error, rest) && !rest.IsStopped(); });
}
}
