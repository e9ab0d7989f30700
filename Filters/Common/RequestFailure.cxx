// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "RequestFailure.h"

#include "Base/Text.h"
#include "ControllerReducer.h"

#include "vtkAlgorithm.h"
#include "vtkDataObject.h"
#include "vtkInformationVector.h"

#include <cstdlib>
#include <string>

namespace camaron
{
namespace
{
struct Aborted
{
};
}

//------------------------------------------------------------------------------
void CheckAbortOnAllRanks(vtkAlgorithm* filter, double progress, Reducer& reducer, bool isFinished)
{
  filter->UpdateProgress(progress);
  std::int64_t goesOn = isFinished && !filter->CheckAbort();
  reducer.Min(&goesOn, 1);
  if (!goesOn)
  {
    throw Aborted();
  }
}

//------------------------------------------------------------------------------
int FailRequest(vtkAlgorithm* filter, const char* failure, vtkInformationVector* outputs)
{
  for (int port = 0; port < outputs->GetNumberOfInformationObjects(); ++port)
  {
    vtkDataObject::GetData(outputs, port)->Initialize();
  }
  try
  {
    throw;
  }
  catch (const Aborted&)
  {
    filter->SetAbortOutput(true); // also if another process was aborted
    return 1;
  }
  catch (const std::exception& error)
  {
    const std::string reason = GetReason(error);
    vtkErrorWithObjectMacro(
      filter, << (*failure ? std::string(failure) + ": " + reason + "." : reason));
    if (dynamic_cast<const std::bad_alloc*>(&error) &&
      ControllerReducer().GetNumberOfProcesses() > 1)
    {
      std::_Exit(EXIT_FAILURE);
    }
  }
  return 0;
}
}
