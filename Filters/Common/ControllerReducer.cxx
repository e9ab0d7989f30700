// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ControllerReducer.h"

#include "vtkCommunicator.h"
#include "vtkMultiProcessController.h"

namespace camaron
{
namespace
{
constexpr int ExchangeTag = 71345; // not used by other filters or VTK
}

//------------------------------------------------------------------------------
ControllerReducer::ControllerReducer()
  : Controller(vtkMultiProcessController::GetGlobalController())
{
}

//------------------------------------------------------------------------------
int ControllerReducer::GetNumberOfProcesses() const
{
  return this->Controller ? this->Controller->GetNumberOfProcesses() : 1;
}

//------------------------------------------------------------------------------
int ControllerReducer::GetProcess() const
{
  return this->Controller ? this->Controller->GetLocalProcessId() : 0;
}

//------------------------------------------------------------------------------
void ControllerReducer::Sum(std::int64_t* values, std::size_t size)
{
  this->Reduce(values, size, vtkCommunicator::SUM_OP);
}

//------------------------------------------------------------------------------
void ControllerReducer::Min(std::int64_t* values, std::size_t size)
{
  this->Reduce(values, size, vtkCommunicator::MIN_OP);
}

//------------------------------------------------------------------------------
void ControllerReducer::Max(std::int64_t* values, std::size_t size)
{
  this->Reduce(values, size, vtkCommunicator::MAX_OP);
}

//------------------------------------------------------------------------------
void ControllerReducer::Reduce(std::int64_t* values, std::size_t size, int operation)
{
  if (this->GetNumberOfProcesses() > 1 && size > 0)
  {
    const std::vector<std::int64_t> own(values, values + size);
    this->Controller->AllReduce(own.data(), values, static_cast<vtkIdType>(size), operation);
  }
}

//------------------------------------------------------------------------------
std::vector<char> ControllerReducer::Gather(
  const std::vector<char>& bytes, std::vector<std::size_t>& sizes)
{
  const int numberOfProcesses = this->GetNumberOfProcesses();
  if (numberOfProcesses == 1)
  {
    return this->Reducer::Gather(bytes, sizes);
  }
  const auto ownLength = static_cast<vtkIdType>(bytes.size());
  std::vector<vtkIdType> lengths(numberOfProcesses), offsets(numberOfProcesses);
  this->Controller->AllGather(&ownLength, lengths.data(), 1);
  sizes.clear();
  vtkIdType total = 0;
  for (int process = 0; process < numberOfProcesses; ++process)
  {
    sizes.push_back(static_cast<std::size_t>(lengths[process]));
    offsets[process] = total;
    total += lengths[process];
  }
  std::vector<char> all(static_cast<std::size_t>(total));
  if (total > 0)
  {
    this->Controller->AllGatherV(
      bytes.data(), all.data(), ownLength, lengths.data(), offsets.data());
  }
  return all;
}

//------------------------------------------------------------------------------
// In each round every process has one partner. The process with the smaller number sends first, so
// that no two processes wait for each other.
std::vector<std::vector<char>> ControllerReducer::Exchange(std::vector<std::vector<char>>&& lists)
{
  const int size = this->GetNumberOfProcesses(), own = this->GetProcess();
  for (int round = 0; round < size; ++round)
  {
    const int partner = (round - own + size) % size;
    if (partner == own)
    {
      continue;
    }
    const std::vector<char> sent = std::move(lists[partner]);
    std::vector<char>& received = lists[partner];
    const auto send = [&]
    {
      const auto length = static_cast<vtkIdType>(sent.size());
      this->Controller->Send(&length, 1, partner, ExchangeTag);
      if (length > 0)
      {
        this->Controller->Send(sent.data(), length, partner, ExchangeTag);
      }
    };
    const auto receive = [&]
    {
      vtkIdType length = 0;
      this->Controller->Receive(&length, 1, partner, ExchangeTag);
      received.resize(static_cast<std::size_t>(length));
      if (length > 0)
      {
        this->Controller->Receive(received.data(), length, partner, ExchangeTag);
      }
    };
    if (own < partner)
    {
      send();
      receive();
    }
    else
    {
      receive();
      send();
    }
  }
  return std::move(lists);
}
}
