// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "HDF5File.h"

#include "Base/Parallel.h"
#include "Intake/Rows/Bytes.h"

#include "vtkSMPTools.h"
#include "vtk_zlib.h"

#include <algorithm>
#include <atomic>
#include <cstring>
#include <iterator>
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
std::int64_t HDF5Object::GetNumber(
  const char* attribute, std::int64_t least, std::int64_t most) const
{
  const std::string name = std::string("the attribute ") + attribute;
  this->Check(H5Aexists(this->Id, attribute) > 0, ErrorKind::Syntax, name, "none");
  const HDF5Id id(H5Aopen(this->Id, attribute, H5P_DEFAULT));
  const HDF5Id type(H5Aget_type(id)), space(H5Aget_space(id));
  long long value = 0;
  this->Check(H5Tget_class(type) == H5T_INTEGER && H5Sget_simple_extent_npoints(space) == 1 &&
      H5Aread(id, H5T_NATIVE_LLONG, &value) >= 0,
    ErrorKind::Syntax, "an integer as " + name, "something else");
  this->File->CheckRange(this->Path, value, least, most, name);
  return value;
}

//------------------------------------------------------------------------------
void HDF5Object::CheckDeclared(const char* attribute, std::int64_t count, const char* what) const
{
  const bool isDeclared = H5Aexists(this->Id, attribute) > 0;
  const std::int64_t declared = isDeclared ? this->GetNumber(attribute) : count;
  this->Check(declared == count, ErrorKind::Count,
    std::to_string(declared) + " " + what + ", as " + attribute + " says", std::to_string(count));
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
bool HDF5Object::Has(const std::string& path) const
{
  const std::size_t slash = path.find('/');
  return slash != std::string::npos
    ? this->Has(path.substr(0, slash)) &&
      this->Open(path.substr(0, slash)).Has(path.substr(slash + 1))
    : !this->Data && H5Lexists(this->Id, path.c_str(), H5P_DEFAULT) > 0;
}

//------------------------------------------------------------------------------
// Goes step by step, as HDF5 would follow links to other files.
HDF5Object HDF5Object::Open(const std::string& path) const
{
  const std::size_t slash = path.find('/');
  if (slash != std::string::npos)
  {
    return this->Open(path.substr(0, slash)).Open(path.substr(slash + 1));
  }
  HDF5Object object;
  object.File = this->File;
  object.Path = this->Path + (this->Path.empty() ? "" : "/") + path;
  object.Check(this->Has(path), ErrorKind::Truncated, "a group or data set", "none");
  H5L_info_t link = {};
  object.Check(
    H5Lget_info(this->Id, path.c_str(), &link, H5P_DEFAULT) >= 0 && link.type == H5L_TYPE_HARD,
    ErrorKind::Unsupported, "an object in this place of the file", "a link");
  object.Id = HDF5Id(H5Oopen(this->Id, path.c_str(), H5P_DEFAULT));
  const H5I_type_t type = H5Iget_type(object.Id);
  object.Check(type == H5I_GROUP || type == H5I_DATASET, ErrorKind::Syntax, "a group or data set",
    object.Id < 0 ? "damaged data" : "something else");
  object.Data = type == H5I_DATASET;
  if (object.Data)
  {
    object.OpenData();
  }
  return object;
}

//------------------------------------------------------------------------------
// Whether the filters are deflate, or shuffle and deflate, which Inflate reverses; an error if
// there are some that are not part of HDF5.
bool HDF5Object::FindFilters(hid_t properties)
{
  const int count = H5Pget_nfilters(properties);
  std::vector<H5Z_filter_t> filters;
  for (int i = 0; i < count; ++i)
  {
    filters.push_back(H5Pget_filter(
      properties, static_cast<unsigned int>(i), nullptr, nullptr, nullptr, 0, nullptr, nullptr));
    // Others would be loaded as plugins.
    this->Check(filters.back() >= 0 && filters.back() < H5Z_FILTER_RESERVED &&
        H5Zfilter_avail(filters.back()) > 0,
      ErrorKind::Unsupported, "filters that are part of HDF5",
      "filter " + std::to_string(filters.back()));
  }
  this->IsShuffled = count == 2 && filters[0] == H5Z_FILTER_SHUFFLE;
  return (count == 1 || this->IsShuffled) && filters.back() == H5Z_FILTER_DEFLATE;
}

//------------------------------------------------------------------------------
// Reads what the data set says about itself, and checks that the file is large enough for it.
void HDF5Object::OpenData()
{
  const HDF5Id properties(H5Dget_create_plist(this->Id)), space(H5Dget_space(this->Id));
  const HDF5Id type(H5Dget_type(this->Id));
  this->Check(
    properties >= 0 && space >= 0 && type >= 0, ErrorKind::Syntax, "a data set", "damaged data");
  const H5D_layout_t layout = H5Pget_layout(properties);
  this->Check((layout == H5D_CHUNKED || layout == H5D_CONTIGUOUS || layout == H5D_COMPACT) &&
      H5Pget_external_count(properties) == 0,
    ErrorKind::Unsupported, "data in this file", "data that are elsewhere");
  const bool isDeflated = this->FindFilters(properties);

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
  this->File->Charge(*this, this->File->Opened.insert(this->Path).second ? memory : 0);

  this->Count = static_cast<std::int64_t>(sizes[0]);
  this->Columns = static_cast<std::int64_t>(sizes[1]);
  this->TypeClass = H5Tget_class(type);
  this->ValueSize = static_cast<int>(valueSize);
  const hid_t types[] = { H5T_NATIVE_INT16, H5T_NATIVE_INT32, H5T_NATIVE_UINT32, H5T_NATIVE_FLOAT,
    H5T_NATIVE_DOUBLE };
  const bool isUsual = std::any_of(
    std::begin(types), std::end(types), [&type](hid_t known) { return H5Tequal(type, known) > 0; });
  if (isChunked && chunk[1] == sizes[1] && isDeflated && isUsual)
  {
    this->ChunkRows = static_cast<std::int64_t>(chunk[0]);
  }
}

//------------------------------------------------------------------------------
// Inflates chunks, each by any thread, unless they are at hand.
void HDF5Object::Inflate(std::int64_t first, std::int64_t last) const
{
  const std::int64_t rowSize = this->Columns * this->ValueSize, size = this->ChunkRows * rowSize;
  const std::int64_t lastInflated = this->FirstInflated + this->Inflated.size() / size - 1;
  if (first >= this->FirstInflated && last <= lastInflated)
  {
    return;
  }
  Buffer<char> all((last - first + 1) * size);
  const std::int64_t known = first == lastInflated; // number of those at hand
  std::copy_n(
    this->Inflated.data() + this->Inflated.size() - known * size, known * size, all.data());
  const auto fileSize = static_cast<hsize_t>(this->File->Size);
  std::vector<std::pair<haddr_t, hsize_t>> places; // of the bytes in the file
  for (std::int64_t i = first + known; i <= last; ++i)
  {
    const hsize_t row[2] = { static_cast<hsize_t>(i * this->ChunkRows), 0 };
    unsigned int skipped = 0; // filters
    haddr_t begin = 0;
    hsize_t bytes = 0;
    this->Check(H5Dget_chunk_info_by_coord(this->Id, row, &skipped, &begin, &bytes) >= 0 &&
        skipped == 0 && bytes > 0 && begin <= fileSize && bytes <= fileSize - begin,
      ErrorKind::Truncated, "data that can be inflated", "damaged data");
    places.emplace_back(begin, bytes);
  }
  std::atomic<bool> areGood{ true };
  ParallelFor(static_cast<vtkIdType>(places.size()), 1,
    [&](vtkIdType begin, vtkIdType end)
    {
      std::vector<char> shuffled(this->IsShuffled ? static_cast<std::size_t>(size) : 0);
      for (vtkIdType i = begin; i < end; ++i)
      {
        const auto [from, bytes] = places[static_cast<std::size_t>(i)];
        // Some programs store only the rows that are in the last chunk.
        const std::int64_t rows = std::min<std::int64_t>(
          this->ChunkRows, this->Count - (first + known + i) * this->ChunkRows);
        auto length = static_cast<uLongf>(size);
        char* const values = all.data() + (known + i) * size;
        char* const to = this->IsShuffled ? shuffled.data() : values;
        if (uncompress(reinterpret_cast<Bytef*>(to), &length,
              reinterpret_cast<const Bytef*>(this->File->Begin + from),
              static_cast<uLong>(bytes)) != Z_OK ||
          length < static_cast<uLongf>(rows * rowSize))
        {
          areGood = false;
        }
        else if (this->IsShuffled)
        {
          Unshuffle(to, static_cast<std::ptrdiff_t>(length), this->ValueSize, values);
        }
      }
    });
  this->Check(areGood, ErrorKind::Truncated, "data that can be inflated", "damaged data");
  this->FirstInflated = first;
  this->Inflated = std::move(all);
}

//------------------------------------------------------------------------------
template <typename Stored, typename Value>
void HDF5Object::ReadInflated(std::int64_t first, std::int64_t count, Value* values) const
{
  this->Inflate(first / this->ChunkRows, (first + count - 1) / this->ChunkRows);
  const auto* const from = reinterpret_cast<const Stored*>(this->Inflated.data());
  std::copy_n(from + (first - this->FirstInflated * this->ChunkRows) * this->Columns,
    count * this->Columns, values);
}

//------------------------------------------------------------------------------
void HDF5Object::ReadAs(hid_t type, std::int64_t first, std::int64_t count, void* values) const
{
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
template <typename Value>
void HDF5Object::Read(std::int64_t first, std::int64_t count, Value* values) const
{
  constexpr bool IsReal = std::is_floating_point<Value>::value;
  using Small = std::conditional_t<IsReal, float, std::int16_t>;
  this->Check(this->Data && this->TypeClass == (IsReal ? H5T_FLOAT : H5T_INTEGER),
    ErrorKind::Syntax, IsReal ? "a data set of reals" : "a data set of integers", "something else");
  if (this->ChunkRows == 0 && count > 0)
  {
    this->ReadAs(IsReal ? H5T_NATIVE_DOUBLE : H5T_NATIVE_INT32, first, count, values);
  }
  else if (count > 0)
  {
    this->ValueSize == sizeof(Small) ? this->ReadInflated<Small>(first, count, values)
                                     : this->ReadInflated<Value>(first, count, values);
  }
}
template void HDF5Object::Read(std::int64_t, std::int64_t, std::int32_t*) const;
template void HDF5Object::Read(std::int64_t, std::int64_t, double*) const;

//------------------------------------------------------------------------------
std::vector<std::int32_t> HDF5Object::ReadNumbers() const
{
  this->CheckColumns(1);
  std::vector<std::int32_t> values(static_cast<std::size_t>(this->Count));
  this->Read(0, this->Count, values.data());
  return values;
}

//------------------------------------------------------------------------------
std::string HDF5Object::ReadText() const
{
  this->Check(this->Data && this->TypeClass == H5T_STRING && this->Count == 1 && this->Columns == 1,
    ErrorKind::Syntax, "one string", "something else");
  const HDF5Id type(H5Dget_type(this->Id));
  if (H5Tis_variable_str(type) > 0)
  {
    char* words = nullptr;
    this->ReadAs(type, 0, 1, &words);
    const std::string text = words ? words : "";
    H5free_memory(words);
    return text;
  }
  std::string text(static_cast<std::size_t>(this->ValueSize), '\0');
  this->ReadAs(type, 0, 1, text.data());
  text.resize(std::strlen(text.c_str()));
  return text;
}

//------------------------------------------------------------------------------
bool HDF5File::IsHDF5(const char* begin, const char* end)
{
  constexpr std::string_view Signature("\x89HDF\r\n\x1a\n", 8);
  const std::string_view bytes(begin, static_cast<std::size_t>(end - begin));
  return bytes.substr(0, Signature.size()) == Signature;
}

//------------------------------------------------------------------------------
HDF5File::HDF5File(std::string name, const char* begin, const char* end, double expected)
  : Name(std::move(name))
  , Begin(begin)
  , Size(static_cast<double>(end - begin))
  , Budget(MostInflation * Size + SmallBudget + expected)
{
  const bool isHDF5 = IsHDF5(begin, end);
  this->Id = HDF5Id(isHDF5
      ? H5LTopen_file_image(const_cast<char*>(begin), static_cast<std::size_t>(end - begin),
          H5LT_FILE_IMAGE_DONT_COPY | H5LT_FILE_IMAGE_DONT_RELEASE)
      : -1);
  if (this->Id < 0)
  {
    this->Fail("", isHDF5 ? ErrorKind::Truncated : ErrorKind::NotThisFormat, "a file of HDF5",
      begin == end ? "an empty file"
        : isHDF5   ? "a damaged or incomplete one"
                   : "another beginning");
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
}
