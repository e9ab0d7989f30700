// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Ends.h
 * @brief How the execution of a filter ends early: by an abort or by an error, with empty outputs.
 */
#ifndef camaron_Ends_h
#define camaron_Ends_h

class vtkAlgorithm;
class vtkInformationVector;

namespace camaron
{
class Reducer;

/// Collective. Reports progress. If the filter was aborted on some process, or @a isFinished is
/// false on one, throws on all of them what EndEarly takes as an abort.
void GoOn(vtkAlgorithm* filter, double progress, Reducer& reducer, bool isFinished = true);

/**
 * Ends RequestData after an exception; call it from catch (...), and return its result. Empties all
 * outputs and reports the error, which begins with @a failure, such as "The kernel cannot be
 * computed", unless that is empty. An abort is no error.
 *
 * A lack of memory is found by one process; if others already wait for it, they would do so
 * forever. So it ends a process that has others, and with it, by MPI, all of them.
 */
int EndEarly(vtkAlgorithm* filter, const char* failure, vtkInformationVector* outputs);
}

#endif
