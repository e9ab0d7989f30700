// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkGatheredTableWriter
 * @brief Writes a table in CSV whose rows are on the first process, as ours are, as one process
 * would.
 *
 * On several processes ParaView's writer merges their tables, after which the columns are in
 * alphabetical order. It still does if other processes have rows, too.
 */
#ifndef vtkGatheredTableWriter_h
#define vtkGatheredTableWriter_h

#include "vtkCSVWriter.h"

class vtkGatheredTableWriter : public vtkCSVWriter
{
public:
  static vtkGatheredTableWriter* New();
  vtkTypeMacro(vtkGatheredTableWriter, vtkCSVWriter);

protected:
  vtkGatheredTableWriter() = default;
  ~vtkGatheredTableWriter() override = default;

  /// Collective.
  void WriteData() override;

private:
  vtkGatheredTableWriter(const vtkGatheredTableWriter&) = delete;
  void operator=(const vtkGatheredTableWriter&) = delete;
};

#endif
