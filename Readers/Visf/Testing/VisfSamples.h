// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file VisfSamples.h
 * @brief Visf files for the tests, created by a small encoder of their own, and functions to read
 * and compare them.
 */
#ifndef camaron_VisfSamples_h
#define camaron_VisfSamples_h

#include "FormatTesting.h"
#include "vtkVisfReader.h"

#include "vtkCellType.h"

#include <array>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>
#include <string>
#include <vector>

namespace camaron
{
namespace testing
{
using Lists = std::vector<std::vector<std::int32_t>>;

struct VisfMesh
{
  int Type = 2;
  std::vector<std::array<float, 3>> Points;
  Lists Polygons;
  Lists Polyhedra;
  Lists Neighbors; // empty: flag 0
};

enum class Encoding
{
  Ascii,
  Web, // ASCII without flag
  Little03,
  Big03,
  Little02,
  Big02,
  Little01,
  Big01
};
constexpr Encoding Encodings[] = { Encoding::Ascii, Encoding::Web, Encoding::Little03,
  Encoding::Big03, Encoding::Little02, Encoding::Big02, Encoding::Little01, Encoding::Big01 };

inline bool IsText(Encoding encoding)
{
  return encoding == Encoding::Ascii || encoding == Encoding::Web;
}

//------------------------------------------------------------------------------
class Encoder
{
public:
  explicit Encoder(Encoding encoding)
    : Kind(encoding)
  {
    const bool first = encoding != Encoding::Little01 && encoding != Encoding::Big01;
    this->Big =
      encoding == Encoding::Big03 || encoding == Encoding::Big02 || encoding == Encoding::Big01;
    const bool raw = encoding == Encoding::Little02 || encoding == Encoding::Big02;
    if (IsText(encoding))
    {
      this->Bytes = "2 ";
    }
    else if (first)
    {
      this->Bytes = std::string(1, static_cast<char>((this->Big ? 0 : 1) + (raw ? 0 : '0')));
    }
  }
  void Word(std::uint32_t word)
  {
    for (int i = 0; i < 4; ++i)
    {
      this->Bytes += static_cast<char>(word >> 8 * (this->Big ? 3 - i : i) & 255);
    }
  }
  void Put(std::int32_t value)
  {
    IsText(this->Kind) ? void(this->Bytes += std::to_string(value) + " ")
                       : this->Word(static_cast<std::uint32_t>(value));
  }
  void Put(float value)
  {
    if (IsText(this->Kind))
    {
      char text[40];
      std::snprintf(text, sizeof(text), "%.9g ", static_cast<double>(value));
      this->Bytes += text;
      return;
    }
    std::uint32_t word;
    std::memcpy(&word, &value, 4);
    this->Word(word);
  }
  void EndLine()
  {
    if (IsText(this->Kind))
    {
      this->Bytes += "\n";
    }
  }
  void Put(const Lists& lists)
  {
    for (const auto& list : lists)
    {
      this->Put(static_cast<std::int32_t>(list.size()));
      for (const std::int32_t id : list)
      {
        this->Put(id);
      }
      this->EndLine();
    }
  }
  void PutCount(std::size_t count)
  {
    this->Put(static_cast<std::int32_t>(count));
    this->EndLine();
  }

  std::string Bytes;

private:
  Encoding Kind;
  bool Big = false;
};

//------------------------------------------------------------------------------
inline std::string Encode(const VisfMesh& mesh, Encoding encoding)
{
  Encoder out(encoding);
  out.PutCount(mesh.Type);
  out.PutCount(mesh.Points.size());
  for (const auto& point : mesh.Points)
  {
    out.Put(point[0]), out.Put(point[1]), out.Put(point[2]);
    out.EndLine();
  }
  if (!mesh.Polygons.empty())
  {
    out.PutCount(mesh.Polygons.size());
    out.Put(mesh.Polygons);
    if (encoding != Encoding::Web)
    {
      out.PutCount(mesh.Neighbors.empty() ? 0 : 1);
      out.Put(mesh.Neighbors);
    }
    if (!mesh.Polyhedra.empty() || encoding == Encoding::Web)
    {
      out.PutCount(mesh.Polyhedra.size());
      out.Put(mesh.Polyhedra);
    }
  }
  return out.Bytes;
}

//------------------------------------------------------------------------------
inline VisfMesh MakeTetrahedron()
{
  VisfMesh mesh;
  mesh.Points = { { { 0, 0, 0 } }, { { 1, 0, 0 } }, { { 0, 1, 0 } }, { { 0, 0, 1 } } };
  mesh.Polygons = { { 0, 1, 3 }, { 1, 2, 3 }, { 2, 0, 3 }, { 0, 2, 1 } };
  mesh.Polyhedra = { { 0, 1, 2, 3 } };
  return mesh;
}

//------------------------------------------------------------------------------
/// A row of unit cubes along x, the first @a wedges of them split into two wedges, with common
/// faces.
inline VisfMesh MakeBar(int cubes, int wedges = 0)
{
  VisfMesh mesh;
  for (int i = 0; i <= cubes; ++i)
  {
    const auto x = static_cast<float>(i);
    mesh.Points.push_back({ { x, 0, 0 } });
    mesh.Points.push_back({ { x, 1, 0 } });
    mesh.Points.push_back({ { x, 1, 1 } });
    mesh.Points.push_back({ { x, 0, 1 } });
  }
  const auto add = [&mesh](std::vector<std::int32_t> polygon)
  {
    mesh.Polygons.push_back(std::move(polygon));
    return static_cast<std::int32_t>(mesh.Polygons.size() - 1);
  };
  std::int32_t left = -1;
  std::array<std::int32_t, 2> halves = { { -1, -1 } };
  for (std::int32_t i = 0; i < cubes; ++i)
  {
    const std::int32_t a = 4 * i, b = a + 4;
    if (i < wedges)
    {
      if (i == 0)
      {
        halves = { { add({ a, a + 1, a + 2 }), add({ a, a + 2, a + 3 }) } };
      }
      const std::int32_t cut = add({ a, a + 2, b + 2, b });
      const std::int32_t first = add({ b, b + 1, b + 2 }), second = add({ b, b + 2, b + 3 });
      mesh.Polyhedra.push_back({ halves[0], first, cut, add({ a, b, b + 1, a + 1 }),
        add({ a + 1, b + 1, b + 2, a + 2 }) });
      mesh.Polyhedra.push_back({ halves[1], second, cut, add({ a + 2, b + 2, b + 3, a + 3 }),
        add({ a + 3, b + 3, b, a }) });
      halves = { { first, second } };
      continue;
    }
    std::vector<std::int32_t> cell;
    if (i > 0 && i == wedges)
    {
      cell = { halves[0], halves[1] }; // seven faces: a polyhedron
    }
    else
    {
      cell = { left < 0 ? add({ a, a + 1, a + 2, a + 3 }) : left };
    }
    left = add({ b, b + 1, b + 2, b + 3 });
    cell.push_back(left);
    for (std::int32_t side = 0; side < 4; ++side)
    {
      const std::int32_t next = (side + 1) % 4;
      cell.push_back(add({ a + side, b + side, b + next, a + next }));
    }
    mesh.Polyhedra.push_back(cell);
  }
  return mesh;
}

//------------------------------------------------------------------------------
inline Result ReadFile(const std::string& path, int piece = 0, int pieces = 1, int ghostLevels = 0)
{
  return ReadWith<vtkVisfReader>(path, piece, pieces, ghostLevels);
}

inline Result ReadBytes(const std::string& bytes)
{
  return ReadFile(File(bytes, "test.visf").Path);
}

inline Result ReadMesh(const VisfMesh& mesh, Encoding encoding)
{
  return ReadBytes(Encode(mesh, encoding));
}
}
}

#endif
