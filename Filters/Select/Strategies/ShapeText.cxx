// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Strategies/ShapeText.h"

#include "Base/Number.h"
#include "Base/Text.h"
#include "Scan/ScanError.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>
#include <stdexcept>

namespace camaron
{
namespace
{
struct KindName
{
  const char* Word;
  ShapeText::Kind What;
};
const KindName KindNames[] = {
  { "sphere", ShapeText::Kind::Sphere },
  { "normals", ShapeText::Kind::Normals },
  { "polygons", ShapeText::Kind::Polygons },
};
const char* const Labels[] = { "center", "centre", "radius", "vertices", "normal", "point" };

//------------------------------------------------------------------------------
// The words of a line, without punctuation and comment.
std::vector<std::string> SplitLine(std::string line)
{
  line.erase(std::min(line.find('#'), line.size()));
  const std::string punctuation = ",;:=()[]{}";
  std::replace_if(
    line.begin(), line.end(), [&](char c) { return punctuation.find(c) != std::string::npos; },
    ' ');
  std::istringstream stream(line);
  std::vector<std::string> words;
  for (std::string word; stream >> word;)
  {
    words.push_back(word);
  }
  return words;
}

//------------------------------------------------------------------------------
std::optional<double> ToNumber(const std::string& word)
{
  double value = 0;
  const char* end = word.data() + word.size();
  return ParseReal(word.data(), end, value) == end && std::isfinite(value)
    ? std::make_optional(value)
    : std::nullopt;
}

//------------------------------------------------------------------------------
[[noreturn]] void Fail(
  const std::string& place, const std::string& expected, const std::string& found)
{
  throw std::invalid_argument(place + ": expected " + expected + ", found " + found);
}

//------------------------------------------------------------------------------
void CheckRow(ShapeText::Kind kind, std::size_t size, const std::string& place)
{
  const std::string found = std::to_string(size);
  if (kind == ShapeText::Kind::Sphere && size != 4 && size != 5)
  {
    Fail(place, "4 numbers, the center of the sphere and its radius", found);
  }
  if (kind == ShapeText::Kind::Normals && size != 6)
  {
    Fail(place, "6 numbers, a normal and a point of the plane", found);
  }
  if (kind == ShapeText::Kind::Polygons && (size < 9 || size % 3 != 0))
  {
    Fail(place, "3 numbers for each of 3 or more points of a polygon", found);
  }
}
}

//------------------------------------------------------------------------------
ShapeText ParseShape(const std::string& file, const std::string& text)
{
  std::optional<ShapeText::Kind> kind;
  ShapeText shape;
  std::istringstream stream(text);
  int lineNumber = 0;
  std::string place = file;
  for (std::string line; std::getline(stream, line);)
  {
    const std::string here = file + ':' + std::to_string(++lineNumber);
    std::vector<double> row;
    for (const std::string& word : SplitLine(line))
    {
      if (!kind)
      {
        const auto known = std::find_if(std::begin(KindNames), std::end(KindNames),
          [&](const KindName& name) { return name.Word == ToLower(word); });
        if (known == std::end(KindNames))
        {
          Fail(here, "sphere, normals or polygons", QuoteWord(word));
        }
        kind = known->What;
      }
      else if (const std::optional<double> number = ToNumber(word))
      {
        row.push_back(*number);
      }
      else if (std::find(std::begin(Labels), std::end(Labels), ToLower(word)) == std::end(Labels))
      {
        Fail(here, "a number", QuoteWord(word));
      }
    }
    if (row.empty())
    {
      continue;
    }
    place = here;
    if (kind == ShapeText::Kind::Sphere && !shape.Rows.empty())
    {
      shape.Rows[0].insert(shape.Rows[0].end(), row.begin(), row.end());
      continue;
    }
    if (kind != ShapeText::Kind::Sphere)
    {
      CheckRow(*kind, row.size(), here);
    }
    shape.Rows.push_back(row);
  }
  if (!kind || shape.Rows.empty())
  {
    Fail(file, kind ? "numbers" : "sphere, normals or polygons", "end of file");
  }
  shape.What = *kind;
  if (shape.What == ShapeText::Kind::Sphere)
  {
    CheckRow(shape.What, shape.Rows[0].size(), place);
  }
  return shape;
}
}
