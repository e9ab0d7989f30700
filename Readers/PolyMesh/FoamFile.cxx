// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FoamFile.h"

#include "Intake/Rows/Bytes.h"

#include "vtk_zlib.h"

#include <charconv>
#include <new>

namespace camaron
{
//------------------------------------------------------------------------------
class FoamFile::Compressor
{
public:
  Compressor()
  {
    constexpr int Window = 15, AsGzip = 16, Memory = 8;
    if (deflateInit2(&this->Stream, Z_DEFAULT_COMPRESSION, Z_DEFLATED, Window + AsGzip, Memory,
          Z_DEFAULT_STRATEGY) != Z_OK)
    {
      throw std::bad_alloc();
    }
  }
  ~Compressor() { deflateEnd(&this->Stream); }
  Compressor(const Compressor&) = delete;
  Compressor& operator=(const Compressor&) = delete;

  /// Gives the bytes, and all the rest at the end, to a file.
  void Write(const std::string& bytes, bool isEnd, OutputFile& file)
  {
    constexpr std::size_t Size = 1 << 16;
    char out[Size];
    this->Stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
    this->Stream.avail_in = static_cast<uInt>(bytes.size());
    do
    {
      this->Stream.next_out = reinterpret_cast<Bytef*>(out);
      this->Stream.avail_out = static_cast<uInt>(Size);
      deflate(&this->Stream, isEnd ? Z_FINISH : Z_NO_FLUSH);
      file.Write(out, Size - this->Stream.avail_out);
    } while (this->Stream.avail_out == 0);
  }

private:
  z_stream Stream = {};
};

//------------------------------------------------------------------------------
FoamFile::FoamFile(const std::string& folder, const std::string& name, const std::string& kind,
  const FoamEncoding& encoding, const std::string& note)
  : File(folder + "/" + name + (encoding.IsCompressed ? ".gz" : ""))
  , Encoding(encoding)
{
  if (encoding.IsCompressed)
  {
    this->Gzip = std::make_unique<Compressor>();
  }
  const std::string order = GetByteOrder() == ByteOrder::Little ? "LSB" : "MSB";
  const std::string label = encoding.Has64BitLabels ? "64" : "32";
  const bool isSet = kind == "cellSet";
  this->Write("FoamFile\n{\n    version     2.0;\n    format      " +
    std::string(encoding.IsBinary ? "binary" : "ascii") + ";\n    arch        \"" + order +
    ";label=" + label + ";scalar=64\";\n    class       " + kind + ";\n" +
    (note.empty() ? "" : "    note        \"" + note + "\";\n") +
    "    location    \"constant/polyMesh" + (isSet ? "/sets" : "") + "\";\n    object      " +
    name + ";\n}\n");
}

//------------------------------------------------------------------------------
FoamFile::~FoamFile() = default;

//------------------------------------------------------------------------------
void FoamFile::Write(const std::string& bytes)
{
  if (this->Gzip)
  {
    this->Gzip->Write(bytes, false, this->File);
  }
  else
  {
    this->File.Write(bytes);
  }
}

//------------------------------------------------------------------------------
bool FoamFile::Finish(bool isWritten, ScanError& error)
{
  if (this->Gzip && isWritten)
  {
    this->Gzip->Write("", true, this->File);
  }
  return this->File.Finish(isWritten, error);
}

//------------------------------------------------------------------------------
void FoamFile::AppendLabel(std::string& bytes, vtkIdType label) const
{
  if (!this->Encoding.IsBinary)
  {
    char digits[24]; // enough for 64 bits
    bytes.append(digits, std::to_chars(digits, digits + sizeof(digits), label).ptr);
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
