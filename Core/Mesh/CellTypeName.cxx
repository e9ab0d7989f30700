// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/CellTypeName.h"

#include "vtkCamaronCompat.h"

#include "vtkCellType.h"

#include <cctype>
#include <utility>

namespace camaron
{
namespace
{
// Short names of VTK.
constexpr std::pair<const char*, const char*> Shortened[] = { { "tetra", "tetrahedron" },
  { "quad", "quadrangle" } };
}

//------------------------------------------------------------------------------
std::string GetCellTypeName(unsigned char type)
{
  if (type == VTK_EMPTY_CELL)
  {
    return "empty cell";
  }
  const std::string name = GetCellClassName(type); // vtkQuadraticTetra
  if (name.compare(0, 3, "vtk") != 0)
  {
    return std::to_string(static_cast<int>(type));
  }
  std::string words;
  std::size_t last = 0; // where the last word begins
  for (std::size_t i = 3; i < name.size(); ++i)
  {
    const bool isUpper = std::isupper(static_cast<unsigned char>(name[i])) != 0;
    const bool wasLower = i > 3 && !std::isupper(static_cast<unsigned char>(name[i - 1]));
    words += isUpper && wasLower ? " " : "";
    last = isUpper && wasLower ? words.size() : last;
    words += static_cast<char>(std::tolower(static_cast<unsigned char>(name[i])));
  }
  for (const auto& [shortened, word] : Shortened)
  {
    if (words.compare(last, std::string::npos, shortened) == 0)
    {
      return words.substr(0, last) + word;
    }
  }
  return words;
}
}
