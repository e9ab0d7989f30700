// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PolygonOFFSamples.h
 * @brief OFF files of every type, created for tests.
 */
#ifndef camaron_PolygonOFFSamples_h
#define camaron_PolygonOFFSamples_h

#include "FormatTesting.h"
#include "Intake/Rows/Bytes.h"
#include "vtkPolygonOFFReader.h"

namespace camaron
{
namespace testing
{
//------------------------------------------------------------------------------
inline Result ReadBytes(const std::string& bytes)
{
  return ReadWith<vtkPolygonOFFReader>(File(bytes, "test.off").Path);
}

//------------------------------------------------------------------------------
/// Big (or little) endian words.
class Words
{
public:
  explicit Words(ByteOrder order = ByteOrder::Big)
    : Swap(order != GetByteOrder())
  {
  }
  Words& operator<<(int value)
  {
    AppendBytes(this->Bytes, static_cast<std::int32_t>(value), this->Swap);
    return *this;
  }
  Words& operator<<(float value)
  {
    AppendBytes(this->Bytes, value, this->Swap);
    return *this;
  }
  std::string Bytes;

private:
  bool Swap;
};

//------------------------------------------------------------------------------
/// The columns of the vertices of a sample.
struct Sample
{
  std::string Keyword = "OFF";
  bool HasTexture = false, HasColors = false, HasNormals = false, IsHomogeneous = false;
  int Dimension = 0; // 0: not declared, 3

  /// Values of vertex i, in the order of the Geomview manual: position, normal, color, texture.
  std::vector<float> GetVertex(int i) const
  {
    const int size = this->Dimension ? this->Dimension : 3;
    const float w = this->IsHomogeneous ? 2 : 1;
    std::vector<float> numbers;
    for (int c = 0; c < size; ++c)
    {
      numbers.push_back(w * (0.5f * i + 10 * c));
    }
    if (this->IsHomogeneous)
    {
      numbers.push_back(w);
    }
    for (int c = 0; this->HasNormals && c < size; ++c)
    {
      numbers.push_back(c == i % size ? 1.f : 0.f);
    }
    if (this->HasColors)
    {
      numbers.insert(numbers.end(), { 0.25f * (i % 5), 1, 0, 0.5f });
    }
    if (this->HasTexture)
    {
      numbers.insert(numbers.end(), { 0.125f * i, 1 - 0.125f * i });
    }
    return numbers;
  }

  /// A strip of triangles.
  std::string GetText(int triangles, const std::string& lineEnd = "\n") const
  {
    std::string text = this->Keyword + lineEnd;
    text += this->Dimension ? std::to_string(this->Dimension) + lineEnd : "";
    text += std::to_string(triangles + 2) + " " + std::to_string(triangles) + " 0" + lineEnd;
    for (int i = 0; i < triangles + 2; ++i)
    {
      for (const float number : this->GetVertex(i))
      {
        text += std::to_string(number) + " ";
      }
      text += lineEnd;
    }
    for (int i = 0; i < triangles; ++i)
    {
      text += "3 " + std::to_string(i) + " " + std::to_string(i + 1) + " " + std::to_string(i + 2) +
        lineEnd;
    }
    return text;
  }

  std::string GetBinary(int triangles, ByteOrder order = ByteOrder::Big) const
  {
    Words words(order);
    if (this->Dimension)
    {
      words << this->Dimension;
    }
    words << triangles + 2 << triangles << 0;
    for (int i = 0; i < triangles + 2; ++i)
    {
      for (const float number : this->GetVertex(i))
      {
        words << number;
      }
    }
    for (int i = 0; i < triangles; ++i)
    {
      words << 3 << i << i + 1 << i + 2 << 0;
    }
    return this->Keyword + " BINARY\n" + words.Bytes;
  }
};

//------------------------------------------------------------------------------
/// Every keyword, and n with 1, 2, 3 and 5 dimensions.
inline std::vector<Sample> GetSamples()
{
  std::vector<Sample> samples;
  for (int bits = 0; bits < 16; ++bits)
  {
    for (const int dimension : { 0, 1, 2, 3, 5 })
    {
      Sample sample;
      sample.HasTexture = bits & 1;
      sample.HasColors = bits & 2;
      sample.HasNormals = bits & 4;
      sample.IsHomogeneous = bits & 8;
      sample.Dimension = dimension;
      sample.Keyword = std::string(sample.HasTexture ? "ST" : "") + (sample.HasColors ? "C" : "") +
        (sample.HasNormals ? "N" : "") + (sample.IsHomogeneous ? "4" : "") +
        (dimension ? "n" : "") + "OFF";
      samples.push_back(sample);
    }
  }
  return samples;
}

//------------------------------------------------------------------------------
/// Faces of every size and with every form of color.
inline std::string MakeMixedText(int times, const std::string& lineEnd = "\n")
{
  const char* const faces[] = { "3 0 1 2", "4 0 1 2 3 255 0 128", "5 0 1 2 3 4 1 2 3 4", "2 0 1",
    "1 4 # a vertex", "0", "3 2 1 0 17", "3 0 1 2 0.5 0.25 1.", "6 0 1 2 3 4 5 1e0 0 0 .5",
    "3 1 1 2 7 8", "3 3 4 5 red" };
  const int number = static_cast<int>(sizeof(faces) / sizeof(faces[0]));
  std::string text = "OFF # mixed" + lineEnd + "6 " + std::to_string(times * number) + lineEnd;
  for (int i = 0; i < 6; ++i)
  {
    text += std::to_string(i * 0.1) + " " + std::to_string(i % 2) + " -1.5D-3" +
      (i == 3 ? " 4" : "") + lineEnd;
  }
  for (int i = 0; i < times * number; ++i)
  {
    text += faces[i % number] + lineEnd;
  }
  return text;
}
}
}

#endif
