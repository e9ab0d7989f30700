// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PythonReport.h"

#include "ErrorMessages.h"

#include "vtkSMProxy.h"

#include <QCoreApplication>

#if CAMARON_HAS_PYTHON
#include "vtkPythonInterpreter.h"
#endif

namespace
{
#if CAMARON_HAS_PYTHON
//------------------------------------------------------------------------------
// A text as Python code: no character of it can end the code.
QString Quote(const QString& text)
{
  return QString("bytes.fromhex('%1').decode()").arg(QString::fromLatin1(text.toUtf8().toHex()));
}

//------------------------------------------------------------------------------
QString Quote(const QStringList& texts)
{
  QStringList quoted;
  for (const QString& text : texts)
  {
    quoted << Quote(text);
  }
  return '[' + quoted.join(", ") + ']';
}
#endif
}

namespace camaron
{
//------------------------------------------------------------------------------
bool CanWriteReport()
{
  return CAMARON_HAS_PYTHON != 0;
}

//------------------------------------------------------------------------------
QString WriteReport(vtkSMProxy* mesh, int port, const QStringList& criteria,
  const ReportRequest& request, const QString& folder)
{
#if CAMARON_HAS_PYTHON
  vtkPythonInterpreter::Initialize();
  vtkNew<vtkPythonInterpreter> interpreter;
  const ErrorMessages errors(interpreter);
  const CheckRequest& rules = request.Rules;
  const QStringList lines = rules.Rules.isEmpty() ? QStringList() : rules.Rules.split('\n');
  const QString code = QString("from camaron import window\n"
                               "window.write_report(%1, %2, %3, %4, %5, %6, %7)\n")
                         .arg(mesh->GetGlobalID())
                         .arg(port)
                         .arg(Quote(criteria), Quote(request.Ranges), Quote(lines),
                           Quote(rules.Tolerate), Quote(folder));
  const int status = vtkPythonInterpreter::RunSimpleString(code.toUtf8().constData());
  const QString error = errors.first();
  if (error.contains("No module named 'camaron'"))
  {
    return QCoreApplication::translate(
      "PythonReport", "Reports need the Python package camaron, which is not in PYTHONPATH.");
  }
  return status == 0 || !error.isEmpty()
    ? error
    : QCoreApplication::translate("PythonReport", "Python failed; see Output Messages.");
#else
  Q_UNUSED(mesh);
  Q_UNUSED(port);
  Q_UNUSED(criteria);
  Q_UNUSED(request);
  return QCoreApplication::translate("PythonReport", "%1: this ParaView has no Python.")
    .arg(folder);
#endif
}
}
