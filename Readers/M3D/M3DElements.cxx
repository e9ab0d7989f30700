// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "M3DElements.h"

#include "Intake/Rows/TextRows.h"

#include <algorithm>
#include <cmath>
#include <cstring>

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
  if (const char* sample = this->Sample.load(std::memory_order_acquire))
  {
    const std::size_t size = this->SampleSize;
    if (static_cast<std::size_t>(this->End - text) >= size &&
      std::memcmp(text, sample, size) == 0 && (text + size == this->End || IsSpace(text[size])))
    {
      return;
    }
  }
  double values[MaterialSize];
  if (!this->Read(row, values))
  {
    return;
  }
  if (!this->Sample.load(std::memory_order_acquire))
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    if (!this->Sample.load(std::memory_order_relaxed))
    {
      std::copy(values, values + MaterialSize, this->Values);
      this->SampleSize = static_cast<std::size_t>(row.GetPosition() - text);
      this->Sample.store(text, std::memory_order_release);
    }
  }
  const auto isSame = [](double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); };
  if (!std::equal(values, values + MaterialSize, this->Values, isSame))
  {
    this->Different.store(true, std::memory_order_relaxed);
  }
}
}
