// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Elements/CoincidentPoints.h"

#include "Base/Parallel.h"
#include "Elements/PointGrid.h"
#include "Mesh/MeshTopology.h"

#include "vtkDataArray.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <tuple>
#include <utility>

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
// A point in a bucket, which contains all points of a cube of space.
struct Entry
{
  std::uint64_t Bucket;
  vtkIdType Id;
  vtkIdType Point;
  bool operator<(const Entry& other) const
  {
    return std::tie(this->Bucket, this->Id, this->Point) <
      std::tie(other.Bucket, other.Id, other.Point);
  }
};

//------------------------------------------------------------------------------
// Finds points by position.
class PointBuckets
{
public:
  PointBuckets(const MeshView& mesh, const PointGrid& grid, const PointNumbers& numbers,
    const std::vector<unsigned char>& isLeftOut)
    : Mesh(mesh)
    , Grid(grid)
    , Entries(static_cast<std::size_t>(mesh.GetNumberOfPoints()))
  {
    ParallelForEach(mesh.GetNumberOfPoints(), MediumGrain,
      [&](vtkIdType point)
      {
        const Vector place = mesh.GetPoint(point);
        const bool counts =
          std::isfinite(PointGrid::GetSize(place)) && (isLeftOut.empty() || !isLeftOut[point]);
        this->Entries[point] = { counts ? grid.GetHash(place) : 0, numbers(point),
          counts ? point : -1 };
      });
    WithThreads([this] { vtkSMPTools::Sort(this->Entries.begin(), this->Entries.end()); });
  }

  /// The lowest id within reach of a point, or -1 if there is only the point itself.
  vtkIdType FindLowest(vtkIdType point) const
  {
    const Vector place = this->Mesh.GetPoint(point);
    if (!std::isfinite(PointGrid::GetSize(place)))
    {
      return -1;
    }
    vtkIdType lowest = -1;
    bool hasOther = false;
    this->Grid.ForNear(
      place, [&](std::uint64_t bucket) { this->Search(bucket, point, place, lowest, hasOther); });
    return hasOther ? lowest : -1;
  }

private:
  // A bucket is in the order of ids: its lowest is the first within reach; a second one shows that
  // there is another point.
  void Search(std::uint64_t bucket, vtkIdType point, const Vector& place, vtkIdType& lowest,
    bool& hasOther) const
  {
    auto entry = std::lower_bound(this->Entries.begin(), this->Entries.end(), bucket,
      [](const Entry& known, std::uint64_t wanted) { return known.Bucket < wanted; });
    bool isFirst = true;
    for (; entry != this->Entries.end() && entry->Bucket == bucket; ++entry)
    {
      if (entry->Point < 0 || !this->Grid.AreNear(place, this->Mesh.GetPoint(entry->Point)))
      {
        continue;
      }
      hasOther = hasOther || entry->Point != point;
      if (isFirst)
      {
        lowest = lowest < 0 ? entry->Id : std::min(lowest, entry->Id);
        isFirst = false;
      }
      if (hasOther)
      {
        return;
      }
    }
  }

  const MeshView& Mesh;
  const PointGrid& Grid;
  std::vector<Entry> Entries;
};
}

//------------------------------------------------------------------------------
vtkIdType PointNumbers::operator()(vtkIdType point) const
{
  return this->Array ? static_cast<vtkIdType>(this->Array->GetComponent(point, 0))
    : this->Ids      ? this->Ids[point]
                     : this->First + point;
}

//------------------------------------------------------------------------------
std::vector<vtkIdType> FindCoincidentPoints(const MeshView& mesh, double tolerance,
  const PointNumbers& numbers, const std::vector<unsigned char>& isLeftOut)
{
  double largest = 0;
  for (vtkIdType point = 0; point < mesh.GetNumberOfPoints(); ++point)
  {
    const double size = PointGrid::GetSize(mesh.GetPoint(point));
    largest = std::isfinite(size) ? std::max(largest, size) : largest;
  }
  const PointGrid grid(tolerance, mesh.HasFloatPoints(), largest);
  return FindCoincidentPoints(mesh, grid, numbers, isLeftOut);
}

//------------------------------------------------------------------------------
std::vector<vtkIdType> FindCoincidentPoints(const MeshView& mesh, const PointGrid& grid,
  const PointNumbers& numbers, const std::vector<unsigned char>& isLeftOut)
{
  const PointBuckets buckets(mesh, grid, numbers, isLeftOut);
  std::vector<vtkIdType> lowest(static_cast<std::size_t>(mesh.GetNumberOfPoints()));
  ParallelForEach(mesh.GetNumberOfPoints(), MediumGrain,
    [&](vtkIdType point) { lowest[point] = buckets.FindLowest(point); });
  return lowest;
}

namespace
{
/// A face, represented by its center, and the position of its points in a list.
struct PlacedFace
{
  Vector Center;
  std::uint64_t Bucket; // a cube near the center
  std::int64_t Number;  // identifies the face for the sender
  std::int64_t FirstPoint;
  std::int32_t Size, Block;
};

struct PlacedFaces
{
  std::vector<PlacedFace> Faces;
  std::vector<Vector> Points;
};

//------------------------------------------------------------------------------
// The boundary faces of own cells, numbered by their facets.
PlacedFaces ListFaces(const PieceOfFaces& piece)
{
  const FacetTable& table = piece.Topology->GetFaces();
  const MeshView& mesh = piece.Topology->GetMesh();
  PlacedFaces result;
  std::vector<vtkIdType> points;
  for (Index face = 0; face < table.GetNumberOfFacets(); ++face)
  {
    if (!table.IsBoundary(face) || !piece.IsOwn(table.GetCells(face).First))
    {
      continue;
    }
    piece.Topology->GetFacePoints(face, points);
    Vector center;
    const auto first = static_cast<std::int64_t>(result.Points.size());
    for (const vtkIdType point : points)
    {
      result.Points.push_back(mesh.GetPoint(point));
      center += result.Points.back();
    }
    center = (1.0 / static_cast<double>(points.size())) * center;
    result.Faces.push_back(
      { center, 0, face, first, static_cast<std::int32_t>(points.size()), piece.Block });
  }
  return result;
}

//------------------------------------------------------------------------------
bool HasCenter(const PlacedFace& face)
{
  return std::isfinite(PointGrid::GetSize(face.Center));
}

//------------------------------------------------------------------------------
ComparedPiece Summarize(
  const PieceOfFaces& piece, std::int32_t process, std::int32_t number, const PlacedFaces& list)
{
  ComparedPiece summary = { { process, number, piece.Block, {} }, 0,
    piece.Topology->GetMesh().HasFloatPoints() };
  for (const PlacedFace& face : list.Faces)
  {
    if (HasCenter(face))
    {
      summary.Box.Add(face.Center);
    }
  }
  for (const Vector& point : list.Points)
  {
    const double size = PointGrid::GetSize(point);
    summary.Largest = std::isfinite(size) ? std::max(summary.Largest, size) : summary.Largest;
  }
  return summary;
}

//------------------------------------------------------------------------------
// Finds coincident faces among faces that are listed once for each nearby cube.
class FaceMatcher
{
public:
  /// @param centers the grid that assigned faces to cubes
  FaceMatcher(const PointGrid& grid, const PointGrid& centers)
    : Grid(grid)
    , Reach(centers.GetReach())
  {
  }

  /// Takes a list from sender @a list.
  void Add(std::size_t list, const std::vector<PlacedFace>& faces, const Vector* points)
  {
    for (const PlacedFace& face : faces)
    {
      this->Items.push_back({ face, points + face.FirstPoint, list });
    }
  }

  /// Calls @a visit(list, number) for every face that coincides with another one, possibly more
  /// than once.
  template <typename Visit>
  void Match(Visit&& visit)
  {
    std::sort(this->Items.begin(), this->Items.end(),
      [](const Item& a, const Item& b)
      {
        return std::tie(a.Face.Block, a.Face.Bucket, a.Face.Center.X) <
          std::tie(b.Face.Block, b.Face.Bucket, b.Face.Center.X);
      });
    this->Next.resize(this->Items.size() + 1);
    std::iota(this->Next.begin(), this->Next.end(), std::size_t(0));
    std::vector<unsigned char> isMatched(this->Items.size(), 0);
    const auto mark = [&](std::size_t i)
    {
      if (!isMatched[i])
      {
        isMatched[i] = 1;
        this->Next[i] = i + 1;
        visit(this->Items[i].List, this->Items[i].Face.Number);
      }
    };
    for (std::size_t i = 0; i < this->Items.size(); ++i)
    {
      // A face that is already matched can only match others, so matched faces are skipped quickly.
      for (std::size_t j = isMatched[i] ? this->FindNext(i + 1) : i + 1;
        j < this->Items.size() && this->AreClose(this->Items[i].Face, this->Items[j].Face);
        j = isMatched[i] ? this->FindNext(j + 1) : j + 1)
      {
        if (this->AreInOnePlace(this->Items[i], this->Items[j]))
        {
          mark(i);
          mark(j);
        }
      }
    }
  }

private:
  struct Item
  {
    PlacedFace Face;
    const Vector* Points;
    std::size_t List;
  };

  // The first unmatched face from here on.
  std::size_t FindNext(std::size_t i)
  {
    while (this->Next[i] != i)
    {
      i = this->Next[i] = this->Next[this->Next[i]];
    }
    return i;
  }

  bool AreClose(const PlacedFace& a, const PlacedFace& b) const
  {
    return a.Block == b.Block && a.Bucket == b.Bucket && b.Center.X - a.Center.X <= this->Reach;
  }

  bool AreInOnePlace(const Item& a, const Item& b) const
  {
    const bool isSame = a.List == b.List && a.Face.Number == b.Face.Number;
    return !isSame && a.Face.Size == b.Face.Size &&
      Norm(a.Face.Center - b.Face.Center) <= this->Reach && this->Covers(a, b) &&
      this->Covers(b, a);
  }

  // Whether every point of the first face is near one of the second.
  bool Covers(const Item& a, const Item& b) const
  {
    return std::all_of(a.Points, a.Points + a.Face.Size,
      [&](const Vector& point)
      {
        return std::any_of(b.Points, b.Points + b.Face.Size,
          [&](const Vector& other) { return this->Grid.AreNear(point, other); });
      });
  }

  const PointGrid& Grid;
  const double Reach;
  std::vector<Item> Items;
  std::vector<std::size_t> Next;
};

//------------------------------------------------------------------------------
// The same faces, once for every cube near them.
std::vector<PlacedFace> PutIntoCubes(const std::vector<PlacedFace>& faces, const PointGrid& centers)
{
  std::vector<PlacedFace> result;
  for (const PlacedFace& face : faces)
  {
    if (HasCenter(face))
    {
      centers.ForNear(face.Center,
        [&](std::uint64_t bucket)
        {
          result.push_back(face);
          result.back().Bucket = bucket;
        });
    }
  }
  return result;
}
}

//------------------------------------------------------------------------------
std::vector<std::vector<Index>> FindMismatchedFaces(
  const std::vector<PieceOfFaces>& pieces, double tolerance, Reducer& reducer)
{
  std::vector<PlacedFaces> lists;
  std::vector<ComparedPiece> own;
  for (const PieceOfFaces& piece : pieces)
  {
    lists.push_back(ListFaces(piece));
    own.push_back(
      Summarize(piece, reducer.GetProcess(), static_cast<std::int32_t>(own.size()), lists.back()));
  }
  const std::vector<ComparedPiece> all = reducer.GatherItems(own);
  const PointGrid grid = MakePointGrid(tolerance, all);
  // If points are within reach, so are centers, except for roundoff.
  const PointGrid centers = MakePointGrid(2 * grid.GetReach(), all);

  const auto numberOfPieces = static_cast<std::int64_t>(pieces.size());
  const auto numberOfProcesses = static_cast<std::size_t>(reducer.GetNumberOfProcesses());
  std::vector<std::vector<PlacedFace>> sentFaces(numberOfProcesses);
  std::vector<std::vector<Vector>> sentPoints(numberOfProcesses);
  std::vector<std::vector<Index>> mismatched(pieces.size());
  for (std::size_t p = 0; p < pieces.size(); ++p)
  {
    const std::vector<PlacedFace> faces = PutIntoCubes(lists[p].Faces, centers);
    FaceMatcher matcher(grid, centers);
    matcher.Add(0, faces, lists[p].Points.data());
    matcher.Match(
      [&](std::size_t, std::int64_t face) { mismatched[p].push_back(static_cast<Index>(face)); });
    const std::vector<Bounds> others = FindOtherBoxes(own[p], all, 2 * centers.GetReach());
    for (PlacedFace face : faces)
    {
      if (std::any_of(others.begin(), others.end(),
            [&](const Bounds& box) { return box.Contains(face.Center); }))
      {
        const std::size_t process = face.Bucket % numberOfProcesses;
        const auto points = lists[p].Points.begin() + face.FirstPoint;
        face.FirstPoint = static_cast<std::int64_t>(sentPoints[process].size());
        sentPoints[process].insert(sentPoints[process].end(), points, points + face.Size);
        face.Number = face.Number * numberOfPieces + static_cast<std::int64_t>(p);
        sentFaces[process].push_back(face);
      }
    }
  }

  const auto faces = reducer.ExchangeItems(std::move(sentFaces));
  const auto points = reducer.ExchangeItems(std::move(sentPoints));
  FaceMatcher matcher(grid, centers);
  for (std::size_t process = 0; process < numberOfProcesses; ++process)
  {
    matcher.Add(process, faces[process], points[process].data());
  }
  std::vector<std::vector<std::int64_t>> answers(numberOfProcesses);
  matcher.Match(
    [&](std::size_t process, std::int64_t number) { answers[process].push_back(number); });
  for (const auto& numbers : reducer.ExchangeItems(std::move(answers)))
  {
    for (const std::int64_t number : numbers)
    {
      mismatched[number % numberOfPieces].push_back(static_cast<Index>(number / numberOfPieces));
    }
  }
  for (std::vector<Index>& list : mismatched)
  {
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
  }
  return mismatched;
}
}
