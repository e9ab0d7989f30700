// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "UpstreamFiles.h"

#include "vtkMeshFileReader.h"

#include "vtkClientServerInterpreter.h"
#include "vtkClientServerInterpreterInitializer.h"
#include "vtkClientServerStream.h"
#include "vtkFileSeriesReader.h"
#include "vtkSmartPointer.h"

#include <set>

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
/// Adds the result of GetFileName, which readers have no common base class for. Other algorithms
/// have no such method: this interpreter, unlike the global one, does not report that.
void AddFileName(vtkAlgorithm* reader, InputFiles& files)
{
  static const auto interpreter = vtkSmartPointer<vtkClientServerInterpreter>::Take(
    vtkClientServerInterpreterInitializer::GetInitializer()->NewInterpreter());
  vtkClientServerStream call;
  call << vtkClientServerStream::Invoke << reader << "GetFileName" << vtkClientServerStream::End;
  const char* name = nullptr;
  if (interpreter->ProcessStream(call) && interpreter->GetLastResult().GetArgument(0, 0, &name) &&
    name)
  {
    files.Add(name);
  }
}

//------------------------------------------------------------------------------
void AddFiles(vtkAlgorithm* algorithm, InputFiles& files, std::set<vtkAlgorithm*>& visited)
{
  if (!algorithm || !visited.insert(algorithm).second)
  {
    return;
  }
  if (auto* const series = vtkFileSeriesReader::SafeDownCast(algorithm))
  {
    for (unsigned int i = 0; i < series->GetNumberOfFileNames(); ++i)
    {
      const char* const name = series->GetFileName(i);
      files.Add(name ? name : "");
    }
    AddFiles(series->GetReader(), files, visited);
  }
  else if (auto* const reader = vtkMeshFileReader::SafeDownCast(algorithm))
  {
    files.Add(reader->GetFilesRead());
  }
  else if (algorithm->GetTotalNumberOfInputConnections() == 0)
  {
    AddFileName(algorithm, files);
  }
  for (int port = 0; port < algorithm->GetNumberOfInputPorts(); ++port)
  {
    for (int i = 0; i < algorithm->GetNumberOfInputConnections(port); ++i)
    {
      AddFiles(algorithm->GetInputAlgorithm(port, i), files, visited);
    }
  }
}
}

//------------------------------------------------------------------------------
InputFiles FindUpstreamFiles(vtkAlgorithm* algorithm)
{
  InputFiles files;
  std::set<vtkAlgorithm*> visited;
  AddFiles(algorithm, files, visited);
  return files;
}
}
