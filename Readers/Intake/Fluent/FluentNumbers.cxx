// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Intake/Fluent/FluentNumbers.h"

#include "Base/Parallel.h"
#include "Base/Progress.h"
#include "Intake/Rows/TextLines.h"

#include <algorithm>
#include <cstring>
#include <numeric>
#include <vector>

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
const char* ParseWord(const char* text, const char* end, std::int32_t& value)
{
  return ParseHex(text, end, value);
}
const char* ParseWord(const char* text, const char* end, double& value)
{
  text = ParseReal(SkipSpaceFrom(text, end), end, value);
  return text && (text == end || IsSpace(*text)) ? text : nullptr;
}
}

//------------------------------------------------------------------------------
// Words that begin in some bytes: few at a time, so that many are counted at once.
template <typename Number>
vtkIdType FluentNumbers<Number>::CountWords(vtkIdType first, vtkIdType last) const
{
  const char* const text = this->Begin;
  vtkIdType count = first == 0 && last > 0 && !IsSpace(text[0]);
  for (vtkIdType i = std::max<vtkIdType>(first, 1); i < last;)
  {
    constexpr vtkIdType Few = 128;
    unsigned char some = 0;
    for (const vtkIdType end = std::min(i + Few, last); i < end; ++i)
    {
      some = static_cast<unsigned char>(some + (IsSpace(text[i - 1]) & !IsSpace(text[i])));
    }
    count += some;
  }
  return count;
}

//------------------------------------------------------------------------------
template <typename Number>
void FluentNumbers<Number>::Read(std::ptrdiff_t bytes, bool inPlace)
{
  if (this->Bytes == 0)
  {
    this->ReadText(bytes);
    return;
  }
  this->Count = this->Words = std::min(bytes, this->End - this->Begin) / this->Bytes;
  this->Last = this->Begin + this->Count * this->Bytes;
  const bool isSame = !this->Swap && this->Bytes == sizeof(Number);
  if (isSame && inPlace)
  {
    this->Data = reinterpret_cast<const Unaligned<Number>*>(this->Begin);
    return;
  }
  this->MakeRoom();
  ParallelFor(this->Count, LightGrain,
    [this, isSame](vtkIdType begin, vtkIdType end)
    {
      const char* place = this->Begin + begin * this->Bytes;
      if (isSame)
      {
        std::memcpy(&this->Numbers[begin], place, (end - begin) * sizeof(Number));
      }
      for (vtkIdType i = begin; i < end && !isSame; ++i, place += this->Bytes)
      {
        this->Numbers[i] = this->Bytes == sizeof(Number)
          ? Load<Number>(place, this->Swap)
          : static_cast<Number>(Load<float>(place, this->Swap));
      }
    });
}

//------------------------------------------------------------------------------
template <typename Number>
void FluentNumbers<Number>::MakeRoom()
{
  if (this->Numbers.size() < this->Words)
  {
    this->Numbers = Buffer<Number>(this->Words);
  }
  this->Data = reinterpret_cast<const Unaligned<Number>*>(this->Numbers.data());
}

//------------------------------------------------------------------------------
template <typename Number>
void FluentNumbers<Number>::ReadText(std::ptrdiff_t bytes)
{
  this->Last = this->End - this->Begin > bytes
    ? std::find_if(this->Begin + bytes, this->End, IsSpace)
    : this->End;
  constexpr vtkIdType MaxChunk = vtkIdType(1) << 16; // several per batch
  const vtkIdType chunk = std::min(TextLines::DefaultChunk, MaxChunk);
  const vtkIdType size = this->Last - this->Begin, chunks = (size + chunk - 1) / chunk;
  std::vector<vtkIdType> places(static_cast<std::size_t>(chunks) + 1, 0); // of the first words
  Progress().For(chunks,
    [&](vtkIdType first, vtkIdType last)
    {
      for (vtkIdType i = first; i < last; ++i)
      {
        places[i + 1] = this->CountWords(i * chunk, std::min(size, (i + 1) * chunk));
      }
    });
  std::partial_sum(places.begin(), places.end(), places.begin());
  this->Words = places.back();
  this->MakeRoom();
  std::atomic<vtkIdType> bad{ this->Words };
  Progress().For(chunks,
    [&](vtkIdType first, vtkIdType last)
    {
      const char* text = this->Begin + first * chunk;
      while (first > 0 && text < this->Last && !IsSpace(text[-1]))
      {
        ++text; // the rest of a word of the chunk before
      }
      for (vtkIdType word = places[first]; word < places[last] && text; ++word)
      {
        text = ParseWord(text, this->Last, this->Numbers[word]);
        if (!text)
        {
          LowerTo(bad, word);
        }
      }
    });
  this->Count = bad;
}

//------------------------------------------------------------------------------
template <typename Number>
void FluentNumbers<Number>::Skip(std::int64_t count)
{
  if (this->Bytes > 0)
  {
    this->Begin = this->Find(count);
    return;
  }
  // Back from the end, as few are left.
  const char* place = this->Last;
  const auto skipBack = [&](bool spaces)
  {
    while (place > this->Begin && IsSpace(place[-1]) == spaces)
    {
      --place;
    }
  };
  skipBack(true);
  for (; count < this->Words; ++count)
  {
    skipBack(false);
    skipBack(true);
  }
  this->Begin = place;
}

//------------------------------------------------------------------------------
template <typename Number>
const char* FluentNumbers<Number>::Find(std::int64_t i) const
{
  if (this->Bytes > 0)
  {
    return this->Begin + i * this->Bytes;
  }
  const char* place = SkipSpaceFrom(this->Begin, this->End);
  for (; i > 0; --i)
  {
    place = SkipSpaceFrom(std::find_if(place, this->End, IsSpace), this->End);
  }
  return place;
}

template class FluentNumbers<std::int32_t>;
template class FluentNumbers<double>;
}
