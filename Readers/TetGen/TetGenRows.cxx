// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "TetGenRows.h"

#include "Base/Parallel.h"

#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkIntArray.h"

namespace camaron
{
namespace
{
constexpr char Attribute[] = "an attribute";
constexpr char Marker[] = "a boundary marker";
constexpr char Tetrahedron[] = "an adjacent tetrahedron";

//------------------------------------------------------------------------------
bool IsInteger(double value)
{
  return value >= INT32_MIN && value <= INT32_MAX && value == static_cast<std::int32_t>(value);
}
}

//------------------------------------------------------------------------------
bool ReadTetGenHeader(
  TextScanner& scanner, std::int64_t* numbers, int size, ErrorKind kind, const char* expected)
{
  if (scanner.HasFailed())
  {
    return false;
  }
  if (!scanner.SkipSpace())
  {
    return scanner.FailAt(
      scanner.GetEnd(), kind == ErrorKind::NotThisFormat ? kind : ErrorKind::Truncated, expected);
  }
  TextScanner line = scanner; // with errors of its own, as the caller words them differently
  TextRow row(line);
  for (int i = 0; i < size && (i == 0 || row.HasMore()); ++i)
  {
    if (!row.ReadInteger(numbers[i], expected))
    {
      return scanner.FailAt(line.GetPosition(), i == 0 ? kind : ErrorKind::Syntax, expected);
    }
  }
  return true;
}

//------------------------------------------------------------------------------
bool CheckTetGenAttributes(TextScanner& scanner, std::int64_t attributes, const char* items)
{
  return (attributes >= 0 && attributes <= MaxTetGenAttributes) ||
    scanner.FailAt(scanner.GetPosition(), ErrorKind::Count,
      "at most " + std::to_string(MaxTetGenAttributes) + " attributes of " + items,
      std::to_string(attributes));
}

//------------------------------------------------------------------------------
bool IsTetGenRow(TextScanner scanner, int ids, int reals)
{
  TextRow row(scanner, RowLayout::OneLine);
  std::int32_t id;
  double value;
  bool good = true;
  for (; ids > 0 && good; --ids)
  {
    good = row.ReadId(id, 0, INT32_MAX, "");
  }
  for (; reals > 0 && good; --reals)
  {
    good = row.ReadReal(value, "");
  }
  return good;
}

//------------------------------------------------------------------------------
bool ReadTetGenInteger(TextRow& row, std::int32_t& value, const char* what)
{
  std::int64_t number;
  if (!row.ReadInteger(number, what))
  {
    return false;
  }
  if (number < INT32_MIN || number > INT32_MAX)
  {
    return row.FailAtLast(ErrorKind::Syntax, std::string(what) + " of 32 bits");
  }
  value = static_cast<std::int32_t>(number);
  return true;
}

//------------------------------------------------------------------------------
void WarnOfUnmarked(const IdSet& rows, Warnings& warnings, const char* one, const char* many)
{
  Tally unmarked;
  for (vtkIdType row = 0; row < rows.GetLimit(); ++row)
  {
    if (rows.Contains(row))
    {
      unmarked.Add(row);
    }
  }
  warnings.Add(unmarked, one, many, "without the boundary marker that the header declares");
}

//------------------------------------------------------------------------------
void TetGenColumns::Start(const Layout& layout, vtkIdType rows)
{
  this->Columns = layout;
  this->FirstIsInteger = true;
  this->Unmarked = IdSet(layout.Markers ? rows : 0);
  this->Surplus = VTK_ID_MAX;
  this->Allocate(0);
}

//------------------------------------------------------------------------------
void TetGenColumns::Allocate(vtkIdType size)
{
  this->Attributes.clear();
  for (int i = 0; i < this->Columns.Attributes; ++i)
  {
    this->Attributes.emplace_back(size);
  }
  this->Markers = Buffer<std::int32_t>(this->Columns.Markers ? size : 0);
  this->Tetrahedra = Buffer<std::int32_t>(this->Columns.Tetrahedra * size);
}

//------------------------------------------------------------------------------
bool TetGenColumns::Read(TextRow& row, vtkIdType number, vtkIdType index)
{
  const bool keep = index >= 0;
  for (int i = 0; i < this->Columns.Attributes; ++i)
  {
    double value;
    if (!row.ReadReal(value, Attribute))
    {
      return false;
    }
    if (keep)
    {
      this->Attributes[i][index] = value;
    }
    if (i == 0 && !IsInteger(value) && this->FirstIsInteger.load(std::memory_order_relaxed))
    {
      this->FirstIsInteger = false;
    }
  }
  if (this->Columns.Markers)
  {
    std::int32_t marker = 0;
    if (this->Columns.Tetrahedra == 0 && !row.HasMore())
    {
      this->Unmarked.Add(number);
    }
    else if (!ReadTetGenInteger(row, marker, Marker))
    {
      return false;
    }
    if (keep)
    {
      this->Markers[index] = marker;
    }
  }
  for (int i = 0; i < this->Columns.Tetrahedra; ++i)
  {
    std::int32_t tetrahedron;
    if (!ReadTetGenInteger(row, tetrahedron, Tetrahedron))
    {
      return false;
    }
    if (keep)
    {
      this->Tetrahedra[this->Columns.Tetrahedra * index + i] = tetrahedron;
    }
  }
  if (row.HasMore())
  {
    LowerTo(this->Surplus, number);
  }
  return true;
}

//------------------------------------------------------------------------------
void TetGenColumns::AddTo(vtkDataSetAttributes* attributes, const char* first)
{
  for (std::size_t i = 0; i < this->Attributes.size(); ++i)
  {
    Buffer<double>& values = this->Attributes[i];
    if (i == 0 && first && this->FirstIsInteger)
    {
      Buffer<std::int32_t> integers(values.size());
      for (vtkIdType row = 0; row < values.size(); ++row)
      {
        integers[row] = static_cast<std::int32_t>(values[row]);
      }
      values = Buffer<double>();
      AddIntegers(attributes, first, std::move(integers));
      continue;
    }
    const std::string name = i == 0 && first ? first : "attr_" + std::to_string(i);
    attributes->AddArray(values.TakeArray<vtkDoubleArray>(1, name.c_str()));
  }
  if (this->Columns.Markers)
  {
    AddIntegers(attributes, "BoundaryMarker", std::move(this->Markers));
  }
  if (this->Columns.Tetrahedra > 0)
  {
    AddIntegers(attributes, "Tetrahedra", std::move(this->Tetrahedra), this->Columns.Tetrahedra);
  }
}

//------------------------------------------------------------------------------
void TetGenColumns::Warn(Warnings& warnings, const char* one, const char* many) const
{
  WarnOfUnmarked(this->Unmarked, warnings, one, many);
  if (this->Surplus < VTK_ID_MAX)
  {
    warnings.Add(std::string("values after those that the header declares are omitted, the first "
                             "of ") +
      one + " " + std::to_string(this->Surplus));
  }
}

//------------------------------------------------------------------------------
void AddIntegers(
  vtkDataSetAttributes* attributes, const char* name, Buffer<std::int32_t>&& values, int components)
{
  attributes->AddArray(values.TakeArray<vtkIntArray>(components, name));
}
}
