// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Intake/FaceMesh/PrimitiveMatcher.h"

#include "Mesh/CellShape.h"

#include "vtkCellType.h"

#include <algorithm>

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
int CountBits(unsigned int v)
{
  int bits = 0;
  for (; v; v &= v - 1)
  {
    ++bits;
  }
  return bits;
}

//------------------------------------------------------------------------------
bool HasTwoBits(unsigned int v)
{
  const unsigned int rest = v & (v - 1);
  return rest != 0 && (rest & (rest - 1)) == 0;
}

//------------------------------------------------------------------------------
// Sets a node if it is 0, which means unknown; false if it is another one.
bool Agree(std::int32_t& known, std::int32_t node)
{
  known = known == 0 ? node : known;
  return known == node;
}

//------------------------------------------------------------------------------
bool AreDistinct(const std::int32_t* nodes, int count)
{
  bool good = true;
  for (int i = 0; i < count; ++i)
  {
    for (int j = 0; j < i; ++j)
    {
      good &= nodes[i] != nodes[j];
    }
  }
  return good;
}
}

//------------------------------------------------------------------------------
// The connectivity of faces and nodes of a type, from VTK's own tables.
struct Primitive
{
  int NumberOfFaces;
  int NumberOfNodes;
  const CellShape* Shape;
  int Sizes[6];
  unsigned char FacesOf[8]; // set of faces around a node
  int Opposite[6];          // the face of the same size with fewer than two common nodes, or -1
  int Mirror[2];            // swapping these two faces creates the mirror image
  int OppositeFace[4];      // for a tetrahedron, the face opposite to a node, and the reverse
  int OppositeNode[4];

  explicit Primitive(unsigned char type)
    : Shape(&GetCellShape(type))
  {
    this->NumberOfFaces = this->Shape->NumberOfFaces;
    this->NumberOfNodes = this->Shape->NumberOfCorners;
    unsigned char nodes[6] = {};
    std::fill(this->FacesOf, this->FacesOf + 8, static_cast<unsigned char>(0));
    for (int f = 0; f < this->NumberOfFaces; ++f)
    {
      const int begin = this->Shape->FaceOffsets[f], end = this->Shape->FaceOffsets[f + 1];
      this->Sizes[f] = end - begin;
      for (int i = begin; i < end; ++i)
      {
        const int node = this->Shape->FacePoints[i];
        nodes[f] |= static_cast<unsigned char>(1 << node);
        this->FacesOf[node] |= static_cast<unsigned char>(1 << f);
      }
    }
    for (int f = 0; this->NumberOfNodes == 4 && f < 4; ++f)
    {
      const int node = CountBits((15u ^ nodes[f]) - 1u);
      this->OppositeFace[node] = f;
      this->OppositeNode[f] = node;
    }
    // Any two faces of a tetrahedron are suitable.
    this->Mirror[0] = this->NumberOfFaces - 2;
    this->Mirror[1] = this->NumberOfFaces - 1;
    for (int f = 0; f < this->NumberOfFaces; ++f)
    {
      this->Opposite[f] = -1;
      for (int g = 0; g < this->NumberOfFaces; ++g)
      {
        if (g != f && this->Sizes[f] == this->Sizes[g] && CountBits(nodes[f] & nodes[g]) < 2)
        {
          this->Opposite[f] = g;
          this->Mirror[0] = f;
          this->Mirror[1] = g;
        }
      }
    }
  }
};

namespace
{
//------------------------------------------------------------------------------
const Primitive& GetPrimitive(unsigned char type)
{
  static const Primitive tetra(VTK_TETRA), hexahedron(VTK_HEXAHEDRON), wedge(VTK_WEDGE),
    pyramid(VTK_PYRAMID);
  return type == VTK_TETRA   ? tetra
    : type == VTK_HEXAHEDRON ? hexahedron
    : type == VTK_WEDGE      ? wedge
                             : pyramid;
}
}

//------------------------------------------------------------------------------
PrimitiveMatcher::PrimitiveMatcher(const PointSource& points)
  : Points(points)
  , Tetrahedron(&GetPrimitive(VTK_TETRA))
{
}

//------------------------------------------------------------------------------
unsigned char PrimitiveMatcher::Guess(
  std::int32_t faces, std::int32_t triangles, std::int32_t quads)
{
  if (faces == 4 && triangles == 4)
  {
    return VTK_TETRA;
  }
  if (faces == 6 && quads == 6)
  {
    return VTK_HEXAHEDRON;
  }
  if (faces == 5 && triangles + quads == 5)
  {
    return triangles == 2 ? VTK_WEDGE : triangles == 4 ? VTK_PYRAMID : VTK_POLYHEDRON;
  }
  return VTK_POLYHEDRON;
}

//------------------------------------------------------------------------------
unsigned char PrimitiveMatcher::Guess(const IdList* faces, std::int32_t count)
{
  std::int32_t triangles = 0, quads = 0;
  for (std::int32_t f = 0; f < count; ++f)
  {
    triangles += faces[f].Size == 3;
    quads += faces[f].Size == 4;
  }
  return Guess(count, triangles, quads);
}

//------------------------------------------------------------------------------
int PrimitiveMatcher::GetNumberOfNodes(unsigned char type)
{
  return type == VTK_TETRA ? 4 : type == VTK_PYRAMID ? 5 : type == VTK_WEDGE ? 6 : 8;
}

//------------------------------------------------------------------------------
bool PrimitiveMatcher::CollectVertices(int numberOfFaces, int numberOfNodes, const IdList* faces)
{
  int count = 0;
  for (int f = 0; f < numberOfFaces; ++f)
  {
    const IdList face = faces[f];
    const auto bit = static_cast<unsigned char>(1 << f);
    this->Sizes[f] = face.Size;
    this->VerticesOf[f] = 0;
    for (std::int32_t i = 0; i < face.Size; ++i)
    {
      const std::int32_t id = face[i];
      int v = 0;
      while (v < count && this->Vertices[v] != id)
      {
        ++v;
      }
      if (v == count)
      {
        if (count == numberOfNodes)
        {
          return false;
        }
        this->Vertices[count] = id;
        this->FacesOf[count++] = 0;
      }
      if (this->FacesOf[v] & bit)
      {
        return false;
      }
      this->FacesOf[v] |= bit;
      this->VerticesOf[f] |= static_cast<unsigned char>(1 << v);
      this->Corners[f][i] = static_cast<unsigned char>(v);
    }
  }
  return count == numberOfNodes;
}

//------------------------------------------------------------------------------
bool PrimitiveMatcher::FindNodes(const Primitive& primitive)
{
  for (int node = 0; node < primitive.NumberOfNodes; ++node)
  {
    unsigned int wanted = 0;
    for (int f = 0; f < primitive.NumberOfFaces; ++f)
    {
      wanted |= (primitive.FacesOf[node] >> f & 1u) << this->FaceOf[f];
    }
    int v = 0;
    while (v < primitive.NumberOfNodes && this->FacesOf[v] != wanted)
    {
      ++v;
    }
    if (v == primitive.NumberOfNodes)
    {
      return false;
    }
    this->Nodes[node] = this->Vertices[v];
  }
  return true;
}

//------------------------------------------------------------------------------
// Approximate if faces are warped; only its sign matters.
double PrimitiveMatcher::GetVolume(const Primitive& primitive) const
{
  double x[MaxNodes][3];
  const auto load = [&](int numberOfNodes)
  {
    for (int node = 0; node < numberOfNodes; ++node)
    {
      this->Points.Get(this->Nodes[node], x[node]);
    }
    for (int node = numberOfNodes - 1; node >= 0; --node)
    {
      for (int c = 0; c < 3; ++c)
      {
        x[node][c] -= x[0][c];
      }
    }
  };
  const auto determinant = [](const double* a, const double* b, const double* c)
  {
    return a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
      a[2] * (b[0] * c[1] - b[1] * c[0]);
  };
  if (primitive.NumberOfNodes == 4)
  {
    load(4);
    return determinant(x[1], x[2], x[3]);
  }
  load(primitive.NumberOfNodes);
  double volume = 0;
  for (int f = 0; f < primitive.NumberOfFaces; ++f)
  {
    const int* p = primitive.Shape->FacePoints + primitive.Shape->FaceOffsets[f];
    if (primitive.Sizes[f] == 3)
    {
      volume += determinant(x[p[0]], x[p[1]], x[p[2]]);
    }
    else
    {
      // Both triangulations of the quadrilateral, so that its direction does not matter.
      volume += 0.5 *
        (determinant(x[p[0]], x[p[1]], x[p[2]]) + determinant(x[p[0]], x[p[2]], x[p[3]]) +
          determinant(x[p[0]], x[p[1]], x[p[3]]) + determinant(x[p[1]], x[p[2]], x[p[3]]));
    }
  }
  return volume;
}

//------------------------------------------------------------------------------
// Equivalent to the general method, for the most frequent cells: a node is not in the face opposite
// to it.
template <typename IsMirrored>
bool PrimitiveMatcher::MatchTetrahedron(const IdList* faces, IsMirrored&& isMirrored)
{
  // Without branches that depend on the mesh, which would cost more than everything else. First,
  // second and third points of the faces, so that all faces are compared together.
  std::uint32_t a[4], b[4], c[4];
  for (int f = 0; f < 4; ++f)
  {
    a[f] = static_cast<std::uint32_t>(faces[f][0]);
    b[f] = static_cast<std::uint32_t>(faces[f][1]);
    c[f] = static_cast<std::uint32_t>(faces[f][2]);
  }
  std::uint32_t v[4] = { a[0], b[0], c[0], 0 };
  for (const std::uint32_t id : { a[1], b[1], c[1] })
  {
    const bool isNew = (id != v[0]) & (id != v[1]) & (id != v[2]);
    v[3] |= isNew ? id : 0u;
  }
  const bool areDistinct = (v[0] != v[1]) & (v[0] != v[2]) & (v[1] != v[2]) & (v[3] != v[0]) &
    (v[3] != v[1]) & (v[3] != v[2]);
  const std::uint32_t sum = v[0] + v[1] + v[2] + v[3];
  std::uint32_t opposite[4]; // for each face, if it has three of the four points
  std::uint32_t missing[4];  // sets of them
  std::uint32_t wrong = 0;
  for (int f = 0; f < 4; ++f)
  {
    const auto has = [&](std::uint32_t id)
    { return static_cast<std::uint32_t>((a[f] == id) | (b[f] == id) | (c[f] == id)); };
    const std::uint32_t has0 = has(v[0]), has1 = has(v[1]), has2 = has(v[2]), has3 = has(v[3]);
    wrong |= (has0 + has1 + has2 + has3) ^ 3u;
    missing[f] = 15u ^ (has0 | has1 << 1 | has2 << 2 | has3 << 3);
    opposite[f] = sum - a[f] - b[f] - c[f];
  }
  if (!areDistinct || wrong != 0 || (missing[0] | missing[1] | missing[2] | missing[3]) != 15u)
  {
    return false;
  }
  const Primitive& primitive = *this->Tetrahedron;
  for (int node = 0; node < 4; ++node)
  {
    this->Nodes[node] = static_cast<std::int32_t>(opposite[primitive.OppositeFace[node]]);
    this->FaceOf[node] = node;
  }
  const bool turn = isMirrored(primitive);
  const int f = primitive.Mirror[0], g = primitive.Mirror[1];
  this->FaceOf[f] = turn ? g : f;
  this->FaceOf[g] = turn ? f : g;
  std::int32_t &first = this->Nodes[primitive.OppositeNode[f]],
               &second = this->Nodes[primitive.OppositeNode[g]];
  const std::int32_t oldFirst = first, oldSecond = second;
  first = turn ? oldSecond : oldFirst;
  second = turn ? oldFirst : oldSecond;
  return true;
}

//------------------------------------------------------------------------------
template <typename IsMirrored>
bool PrimitiveMatcher::MatchAny(unsigned char type, const IdList* faces, IsMirrored&& isMirrored)
{
  if (type == VTK_TETRA)
  {
    return this->MatchTetrahedron(faces, isMirrored);
  }
  const Primitive& primitive = GetPrimitive(type);
  const int numberOfFaces = primitive.NumberOfFaces;
  if (!this->CollectVertices(numberOfFaces, primitive.NumberOfNodes, faces))
  {
    return false;
  }

  // Each of VTK's faces in turn takes the first remaining face of its size, and its opposite.
  unsigned int taken = 0;
  std::fill(this->FaceOf, this->FaceOf + numberOfFaces, -1);
  for (int f = 0; f < numberOfFaces; ++f)
  {
    if (this->FaceOf[f] >= 0)
    {
      continue;
    }
    int first = 0;
    while (
      first < numberOfFaces && ((taken >> first & 1u) || this->Sizes[first] != primitive.Sizes[f]))
    {
      ++first;
    }
    if (first == numberOfFaces)
    {
      return false;
    }
    this->FaceOf[f] = first;
    taken |= 1u << first;
    if (primitive.Opposite[f] >= 0)
    {
      int opposite = 0;
      while (opposite < numberOfFaces &&
        ((taken >> opposite & 1u) || this->Sizes[opposite] != primitive.Sizes[f] ||
          CountBits(this->VerticesOf[first] & this->VerticesOf[opposite]) > 1))
      {
        ++opposite;
      }
      if (opposite == numberOfFaces)
      {
        return false;
      }
      this->FaceOf[primitive.Opposite[f]] = opposite;
      taken |= 1u << opposite;
    }
  }
  if (!this->FindNodes(primitive))
  {
    return false;
  }

  // Consecutive vertices of a quadrilateral share an edge, which has two faces.
  for (int f = 0; f < numberOfFaces; ++f)
  {
    const unsigned char* corner = this->Corners[f];
    if (this->Sizes[f] == 4 &&
      !(HasTwoBits(this->FacesOf[corner[0]] & this->FacesOf[corner[1]]) &&
        HasTwoBits(this->FacesOf[corner[1]] & this->FacesOf[corner[2]])))
    {
      return false;
    }
  }

  if (isMirrored(primitive))
  {
    std::swap(this->FaceOf[primitive.Mirror[0]], this->FaceOf[primitive.Mirror[1]]);
    return this->FindNodes(primitive);
  }
  return true;
}

//------------------------------------------------------------------------------
bool PrimitiveMatcher::Match(unsigned char type, const IdList* faces)
{
  return this->MatchAny(
    type, faces, [this](const Primitive& primitive) { return this->GetVolume(primitive) < 0; });
}

//------------------------------------------------------------------------------
bool PrimitiveMatcher::Match(
  unsigned char type, const IdList* faces, const FaceDirection* directions)
{
  if (type == VTK_HEXAHEDRON && this->MatchHexahedron(faces, directions))
  {
    return true;
  }
  return this->MatchAny(type, faces,
    [&](const Primitive& primitive) { return this->RunsAgainst(primitive, faces, directions); });
}

//------------------------------------------------------------------------------
// Shortcut for the usual case of a frequent type: six consistently oriented quadrilaterals with
// eight points.
bool PrimitiveMatcher::MatchHexahedron(const IdList* faces, const FaceDirection* directions)
{
  // VTK's faces by the bits of the state: at the edges of the bottom, the bottom itself, and the
  // top.
  constexpr int FaceOfBit[6] = { 2, 1, 3, 0, 4, 5 };
  std::uint32_t state = 0;
  bool good = true;
  for (int f = 0; f < 6 && good; ++f)
  {
    const bool turn = directions[f] == FaceDirection::Outward;
    const std::int32_t corners[4] = { faces[f][0] + 1, faces[f][turn ? 3 : 1] + 1, faces[f][2] + 1,
      faces[f][turn ? 1 : 3] + 1 };
    const std::uint32_t before = state;
    good = AddToHexahedron(this->Nodes, state, corners);
    for (int bit = 0; bit < 6; ++bit)
    {
      if ((state & ~before) >> bit & 1)
      {
        this->FaceOf[FaceOfBit[bit]] = f;
      }
    }
  }
  for (std::int32_t& node : this->Nodes)
  {
    --node;
  }
  return good && state == Complete;
}

//------------------------------------------------------------------------------
// The first face is the bottom, nodes 0 to 3; the bits of the state are the sides at its edges, the
// bottom and the top.
bool PrimitiveMatcher::AddToHexahedron(
  std::int32_t* nodes, std::uint32_t& state, const std::int32_t* face)
{
  constexpr std::uint32_t Sides = 0x0f, Bottom = 0x10, Top = 0x20;
  std::int32_t* const high = nodes + 4;
  if (state == 0)
  {
    std::copy(face, face + 4, nodes);
    std::fill(high, high + 4, 0);
    state = Bottom;
    return true;
  }
  int low[4]; // index of each node in the bottom, or -1
  int first = -1;
  for (int i = 0; i < 4; ++i)
  {
    const std::int32_t id = face[i];
    low[i] = id == nodes[0] ? 0 : id == nodes[1] ? 1 : id == nodes[2] ? 2 : id == nodes[3] ? 3 : -1;
  }
  for (int i = 0; i < 4; ++i)
  {
    first =
      low[i] >= 0 && low[i] == ((low[(i + 1) & 3] + 1) & 3) && low[(i + 1) & 3] >= 0 ? i : first;
  }
  bool good = true;
  if (first >= 0)
  {
    // A side runs along its edge of the bottom in the opposite direction.
    const int a = low[(first + 1) & 3], b = low[first];
    const std::int32_t overA = face[(first + 2) & 3], overB = face[(first + 3) & 3];
    const auto bit = static_cast<std::uint32_t>(1 << a);
    good = low[(first + 2) & 3] < 0 && low[(first + 3) & 3] < 0 && !(state & bit);
    if (!(state & Sides) && (state & Top))
    {
      std::int32_t* const start = std::find(high, high + 4, overA);
      std::rotate(high, start == high + 4 ? high : start, high + 4);
      std::rotate(high, high + (4 - a), high + 4);
    }
    good = good && Agree(high[a], overA) && Agree(high[b], overB);
    state |= bit;
  }
  else
  {
    const std::int32_t top[4] = { face[0], face[3], face[2], face[1] };
    int turn = 0;
    for (int i = 0; i < 4; ++i)
    {
      for (int j = 0; j < 4; ++j)
      {
        turn = high[i] == top[j] ? (j - i) & 3 : turn;
      }
    }
    good = !(state & Top);
    for (int i = 0; i < 4; ++i)
    {
      good = good && low[i] < 0 && Agree(high[i], top[(i + turn) & 3]);
    }
    state |= Top;
  }
  if (state == (Sides | Bottom | Top))
  {
    good = good && AreDistinct(nodes, 8);
    state = Complete;
  }
  return good;
}

//------------------------------------------------------------------------------
// Whether VTK's first face of the nodes found has the opposite orientation of the given face.
bool PrimitiveMatcher::RunsAgainst(
  const Primitive& primitive, const IdList* faces, const FaceDirection* directions) const
{
  const int g = this->FaceOf[0];
  const int* p = primitive.Shape->FacePoints;
  const std::int32_t a = this->Nodes[p[0]], b = this->Nodes[p[1]];
  const IdList& face = faces[g];
  std::int32_t i = 0;
  while (i + 1 < face.Size && face[i] != a)
  {
    ++i;
  }
  const bool runsAlong = face[i + 1 < face.Size ? i + 1 : 0] == b;
  return runsAlong != (directions[g] == FaceDirection::Outward);
}
}
