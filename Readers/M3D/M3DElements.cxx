// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "M3DElements.h"

#include "Intake/Rows/TextRows.h"

#include <algorithm>
#include <cmath>

namespace camaron
{
namespace
{
constexpr ElementKind Kinds[] = {
  { 'T', VTK_TETRA, 4 },
  { 'P', VTK_PYRAMID, 5 },
  { 'R', VTK_WEDGE, 6 },
  { 'H', VTK_HEXAHEDRON, 8 },
};
constexpr ElementKind FlatKinds[] = {
  { 't', VTK_TRIANGLE, 3 },
  { 'q', VTK_QUAD, 4 },
};
constexpr ElementKind FlatMVMKinds[] = {
  { 'T', VTK_TRIANGLE, 3 },
  { 'Q', VTK_QUAD, 4 },
};

//------------------------------------------------------------------------------
template <std::size_t Size, typename Is>
const ElementKind* Find(const ElementKind (&kinds)[Size], Is&& is)
{
  const auto* const found = std::find_if(kinds, kinds + Size, is);
  return found < kinds + Size ? found : nullptr;
}

//------------------------------------------------------------------------------
template <typename Is>
const ElementKind* FindInDialect(M3DDialect dialect, Is&& is)
{
  if (const ElementKind* kind = Find(Kinds, is))
  {
    return kind;
  }
  return dialect == M3DDialect::MVM ? Find(FlatMVMKinds, is) : Find(FlatKinds, is);
}
}

//------------------------------------------------------------------------------
const ElementKind* FindElementKind(char letter, M3DDialect dialect)
{
  return FindInDialect(dialect, [=](const ElementKind& kind) { return kind.Letter == letter; });
}

//------------------------------------------------------------------------------
const ElementKind* FindElementKind(unsigned char type, M3DDialect dialect)
{
  return FindInDialect(dialect, [=](const ElementKind& kind) { return kind.Type == type; });
}

//------------------------------------------------------------------------------
const ElementKind* ReadElement(
  TextRow& row, M3DDialect dialect, vtkIdType numberOfNodes, std::int32_t* nodes)
{
  const bool isMVM = dialect == M3DDialect::MVM;
  const char* const what =
    isMVM ? "an element (T, P, R, H or Q)" : "an element (T, P, R, H, t or q)";
  std::string_view word;
  if (!row.ReadWord(word, what))
  {
    return nullptr;
  }
  const ElementKind* const kind = FindElementKind(word[0], dialect);
  if (!kind)
  {
    row.FailAt(word.data(), ErrorKind::Syntax, what);
    return nullptr;
  }
  // In MVM files triangles have the same letter as tetrahedra, and fewer nodes.
  const ElementKind* const triangle = isMVM && kind->Type == VTK_TETRA ? FlatMVMKinds : nullptr;
  std::int64_t size = kind->NumberOfNodes;
  const bool hasSize = word.size() > 1 && IsDigit(word[1]);
  if (hasSize)
  {
    ParseInteger(word.data() + 1, word.data() + word.size(), size);
    if (size != kind->NumberOfNodes && !(triangle && size == triangle->NumberOfNodes))
    {
      row.FailAt(word.data(), ErrorKind::Unsupported,
        std::string("an element of type ") + kind->Letter + " with " + (triangle ? "3 or " : "") +
          std::to_string(kind->NumberOfNodes) + " nodes");
      return nullptr;
    }
  }
  for (int i = 0; i < size; ++i)
  {
    if (triangle && i == triangle->NumberOfNodes && !hasSize && !row.HasMore())
    {
      return triangle;
    }
    if (!row.ReadId(nodes[i], 0, numberOfNodes - 1, "a node of an element"))
    {
      return nullptr;
    }
  }
  return size == kind->NumberOfNodes ? kind : triangle;
}

//------------------------------------------------------------------------------
bool MaterialTally::Read(TextRow& row, double* values)
{
  for (int c = 0; c < MaterialSize; ++c)
  {
    // A word that is not a number is not a material; Camarón ignores it.
    std::string_view word;
    const bool good = row.HasMore() && row.ReadWord(word, "the material of an element");
    const char* const end = word.data() + word.size();
    if (!good || ParseReal(word.data(), end, values[c]) != end)
    {
      this->Missing.store(true, std::memory_order_relaxed);
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
void MaterialTally::Add(TextRow& row)
{
  if (this->Different.load(std::memory_order_relaxed))
  {
    return;
  }
  const char* const text = row.GetPosition();
  const bool isFound = this->Found.load(std::memory_order_acquire);
  const std::size_t size = isFound ? this->Sample.size() : 0;
  if (isFound && static_cast<std::size_t>(this->End - text) >= size &&
    std::string_view(text, size) == this->Sample &&
    (text + size == this->End || IsSpace(text[size])))
  {
    return;
  }
  double values[MaterialSize];
  if (!this->Read(row, values))
  {
    return;
  }
  const std::lock_guard<std::mutex> lock(this->Mutex);
  if (!this->Found.load(std::memory_order_relaxed))
  {
    std::copy(values, values + MaterialSize, this->Values);
    this->Sample = { text, static_cast<std::size_t>(row.GetPosition() - text) };
    this->Found.store(true, std::memory_order_release);
  }
  const auto isSame = [](double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); };
  if (!std::equal(values, values + MaterialSize, this->Values, isSame))
  {
    this->Different.store(true, std::memory_order_relaxed);
  }
}
}
