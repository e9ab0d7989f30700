// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/CellTopology.h"

#include "Base/DisjointSets.h"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <utility>

namespace camaron
{
namespace
{
constexpr int MaxBits = 64; // of a set of points or faces

//------------------------------------------------------------------------------
std::uint64_t DropLowest(std::uint64_t set)
{
  return set & (set - 1);
}
}

//------------------------------------------------------------------------------
void CellTopology::Clear()
{
  this->IsAsAdded = false;
  this->NumberOfPoints = 0;
  this->FaceOffsets.assign(1, 0);
  this->FacePoints.clear();
}

//------------------------------------------------------------------------------
void CellTopology::AddFace(const int* points, int size)
{
  this->FacePoints.insert(this->FacePoints.end(), points, points + size);
  this->FaceOffsets.push_back(this->FaceOffsets.back() + size);
}

//------------------------------------------------------------------------------
void CellTopology::Take(
  int numberOfPoints, std::vector<int>& faceOffsets, std::vector<int>& facePoints)
{
  this->IsAsAdded = false;
  this->NumberOfPoints = numberOfPoints;
  std::swap(this->FaceOffsets, faceOffsets);
  std::swap(this->FacePoints, facePoints);
}

//------------------------------------------------------------------------------
bool CellTopology::Knows(
  int numberOfPoints, const std::vector<int>& faceOffsets, const std::vector<int>& facePoints) const
{
  return this->KnowsSizes(faceOffsets) && this->NumberOfPoints == numberOfPoints &&
    this->FacePoints == facePoints;
}

//------------------------------------------------------------------------------
bool CellTopology::KnowsSizes(const std::vector<int>& faceOffsets) const
{
  return this->IsAsAdded && this->FaceOffsets == faceOffsets;
}

//------------------------------------------------------------------------------
bool CellTopology::Finish(bool edgesCanWait)
{
  const int numberOfFaces = this->GetNumberOfFaces();
  this->FaceNumbers.resize(numberOfFaces);
  std::iota(this->FaceNumbers.begin(), this->FaceNumbers.end(), 0);
  this->ListCorners();
  const int size = static_cast<int>(this->FacePoints.size());
  const int *points = this->FacePoints.data(), *nexts = this->NextPoints.data();
  int isRepeated = 0;
  for (int i = 0; i < size; ++i)
  {
    isRepeated |= points[i] == nexts[i];
  }
  for (int f = 0; f < numberOfFaces; ++f)
  {
    isRepeated |= this->GetFaceSize(f) < 3;
  }
  const bool wasRepeated = isRepeated && this->DropRepeatedPoints();
  const bool isAsAdded = !wasRepeated && this->GetNumberOfFaces() == numberOfFaces;
  this->Reversed.assign(this->GetNumberOfFaces(), 0);
  this->Edges.clear();
  this->HasEdges = this->IsOneShell = this->HasShells = this->HasFacePairs = false;
  this->KnowsVertexFigures = this->HasVertexFigures = false;
  this->IsAsAdded = isAsAdded;
  if (!edgesCanWait)
  {
    this->FindEdges();
  }
  return wasRepeated;
}

//------------------------------------------------------------------------------
void CellTopology::CheckClosed()
{
  if (!this->HasEdges && !this->IsOneShell)
  {
    this->IsOneShell = this->IsClosedShell();
    if (this->IsOneShell)
    {
      this->IsClosed = this->IsManifold = true;
      return;
    }
    this->FindEdges();
  }
}

//------------------------------------------------------------------------------
void CellTopology::FindEdges()
{
  if (!this->HasEdges)
  {
    this->HasEdges = true;
    this->ListEdges();
  }
}

//------------------------------------------------------------------------------
// Whether two faces traverse every edge, in opposite directions, and all faces are connected. Only
// for cells with few points and faces, which fit into bit sets; also false if faces share points
// that are not on a common edge. Takes a third of the time of listing the edges.
bool CellTopology::IsClosedShell() const
{
  const int size = static_cast<int>(this->FacePoints.size());
  const int numberOfFaces = this->GetNumberOfFaces();
  if (this->NumberOfPoints > MaxBits || numberOfFaces > MaxBits || numberOfFaces == 0)
  {
    return false;
  }
  const int *points = this->FacePoints.data(), *nexts = this->NextPoints.data(),
            *faces = this->CornerFaces.data();
  struct PointSets
  {
    std::uint64_t Nexts, Faces;
  };
  PointSets sets[MaxBits];
  std::fill_n(sets, this->NumberOfPoints, PointSets{ 0, 0 });
  std::uint64_t isTwice = 0;
  for (int i = 0; i < size; ++i)
  {
    PointSets& set = sets[points[i]];
    isTwice |= set.Nexts >> nexts[i]; // its lowest bit: the edge has occurred before
    set.Nexts |= std::uint64_t(1) << nexts[i];
    set.Faces |= std::uint64_t(1) << faces[i];
  }
  std::uint64_t isOpposite = 1, isMany = 0;
  for (int i = 0; i < size; ++i)
  {
    isOpposite &= sets[nexts[i]].Nexts >> points[i];
  }
  for (int point = 0; point < this->NumberOfPoints; ++point)
  {
    isMany |= DropLowest(DropLowest(DropLowest(sets[point].Faces)));
  }
  if ((isTwice & 1) || !isOpposite)
  {
    return false;
  }
  // Up to three faces at a point are connected there; of more, only those that share an edge.
  std::uint64_t isShared = 0; // by a third face
  for (int i = 0; isMany && i < size; ++i)
  {
    isShared |= DropLowest(DropLowest(sets[points[i]].Faces & sets[nexts[i]].Faces));
  }
  if (isShared)
  {
    return false;
  }
  const std::uint64_t all = ~std::uint64_t(0) >> (MaxBits - numberOfFaces);
  std::uint64_t reached = 1, done = 0;
  while (reached != all && reached != done)
  {
    done = reached;
    for (int point = 0; !isMany && point < this->NumberOfPoints; ++point)
    {
      reached |= sets[point].Faces & reached ? sets[point].Faces : 0;
    }
    for (int i = 0; isMany && i < size; ++i)
    {
      const std::uint64_t both = sets[points[i]].Faces & sets[nexts[i]].Faces;
      reached |= both & reached ? both : 0;
    }
  }
  return reached == all;
}

//------------------------------------------------------------------------------
bool CellTopology::DropRepeatedPoints()
{
  const std::vector<int> offsets(this->FaceOffsets), points(this->FacePoints);
  bool isRepeated = false;
  this->FaceOffsets.assign(1, 0);
  this->FaceNumbers.clear();
  int end = 0;
  for (int f = 0; f + 1 < static_cast<int>(offsets.size()); ++f)
  {
    const int begin = end;
    for (int i = offsets[f]; i < offsets[f + 1]; ++i)
    {
      if (points[i] != points[i > offsets[f] ? i - 1 : offsets[f + 1] - 1])
      {
        this->FacePoints[end++] = points[i];
      }
    }
    isRepeated = isRepeated || end - begin < offsets[f + 1] - offsets[f];
    if (end - begin < 3)
    {
      end = begin;
      continue;
    }
    this->FaceOffsets.push_back(end);
    this->FaceNumbers.push_back(f);
  }
  this->FacePoints.resize(end);
  this->ListCorners();
  return isRepeated;
}

//------------------------------------------------------------------------------
void CellTopology::ListCorners()
{
  const int size = static_cast<int>(this->FacePoints.size()),
            numberOfFaces = this->GetNumberOfFaces();
  // Branches on the number of points of a face would be mispredicted: a fixed number is written for
  // each face, and the next face overwrites the excess.
  constexpr int usual = 8;
  this->NextPoints.resize(size);
  this->CornerFaces.resize(size + usual);
  const int *points = this->FacePoints.data(), *offsets = this->FaceOffsets.data();
  int *nexts = this->NextPoints.data(), *faces = this->CornerFaces.data();
  std::copy(points + std::min(size, 1), points + size, nexts);
  for (int f = 0; f < numberOfFaces; ++f)
  {
    const int begin = offsets[f], end = offsets[f + 1];
    std::fill_n(faces + begin, usual, f);
    if (end > begin + usual)
    {
      std::fill(faces + begin + usual, faces + end, f);
    }
    if (end > begin)
    {
      nexts[end - 1] = points[begin];
    }
  }
}

//------------------------------------------------------------------------------
// Sets FaceEdges and FirstCorners; returns the number of edges.
int CellTopology::NumberEdges()
{
  const int size = static_cast<int>(this->FacePoints.size());
  const int *points = this->FacePoints.data(), *nexts = this->NextPoints.data();
  this->FaceEdges.resize(size);
  this->FirstCorners.resize(size);
  int *const edgeOf = this->FaceEdges.data(), *const firsts = this->FirstCorners.data();
  if (this->NumberOfPoints > MaxBits)
  {
    const int numberOfEdges = this->EdgeNumbers.Number(
      size,
      [&](int i)
      {
        const std::int64_t a = points[i], b = nexts[i];
        return std::min(a, b) << 32 | std::max(a, b);
      },
      edgeOf);
    std::copy_n(this->EdgeNumbers.GetFirsts(), numberOfEdges, firsts);
    return numberOfEdges;
  }
  this->EdgeTable.resize(MaxBits * MaxBits);
  int* const table = this->EdgeTable.data();
  std::uint64_t known[MaxBits]; // for every point, its edges to points with larger numbers
  std::fill_n(known, this->NumberOfPoints, 0);
  int count = 0;
  for (int i = 0; i < size; ++i)
  {
    const int low = std::min(points[i], nexts[i]), high = std::max(points[i], nexts[i]);
    int& place = table[MaxBits * low + high];
    // Does not branch, because branches are mispredicted in irregular meshes.
    const int isKnown = static_cast<int>(known[low] >> high & 1);
    const int number = isKnown ? place : count;
    known[low] |= std::uint64_t(1) << high;
    place = number;
    edgeOf[i] = number;
    firsts[count] = i; // overwritten later unless the edge is new
    count += 1 - isKnown;
  }
  return count;
}

//------------------------------------------------------------------------------
void CellTopology::ListEdges()
{
  const int size = static_cast<int>(this->FacePoints.size());
  const int *points = this->FacePoints.data(), *nexts = this->NextPoints.data();
  const int numberOfEdges = this->NumberEdges();
  const int* const edgeOf = this->FaceEdges.data();
  this->EdgeUses.assign(numberOfEdges, 0);
  this->LastCorners.resize(numberOfEdges);
  for (int i = 0; i < size; ++i)
  {
    ++this->EdgeUses[edgeOf[i]];
    this->LastCorners[edgeOf[i]] = i;
  }
  this->Edges.resize(numberOfEdges);
  bool consistent = true, simple = true;
  this->IsManifold = size > 0;
  for (int e = 0; e < numberOfEdges; ++e)
  {
    const int first = this->FirstCorners[e], last = this->LastCorners[e];
    const int uses = this->EdgeUses[e];
    Edge& edge = this->Edges[e];
    edge.Points[0] = points[first];
    edge.Points[1] = nexts[first];
    edge.Faces[0] = this->CornerFaces[first];
    edge.Faces[1] = uses > 1 ? this->CornerFaces[last] : -1;
    edge.Uses = uses;
    edge.Consistent = uses > 1 && points[last] == nexts[first];
    consistent &= edge.Consistent;
    simple &= uses <= 2;
    this->IsManifold &= uses == 2;
  }
  if (!simple)
  {
    this->FindSecondFaces();
  }
  this->IsClosed = size > 0 && (this->IsManifold ? consistent : this->IsBalanced());
}

//------------------------------------------------------------------------------
// Of edges with more than two faces, which the last one was taken for the second of.
void CellTopology::FindSecondFaces()
{
  for (int i = static_cast<int>(this->FacePoints.size()) - 1; i >= 0; --i)
  {
    Edge& edge = this->Edges[this->FaceEdges[i]];
    if (edge.Uses > 2 && i > this->FirstCorners[this->FaceEdges[i]])
    {
      edge.Faces[1] = this->CornerFaces[i];
      edge.Consistent = edge.Points[0] == this->NextPoints[i];
    }
  }
}

//------------------------------------------------------------------------------
// Whether every edge is traversed equally often in both directions. Only for the rare non-manifold
// cell.
bool CellTopology::IsBalanced() const
{
  std::vector<int> balance(this->Edges.size(), 0);
  for (std::size_t i = 0; i < this->FacePoints.size(); ++i)
  {
    const int e = this->FaceEdges[i];
    balance[e] += this->FacePoints[i] == this->Edges[e].Points[0] ? 1 : -1;
  }
  return std::all_of(
    balance.begin(), balance.end(), [](int difference) { return difference == 0; });
}

//------------------------------------------------------------------------------
void CellTopology::FindShells()
{
  if (!this->HasShells)
  {
    this->FindShells(false);
    this->HasShells = true;
  }
}

//------------------------------------------------------------------------------
void CellTopology::FindShells(bool makeConsistent)
{
  const int numberOfFaces = this->GetNumberOfFaces();
  if (this->IsOneShell || this->IsConnectedManifold())
  {
    this->Shells.assign(numberOfFaces, 0);
    this->NumberOfShells = 1;
    return;
  }
  this->Shells.assign(numberOfFaces, -1);
  this->NumberOfShells = 0;
  bool isReversed = false;
  for (int first = 0; first < numberOfFaces; ++first)
  {
    if (this->Shells[first] < 0)
    {
      isReversed |= this->FloodShell(this->NumberOfShells++, first, makeConsistent);
    }
  }
  if (isReversed)
  {
    this->ListCorners();
    this->ListEdges();
  }
  if (this->NumberOfShells > 1 && !this->IsManifold)
  {
    this->JoinOpenShells();
  }
}

//------------------------------------------------------------------------------
// Whether the edges are known, have exactly two faces each, and all faces are connected; only
// called for few faces.
bool CellTopology::IsConnectedManifold() const
{
  const int numberOfFaces = this->GetNumberOfFaces();
  if (!this->HasEdges || !this->IsClosed || !this->IsManifold || numberOfFaces > MaxBits)
  {
    return false;
  }
  std::uint64_t neighbors[MaxBits] = {};
  for (const Edge& edge : this->Edges)
  {
    neighbors[edge.Faces[0]] |= std::uint64_t(1) << edge.Faces[1];
    neighbors[edge.Faces[1]] |= std::uint64_t(1) << edge.Faces[0];
  }
  const std::uint64_t all = ~std::uint64_t(0) >> (MaxBits - numberOfFaces);
  std::uint64_t reached = 1, done = 0;
  while (reached != all && reached != done)
  {
    done = reached;
    for (int f = 0; f < numberOfFaces; ++f)
    {
      reached |= done >> f & 1 ? neighbors[f] : 0;
    }
  }
  return reached == all;
}

//------------------------------------------------------------------------------
// Returns whether a face was reversed.
bool CellTopology::FloodShell(int shell, int first, bool makeConsistent)
{
  bool isReversed = false;
  this->Shells[first] = shell;
  this->Stack.assign(1, first);
  while (!this->Stack.empty())
  {
    const int face = this->Stack.back();
    this->Stack.pop_back();
    for (int i = this->FaceOffsets[face]; i < this->FaceOffsets[face + 1]; ++i)
    {
      const Edge& edge = this->Edges[this->FaceEdges[i]];
      const int other = edge.Faces[0] == face ? edge.Faces[1] : edge.Faces[0];
      if (edge.Uses != 2 || this->Shells[other] >= 0)
      {
        continue;
      }
      if (makeConsistent && edge.Consistent == (this->Reversed[face] != this->Reversed[other]))
      {
        this->ReverseFace(other);
        isReversed = true;
      }
      this->Shells[other] = shell;
      this->Stack.push_back(other);
    }
  }
  return isReversed;
}

//------------------------------------------------------------------------------
// Merges groups of faces that end at an edge with more than two faces. Only for the rare cell.
void CellTopology::JoinOpenShells()
{
  DisjointSets joined(this->NumberOfShells);
  for (int shell = 0; shell < this->NumberOfShells; ++shell)
  {
    joined.Insert(shell);
  }
  struct Use
  {
    int Edge, Shell, Direction;
  };
  std::vector<Use> uses;
  for (std::size_t i = 0; i < this->FacePoints.size(); ++i)
  {
    const int e = this->FaceEdges[i];
    if (this->Edges[e].Uses != 2)
    {
      const bool isForward = this->FacePoints[i] == this->Edges[e].Points[0];
      uses.push_back({ e, this->Shells[this->CornerFaces[i]], isForward ? 1 : -1 });
    }
  }
  std::sort(uses.begin(), uses.end(), [](const Use& a, const Use& b)
    { return std::pair<int, int>(a.Edge, a.Shell) < std::pair<int, int>(b.Edge, b.Shell); });
  int open = -1, edge = -1; // an open shell at the edge
  for (std::size_t i = 0, end = 0; i < uses.size(); i = end)
  {
    int balance = 0;
    for (; end < uses.size() && uses[end].Edge == uses[i].Edge && uses[end].Shell == uses[i].Shell;
      ++end)
    {
      balance += uses[end].Direction;
    }
    open = uses[i].Edge == edge ? open : -1;
    edge = uses[i].Edge;
    if (balance != 0)
    {
      joined.Join(uses[i].Shell, open >= 0 ? open : uses[i].Shell);
      open = uses[i].Shell;
    }
  }
  std::vector<int> numbers(this->NumberOfShells, -1);
  this->NumberOfShells = 0;
  for (int& shell : this->Shells)
  {
    int& number = numbers[joined.Find(shell)];
    number = number < 0 ? this->NumberOfShells++ : number;
    shell = number;
  }
}

//------------------------------------------------------------------------------
void CellTopology::ReverseFace(int face)
{
  const auto begin = this->FaceOffsets[face], end = this->FaceOffsets[face + 1];
  std::reverse(this->FacePoints.begin() + begin, this->FacePoints.begin() + end);
  if (this->HasEdges)
  {
    // The last edge joins the last point with the first one also in reverse order.
    std::reverse(this->FaceEdges.begin() + begin, this->FaceEdges.begin() + end - 1);
  }
  this->Reversed[face] ^= 1;
  this->IsAsAdded = this->KnowsVertexFigures = false;
}

//------------------------------------------------------------------------------
int CellTopology::GetNumberOfReversedFaces() const
{
  return static_cast<int>(std::count(this->Reversed.begin(), this->Reversed.end(), 1));
}

//------------------------------------------------------------------------------
void CellTopology::ReverseShells(const std::vector<unsigned char>& areReversed)
{
  for (int f = 0; f < this->GetNumberOfFaces(); ++f)
  {
    if (areReversed[this->Shells[f]])
    {
      this->ReverseFace(f);
    }
  }
  if (!this->HasEdges)
  {
    this->ListCorners();
    return;
  }
  for (Edge& edge : this->Edges)
  {
    if (areReversed[this->Shells[edge.Faces[0]]])
    {
      std::swap(edge.Points[0], edge.Points[1]);
    }
  }
}

//------------------------------------------------------------------------------
// If two faces traverse every edge in opposite directions, the next corner at a point is at the end
// of its edge in the other face. Otherwise the faces at the points do not form cycles, except for a
// cell without faces.
void CellTopology::MakeVertexFigures()
{
  if (this->KnowsVertexFigures)
  {
    return;
  }
  this->KnowsVertexFigures = true;
  this->HasVertexFigures = this->FacePoints.empty() || (this->IsClosed && this->IsManifold);
  if (!this->HasVertexFigures)
  {
    return;
  }
  const int size = static_cast<int>(this->FacePoints.size());
  this->Twins.assign(this->Edges.size(), 0);
  this->LastCornersOfPoints.resize(this->NumberOfPoints);
  this->CornerCounts.assign(this->NumberOfPoints, 0);
  const int *points = this->FacePoints.data(), *edges = this->FaceEdges.data(),
            *faces = this->CornerFaces.data(), *offsets = this->FaceOffsets.data();
  int *const twins = this->Twins.data(), *const counts = this->CornerCounts.data();
  for (int i = 0; i < size; ++i)
  {
    twins[edges[i]] += i;
    this->LastCornersOfPoints[points[i]] = i;
    ++counts[points[i]];
  }
  this->Spokes.resize(size);
  this->SpokeOffsets.resize(this->NumberOfPoints + 1);
  Spoke* to = this->Spokes.data();
  this->SpokeOffsets[0] = 0;
  for (int point = 0; point < this->NumberOfPoints; ++point)
  {
    const int first = this->LastCornersOfPoints[point], count = counts[point];
    int corner = first, steps = 0;
    while (steps < count && (steps == 0 || corner != first))
    {
      const int twin = twins[edges[corner]] - corner, face = faces[twin];
      *to++ = { edges[corner], face };
      corner = twin + 1 < offsets[face + 1] ? twin + 1 : offsets[face];
      ++steps;
    }
    this->HasVertexFigures &= steps == count && (count == 0 || corner == first);
    this->SpokeOffsets[point + 1] = static_cast<int>(to - this->Spokes.data());
  }
  this->Spokes.resize(to - this->Spokes.data());
}

//------------------------------------------------------------------------------
// Loops over consecutive faces of the same size are predicted by the processor.
void CellTopology::FindFacePairs()
{
  if (this->HasFacePairs)
  {
    return;
  }
  this->HasFacePairs = true;
  const int numberOfFaces = this->GetNumberOfFaces();
  this->FirstFaces.resize(MaxBits, -1);
  this->NextFaces.resize(numberOfFaces);
  this->FacePairs.resize(numberOfFaces);
  FacePair* to = this->FacePairs.data();
  std::uint64_t sizes = 0;
  for (int f = 0; f < numberOfFaces; ++f)
  {
    const int size = this->GetFaceSize(f);
    if (size >= MaxBits)
    {
      *to++ = { f, f };
      continue;
    }
    this->NextFaces[f] = this->FirstFaces[size];
    this->FirstFaces[size] = f;
    sizes |= std::uint64_t(1) << size;
  }
  for (int size = 0; sizes != 0; ++size, sizes >>= 1)
  {
    int face = this->FirstFaces[size];
    this->FirstFaces[size] = -1;
    while (face >= 0)
    {
      const int next = this->NextFaces[face];
      *to++ = { face, next >= 0 ? next : face };
      face = next >= 0 ? this->NextFaces[next] : -1;
    }
  }
  this->FacePairs.resize(to - this->FacePairs.data());
}
}
