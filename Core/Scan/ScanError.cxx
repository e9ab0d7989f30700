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
std::string Warning::GetSentence() const
{
  if (this->Found.Count == 0)
  {
    return this->What;
  }
  const std::string first = this->One + " " + std::to_string(this->Found.First) + this->Note;
  return this->Found.Count == 1 ? "1 " + this->One + " " + this->What + ": " + first
                                : std::to_string(this->Found.Count) + " " + this->Many + " " +
      this->What + ", the first is " + first;
}

//------------------------------------------------------------------------------
void Warnings::Add(
  const Tally& tally, const char* one, const char* many, const char* what, const char* note)
{
  if (tally.Count > 0)
  {
    this->Add(Warning{ what, tally, one, many, note });
  }
}

//------------------------------------------------------------------------------
std::vector<std::string> Warnings::GetSentences() const
{
  std::vector<std::string> sentences;
  for (const Warning& warning : this->All)
  {
    sentences.push_back(warning.GetSentence());
  }
  return sentences;
}
}
