// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "HDF5File.h"

#include "Base/Parallel.h"

#include "vtk_hdf5.h"
#include "vtk_zlib.h"

#include <algorithm>
#include <atomic>
#include <cstring>
#include <limits>
#include <string_view>
#include <type_traits>

namespace camaron
{
namespace
{
/// Bytes that deflate can make of one.
constexpr double MostDeflation = 1032;
/// Bytes of all data sets for each byte of the file, as for files of gzip.
constexpr double MostInflation = 100;
/// More than that, a small file may need.
constexpr double SmallBudget = 1 << 20;

//------------------------------------------------------------------------------
std::string CountBytes(double bytes)
{
  constexpr double Large = 1e15; // numbers of this size are of no use
  return bytes < Large ? std::to_string(static_cast<std::int64_t>(bytes)) + " bytes"
                       : "more than 1e15 bytes";
}

//------------------------------------------------------------------------------
// A number as another type; integers with more than 32 bits become the smallest or greatest.
template <typename Value, typename Stored>
Value Convert(Stored value)
{
  if constexpr (std::is_integral<Stored>::value && sizeof(Stored) > sizeof(Value))
  {
    using Limits = std::numeric_limits<Value>;
    const bool isNegative = std::is_signed<Stored>::value && value < Stored(0);
    return isNegative
      ? static_cast<Value>(std::max<std::int64_t>(static_cast<std::int64_t>(value), Limits::min()))
      : static_cast<Value>(
          std::min<std::uint64_t>(static_cast<std::uint64_t>(value), Limits::max()));
  }
  else
  {
    return static_cast<Value>(value);
  }
}

//------------------------------------------------------------------------------
herr_t AddName(hid_t, const char* name, const H5L_info_t*, void* names)
{
  try
  {
    static_cast<std::vector<std::string>*>(names)->emplace_back(name);
    return 0;
  }
  catch (const std::bad_alloc&)
  {
    return -1;
  }
}
}

//------------------------------------------------------------------------------
HDF5Id::~HDF5Id()
{
  if (this->Id >= 0)
  {
    H5Idec_ref(this->Id);
  }
}

//------------------------------------------------------------------------------
HDF5Silence::HDF5Silence()
{
  H5Eget_auto2(H5E_DEFAULT, &this->Reporter, &this->Data);
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

//------------------------------------------------------------------------------
HDF5Silence::~HDF5Silence()
{
  H5Eset_auto2(H5E_DEFAULT, this->Reporter, this->Data);
}

//------------------------------------------------------------------------------
void HDF5Object::Fail(ErrorKind kind, const std::string& expected, const std::string& found) const
{
  throw HDF5Error{ { kind,
    this->File->GetName() + ": " + (this->Path.empty() ? "" : this->Path + ": ") + "expected " +
      expected + ", found " + found } };
}

//------------------------------------------------------------------------------
void HDF5Object::FailAt(
  std::int64_t index, ErrorKind kind, const std::string& expected, const std::string& found) const
{
  throw HDF5Error{ { kind,
    this->File->GetName() + ": " + this->Path + "[" + std::to_string(index) + "]: expected " +
      expected + ", found " + found } };
}

//------------------------------------------------------------------------------
std::optional<std::int64_t> HDF5Object::FindNumber(const char* attribute) const
{
  if (H5Aexists(this->Id, attribute) <= 0)
  {
    return std::nullopt;
  }
  const HDF5Id id(H5Aopen(this->Id, attribute, H5P_DEFAULT));
  const HDF5Id type(id < 0 ? -1 : H5Aget_type(id)), space(id < 0 ? -1 : H5Aget_space(id));
  long long value = 0;
  const bool isRead = type >= 0 && space >= 0 && H5Tget_class(type) == H5T_INTEGER &&
    H5Sget_simple_extent_npoints(space) == 1 && H5Aread(id, H5T_NATIVE_LLONG, &value) >= 0;
  this->Check(isRead, ErrorKind::Syntax, std::string("an integer as the attribute ") + attribute,
    "something else");
  return value;
}

//------------------------------------------------------------------------------
std::int64_t HDF5Object::GetNumber(const char* attribute) const
{
  const std::optional<std::int64_t> value = this->FindNumber(attribute);
  this->Check(
    value.has_value(), ErrorKind::Syntax, std::string("the attribute ") + attribute, "none");
  return *value;
}

//------------------------------------------------------------------------------
std::vector<std::string> HDF5Object::GetNames() const
{
  std::vector<std::string> names;
  hsize_t first = 0;
  this->Check(!this->Data &&
      H5Literate(this->Id, H5_INDEX_NAME, H5_ITER_NATIVE, &first, AddName, &names) >= 0,
    ErrorKind::Syntax, "a group", this->Data ? "a data set" : "damaged data");
  std::sort(names.begin(), names.end());
  return names;
}

//------------------------------------------------------------------------------
bool HDF5Object::Has(const std::string& name) const
{
  return !this->Data && H5Lexists(this->Id, name.c_str(), H5P_DEFAULT) > 0;
}

//------------------------------------------------------------------------------
HDF5Object HDF5Object::Open(const std::string& name) const
{
  return this->OpenAny(name, true);
}

//------------------------------------------------------------------------------
HDF5Object HDF5Object::OpenAny(const std::string& name, bool isNew) const
{
  HDF5Object object;
  object.File = this->File;
  object.Path = this->Path + (this->Path.empty() ? "" : "/") + name;
  object.Check(this->Has(name), ErrorKind::Truncated, "a group or data set", "none");
  H5L_info_t link = {};
  object.Check(
    H5Lget_info(this->Id, name.c_str(), &link, H5P_DEFAULT) >= 0 && link.type == H5L_TYPE_HARD,
    ErrorKind::Unsupported, "an object in this place of the file", "a link");
  object.Id = HDF5Id(H5Oopen(this->Id, name.c_str(), H5P_DEFAULT));
  const H5I_type_t type = object.Id < 0 ? H5I_BADID : H5Iget_type(object.Id);
  object.Check(type == H5I_GROUP || type == H5I_DATASET, ErrorKind::Syntax, "a group or data set",
    object.Id < 0 ? "damaged data" : "something else");
  object.Data = type == H5I_DATASET;
  if (object.Data)
  {
    object.OpenData(isNew);
  }
  return object;
}

//------------------------------------------------------------------------------
void HDF5Object::CheckFilters(std::int64_t properties) const
{
  const int count = H5Pget_nfilters(properties);
  this->Check(count >= 0, ErrorKind::Syntax, "filters", "damaged data");
  for (int i = 0; i < count; ++i)
  {
    unsigned int flags = 0;
    std::size_t values = 0;
    char name[1] = {};
    const H5Z_filter_t filter = H5Pget_filter(properties, static_cast<unsigned int>(i), &flags,
      &values, nullptr, sizeof(name), name, nullptr);
    // Others would be loaded as plugins.
    this->Check(filter >= 0 && filter < H5Z_FILTER_RESERVED && H5Zfilter_avail(filter) > 0,
      ErrorKind::Unsupported, "filters that are part of HDF5", "filter " + std::to_string(filter));
  }
}

//------------------------------------------------------------------------------
// Reads what the data set says about itself, and checks that the file is large enough for it.
void HDF5Object::OpenData(bool isNew)
{
  const HDF5Id properties(H5Dget_create_plist(this->Id)), space(H5Dget_space(this->Id));
  const HDF5Id type(H5Dget_type(this->Id));
  this->Check(
    properties >= 0 && space >= 0 && type >= 0, ErrorKind::Syntax, "a data set", "damaged data");
  const H5D_layout_t layout = H5Pget_layout(properties);
  this->Check((layout == H5D_CHUNKED || layout == H5D_CONTIGUOUS || layout == H5D_COMPACT) &&
      H5Pget_external_count(properties) == 0,
    ErrorKind::Unsupported, "data in this file", "data that are elsewhere");
  this->CheckFilters(properties);

  constexpr int MostDimensions = 2;
  hsize_t sizes[MostDimensions] = { 1, 1 }, chunk[MostDimensions] = { 1, 1 };
  const int dimensions = H5Sget_simple_extent_ndims(space);
  this->Check(dimensions >= 0 && dimensions <= MostDimensions &&
      H5Sget_simple_extent_dims(space, sizes, nullptr) == dimensions,
    ErrorKind::Syntax, "data with one or two dimensions", std::to_string(dimensions));
  const bool isChunked = layout == H5D_CHUNKED;
  this->Check(!isChunked || H5Pget_chunk(properties, dimensions, chunk) == dimensions,
    ErrorKind::Syntax, "chunks of data", "damaged data");

  const auto valueSize = static_cast<double>(H5Tget_size(type));
  const auto getBytes = [valueSize](const hsize_t* of)
  { return static_cast<double>(of[0]) * static_cast<double>(of[1]) * valueSize; };
  const double bytes = getBytes(sizes);
  const double memory = std::max(bytes, isChunked ? getBytes(chunk) : 0);
  const auto stored = static_cast<double>(H5Dget_storage_size(this->Id));
  const double most = stored * (H5Pget_nfilters(properties) > 0 ? MostDeflation : 1);
  this->Check(stored <= this->File->Size && bytes <= most, ErrorKind::Truncated,
    CountBytes(bytes) + " of data",
    CountBytes(std::min(stored, this->File->Size)) + " in the file");
  this->File->Charge(*this, isNew ? memory : 0);

  this->Count = static_cast<std::int64_t>(sizes[0]);
  this->Columns = static_cast<std::int64_t>(sizes[1]);
  this->TypeClass = H5Tget_class(type);
  this->ValueSize = static_cast<int>(valueSize);
  this->IsUnsigned = this->TypeClass == H5T_INTEGER && H5Tget_sign(type) == H5T_SGN_NONE;
  if (isChunked && chunk[1] == sizes[1] && this->MayInflate(properties, type))
  {
    this->ChunkRows = static_cast<std::int64_t>(chunk[0]);
  }
  else if (isChunked)
  {
    // Rows are read in batches; each chunk shall be inflated once for all of them.
    const HDF5Id access(H5Pcreate(H5P_DATASET_ACCESS));
    constexpr std::size_t Slots = 521;
    H5Pset_chunk_cache(access, Slots, static_cast<std::size_t>(getBytes(chunk)), 1);
    HDF5Id again(H5Dopen2(this->File->Id, ("/" + this->Path).c_str(), access));
    this->Check(again >= 0, ErrorKind::Syntax, "a data set", "damaged data");
    this->Id = std::move(again);
  }
}

//------------------------------------------------------------------------------
// Whether the chunks are compressed as usual, with numbers of this processor.
bool HDF5Object::MayInflate(std::int64_t properties, std::int64_t type) const
{
  unsigned int flags = 0;
  std::size_t values = 0;
  char name[1] = {};
  const bool isInteger = this->TypeClass == H5T_INTEGER && this->ValueSize <= 8;
  const HDF5Id native(isInteger ? H5Tget_native_type(type, H5T_DIR_ASCEND) : -1);
  return H5Pget_nfilters(properties) == 1 &&
    H5Pget_filter(properties, 0, &flags, &values, nullptr, sizeof(name), name, nullptr) ==
    H5Z_FILTER_DEFLATE &&
    (isInteger ? H5Tequal(native, type) > 0
               : H5Tequal(type, H5T_NATIVE_DOUBLE) > 0 || H5Tequal(type, H5T_NATIVE_FLOAT) > 0);
}

//------------------------------------------------------------------------------
// A chunk, after inflating it and some that follow, each by any thread.
const char* HDF5Object::Inflate(std::int64_t chunk) const
{
  const std::int64_t size = this->ChunkRows * this->Columns * this->ValueSize;
  if (chunk < this->FirstInflated || chunk >= this->FirstInflated + this->NumberOfInflated)
  {
    // For many threads, but not much of the whole.
    constexpr std::int64_t MostBytes = std::int64_t(1) << 23, Part = 16;
    const std::int64_t all = (this->Count + this->ChunkRows - 1) / this->ChunkRows;
    const std::int64_t count =
      std::max<std::int64_t>(std::min({ MostBytes / size, all / Part, all - chunk }), 1);
    this->NumberOfInflated = 0;
    if (this->Inflated.size() < count * size)
    {
      this->Inflated = Buffer<char>(count * size);
    }
    std::vector<std::vector<Bytef>> stored(static_cast<std::size_t>(count));
    bool good = true;
    for (std::size_t i = 0; i < stored.size() && good; ++i)
    {
      const hsize_t place[2] = {
        static_cast<hsize_t>((chunk + static_cast<std::int64_t>(i)) * this->ChunkRows), 0
      };
      hsize_t bytes = 0;
      std::uint32_t skipped = 0; // filters
      good = H5Dget_chunk_storage_size(this->Id, place, &bytes) >= 0 &&
        static_cast<double>(bytes) <= this->File->Size;
      stored[i].resize(good ? bytes : 0);
      good = good && bytes > 0 &&
        H5Dread_chunk(this->Id, H5P_DEFAULT, place, &skipped, stored[i].data()) >= 0 &&
        skipped == 0;
    }
    std::atomic<bool> areGood{ good };
    ParallelFor(good ? count : 0, 1,
      [&](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType i = begin; i < end; ++i)
        {
          const std::vector<Bytef>& from = stored[static_cast<std::size_t>(i)];
          // Some programs store only the rows that are in the last chunk.
          const std::int64_t rows =
            std::min<std::int64_t>(this->ChunkRows, this->Count - (chunk + i) * this->ChunkRows);
          const auto needed = static_cast<uLongf>(rows * (size / this->ChunkRows));
          auto length = static_cast<uLongf>(size);
          auto* const to = reinterpret_cast<Bytef*>(this->Inflated.data() + i * size);
          if (uncompress(to, &length, from.data(), static_cast<uLong>(from.size())) != Z_OK ||
            length < needed)
          {
            areGood = false;
          }
        }
      });
    this->Check(areGood, ErrorKind::Truncated, "data that can be inflated", "damaged data");
    this->FirstInflated = chunk;
    this->NumberOfInflated = count;
  }
  return this->Inflated.data() + (chunk - this->FirstInflated) * size;
}

//------------------------------------------------------------------------------
template <typename Stored, typename Value>
void HDF5Object::ReadInflated(std::int64_t first, std::int64_t count, Value* values) const
{
  for (std::int64_t row = first; row < first + count;)
  {
    const std::int64_t chunk = row / this->ChunkRows, offset = row % this->ChunkRows;
    const std::int64_t rows = std::min(this->ChunkRows - offset, first + count - row);
    const std::int64_t size = rows * this->Columns;
    const char* from = this->Inflate(chunk) + offset * this->Columns * this->ValueSize;
    for (std::int64_t i = 0; i < size; ++i, from += sizeof(Stored))
    {
      Stored value;
      std::memcpy(&value, from, sizeof(value));
      *values++ = Convert<Value>(value);
    }
    row += rows;
  }
}

//------------------------------------------------------------------------------
void HDF5Object::ReadAs(
  std::int64_t type, std::int64_t first, std::int64_t count, void* values) const
{
  if (count == 0)
  {
    return;
  }
  const HDF5Id space(H5Dget_space(this->Id));
  const hsize_t start[2] = { static_cast<hsize_t>(first), 0 };
  const hsize_t size[2] = { static_cast<hsize_t>(count), static_cast<hsize_t>(this->Columns) };
  const hsize_t total = size[0] * size[1];
  const HDF5Id memory(H5Screate_simple(1, &total, nullptr));
  const int dimensions = H5Sget_simple_extent_ndims(space);
  this->Check((dimensions == 0 ||
                H5Sselect_hyperslab(space, H5S_SELECT_SET, start, nullptr, size, nullptr) >= 0) &&
      H5Dread(this->Id, type, memory, space, H5P_DEFAULT, values) >= 0,
    ErrorKind::Truncated, "data that HDF5 can read", "damaged data");
}

//------------------------------------------------------------------------------
void HDF5Object::Read(std::int64_t first, std::int64_t count, std::int32_t* values) const
{
  this->Check(this->Data && this->TypeClass == H5T_INTEGER, ErrorKind::Syntax,
    "a data set of integers", "something else");
  if (this->ChunkRows == 0)
  {
    const bool isPlain = this->IsUnsigned && this->ValueSize == 4; // which needs no conversion
    this->ReadAs(isPlain ? H5T_NATIVE_UINT32 : H5T_NATIVE_INT32, first, count, values);
    return;
  }
  switch (this->IsUnsigned ? -this->ValueSize : this->ValueSize)
  {
    case 1:
      return this->ReadInflated<std::int8_t>(first, count, values);
    case -1:
      return this->ReadInflated<std::uint8_t>(first, count, values);
    case 2:
      return this->ReadInflated<std::int16_t>(first, count, values);
    case -2:
      return this->ReadInflated<std::uint16_t>(first, count, values);
    case 4:
    case -4:
      return this->ReadInflated<std::int32_t>(first, count, values);
    case 8:
      return this->ReadInflated<std::int64_t>(first, count, values);
    default:
      return this->ReadInflated<std::uint64_t>(first, count, values);
  }
}

//------------------------------------------------------------------------------
void HDF5Object::Read(std::int64_t first, std::int64_t count, double* values) const
{
  this->Check(this->Data && this->TypeClass == H5T_FLOAT, ErrorKind::Syntax, "a data set of reals",
    "something else");
  if (this->ChunkRows == 0)
  {
    return this->ReadAs(H5T_NATIVE_DOUBLE, first, count, values);
  }
  return this->ValueSize == sizeof(float) ? this->ReadInflated<float>(first, count, values)
                                          : this->ReadInflated<double>(first, count, values);
}

//------------------------------------------------------------------------------
std::string HDF5Object::ReadText() const
{
  const HDF5Id type(H5Dget_type(this->Id));
  this->Check(this->Data && this->TypeClass == H5T_STRING && H5Tis_variable_str(type) == 0 &&
      this->Count == 1 && this->Columns == 1,
    ErrorKind::Syntax, "one string of fixed length", "something else");
  std::string text(static_cast<std::size_t>(this->ValueSize), '\0');
  this->ReadAs(type, 0, 1, text.data());
  text.resize(std::strlen(text.c_str()));
  return text;
}

//------------------------------------------------------------------------------
bool HDF5File::IsHDF5(const char* begin, const char* end)
{
  constexpr std::string_view Signature("\x89HDF\r\n\x1a\n", 8);
  return end - begin >= static_cast<std::ptrdiff_t>(Signature.size()) &&
    std::memcmp(begin, Signature.data(), Signature.size()) == 0;
}

//------------------------------------------------------------------------------
HDF5File::HDF5File(std::string name, const char* begin, const char* end, double expected)
  : Name(std::move(name))
  , Size(static_cast<double>(end - begin))
  , Budget(MostInflation * Size + SmallBudget + expected)
{
  static_assert(sizeof(hid_t) == sizeof(std::int64_t), "the identifiers of HDF5");
  const bool isHDF5 = IsHDF5(begin, end);
  this->Id = HDF5Id(isHDF5
      ? H5LTopen_file_image(const_cast<char*>(begin), static_cast<std::size_t>(end - begin),
          H5LT_FILE_IMAGE_DONT_COPY | H5LT_FILE_IMAGE_DONT_RELEASE)
      : -1);
  if (this->Id < 0)
  {
    throw HDF5Error{ { isHDF5 ? ErrorKind::Truncated : ErrorKind::NotThisFormat,
      this->Name + ": expected a file of HDF5, found " +
        (begin == end ? "an empty file"
            : isHDF5  ? "a damaged or incomplete one"
                      : "another beginning") } };
  }
}

//------------------------------------------------------------------------------
HDF5Object HDF5File::GetRoot()
{
  HDF5Object root;
  root.File = this;
  root.Id = HDF5Id(H5Gopen2(this->Id, "/", H5P_DEFAULT));
  root.Check(root.Id >= 0, ErrorKind::Syntax, "a group", "damaged data");
  return root;
}

//------------------------------------------------------------------------------
void HDF5File::Charge(const HDF5Object& object, double bytes)
{
  this->Budget -= bytes;
  object.Check(this->Budget >= 0, ErrorKind::Count,
    "data sets that are together at most " + std::to_string(static_cast<int>(MostInflation)) +
      " times as large as the file",
    "one of " + CountBytes(bytes) + " after others");
}

//------------------------------------------------------------------------------
HDF5Object HDF5File::Reopen(const std::string& path)
{
  HDF5Object object = this->GetRoot();
  for (std::size_t begin = 0; begin < path.size();)
  {
    const std::size_t end = std::min(path.find('/', begin), path.size());
    object = object.OpenAny(path.substr(begin, end - begin), false);
    begin = end + 1;
  }
  return object;
}
}
