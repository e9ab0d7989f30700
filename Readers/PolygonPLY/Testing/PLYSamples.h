// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PLYSamples.h
 * @brief PLY files for tests, encoded independently of the writer.
 */
#ifndef camaron_PLYSamples_h
#define camaron_PLYSamples_h

#include "Base/Number.h"
#include "FormatTesting.h"
#include "Intake/Rows/Bytes.h"
#include "vtkPolygonPLYReader.h"

#include <list>
#include <string>
#include <vector>

namespace camaron
{
namespace testing
{
constexpr const char* Formats[] = { "ascii", "binary_little_endian", "binary_big_endian" };

inline Result ReadBytes(const std::string& bytes)
{
  return ReadWith<vtkPolygonPLYReader>(File(bytes, "test.ply").Path);
}

//------------------------------------------------------------------------------
/// An element; every value of a row is a list, with one number for other properties.
struct Element
{
  struct Property
  {
    std::string Type, Name; ///< the type of a list is "list COUNT ITEM"
  };
  std::string Name;
  std::vector<Property> Properties;
  std::vector<std::vector<std::vector<double>>> Rows;

  Element& Add(const std::string& type, const std::string& name)
  {
    this->Properties.push_back({ type, name });
    return *this;
  }
};

//------------------------------------------------------------------------------
struct Sample
{
  std::list<Element> Elements;

  Element& AddElement(const std::string& name)
  {
    this->Elements.emplace_back();
    this->Elements.back().Name = name;
    return this->Elements.back();
  }

  /// Vertices of type double on a curve, with the property mass, which is their number.
  Element& AddVertices(int count)
  {
    Element& vertices = this->AddElement("vertex");
    vertices.Add("double", "x").Add("double", "y").Add("double", "z").Add("short", "mass");
    for (int i = 0; i < count; ++i)
    {
      vertices.Rows.push_back(
        { { i * 0.1 }, { i * i * 0.01 }, { i % 3 * 1.0 }, { static_cast<double>(i) } });
    }
    return vertices;
  }

  static void AppendValue(
    std::string& bytes, const std::string& type, double value, const std::string& format)
  {
    const bool swap = (format == "binary_big_endian") != (GetByteOrder() == ByteOrder::Big);
    const auto put = [&](auto number)
    {
      if (format != "ascii")
      {
        AppendBytes(bytes, number, swap);
      }
      else
      {
        AppendNumber(bytes, number);
        bytes += ' ';
      }
    };
    // Integers; -1 of them is valid in all unsigned types.
    const bool isReal = type[0] == 'f' || type[0] == 'd';
    const auto integer = isReal ? std::int64_t(0) : static_cast<std::int64_t>(value);
    const auto is = [&](const char* a, const char* b) { return type == a || type == b; };
    if (is("char", "int8"))
    {
      format == "ascii" ? put(static_cast<int>(value)) : put(static_cast<std::int8_t>(value));
    }
    else if (is("uchar", "uint8"))
    {
      const auto byte = static_cast<std::uint8_t>(integer);
      format == "ascii" ? put(static_cast<int>(byte)) : put(byte);
    }
    else if (is("short", "int16"))
    {
      put(static_cast<std::int16_t>(value));
    }
    else if (is("ushort", "uint16"))
    {
      put(static_cast<std::uint16_t>(integer));
    }
    else if (is("int", "int32"))
    {
      put(static_cast<std::int32_t>(value));
    }
    else if (is("uint", "uint32"))
    {
      put(static_cast<std::uint32_t>(integer));
    }
    else if (type == "int64")
    {
      put(integer);
    }
    else if (type == "uint64")
    {
      put(static_cast<std::uint64_t>(integer));
    }
    else if (is("float", "float32"))
    {
      put(static_cast<float>(value));
    }
    else
    {
      put(value);
    }
  }

  std::string Encode(const std::string& format, const std::string& lineEnd = "\n") const
  {
    std::string bytes = "ply" + lineEnd + "format " + format + " 1.0" + lineEnd;
    for (const Element& element : this->Elements)
    {
      bytes += "element " + element.Name + " " + std::to_string(element.Rows.size()) + lineEnd;
      for (const auto& property : element.Properties)
      {
        bytes += "property " + property.Type + " " + property.Name + lineEnd;
      }
    }
    bytes += "end_header" + lineEnd;
    for (const Element& element : this->Elements)
    {
      for (const auto& row : element.Rows)
      {
        for (std::size_t p = 0; p < row.size(); ++p)
        {
          std::string type = element.Properties[p].Type;
          if (type.compare(0, 5, "list ") == 0)
          {
            const std::size_t blank = type.find(' ', 5);
            AppendValue(
              bytes, type.substr(5, blank - 5), static_cast<double>(row[p].size()), format);
            type = type.substr(blank + 1);
          }
          for (const double value : row[p])
          {
            AppendValue(bytes, type, value, format);
          }
        }
        bytes += format == "ascii" ? lineEnd : "";
      }
    }
    return bytes;
  }
};

//------------------------------------------------------------------------------
/// Polygons with three to six vertices and values, an edge before and a strip after them.
inline Sample MakeMixedSurface(int polygons)
{
  Sample sample;
  Element& edges = sample.AddElement("edge");
  edges.Add("int", "vertex1").Add("int", "vertex2").Add("float", "value");
  edges.Rows = { { { 0 }, { 3 }, { -1 } } };
  sample.AddVertices(polygons + 6);
  Element& faces = sample.AddElement("face");
  faces.Add("uchar", "kind").Add("list uchar int", "vertex_indices").Add("float", "value");
  for (int i = 0; i < polygons; ++i)
  {
    std::vector<double> ids;
    for (int j = 0; j < 3 + i % 4; ++j)
    {
      ids.push_back(i + j);
    }
    faces.Rows.push_back({ { static_cast<double>(i % 200) }, ids, { i * 0.5 } });
  }
  Element& strips = sample.AddElement("tristrips");
  strips.Add("list int int", "vertex_indices");
  strips.Rows = { { { 0, 1, 2, 3, -1, 4, 5, 0 } } };
  return sample;
}

//------------------------------------------------------------------------------
/// A cube with a pyramid on it, given by faces; a triangle and an edge next to them.
inline Sample MakeCells()
{
  Sample sample;
  Element& vertices = sample.AddVertices(10);
  const double places[10][3] = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { 0, 0, 1 },
    { 1, 0, 1 }, { 1, 1, 1 }, { 0, 1, 1 }, { 0.5, 0.5, 2 }, { -1, 0, 0 } };
  for (int i = 0; i < 10; ++i)
  {
    for (int c = 0; c < 3; ++c)
    {
      vertices.Rows[i][c] = { places[i][c] };
    }
  }
  Element& cells = sample.AddElement("cell");
  cells.Add("list uchar int", "face_indices").Add("uchar", "zone");
  cells.Rows = { { { 0, 1, 2, 3, 4, 5 }, { 7 } }, { { 5, 6, 7, 8, 9 }, { 8 } } };
  Element& faces = sample.AddElement("face");
  faces.Add("list uchar int", "vertex_indices").Add("float", "area");
  const std::vector<std::vector<double>> lists = { { 0, 3, 2, 1 }, { 0, 1, 5, 4 }, { 1, 2, 6, 5 },
    { 2, 3, 7, 6 }, { 3, 0, 4, 7 }, { 4, 5, 6, 7 }, { 4, 5, 8 }, { 5, 6, 8 }, { 6, 7, 8 },
    { 7, 4, 8 }, { 0, 1, 9 } };
  for (const auto& list : lists)
  {
    faces.Rows.push_back({ list, { static_cast<double>(list.size()) } });
  }
  Element& edges = sample.AddElement("edge");
  edges.Add("int", "vertex1").Add("int", "vertex2");
  edges.Rows = { { { 0 }, { 9 } } };
  return sample;
}
}
}

#endif
