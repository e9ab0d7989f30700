// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGatheredTableWriter.h"

#include "ControllerReducer.h"

#include "vtkDummyController.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkSmartPointer.h"
#include "vtkTable.h"

#include <cstdint>

vtkStandardNewMacro(vtkGatheredTableWriter);

//------------------------------------------------------------------------------
void vtkGatheredTableWriter::WriteData()
{
  camaron::ControllerReducer reducer;
  const bool isFirst = reducer.GetProcess() == 0;
  auto* table = vtkTable::SafeDownCast(this->GetInput());
  std::int64_t rowsElsewhere = table && !isFirst ? table->GetNumberOfRows() : 0;
  reducer.Sum(&rowsElsewhere, 1);
  if (rowsElsewhere > 0)
  {
    this->Superclass::WriteData();
  }
  else if (isFirst)
  {
    const vtkSmartPointer<vtkMultiProcessController> all = this->GetController();
    this->SetController(vtkNew<vtkDummyController>());
    this->Superclass::WriteData();
    this->SetController(all);
  }
}
