// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Ranks/CompletedPieces.h"

#include "Mesh/CellShape.h"
#include "Mesh/CellWriter.h"
#include "Ranks/LinkedPieces.h"
#include "Ranks/PieceBorders.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointSet.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <tuple>
#include <unordered_map>
#include <utility>

namespace camaron
{
namespace
{
struct KeyHash
{
  std::size_t operator()(const PointKey& key) const { return static_cast<std::size_t>(Hash(key)); }
};

// A cell of another piece, as encoded in its message.
struct AddedCell
{
  std::int64_t Id;
  PieceAt From;
  unsigned char Type, Ghosts;
  const std::int64_t* Lists; // its points, then its faces, as point numbers, each list preceded by
                             // its size
  const double* Values;
  std::size_t Message;
};

// Cells and points that complete a piece.
struct Addition
{
  std::vector<AddedCell> Cells;
  std::vector<std::vector<vtkIdType>> Points; // of each message, as numbered in the completed piece
  std::vector<double> Coordinates;            // of the points that the piece does not have
};

// A cell of a completed piece: one of its own, or an added one.
struct Place
{
  std::int64_t Id;
  PieceAt From;
  Index Cell;
  bool IsAdded;
  bool operator<(const Place& other) const
  {
    return std::tie(this->Id, this->From, this->Cell) < std::tie(other.Id, other.From, other.Cell);
  }
};

//------------------------------------------------------------------------------
// Whether cells of a type list their faces; see CellShape.
bool ListsFaces(unsigned char type)
{
  return GetCellShape(type).ListsFaces;
}

//------------------------------------------------------------------------------
void WriteCell(const MeshView& mesh, vtkIdType cell, CellWriter& writer)
{
  const unsigned char type = mesh.GetCellType(cell);
  for (const vtkIdType point : mesh.GetCellPoints(cell))
  {
    writer.AddPoint(point);
  }
  if (ListsFaces(type))
  {
    for (const vtkIdType face : mesh.GetPolyhedronFaces(cell))
    {
      for (const vtkIdType point : mesh.GetPolyhedronFacePoints(face))
      {
        writer.AddFacePoint(point);
      }
      writer.EndFace();
    }
  }
  writer.EndCell(type);
}

//------------------------------------------------------------------------------
// @a points maps point numbers of the message to points of the grid.
void WriteCell(const AddedCell& cell, const std::vector<vtkIdType>& points, CellWriter& writer)
{
  const std::int64_t* item = cell.Lists;
  for (std::int64_t left = *item++; left > 0; --left)
  {
    writer.AddPoint(points[static_cast<std::size_t>(*item++)]);
  }
  for (std::int64_t faces = ListsFaces(cell.Type) ? *item++ : 0; faces > 0; --faces)
  {
    for (std::int64_t left = *item++; left > 0; --left)
    {
      writer.AddFacePoint(points[static_cast<std::size_t>(*item++)]);
    }
    writer.EndFace();
  }
  writer.EndCell(cell.Type);
}

//------------------------------------------------------------------------------
class PieceCompleter
{
public:
  PieceCompleter(
    const std::vector<LinkedPiece>& pieces, const Completion& options, camaron::Reducer& reducer)
    : Pieces(pieces)
    , Options(options)
    , Reducer(reducer)
    , NumberOfProcesses(static_cast<std::size_t>(reducer.GetNumberOfProcesses()))
    , Borders(pieces, reducer)
    , Ids(pieces, reducer)
    , Sharings(pieces.size())
    , Additions(pieces.size())
    , IsAtBorder(pieces.size())
  {
  }

  std::vector<vtkSmartPointer<vtkDataSet>> Complete()
  {
    if (this->Options.AsksOthers)
    {
      this->Sharings = FindSharedPoints(this->Pieces, this->Borders, this->Reducer);
      this->ExchangeCells();
    }
    std::vector<vtkSmartPointer<vtkDataSet>> meshes;
    for (std::size_t piece = 0; piece < this->Pieces.size(); ++piece)
    {
      meshes.push_back(this->Make(piece));
    }
    return meshes;
  }

private:
  bool Takes(std::size_t piece, vtkIdType cell) const
  {
    return !this->Options.AsksOthers || !this->Pieces[piece].IsCopy(cell);
  }

  //----------------------------------------------------------------------------
  // Sends every piece the cells at the points that it shares.
  void ExchangeCells()
  {
    std::vector<std::vector<std::int64_t>> integers(this->NumberOfProcesses);
    std::vector<std::vector<double>> reals(this->NumberOfProcesses);
    for (std::size_t p = 0; p < this->Pieces.size(); ++p)
    {
      std::vector<vtkIdType> numbers;
      for (const auto& target : this->FindCellsForOthers(p))
      {
        this->WriteCells(p, target.first.Piece, target.second, numbers,
          integers[target.first.Process], reals[target.first.Process]);
      }
    }
    this->Integers = this->Reducer.ExchangeItems(std::move(integers));
    this->Reals = this->Reducer.ExchangeItems(std::move(reals));
    std::vector<std::unordered_map<PointKey, vtkIdType, KeyHash>> points(this->Pieces.size());
    for (std::size_t p = 0; p < this->Pieces.size(); ++p)
    {
      for (const SharedPoint& sharing : this->Sharings[p])
      {
        points[p].emplace(this->Borders.GetKey(p, sharing.Point), sharing.Point);
      }
      this->AddUnusedPoints(p, points[p]);
    }
    for (std::size_t process = 0; process < this->NumberOfProcesses; ++process)
    {
      const std::int64_t* item = this->Integers[process].data();
      const double* real = this->Reals[process].data();
      while (item != this->Integers[process].data() + this->Integers[process].size())
      {
        this->ReadCells(static_cast<std::int32_t>(process), item, real, points);
      }
    }
  }

  //----------------------------------------------------------------------------
  // Points unused in a piece may still be points of added cells, by their global ids.
  void AddUnusedPoints(
    std::size_t piece, std::unordered_map<PointKey, vtkIdType, KeyHash>& points) const
  {
    if (points.empty() || !this->Borders.UsesIds())
    {
      return;
    }
    const MeshView& mesh = this->Pieces[piece].Topology->GetMesh();
    const std::vector<bool> isUsed = mesh.FindUsedPoints();
    for (vtkIdType point = 0; point < mesh.GetNumberOfPoints(); ++point)
    {
      if (!isUsed[static_cast<std::size_t>(point)])
      {
        points.emplace(this->Borders.GetKey(piece, point), point);
      }
    }
  }

  //----------------------------------------------------------------------------
  std::map<PieceAt, std::vector<Index>> FindCellsForOthers(std::size_t piece)
  {
    std::map<PieceAt, std::vector<Index>> cells;
    const std::vector<SharedPoint>& sharings = this->Sharings[piece];
    if (sharings.empty())
    {
      return cells;
    }
    const MeshView& mesh = this->Pieces[piece].Topology->GetMesh();
    std::vector<std::size_t> first(static_cast<std::size_t>(mesh.GetNumberOfPoints()) + 1, 0);
    for (const SharedPoint& sharing : sharings)
    {
      ++first[sharing.Point + 1];
    }
    std::partial_sum(first.begin(), first.end(), first.begin());
    this->IsAtBorder[piece].resize(mesh.GetNumberOfCells());
    std::vector<PieceAt> targets;
    for (vtkIdType cell = 0; cell < mesh.GetNumberOfCells(); ++cell)
    {
      if (!this->Takes(piece, cell))
      {
        continue;
      }
      targets.clear();
      for (const vtkIdType point : mesh.GetCellPoints(cell))
      {
        for (std::size_t s = first[point]; s < first[point + 1]; ++s)
        {
          targets.push_back(sharings[s].Other);
        }
      }
      std::sort(targets.begin(), targets.end());
      targets.erase(std::unique(targets.begin(), targets.end()), targets.end());
      for (const PieceAt& target : targets)
      {
        cells[target].push_back(static_cast<Index>(cell));
      }
      this->IsAtBorder[piece][cell] = !targets.empty();
    }
    return cells;
  }

  //----------------------------------------------------------------------------
  // Integers: the pieces, the numbers of cells and points; ids of the points if they have any; for
  // each cell its id, type and ghost type, its points and its faces. Reals: coordinates, then the
  // values of each cell.
  void WriteCells(std::size_t piece, std::int32_t target, const std::vector<Index>& cells,
    std::vector<vtkIdType>& numbers, std::vector<std::int64_t>& integers,
    std::vector<double>& reals)
  {
    const LinkedPiece& from = this->Pieces[piece];
    const MeshView& mesh = from.Topology->GetMesh();
    numbers.resize(mesh.GetNumberOfPoints(), -1);
    std::vector<std::int64_t> rows;
    std::vector<vtkIdType> points;
    const auto write = [&](const IndexRange& list)
    {
      rows.push_back(list.Size);
      for (const vtkIdType point : list)
      {
        vtkIdType& number = numbers[point];
        if (number < 0)
        {
          number = static_cast<vtkIdType>(points.size());
          points.push_back(point);
        }
        rows.push_back(number);
      }
    };
    for (const Index cell : cells)
    {
      const unsigned char type = mesh.GetCellType(cell);
      const unsigned char ghosts = from.Options.Ghosts ? from.Options.Ghosts[cell] : 0;
      rows.insert(rows.end(), { this->Ids.GetInBlock(piece, cell), type, ghosts });
      write(mesh.GetCellPoints(cell));
      if (ListsFaces(type))
      {
        const IndexRange faces = mesh.GetPolyhedronFaces(cell);
        rows.push_back(faces.Size);
        for (const vtkIdType face : faces)
        {
          write(mesh.GetPolyhedronFacePoints(face));
        }
      }
    }
    integers.insert(integers.end(),
      { target, static_cast<std::int64_t>(piece), static_cast<std::int64_t>(cells.size()),
        static_cast<std::int64_t>(points.size()) });
    for (const vtkIdType point : points)
    {
      if (this->Borders.UsesIds())
      {
        integers.push_back(from.PointIds[point]);
      }
      double x[3];
      mesh.GetPoint(point, x);
      reals.insert(reals.end(), x, x + 3);
      numbers[point] = -1;
    }
    integers.insert(integers.end(), rows.begin(), rows.end());
    const std::vector<vtkDataArray*> arrays = this->GetArrays(piece);
    for (const Index cell : cells)
    {
      for (vtkDataArray* array : arrays)
      {
        reals.push_back(GetValue(array, cell));
      }
    }
  }

  //----------------------------------------------------------------------------
  // The requested arrays of a piece, or nullptr.
  std::vector<vtkDataArray*> GetArrays(std::size_t piece) const
  {
    std::vector<vtkDataArray*> arrays;
    for (const std::string& name : this->Options.Arrays)
    {
      arrays.push_back(this->Pieces[piece].Data->GetCellData()->GetArray(name.c_str()));
    }
    return arrays;
  }
  static double GetValue(vtkDataArray* array, vtkIdType cell)
  {
    return array ? array->GetComponent(cell, 0) : Null(NullReason::NotApplicable);
  }

  //----------------------------------------------------------------------------
  // Reads the output of WriteCells.
  void ReadCells(std::int32_t process, const std::int64_t*& item, const double*& real,
    std::vector<std::unordered_map<PointKey, vtkIdType, KeyHash>>& knownPoints)
  {
    const auto piece = static_cast<std::size_t>(item[0]);
    const auto from = static_cast<std::int32_t>(item[1]);
    const std::int64_t numberOfCells = item[2], numberOfPoints = item[3];
    item += 4;
    Addition& addition = this->Additions[piece];
    auto& known = knownPoints[piece];
    const vtkIdType numberOfOwn = this->Pieces[piece].Topology->GetMesh().GetNumberOfPoints();
    std::vector<vtkIdType> points;
    for (std::int64_t i = 0; i < numberOfPoints; ++i, real += 3)
    {
      const PointKey key =
        this->Borders.GetKey(this->Borders.UsesIds() ? *item++ : 0, { real[0], real[1], real[2] });
      const auto next = static_cast<vtkIdType>(addition.Coordinates.size() / 3) + numberOfOwn;
      const auto found = known.emplace(key, next);
      if (found.second)
      {
        addition.Coordinates.insert(addition.Coordinates.end(), real, real + 3);
      }
      points.push_back(found.first->second);
    }
    for (std::int64_t i = 0; i < numberOfCells; ++i)
    {
      const auto type = static_cast<unsigned char>(item[1]);
      const auto ghosts = static_cast<unsigned char>(item[2] | vtkDataSetAttributes::DUPLICATECELL);
      addition.Cells.push_back(
        { item[0], { process, from }, type, ghosts, item + 3, real, addition.Points.size() });
      item += 3;
      item += 1 + *item;
      for (std::int64_t f = ListsFaces(type) ? *item++ : 0; f > 0; --f)
      {
        item += 1 + *item;
      }
      real += this->Options.Arrays.size();
    }
    addition.Points.push_back(std::move(points));
  }

  //----------------------------------------------------------------------------
  // The cells of a completed piece in order; empty if they are those of the piece.
  std::vector<Place> FindPlaces(std::size_t piece) const
  {
    const vtkIdType numberOfCells = this->Pieces[piece].Topology->GetMesh().GetNumberOfCells();
    const PieceAt own = { this->Reducer.GetProcess(), static_cast<std::int32_t>(piece) };
    const std::vector<unsigned char>& isAtBorder = this->IsAtBorder[piece];
    std::vector<Place> places;
    for (vtkIdType cell = 0; cell < numberOfCells; ++cell)
    {
      if (this->Takes(piece, cell) &&
        (!this->Options.BorderOnly || (!isAtBorder.empty() && isAtBorder[cell])))
      {
        places.push_back({ this->GetId(piece, cell), own, static_cast<Index>(cell), false });
      }
    }
    const std::vector<AddedCell>& added = this->Additions[piece].Cells;
    for (std::size_t i = 0; i < added.size(); ++i)
    {
      places.push_back({ added[i].Id, added[i].From, static_cast<Index>(i), true });
    }
    const bool isSorted = std::is_sorted(places.begin(), places.end());
    if (isSorted && added.empty() && static_cast<vtkIdType>(places.size()) == numberOfCells)
    {
      places.clear();
    }
    else if (!isSorted)
    {
      std::sort(places.begin(), places.end());
    }
    return places;
  }

  //----------------------------------------------------------------------------
  std::int64_t GetId(std::size_t piece, vtkIdType cell) const
  {
    return this->Options.AsksOthers ? this->Ids.GetInBlock(piece, cell)
      : this->Pieces[piece].CellIds ? this->Pieces[piece].CellIds[cell]
                                    : cell;
  }

  //----------------------------------------------------------------------------
  vtkSmartPointer<vtkDataSet> Make(std::size_t piece) const
  {
    const LinkedPiece& from = this->Pieces[piece];
    const MeshView& mesh = from.Topology->GetMesh();
    std::vector<Place> places = this->FindPlaces(piece);
    vtkSmartPointer<vtkDataSet> result;
    if (places.empty() && !this->Options.BorderOnly)
    {
      result.TakeReference(from.Data->NewInstance());
      result->CopyStructure(from.Data);
      for (vtkIdType cell = 0; cell < mesh.GetNumberOfCells(); ++cell)
      {
        places.push_back({ this->GetId(piece, cell), {}, static_cast<Index>(cell), false });
      }
    }
    else
    {
      CellWriter writer;
      const Addition& addition = this->Additions[piece];
      for (const Place& place : places)
      {
        if (place.IsAdded)
        {
          const AddedCell& cell = addition.Cells[place.Cell];
          WriteCell(cell, addition.Points[cell.Message], writer);
        }
        else
        {
          WriteCell(mesh, place.Cell, writer);
        }
      }
      const auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
      writer.SetCells(grid);
      grid->SetPoints(this->MakePoints(piece));
      result = grid;
    }
    this->AddArrays(piece, places, result->GetCellData());
    return result;
  }

  //----------------------------------------------------------------------------
  vtkSmartPointer<vtkPoints> MakePoints(std::size_t piece) const
  {
    const std::vector<double>& added = this->Additions[piece].Coordinates;
    vtkPointSet* data = vtkPointSet::SafeDownCast(this->Pieces[piece].Data);
    vtkSmartPointer<vtkPoints> points = data ? data->GetPoints() : nullptr;
    if (!added.empty() && points)
    {
      vtkDataArray* own = points->GetData();
      points = vtkSmartPointer<vtkPoints>::New(own->GetDataType());
      const vtkIdType size = own->GetNumberOfTuples();
      points->SetNumberOfPoints(size + static_cast<vtkIdType>(added.size() / 3));
      points->GetData()->InsertTuples(0, size, 0, own);
      for (std::size_t i = 0; i < added.size() / 3; ++i)
      {
        points->SetPoint(size + static_cast<vtkIdType>(i), &added[3 * i]);
      }
    }
    return points;
  }

  //----------------------------------------------------------------------------
  void AddArrays(std::size_t piece, const std::vector<Place>& places, vtkCellData* data) const
  {
    const unsigned char* ownGhosts = this->Pieces[piece].Options.Ghosts;
    const std::vector<AddedCell>& added = this->Additions[piece].Cells;
    const auto fill = [&](auto* array, const char* name, auto&& get)
    {
      array->SetName(name);
      array->SetNumberOfValues(static_cast<vtkIdType>(places.size()));
      std::transform(places.begin(), places.end(), array->GetPointer(0), get);
    };
    vtkNew<vtkIdTypeArray> ids;
    fill(ids.Get(), "GlobalCellIds", [](const Place& place) { return place.Id; });
    data->SetGlobalIds(ids);
    if (this->Options.AsksOthers || ownGhosts)
    {
      vtkNew<vtkUnsignedCharArray> ghosts;
      fill(ghosts.Get(), vtkDataSetAttributes::GhostArrayName(),
        [&](const Place& place) -> unsigned char
        {
          return place.IsAdded ? added[place.Cell].Ghosts : ownGhosts ? ownGhosts[place.Cell] : 0;
        });
      data->AddArray(ghosts);
    }
    const std::vector<vtkDataArray*> arrays = this->GetArrays(piece);
    for (std::size_t a = 0; a < arrays.size(); ++a)
    {
      vtkNew<vtkDoubleArray> values;
      fill(values.Get(), this->Options.Arrays[a].c_str(), [&](const Place& place)
        { return place.IsAdded ? added[place.Cell].Values[a] : GetValue(arrays[a], place.Cell); });
      if (arrays[a])
      {
        values->CopyInformation(arrays[a]->GetInformation());
      }
      data->AddArray(values);
    }
  }

  const std::vector<LinkedPiece>& Pieces;
  const Completion& Options;
  camaron::Reducer& Reducer;
  const std::size_t NumberOfProcesses;
  const PieceBorders Borders;
  const CellIds Ids;
  std::vector<std::vector<SharedPoint>> Sharings;  // by piece
  std::vector<std::vector<std::int64_t>> Integers; // from each process
  std::vector<std::vector<double>> Reals;
  std::vector<Addition> Additions;                    // by piece
  std::vector<std::vector<unsigned char>> IsAtBorder; // cells by piece; empty if none is
};
}

//------------------------------------------------------------------------------
std::vector<vtkSmartPointer<vtkDataSet>> CompletePieces(
  const std::vector<LinkedPiece>& pieces, const Completion& completion, Reducer& reducer)
{
  return PieceCompleter(pieces, completion, reducer).Complete();
}
}
