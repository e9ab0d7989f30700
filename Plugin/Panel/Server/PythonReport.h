// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PythonReport.h
 * @brief The report of `camaron inspect`, about a mesh of the pipeline.
 */
#ifndef camaron_PythonReport_h
#define camaron_PythonReport_h

#include "InspectedMeshTypes.h"

#include <QStringList>

class vtkSMProxy;

namespace camaron
{
/// Whether this ParaView has Python.
bool CanWriteReport();

/**
 * Runs the Python package: it writes report.html, summary.json and worst.csv to a folder of this
 * computer, about these criteria, or those of the mesh if it is an Element Quality, judged by the
 * ranges of the request, with the verdicts on its rules if there are any. Returns an error, empty
 * if written.
 */
QString WriteReport(vtkSMProxy* mesh, int port, const QStringList& criteria,
  const ReportRequest& request, const QString& folder);
}

#endif
