// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SortedRows.h
 * @brief Rows of a table of all processes in one order.
 */
#ifndef camaron_SortedRows_h
#define camaron_SortedRows_h

#include <string>

class vtkTable;

namespace camaron
{
class Reducer;

/// One process has memory for them.
constexpr int MostSortedRows = 1000000;

/**
 * Moves the rows of all processes to process 0 and sorts them by a column of one component, which
 * moves behind the first @a fixed columns; rows with the same value by the columns Block and Id.
 * Undefined values are last. Columns without any value (only NaN or empty texts) are left out.
 * Without the column, the rows are those of one process after the other. More than MostSortedRows
 * of all processes stay where they are. All processes must call this. Throws std::runtime_error on
 * all of them if the rows cannot be gathered.
 */
void SortRows(
  vtkTable* table, const std::string& column, bool isDescending, int fixed, Reducer& reducer);
}

#endif
