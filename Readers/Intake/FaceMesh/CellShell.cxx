// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Intake/FaceMesh/CellShell.h"

#include "Base/Hash.h"
#include "Geometry/ClosedShell.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

namespace camaron
{
namespace
{
// A smaller volume, relative to its bound, is rounding.
constexpr double NoVolume = 1e-12;

//------------------------------------------------------------------------------
// Shift that reduces a 64-bit hash to an index into a table at least twice as large as its
// contents.
int GetTableShift(std::size_t content)
{
  int shift = 64 - 4;
  while ((std::size_t(1) << (64 - shift)) < 2 * content)
  {
    --shift;
  }
  return shift;
}

//------------------------------------------------------------------------------
// Of the scalar product of two vectors.
double GetBound(double x, double y, double z, const double other[3])
{
  return (std::fabs(x) + std::fabs(y) + std::fabs(z)) *
    (std::fabs(other[0]) + std::fabs(other[1]) + std::fabs(other[2]));
}

//------------------------------------------------------------------------------
std::uint64_t Hash(std::uint64_t key)
{
  return key * HashFactor;
}
}

//------------------------------------------------------------------------------
template <typename GetId>
void CellShell::Load(const IdList* faces, std::int32_t count, GetId&& getId)
{
  this->Faces.resize(count);
  this->Begins.resize(std::size_t(count) + 1);
  std::int32_t filled = 0, corners = 0;
  for (std::int32_t f = 0; f < count; ++f)
  {
    this->Faces[filled] = getId(f);
    this->Begins[filled] = corners;
    filled += faces[f].Size > 0;
    corners += faces[f].Size;
  }
  this->Begins[filled] = corners;
  this->Faces.resize(filled);
  this->Begins.resize(std::size_t(filled) + 1);
  this->NumberPoints(faces, count);
}

//------------------------------------------------------------------------------
void CellShell::Load(const IdList& cell, const IdList* faces)
{
  this->Load(faces, cell.Size, [&cell](std::int32_t f) { return cell[f]; });
}

//------------------------------------------------------------------------------
void CellShell::Load(const IdList* faces, std::int32_t count)
{
  this->Load(faces, count, [](std::int32_t f) { return f; });
}

//------------------------------------------------------------------------------
// Converts point ids to positions in the list of distinct points.
void CellShell::NumberPoints(const IdList* faces, std::int32_t count)
{
  const std::int32_t numberOfCorners = this->Begins.back();
  this->Turned.assign(this->Faces.size(), 0);
  this->Corners.resize(numberOfCorners);
  this->Ids.resize(numberOfCorners);
  const int shift = GetTableShift(numberOfCorners);
  this->Table.assign(std::size_t(1) << (64 - shift), -1);
  const std::size_t mask = this->Table.size() - 1;
  std::int32_t* const table = this->Table.data();
  std::int32_t* const ids = this->Ids.data();
  std::int32_t* corner = this->Corners.data();
  std::int32_t numberOfIds = 0;
  for (std::int32_t f = 0; f < count; ++f)
  {
    const IdList face = faces[f];
    for (std::int32_t i = 0; i < face.Size; ++i)
    {
      const std::int32_t id = face[i];
      std::size_t slot = Hash(static_cast<std::uint32_t>(id)) >> shift;
      while (table[slot] >= 0 && ids[table[slot]] != id)
      {
        slot = (slot + 1) & mask;
      }
      if (table[slot] < 0)
      {
        table[slot] = numberOfIds;
        ids[numberOfIds++] = id;
      }
      *corner++ = table[slot];
    }
  }
  this->Ids.resize(numberOfIds);
}

//------------------------------------------------------------------------------
// Finds the other use of every edge; false if an edge is used once or more than twice.
// findOrAdd(corner, a, b) returns the corner where the edge between a and b first occurred, or -1.
template <typename FindOrAdd>
bool CellShell::PairEdges(FindOrAdd&& findOrAdd)
{
  std::int32_t open = 0;
  for (std::int32_t face = 0; face < this->GetNumberOfFaces(); ++face)
  {
    const std::int32_t begin = this->Begins[face], end = this->Begins[face + 1];
    std::int32_t a = this->Corners[begin];
    for (std::int32_t corner = begin; corner < end; ++corner)
    {
      const std::int32_t b = this->Corners[corner + 1 < end ? corner + 1 : begin];
      this->Owners[corner] = face;
      if (a == b)
      {
        this->Mates[corner] = corner; // a point repeated in a row has no edge
        continue;
      }
      const std::int32_t other = findOrAdd(corner, std::min(a, b), std::max(a, b));
      if (other < 0)
      {
        ++open;
      }
      else if (this->Mates[other] >= 0)
      {
        return false;
      }
      else
      {
        this->Mates[other] = corner;
        this->Mates[corner] = other;
        --open;
      }
      a = b;
    }
  }
  return open == 0;
}

//------------------------------------------------------------------------------
bool CellShell::PairEdges()
{
  const std::size_t numberOfCorners = this->Corners.size();
  this->Mates.assign(numberOfCorners, -1);
  this->Owners.resize(numberOfCorners);
  if (this->Ids.size() <= MaxSmall && numberOfCorners < UINT8_MAX)
  {
    std::fill(
      this->Matrix, this->Matrix + MaxSmall * this->Ids.size(), static_cast<unsigned char>(0));
    return this->PairEdges(
      [this](std::int32_t corner, std::int32_t a, std::int32_t b)
      {
        unsigned char& entry = this->Matrix[MaxSmall * a + b];
        const std::int32_t other = entry - 1;
        entry = other < 0 ? static_cast<unsigned char>(corner + 1) : entry;
        return other;
      });
  }
  const int shift = GetTableShift(numberOfCorners);
  this->Table.assign(std::size_t(1) << (64 - shift), -1);
  const std::size_t mask = this->Table.size() - 1;
  return this->PairEdges(
    [&](std::int32_t corner, std::int32_t a, std::int32_t b)
    {
      std::size_t slot =
        Hash(static_cast<std::uint64_t>(a) << 32 | static_cast<std::uint32_t>(b)) >> shift;
      std::int32_t other = this->Table[slot];
      for (; other >= 0; slot = (slot + 1) & mask, other = this->Table[slot])
      {
        const std::int32_t owner = this->Owners[other];
        const std::int32_t next =
          other + 1 < this->Begins[owner + 1] ? other + 1 : this->Begins[owner];
        const std::int32_t c = this->Corners[other], d = this->Corners[next];
        if (std::min(c, d) == a && std::max(c, d) == b)
        {
          return other;
        }
      }
      this->Table[slot] = corner;
      return other;
    });
}

//------------------------------------------------------------------------------
// Six times the volume between the face, triangulated from the mean of its points, and the first
// point of the cell; positive if the stored face points away from it. Adds to @a bound what it
// cannot exceed.
double CellShell::GetVolumeOfFace(std::int32_t face, double& bound) const
{
  const std::int32_t begin = this->Begins[face], end = this->Begins[face + 1];
  const double* p = &this->Places[3 * std::size_t(this->Corners[end - 1])];
  double sum[3] = { 0, 0, 0 }, area[3] = { 0, 0, 0 };
  for (std::int32_t corner = begin; corner < end; ++corner)
  {
    const double* const q = &this->Places[3 * std::size_t(this->Corners[corner])];
    area[0] += p[1] * q[2] - p[2] * q[1];
    area[1] += p[2] * q[0] - p[0] * q[2];
    area[2] += p[0] * q[1] - p[1] * q[0];
    std::transform(sum, sum + 3, q, sum, std::plus<>());
    p = q;
  }
  const double size = end - begin;
  const double x = sum[0] / size, y = sum[1] / size, z = sum[2] / size;
  bound += GetBound(x, y, z, area);
  return x * area[0] + y * area[1] + z * area[2];
}

//------------------------------------------------------------------------------
void CellShell::LoadPlaces()
{
  this->Places.resize(3 * this->Ids.size());
  double origin[3];
  this->Points.Get(this->Ids[0], origin);
  for (std::size_t i = 0; i < this->Ids.size(); ++i)
  {
    double* x = &this->Places[3 * i];
    this->Points.Get(this->Ids[i], x);
    for (int c = 0; c < 3; ++c)
    {
      x[c] -= origin[c];
    }
  }
}

//------------------------------------------------------------------------------
// Shortcut for the usual case: if all faces, oriented away from the mean of the points, are
// consistent and form one sphere, this is the result of the general method. Returns false
// otherwise.
bool CellShell::TurnFromMean()
{
  const std::size_t numberOfPoints = this->Ids.size();
  if (numberOfPoints > MaxSmall)
  {
    return false;
  }
  double mean[3] = { 0, 0, 0 };
  for (std::size_t i = 0; i < numberOfPoints; ++i)
  {
    for (std::size_t c = 0; c < 3; ++c)
    {
      mean[c] += this->Places[3 * i + c];
    }
  }
  for (double& x : mean)
  {
    x /= static_cast<double>(numberOfPoints);
  }
  std::fill_n(this->Next, numberOfPoints, std::uint64_t(0));
  const double* const places = this->Places.data();
  const std::int32_t* const corners = this->Corners.data();
  std::uint64_t isTwice = 0;
  double sum = 0, bound = 0; // of the volumes of the faces
  for (std::int32_t face = 0; face < this->GetNumberOfFaces(); ++face)
  {
    const std::int32_t begin = this->Begins[face], end = this->Begins[face + 1];
    double area[3] = { 0, 0, 0 }, x = 0, y = 0, z = 0; // the mean of its points, from that of all
    const double* p = places + 3 * std::size_t(corners[end - 1]);
    for (std::int32_t corner = begin; corner < end; ++corner)
    {
      const double* const q = places + 3 * std::size_t(corners[corner]);
      area[0] += p[1] * q[2] - p[2] * q[1];
      area[1] += p[2] * q[0] - p[0] * q[2];
      area[2] += p[0] * q[1] - p[1] * q[0];
      x += q[0];
      y += q[1];
      z += q[2];
      p = q;
    }
    const double size = end - begin;
    x = x / size - mean[0];
    y = y / size - mean[1];
    z = z / size - mean[2];
    const double volume = x * area[0] + y * area[1] + z * area[2];
    if (!(volume < 0 || volume > 0))
    {
      return false;
    }
    sum += std::fabs(volume);
    bound += GetBound(x, y, z, area);
    const bool turned = volume < 0;
    this->Turned[face] = turned;
    std::int32_t last = corners[end - 1];
    for (std::int32_t corner = begin; corner < end; ++corner)
    {
      const std::int32_t now = corners[corner];
      std::uint64_t& next = this->Next[turned ? now : last];
      const std::uint64_t bit = std::uint64_t(1) << (turned ? last : now);
      isTwice |= next & bit;
      next |= bit;
      last = now;
    }
  }
  // No edge is traversed twice in one direction, so each must be traversed in both.
  std::uint64_t isConsistent = isTwice == 0;
  for (std::int32_t face = 0; face < this->GetNumberOfFaces(); ++face)
  {
    const std::int32_t begin = this->Begins[face], end = this->Begins[face + 1];
    std::int32_t last = corners[end - 1];
    for (std::int32_t corner = begin; corner < end; ++corner)
    {
      const std::int32_t now = corners[corner];
      isConsistent &= (this->Next[last] >> now) & (this->Next[now] >> last) & (last != now);
      last = now;
    }
  }
  return isConsistent != 0 && sum > NoVolume * bound && this->IsOneSphere();
}

//------------------------------------------------------------------------------
// For a shell that is completely visible from the mean. Euler's formula distinguishes one sphere
// from several, unless these share points, which then have six or more edges; also returns false in
// that case.
bool CellShell::IsOneSphere() const
{
  const std::size_t numberOfPoints = this->Ids.size();
  std::uint64_t further = 0;
  for (std::size_t point = 0; point < numberOfPoints; ++point)
  {
    std::uint64_t edges = this->Next[point];
    for (int edge = 0; edge < 5; ++edge)
    {
      edges &= edges - 1; // without the lowest bit
    }
    further |= edges;
  }
  const std::int32_t numberOfEdges = this->GetNumberOfCorners() / 2;
  return further == 0 &&
    static_cast<std::int32_t>(numberOfPoints) - numberOfEdges + this->GetNumberOfFaces() == 2;
}

//------------------------------------------------------------------------------
// Whether the part of the shell that begins at this position of Stack is the wrong one of the two
// orientations of a part without volume. It is decided by the first face in which some point occurs
// once between two different points: the lowest such id is followed by the lower of the two.
bool CellShell::IsAgainstIds(std::size_t begin)
{
  std::int32_t first = this->GetNumberOfFaces();
  bool isAgainst = false;
  for (std::size_t i = begin; i < this->Stack.size(); ++i)
  {
    const std::int32_t face = this->Stack[i];
    const std::int32_t size = this->GetFaceSize(face);
    const auto getId = [&](std::int32_t at)
    { return this->Ids[this->Corners[this->Begins[face] + at]]; };
    this->Order.resize(face < first ? size : 0);
    std::iota(this->Order.begin(), this->Order.end(), 0);
    std::sort(this->Order.begin(), this->Order.end(),
      [&](std::int32_t a, std::int32_t b) { return getId(a) < getId(b); });
    for (std::size_t k = 0; k < this->Order.size() && face < first; ++k)
    {
      const std::int32_t at = this->Order[k], id = getId(at);
      const bool isOnce = (k == 0 || getId(this->Order[k - 1]) != id) &&
        (k + 1 == this->Order.size() || getId(this->Order[k + 1]) != id);
      const std::int32_t next = getId(at + 1 < size ? at + 1 : 0);
      const std::int32_t last = getId(at > 0 ? at - 1 : size - 1);
      if (isOnce && next != last)
      {
        first = face;
        isAgainst = (next > last) != (this->Turned[face] != 0);
      }
    }
  }
  return isAgainst;
}

//------------------------------------------------------------------------------
bool CellShell::TurnConsistently()
{
  const std::int32_t numberOfFaces = this->GetNumberOfFaces();
  this->Seen.assign(numberOfFaces, 0);
  this->Stack.clear();
  this->Parts.clear();
  for (std::int32_t start = 0; start < numberOfFaces; ++start)
  {
    if (this->Seen[start])
    {
      continue;
    }
    this->Seen[start] = 1;
    const std::size_t first = this->Stack.size();
    this->Parts.push_back(first);
    this->Stack.push_back(start);
    double volume = 0, bound = 0;
    for (std::size_t next = first; next < this->Stack.size(); ++next)
    {
      const std::int32_t face = this->Stack[next];
      const double part = this->GetVolumeOfFace(face, bound);
      volume += this->Turned[face] ? -part : part;
      for (std::int32_t corner = this->Begins[face]; corner < this->Begins[face + 1]; ++corner)
      {
        const std::int32_t mate = this->Mates[corner];
        if (mate == corner)
        {
          continue;
        }
        const std::int32_t neighbor = this->Owners[mate];
        const bool sameDirection = this->Corners[corner] == this->Corners[mate];
        const auto turned = static_cast<unsigned char>(this->Turned[face] ^ sameDirection);
        if (!this->Seen[neighbor])
        {
          this->Seen[neighbor] = 1;
          this->Turned[neighbor] = turned;
          this->Stack.push_back(neighbor);
        }
        else if (this->Turned[neighbor] != turned)
        {
          return false;
        }
      }
    }
    const bool isFlat = !(std::fabs(volume) > NoVolume * bound);
    if (isFlat ? this->IsAgainstIds(first) : volume < 0)
    {
      for (std::size_t i = first; i < this->Stack.size(); ++i)
      {
        this->Turned[this->Stack[i]] ^= 1;
      }
    }
  }
  this->TurnVoids();
  return true;
}

//------------------------------------------------------------------------------
// Parts of the shell that are inside others.
void CellShell::TurnVoids()
{
  if (this->Parts.size() < 2)
  {
    return;
  }
  this->Parts.push_back(this->Stack.size());
  std::vector<ClosedShell> shells(this->Parts.size() - 1);
  for (std::size_t part = 0; part < shells.size(); ++part)
  {
    for (std::size_t i = this->Parts[part]; i < this->Parts[part + 1]; ++i)
    {
      this->AddTriangles(this->Stack[i], shells[part]);
    }
  }
  const std::vector<unsigned char> areVoids = FindVoids(shells);
  for (std::size_t part = 0; part < shells.size(); ++part)
  {
    for (std::size_t i = this->Parts[part]; i < this->Parts[part + 1]; ++i)
    {
      this->Turned[this->Stack[i]] ^= areVoids[part];
    }
  }
}

//------------------------------------------------------------------------------
// The triangles between the edges of a face and the mean of its points.
void CellShell::AddTriangles(std::int32_t face, ClosedShell& shell) const
{
  std::vector<Vector> ring;
  Vector sum;
  for (std::int32_t corner = this->Begins[face]; corner < this->Begins[face + 1]; ++corner)
  {
    const double* const x = &this->Places[3 * std::size_t(this->Corners[corner])];
    ring.push_back({ x[0], x[1], x[2] });
    sum += ring.back();
  }
  if (this->Turned[face])
  {
    std::reverse(ring.begin(), ring.end());
  }
  const Vector mean = (1.0 / static_cast<double>(ring.size())) * sum;
  Vector last = ring.back();
  for (const Vector& next : ring)
  {
    shell.Add(mean, last, next);
    last = next;
  }
}

//------------------------------------------------------------------------------
bool CellShell::Orient()
{
  this->LoadPlaces();
  if (this->TurnFromMean())
  {
    return true;
  }
  std::fill(this->Turned.begin(), this->Turned.end(), static_cast<unsigned char>(0));
  if (this->PairEdges() && this->TurnConsistently())
  {
    return true;
  }
  std::fill(this->Turned.begin(), this->Turned.end(), static_cast<unsigned char>(0));
  return false;
}
}
