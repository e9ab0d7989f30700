// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Intake/Pieces/PieceExchange.h"

#include "Intake/Pieces/PieceRequest.h"

#include "vtkCommunicator.h"
#include "vtkMultiProcessController.h"

#include <new>

namespace camaron
{
namespace
{
constexpr std::int64_t Left = -1; // the place of a process in its last step
}

//------------------------------------------------------------------------------
vtkMultiProcessController* FindProcesses(const PieceRequest& request)
{
  vtkMultiProcessController* const all = vtkMultiProcessController::GetGlobalController();
  return request.NumberOfPieces > 1 && all &&
      all->GetNumberOfProcesses() == request.NumberOfPieces &&
      all->GetLocalProcessId() == request.Piece
    ? all
    : nullptr;
}

//------------------------------------------------------------------------------
void PieceExchange::Close()
{
  std::vector<vtkIdType> sizes;
  if (this->Processes)
  {
    this->AreTogether(Left, 0, sizes);
  }
}

//------------------------------------------------------------------------------
// Few batches are loaded by all processes.
int PieceExchange::CountParts(std::int64_t batches) const
{
  const int processes = this->Processes ? this->Processes->GetNumberOfProcesses() : 1;
  return batches >= processes ? processes : 1;
}

//------------------------------------------------------------------------------
int PieceExchange::GetOwnPart() const
{
  return this->Processes->GetLocalProcessId();
}

//------------------------------------------------------------------------------
// A step: whether all processes are at this place; gets the sizes of their data. Closes otherwise.
bool PieceExchange::AreTogether(
  std::int64_t place, std::int64_t size, std::vector<vtkIdType>& sizes)
{
  const auto processes = static_cast<std::size_t>(this->Processes->GetNumberOfProcesses());
  const long long own[2] = { place, size };
  std::vector<long long> all(2 * processes, Left);
  bool good = this->Processes->AllGather(own, all.data(), 2) != 0 && place != Left;
  sizes.clear();
  for (std::size_t i = 0; i < processes; ++i)
  {
    good = good && all[2 * i] == place;
    sizes.push_back(static_cast<vtkIdType>(all[2 * i + 1]));
  }
  this->Processes = good ? this->Processes : nullptr;
  return good;
}

//------------------------------------------------------------------------------
template <typename Value>
bool PieceExchange::ExchangeAny(std::int64_t place, const Value* values, std::int64_t size,
  Buffer<Value>& all, std::vector<vtkIdType>& begins)
{
  std::vector<vtkIdType> sizes;
  if (!this->Processes || !this->AreTogether(place, size, sizes))
  {
    return false;
  }
  begins.assign(1, 0);
  for (const vtkIdType one : sizes)
  {
    begins.push_back(begins.back() + one);
  }
  int hasMemory = 1;
  try
  {
    all = Buffer<Value>(begins.back());
  }
  catch (const std::bad_alloc&)
  {
    hasMemory = 0;
  }
  int haveAll = 0;
  this->Processes->AllReduce(&hasMemory, &haveAll, 1, vtkCommunicator::MIN_OP);
  const bool good = haveAll != 0 &&
    this->Processes->AllGatherV(values, all.data(), size, sizes.data(), begins.data()) != 0;
  this->Processes = good ? this->Processes : nullptr;
  return good;
}

//------------------------------------------------------------------------------
bool PieceExchange::Exchange(std::int64_t place, const std::int32_t* values, std::int64_t size,
  Buffer<std::int32_t>& all, std::vector<vtkIdType>& begins)
{
  return this->ExchangeAny(place, values, size, all, begins);
}

//------------------------------------------------------------------------------
bool PieceExchange::Exchange(std::int64_t place, const double* values, std::int64_t size,
  Buffer<double>& all, std::vector<vtkIdType>& begins)
{
  return this->ExchangeAny(place, values, size, all, begins);
}
}
