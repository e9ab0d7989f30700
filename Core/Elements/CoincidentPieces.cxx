// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// Coincident points of several pieces.
#include "Elements/CoincidentPoints.h"

#include "Ranks/EqualKeys.h"

#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <tuple>

namespace camaron
{
namespace
{
struct PieceOfPoints : ComparedPiece
{
  std::int64_t NumberOfPoints;
  bool HasIds;
};

/// A point of a piece, sent to the ranks that compare the points of its cube and of near cubes.
struct PlacedPoint
{
  Vector Place;
  std::int64_t Id;
  vtkIdType Local;
  std::uint64_t Bucket; // of the cube
  std::int32_t Block, Process, Piece;
  bool IsInCube;
  bool IsTwiceInPiece; // set by the rank that compares

  auto GetKey() const { return std::make_tuple(this->Block, this->Bucket); }
  std::uint64_t GetHash() const { return this->Bucket; }
  auto GetPlace() const { return std::tie(this->Place.X, this->Place.Y, this->Place.Z); }
};

struct Answer
{
  std::int64_t Lowest; // -1 if there is none
  std::int64_t HasOther;
};

//------------------------------------------------------------------------------
Vector GetPlace(const MeshView& mesh, vtkIdType point, bool asFloat)
{
  const Vector x = mesh.GetPoint(point);
  const auto convert = [=](double coordinate) // -0 becomes 0
  { return (asFloat ? static_cast<float>(coordinate) : coordinate) + 0.0; };
  return { convert(x.X), convert(x.Y), convert(x.Z) };
}

//------------------------------------------------------------------------------
// The points that only belong to duplicates of cells, and duplicate points without cells.
std::vector<unsigned char> FindCopiedPoints(const LinkedPiece& piece)
{
  enum : unsigned char
  {
    OfCopy = 1,
    OfOwn = 2
  };
  const MeshView& mesh = piece.Topology->GetMesh();
  std::vector<unsigned char> marks(static_cast<std::size_t>(mesh.GetNumberOfPoints()), 0);
  for (vtkIdType cell = 0; cell < mesh.GetNumberOfCells(); ++cell)
  {
    for (const vtkIdType point : mesh.GetCellPoints(cell))
    {
      marks[point] |= piece.IsCopy(cell) ? OfCopy : OfOwn;
    }
  }
  vtkUnsignedCharArray* const ghosts = piece.Data->GetPointGhostArray();
  for (std::size_t point = 0; point < marks.size(); ++point)
  {
    const bool isUnusedCopy = ghosts && marks[point] == 0 &&
      (ghosts->GetValue(static_cast<vtkIdType>(point)) & vtkDataSetAttributes::DUPLICATEPOINT);
    marks[point] = marks[point] == OfCopy || isUnusedCopy;
  }
  return marks;
}

//------------------------------------------------------------------------------
PieceOfPoints Summarize(const LinkedPiece& piece, std::int32_t process, std::int32_t number,
  const std::vector<unsigned char>& isLeftOut)
{
  const MeshView& mesh = piece.Topology->GetMesh();
  const vtkIdType size = mesh.GetNumberOfPoints();
  PieceOfPoints summary = { { { process, number, piece.Block, {} }, 0, mesh.HasFloatPoints() },
    size, piece.PointIds || size == 0 };
  for (vtkIdType point = 0; point < size; ++point)
  {
    const Vector place = GetPlace(mesh, point, false);
    const double largest = PointGrid::GetSize(place);
    if (!isLeftOut[point] && std::isfinite(largest))
    {
      summary.Largest = std::max(summary.Largest, largest);
      summary.Box.Add(place);
    }
  }
  return summary;
}

//------------------------------------------------------------------------------
// Compares the points of a cube.
class Judge
{
public:
  Judge(const PointGrid& grid, bool hasIds)
    : Grid(grid)
    , HasIds(hasIds)
  {
  }

  void operator()(const std::vector<Received<PlacedPoint>>& group, std::vector<Answer>& answers)
  {
    this->Points.clear();
    for (const Received<PlacedPoint>& item : group)
    {
      if (item.Sent->IsInCube)
      {
        this->Points.push_back(*item.Sent);
      }
    }
    this->MarkTwice();
    std::sort(this->Points.begin(), this->Points.end(),
      [](const PlacedPoint& a, const PlacedPoint& b) { return a.Id < b.Id; });
    std::transform(group.begin(), group.end(), answers.begin(),
      [this](const Received<PlacedPoint>& item) { return this->FindOthers(*item.Sent); });
  }

private:
  // Without ids, points of one piece at the same position are different, although those of two
  // pieces are the same.
  void MarkTwice()
  {
    const auto key = [this](const PlacedPoint& point)
    {
      return std::tuple_cat(std::tie(point.Process, point.Piece), point.GetPlace(),
        std::make_tuple(this->HasIds ? point.Id : 0));
    };
    std::sort(this->Points.begin(), this->Points.end(),
      [&](const PlacedPoint& a, const PlacedPoint& b) { return key(a) < key(b); });
    for (std::size_t i = 1; i < this->Points.size(); ++i)
    {
      if (key(this->Points[i - 1]) == key(this->Points[i]))
      {
        this->Points[i - 1].IsTwiceInPiece = this->Points[i].IsTwiceInPiece = true;
      }
    }
  }

  Answer FindOthers(const PlacedPoint& point) const
  {
    Answer answer = { -1, 0 };
    for (const PlacedPoint& other : this->Points)
    {
      if (this->Grid.AreNear(point.Place, other.Place))
      {
        answer.Lowest = answer.Lowest < 0 ? other.Id : answer.Lowest;
        const bool isSame =
          this->HasIds ? point.Id == other.Id : point.GetPlace() == other.GetPlace();
        answer.HasOther = other.IsTwiceInPiece || !isSame;
      }
      if (answer.HasOther)
      {
        break;
      }
    }
    return answer;
  }

  const PointGrid& Grid;
  const bool HasIds;
  std::vector<PlacedPoint> Points;
};
}

//------------------------------------------------------------------------------
std::vector<std::vector<vtkIdType>> FindCoincidentPoints(
  const std::vector<LinkedPiece>& pieces, double tolerance, Reducer& reducer)
{
  std::vector<std::vector<unsigned char>> areLeftOut;
  std::vector<PieceOfPoints> own;
  for (const LinkedPiece& piece : pieces)
  {
    areLeftOut.push_back(FindCopiedPoints(piece));
    own.push_back(Summarize(
      piece, reducer.GetProcess(), static_cast<std::int32_t>(own.size()), areLeftOut.back()));
  }
  const std::vector<PieceOfPoints> all = reducer.GatherItems(own);
  const PointGrid grid = MakePointGrid(tolerance, all);
  const bool hasFloats =
    std::any_of(all.begin(), all.end(), [](const PieceOfPoints& piece) { return piece.HasFloats; });
  const bool hasIds =
    std::all_of(all.begin(), all.end(), [](const PieceOfPoints& piece) { return piece.HasIds; });

  std::vector<std::vector<vtkIdType>> lowest;
  std::vector<PointNumbers> numbers;
  std::vector<PlacedPoint> asked; // once for every near cube
  for (std::size_t p = 0; p < pieces.size(); ++p)
  {
    const MeshView& mesh = pieces[p].Topology->GetMesh();
    PointNumbers ofPiece;
    ofPiece.Ids = hasIds ? pieces[p].PointIds : nullptr;
    for (const PieceOfPoints& other : all)
    {
      const bool isBefore =
        std::tie(other.Process, other.Piece) < std::tie(own[p].Process, own[p].Piece);
      ofPiece.First += other.Block == own[p].Block && isBefore ? other.NumberOfPoints : 0;
    }
    numbers.push_back(ofPiece);
    const std::vector<Bounds> others = FindOtherBoxes(own[p], all, 2 * grid.GetReach());
    lowest.push_back(FindCoincidentPoints(mesh, grid, ofPiece, areLeftOut[p]));
    for (vtkIdType point = 0; point < mesh.GetNumberOfPoints(); ++point)
    {
      const Vector place = GetPlace(mesh, point, hasFloats);
      const bool isNear = !areLeftOut[p][point] && std::isfinite(PointGrid::GetSize(place)) &&
        std::any_of(
          others.begin(), others.end(), [&](const Bounds& box) { return box.Contains(place); });
      if (isNear)
      {
        PlacedPoint placed = { place, ofPiece(point), point, 0, own[p].Block, own[p].Process,
          own[p].Piece, false, false };
        const std::uint64_t home = grid.GetHash(place);
        bool isPlaced = false; // cubes may be visited twice
        grid.ForNear(place,
          [&](std::uint64_t bucket)
          {
            placed.Bucket = bucket;
            placed.IsInCube = !isPlaced && bucket == home;
            isPlaced = isPlaced || placed.IsInCube;
            asked.push_back(placed);
          });
      }
    }
  }

  const std::vector<Answer> answers = AskEachOfEqual<Answer>(asked, reducer, Judge(grid, hasIds));

  // A point may coincide with one in its own piece and with a lower one elsewhere.
  std::vector<std::vector<std::int64_t>> elsewhere;
  for (std::size_t p = 0; p < pieces.size(); ++p)
  {
    elsewhere.emplace_back(lowest[p].size(), -1);
  }
  for (std::size_t i = 0; i < answers.size(); ++i)
  {
    const Answer& answer = answers[i];
    const std::int32_t piece = asked[i].Piece;
    const vtkIdType point = asked[i].Local;
    if (answer.Lowest >= 0)
    {
      std::int64_t& known = elsewhere[piece][point];
      known = known < 0 ? answer.Lowest : std::min(known, answer.Lowest);
    }
    if (answer.HasOther && lowest[piece][point] < 0)
    {
      lowest[piece][point] = numbers[piece](point);
    }
  }
  for (std::size_t p = 0; p < pieces.size(); ++p)
  {
    for (std::size_t point = 0; point < lowest[p].size(); ++point)
    {
      if (lowest[p][point] >= 0 && elsewhere[p][point] >= 0)
      {
        lowest[p][point] = std::min<vtkIdType>(lowest[p][point], elsewhere[p][point]);
      }
    }
  }
  return lowest;
}
}
