// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file RequestFailure.h
 * @brief Ends the execution of a filter after an abort or an error, with empty outputs.
 */
#ifndef camaron_RequestFailure_h
#define camaron_RequestFailure_h

class vtkAlgorithm;
class vtkInformationVector;

namespace camaron
{
class Reducer;

/// Collective. Reports progress. If the filter was aborted on any process, or @a isFinished is
/// false on one, throws on all of them an exception that FailRequest treats as an abort.
void CheckAbortOnAllRanks(
  vtkAlgorithm* filter, double progress, Reducer& reducer, bool isFinished = true);

/**
 * Ends RequestData after an exception: call it from catch (...) and return its result. Empties all
 * outputs and reports the error, which begins with @a failure, such as "The kernel cannot be
 * computed", unless that is empty. An abort is not reported.
 *
 * Lack of memory may occur on one process while the others wait for it in a collective call. If
 * there are several processes, it therefore exits, and MPI ends all of them.
 */
int FailRequest(vtkAlgorithm* filter, const char* failure, vtkInformationVector* outputs);
}

#endif
