// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// A small simulation that stops when its mesh becomes bad.
//
//     mpiexec -n 2 sheared_block check_quality.py [STEPS]
//
// Each step shears a block of hexahedra a bit more, the upper layers most. The Catalyst script
// check_quality.py tests its rules on the mesh in memory; the simulation reads the verdict from the
// script's filter "check" and stops at "fail". Without a verdict, as after an error of the script,
// it stops with a status other than 0. Each rank has a slab of the block.
#include "vtkAbstractArray.h"
#include "vtkAlgorithm.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDataObject.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkInSituInitializationHelper.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkPVTrivialProducer.h"
#include "vtkPVVersion.h"
#include "vtkPoints.h"
#include "vtkSMProxyManager.h"
#include "vtkSMSessionProxyManager.h"
#include "vtkSMSourceProxy.h"
#include "vtkSmartPointer.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVariant.h"

#ifdef HAS_MPI
#include <mpi.h>
#endif

#include <cstdlib>
#include <iostream>
#include <string>

namespace
{
constexpr int Size = 16; // hexahedra along each side of the block
constexpr double ShearPerStep = 0.25;
constexpr const char* PipelineName = "check_quality";

//------------------------------------------------------------------------------
vtkSmartPointer<vtkUnstructuredGrid> MakeMesh(double shear, int rank, int ranks)
{
  const int first = Size * rank / ranks, last = Size * (rank + 1) / ranks;
  vtkNew<vtkPoints> points;
  for (int k = 0; k <= Size; ++k)
  {
    for (int j = 0; j <= Size; ++j)
    {
      for (int i = first; i <= last; ++i)
      {
        const double z = static_cast<double>(k) / Size;
        points->InsertNextPoint(
          static_cast<double>(i) / Size + shear * z * z, static_cast<double>(j) / Size, z);
      }
    }
  }
  vtkNew<vtkIdTypeArray> ids; // the same on any number of ranks
  ids->SetName("GlobalCellIds");
  const vtkIdType row = last - first + 1, layer = row * (Size + 1);
  auto mesh = vtkSmartPointer<vtkUnstructuredGrid>::New();
  mesh->SetPoints(points);
  for (int k = 0; k < Size; ++k)
  {
    for (int j = 0; j < Size; ++j)
    {
      for (int i = 0; i < last - first; ++i)
      {
        const vtkIdType a = i + row * j + layer * k, b = a + row, c = a + layer, d = b + layer;
        const vtkIdType corners[] = { a, a + 1, b + 1, b, c, c + 1, d + 1, d };
        mesh->InsertNextCell(VTK_HEXAHEDRON, 8, corners);
        ids->InsertNextValue(first + i + Size * (j + Size * k));
      }
    }
  }
  mesh->GetCellData()->SetGlobalIds(ids);
  return mesh;
}

enum class Verdict : int
{
  Passes,
  Fails,
  Unknown
};

//------------------------------------------------------------------------------
// The verdict of the script's filter, complete on process 0, on all processes.
Verdict GetVerdict(vtkMultiProcessController* controller)
{
  auto* manager = vtkSMProxyManager::GetProxyManager()->GetActiveSessionProxyManager();
  vtkSMProxy* check = manager->GetProxy("sources", "check");
  auto* filter = check ? vtkAlgorithm::SafeDownCast(check->GetClientSideObject()) : nullptr;
  vtkDataObject* verdicts = filter ? filter->GetOutputDataObject(0) : nullptr;
  auto* verdict = verdicts ? verdicts->GetFieldData()->GetAbstractArray("Verdict") : nullptr;
  const bool hasValue = verdict && verdict->GetNumberOfValues() > 0;
  const std::string text = hasValue ? verdict->GetVariantValue(0).ToString() : "";
  int result = static_cast<int>(text.empty() ? Verdict::Unknown
      : text == "fail"                       ? Verdict::Fails
                                             : Verdict::Passes);
  controller->Broadcast(&result, 1, 0);
  return static_cast<Verdict>(result);
}

//------------------------------------------------------------------------------
void Initialize()
{
  vtkTypeUInt64 communicator = 0;
#ifdef HAS_MPI
  communicator = static_cast<vtkTypeUInt64>(MPI_Comm_c2f(MPI_COMM_WORLD));
#endif
#if PARAVIEW_VERSION_MAJOR > 6 || (PARAVIEW_VERSION_MAJOR == 6 && PARAVIEW_VERSION_MINOR >= 1)
  vtkInSituInitializationHelper::Initialize(communicator, {});
#else
  vtkInSituInitializationHelper::Initialize(communicator);
#endif
}

//------------------------------------------------------------------------------
// Whether the mesh could be checked at all steps.
bool Simulate(const char* script, int steps)
{
  auto* manager = vtkSMProxyManager::GetProxyManager()->GetActiveSessionProxyManager();
  vtkSmartPointer<vtkSMSourceProxy> source;
  source.TakeReference(
    vtkSMSourceProxy::SafeDownCast(manager->NewProxy("sources", "PVTrivialProducer")));
  vtkInSituInitializationHelper::SetProducer("input", source);
  vtkInSituInitializationHelper::AddPipeline(PipelineName, script);
  auto* producer = vtkPVTrivialProducer::SafeDownCast(source->GetClientSideObject());
  auto* controller = vtkMultiProcessController::GetGlobalController();
  const int rank = controller->GetLocalProcessId(), ranks = controller->GetNumberOfProcesses();
  for (int step = 0; step < steps; ++step)
  {
    const double time = step;
    producer->SetOutput(MakeMesh(ShearPerStep * step, rank, ranks), time);
    vtkInSituInitializationHelper::MarkProducerModified(source);
    vtkInSituInitializationHelper::UpdateAllProducers(time);
    vtkInSituInitializationHelper::ExecutePipelines(step, time, { PipelineName });
    const Verdict verdict = GetVerdict(controller);
    if (verdict != Verdict::Passes)
    {
      if (rank == 0)
      {
        std::cout << "stopped at step " << step << ": the mesh "
                  << (verdict == Verdict::Fails ? "fails its rules" : "cannot be checked")
                  << std::endl;
      }
      return verdict == Verdict::Fails;
    }
  }
  return true;
}
}

//------------------------------------------------------------------------------
int main(int argc, char** argv)
{
#ifdef HAS_MPI
  MPI_Init(&argc, &argv);
#endif
  if (argc < 2)
  {
    std::cerr << "usage: sheared_block SCRIPT [STEPS]" << std::endl;
    return EXIT_FAILURE;
  }
  constexpr int defaultSteps = 100;
  Initialize();
  const bool isChecked = Simulate(argv[1], argc > 2 ? std::atoi(argv[2]) : defaultSteps);
  vtkInSituInitializationHelper::Finalize();
#ifdef HAS_MPI
  MPI_Finalize();
#endif
  return isChecked ? EXIT_SUCCESS : EXIT_FAILURE;
}
