// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "TableRows.h"

#include "Ranks/Reducer.h"

#include "vtkDataArray.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkSmartPointer.h"
#include "vtkStringArray.h"
#include "vtkTable.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <stdexcept>
#include <vector>

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
// The tables of all processes with rows; empty on others than process 0.
std::vector<vtkSmartPointer<vtkTable>> GatherTables(vtkTable* table, Reducer& reducer)
{
  const auto own = vtkSmartPointer<vtkTable>::New();
  own->ShallowCopy(table);
  std::vector<vtkSmartPointer<vtkDataObject>> all = { own };
  if (reducer.GetNumberOfProcesses() > 1)
  {
    all.clear();
    std::int64_t isLost =
      vtkMultiProcessController::GetGlobalController()->Gather(own, all, 0) ? 0 : 1;
    reducer.Max(&isLost, 1);
    if (isLost)
    {
      throw std::runtime_error("the rows of all processes cannot be gathered");
    }
  }
  std::vector<vtkSmartPointer<vtkTable>> tables;
  for (const vtkSmartPointer<vtkDataObject>& data : all)
  {
    auto* rows = vtkTable::SafeDownCast(data);
    if (rows && rows->GetNumberOfRows() > 0)
    {
      tables.emplace_back(rows);
    }
  }
  return tables;
}

//------------------------------------------------------------------------------
bool HasValue(vtkAbstractArray* column)
{
  if (auto* texts = vtkStringArray::SafeDownCast(column))
  {
    for (vtkIdType i = 0; i < texts->GetNumberOfValues(); ++i)
    {
      if (!texts->GetValue(i).empty())
      {
        return true;
      }
    }
    return false;
  }
  auto* numbers = vtkDataArray::SafeDownCast(column);
  const int components = column->GetNumberOfComponents();
  for (vtkIdType i = 0; numbers && i < numbers->GetNumberOfTuples(); ++i)
  {
    for (int c = 0; c < components; ++c)
    {
      if (!std::isnan(numbers->GetComponent(i, c)))
      {
        return true;
      }
    }
  }
  return !numbers;
}

//------------------------------------------------------------------------------
// Of rows with the same value first by block, then by id, so that the order does not depend on the
// processes.
std::vector<vtkIdType> FindOrder(vtkTable* table, const std::string& column, bool isDescending)
{
  std::vector<vtkIdType> order(static_cast<std::size_t>(table->GetNumberOfRows()));
  std::iota(order.begin(), order.end(), 0);
  auto* values = vtkDataArray::SafeDownCast(table->GetColumnByName(column.c_str()));
  auto* ids = IntegerColumn::SafeDownCast(table->GetColumnByName("Id"));
  auto* blocks = vtkStringArray::SafeDownCast(table->GetColumnByName("Block"));
  if (values && values->GetNumberOfComponents() == 1)
  {
    std::sort(order.begin(), order.end(),
      [&](vtkIdType a, vtkIdType b)
      {
        const double x = values->GetComponent(a, 0), y = values->GetComponent(b, 0);
        if (std::isnan(x) != std::isnan(y))
        {
          return std::isnan(y);
        }
        if (!std::isnan(x) && x != y)
        {
          return isDescending ? x > y : x < y;
        }
        const int block = blocks->GetValue(a).compare(blocks->GetValue(b));
        return block != 0 ? block < 0 : ids->GetValue(a) < ids->GetValue(b);
      });
  }
  return order;
}
}

//------------------------------------------------------------------------------
void SortRows(
  vtkTable* table, const std::string& column, bool isDescending, int fixed, Reducer& reducer)
{
  std::int64_t rows = table->GetNumberOfRows();
  reducer.Sum(&rows, 1);
  if (rows > MostSortedRows)
  {
    return;
  }
  const std::vector<vtkSmartPointer<vtkTable>> tables = GatherTables(table, reducer);
  table->Initialize();
  if (tables.empty())
  {
    return;
  }
  vtkTable* first = tables.front();
  vtkNew<vtkTable> all;
  for (vtkIdType i = 0; i < first->GetNumberOfColumns(); ++i)
  {
    vtkAbstractArray* pattern = first->GetColumn(i);
    const auto joined = vtkSmartPointer<vtkAbstractArray>::Take(pattern->NewInstance());
    joined->SetName(pattern->GetName());
    joined->SetNumberOfComponents(pattern->GetNumberOfComponents());
    joined->CopyComponentNames(pattern);
    for (vtkTable* rows : tables)
    {
      vtkAbstractArray* part = rows->GetColumnByName(pattern->GetName());
      joined->InsertTuples(joined->GetNumberOfTuples(), part->GetNumberOfTuples(), 0, part);
    }
    all->AddColumn(joined);
  }
  const std::vector<vtkIdType> order = FindOrder(all, column, isDescending);
  std::vector<vtkAbstractArray*> columns;
  for (vtkIdType i = 0; i < all->GetNumberOfColumns(); ++i)
  {
    columns.push_back(all->GetColumn(i));
  }
  std::stable_partition(columns.begin() + fixed, columns.end(),
    [&](vtkAbstractArray* array) { return column == array->GetName(); });
  for (vtkAbstractArray* unsorted : columns)
  {
    if (!HasValue(unsorted))
    {
      continue;
    }
    const auto sorted = vtkSmartPointer<vtkAbstractArray>::Take(unsorted->NewInstance());
    sorted->SetName(unsorted->GetName());
    sorted->SetNumberOfComponents(unsorted->GetNumberOfComponents());
    sorted->CopyComponentNames(unsorted);
    for (const vtkIdType row : order)
    {
      sorted->InsertNextTuple(row, unsorted);
    }
    table->AddColumn(sorted);
  }
}
}
