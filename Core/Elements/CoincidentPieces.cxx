// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// Coincident points of several pieces.
#include "Elements/CoincidentPoints.h"

#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <tuple>
#include <utility>

namespace camaron
{
namespace
{
struct PieceOfPoints : ComparedPiece
{
  std::int64_t NumberOfPoints;
  bool HasIds;
};

/// A point of a piece, sent to the rank that compares the points of its cube.
struct PlacedPoint
{
  Vector Place;
  std::int64_t Id;
  std::uint64_t Bucket;
  std::int32_t Block, Process, Piece;
  bool IsTwiceInPiece; // set by the rank that compares

  auto GetPlace() const { return std::tie(this->Place.X, this->Place.Y, this->Place.Z); }
};

/// Requests the points of one cube near a position.
struct Question
{
  Vector Place;
  std::int64_t Id;
  std::uint64_t Bucket;
  std::int32_t Block;
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
// Compares the points of some cubes.
class Judge
{
public:
  Judge(const std::vector<std::vector<PlacedPoint>>& lists, const PointGrid& grid, bool hasIds)
    : Grid(grid)
    , HasIds(hasIds)
  {
    for (const auto& list : lists)
    {
      this->Points.insert(this->Points.end(), list.begin(), list.end());
    }
    this->MarkTwice();
    std::sort(this->Points.begin(), this->Points.end(),
      [](const PlacedPoint& a, const PlacedPoint& b)
      { return std::tie(a.Block, a.Bucket, a.Id) < std::tie(b.Block, b.Bucket, b.Id); });
  }

  Answer operator()(const Question& question) const
  {
    Answer answer = { -1, 0 };
    auto point = std::lower_bound(this->Points.begin(), this->Points.end(), question,
      [](const PlacedPoint& known, const Question& wanted)
      { return std::tie(known.Block, known.Bucket) < std::tie(wanted.Block, wanted.Bucket); });
    for (; point != this->Points.end() && point->Block == question.Block &&
      point->Bucket == question.Bucket && !answer.HasOther;
      ++point)
    {
      if (this->Grid.AreNear(question.Place, point->Place))
      {
        answer.Lowest = answer.Lowest < 0 ? point->Id : answer.Lowest;
        answer.HasOther = point->IsTwiceInPiece || !this->IsSame(question, *point);
      }
    }
    return answer;
  }

private:
  // Without ids, points of one piece at the same position are different, although those of two
  // pieces are the same.
  void MarkTwice()
  {
    const auto key = [this](const PlacedPoint& point)
    {
      return std::tuple_cat(std::tie(point.Block, point.Process, point.Piece), point.GetPlace(),
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

  bool IsSame(const Question& question, const PlacedPoint& point) const
  {
    const Vector& place = question.Place;
    return this->HasIds ? question.Id == point.Id
                        : std::tie(place.X, place.Y, place.Z) == point.GetPlace();
  }

  const PointGrid& Grid;
  const bool HasIds;
  std::vector<PlacedPoint> Points;
};

//------------------------------------------------------------------------------
// The questions of this rank, and their origins.
struct Inquiry
{
  const std::size_t NumberOfProcesses;
  std::vector<std::vector<PlacedPoint>> Points; // by rank
  std::vector<Question> Questions;
  std::vector<std::pair<std::size_t, vtkIdType>> Askers; // piece and point of every question

  explicit Inquiry(std::size_t numberOfProcesses)
    : NumberOfProcesses(numberOfProcesses)
    , Points(numberOfProcesses)
  {
  }

  std::size_t GetJudge(std::uint64_t bucket) const { return bucket % this->NumberOfProcesses; }

  void Add(const PointGrid& grid, const PlacedPoint& point, vtkIdType local)
  {
    this->Points[this->GetJudge(point.Bucket)].push_back(point);
    grid.ForNear(point.Place,
      [&](std::uint64_t bucket)
      {
        this->Questions.push_back({ point.Place, point.Id, bucket, point.Block });
        this->Askers.emplace_back(static_cast<std::size_t>(point.Piece), local);
      });
  }
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
  const PointGrid grid = MakeGrid(tolerance, all);
  const bool hasFloats =
    std::any_of(all.begin(), all.end(), [](const PieceOfPoints& piece) { return piece.HasFloats; });
  const bool hasIds =
    std::all_of(all.begin(), all.end(), [](const PieceOfPoints& piece) { return piece.HasIds; });

  std::vector<std::vector<vtkIdType>> lowest;
  std::vector<PointNumbers> numbers;
  Inquiry inquiry(static_cast<std::size_t>(reducer.GetNumberOfProcesses()));
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
        inquiry.Add(grid,
          { place, ofPiece(point), grid.GetHash(place), pieces[p].Block, own[p].Process,
            own[p].Piece, false },
          point);
      }
    }
  }

  const Judge judge(reducer.ExchangeItems(std::move(inquiry.Points)), grid, hasIds);
  const std::vector<Answer> answers = reducer.Ask(
    inquiry.Questions, [&](const Question& question) { return inquiry.GetJudge(question.Bucket); },
    [&](const std::vector<std::vector<Question>>& received)
    {
      std::vector<std::vector<Answer>> judged;
      for (const std::vector<Question>& questions : received)
      {
        judged.emplace_back();
        std::transform(
          questions.begin(), questions.end(), std::back_inserter(judged.back()), judge);
      }
      return judged;
    });

  // A point may coincide with one in its own piece and with a lower one elsewhere.
  std::vector<std::vector<std::int64_t>> elsewhere;
  for (std::size_t p = 0; p < pieces.size(); ++p)
  {
    elsewhere.emplace_back(lowest[p].size(), -1);
  }
  for (std::size_t i = 0; i < answers.size(); ++i)
  {
    const Answer& answer = answers[i];
    const auto& [piece, point] = inquiry.Askers[i];
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
