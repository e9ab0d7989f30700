// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Scan/ScanError.h"

#include "Base/Number.h"

#include "vtkErrorCode.h"

namespace camaron
{
//------------------------------------------------------------------------------
unsigned long GetVTKErrorCode(ErrorKind kind)
{
  switch (kind)
  {
    case ErrorKind::None:
      return vtkErrorCode::NoError;
    case ErrorKind::Open:
    case ErrorKind::Changed:
    case ErrorKind::Write:
      return vtkErrorCode::CannotOpenFileError;
    case ErrorKind::DiskFull:
      return vtkErrorCode::OutOfDiskSpaceError;
    case ErrorKind::Companion:
      return vtkErrorCode::FileNotFoundError;
    case ErrorKind::NotThisFormat:
      return vtkErrorCode::UnrecognizedFileTypeError;
    case ErrorKind::Truncated:
      return vtkErrorCode::PrematureEndOfFileError;
    case ErrorKind::Memory:
      return vtkErrorCode::UserError;
    default:
      return vtkErrorCode::FileFormatError;
  }
}

//------------------------------------------------------------------------------
std::string QuoteWord(std::string_view word)
{
  constexpr std::size_t MaxLength = 30;
  std::string quoted;
  for (const char letter : word)
  {
    if (IsSpace(letter))
    {
      break;
    }
    if (quoted.size() == MaxLength)
    {
      quoted += "...";
      break;
    }
    quoted += ToPrintable(letter);
  }
  return "'" + quoted + "'";
}

//------------------------------------------------------------------------------
void Warnings::Add(
  const Tally& tally, const char* one, const char* many, const char* what, const char* note)
{
  const std::string first = std::string(one) + " " + std::to_string(tally.First) + note;
  if (tally.Count == 1)
  {
    this->Add("1 " + std::string(one) + " " + what + ": " + first);
  }
  else if (tally.Count > 1)
  {
    this->Add(std::to_string(tally.Count) + " " + many + " " + what + ", the first is " + first);
  }
}
}
