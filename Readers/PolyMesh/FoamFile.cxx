// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FoamFile.h"

#include "Base/Number.h"
#include "Intake/Rows/Bytes.h"

#include <cerrno>
#include <cstring>

namespace camaron
{
//------------------------------------------------------------------------------
FoamFile::FoamFile(const std::filesystem::path& folder, const std::string& name,
  const std::string& kind, const FoamEncoding& encoding, const std::string& note)
  : Name(name + (encoding.IsCompressed ? ".gz" : ""))
  , Encoding(encoding)
{
  const std::string path = (folder / this->Name).string();
  this->File = gzopen(path.c_str(), encoding.IsCompressed ? "wb" : "wbT"); // T: not compressed
  if (!this->File)
  {
    this->Fail();
    return;
  }
  const std::string order = GetByteOrder() == ByteOrder::Little ? "LSB" : "MSB";
  this->Write("FoamFile\n{\n    version     2.0;\n    format      " +
    std::string(encoding.IsBinary ? "binary" : "ascii") + ";\n    arch        \"" + order +
    ";label=" + (encoding.Has64BitLabels ? "64" : "32") + ";scalar=64\";\n    class       " + kind +
    ";\n" + (note.empty() ? "" : "    note        \"" + note + "\";\n") +
    "    location    \"constant/polyMesh" + (kind == "cellSet" ? "/sets" : "") +
    "\";\n    object      " + name + ";\n}\n");
}

//------------------------------------------------------------------------------
FoamFile::~FoamFile()
{
  if (this->File)
  {
    gzclose(this->File);
  }
}

//------------------------------------------------------------------------------
void FoamFile::Write(const std::string& bytes)
{
  if (!this->HasFailed() && !bytes.empty() &&
    gzwrite(this->File, bytes.data(), static_cast<unsigned>(bytes.size())) <= 0)
  {
    this->Fail();
  }
}

//------------------------------------------------------------------------------
bool FoamFile::Finish(bool isWritten, ScanError& error)
{
  if (this->File && gzclose(this->File) != Z_OK && !this->HasFailed())
  {
    this->Fail();
  }
  this->File = nullptr;
  error = error ? error : this->Error;
  return isWritten && !this->HasFailed();
}

//------------------------------------------------------------------------------
void FoamFile::Fail()
{
  this->Error = { errno == ENOSPC || errno == EFBIG ? ErrorKind::DiskFull : ErrorKind::Write,
    this->Name + ": cannot write the file: " + std::strerror(errno) };
}

//------------------------------------------------------------------------------
void FoamFile::AppendLabel(std::string& bytes, vtkIdType label) const
{
  if (!this->Encoding.IsBinary)
  {
    AppendNumber(bytes, label);
  }
  else if (this->Encoding.Has64BitLabels)
  {
    AppendBytes(bytes, static_cast<std::int64_t>(label), false);
  }
  else
  {
    AppendBytes(bytes, static_cast<std::int32_t>(label), false);
  }
}
}
