// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "MergedWarnings.h"

#include "Base/Number.h"
#include "Scan/ScanError.h"

#include <algorithm>
#include <set>

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
// A sentence that Warnings creates from a tally: "3 cells not closed, the first is cell 7", "1 cell
// not closed: cell 7".
class CountedSentence
{
public:
  explicit CountedSentence(const std::string& sentence)
    : Text(sentence)
  {
    const std::size_t count = sentence.find(' ');
    const std::size_t noun = count == std::string::npos ? count : sentence.find(' ', count + 1);
    if (noun == std::string::npos || !ReadNumber(0, count, this->Found.Count))
    {
      return;
    }
    constexpr char Many[] = ", the first is ", One[] = ": ";
    const char* const link = this->Found.Count == 1 ? One : Many;
    const std::size_t end = sentence.rfind(link);
    const std::size_t place =
      end == std::string::npos ? end : end + std::char_traits<char>::length(link);
    const std::size_t id = place == std::string::npos ? place : sentence.find(' ', place);
    if (id == std::string::npos || end < noun)
    {
      return;
    }
    const std::size_t idEnd =
      std::min(sentence.find_first_not_of("0123456789", id + 1), sentence.size());
    this->IsCounted = ReadNumber(id + 1, idEnd, this->Found.First);
    this->Plural = sentence.substr(count + 1, noun - count - 1);
    this->Singular = sentence.substr(place, id - place);
    this->What = sentence.substr(noun + 1, end - noun - 1);
    this->Note = sentence.substr(idEnd);
  }

  bool IsOfKind(const CountedSentence& other) const
  {
    return this->IsCounted && other.IsCounted && this->Singular == other.Singular &&
      this->What == other.What && this->Note == other.Note;
  }
  /// Adds the count of another rank.
  void Merge(const CountedSentence& other)
  {
    this->Plural = this->Found.Count == 1 ? other.Plural : this->Plural;
    this->Found.Merge(other.Found);
    // If two ranks found one each, the plural is not known.
    const std::string many = this->Plural == this->Singular ? this->Singular + "s" : this->Plural;
    Warnings wording;
    wording.Add(
      this->Found, this->Singular.c_str(), many.c_str(), this->What.c_str(), this->Note.c_str());
    this->Text = wording.GetSentences()[0];
  }

  std::string Text;

private:
  bool ReadNumber(std::size_t begin, std::size_t end, vtkIdType& number) const
  {
    std::int64_t value = 0;
    const char* const last = this->Text.data() + end;
    const bool good = end > begin && ParseInteger(this->Text.data() + begin, last, value) == last;
    number = static_cast<vtkIdType>(value);
    return good;
  }

  bool IsCounted = false;
  Tally Found;
  std::string Singular, Plural, What, Note;
};
}

//------------------------------------------------------------------------------
std::vector<std::string> MergeWarnings(const std::vector<std::vector<std::string>>& ofProcesses)
{
  std::vector<CountedSentence> merged;
  std::set<std::string> said;
  for (const std::vector<std::string>& sentences : ofProcesses)
  {
    std::size_t next = 0; // position of the warning after the last known one
    for (const std::string& text : sentences)
    {
      const CountedSentence sentence(text);
      const auto known =
        std::find_if(merged.begin(), merged.end(), [&](const CountedSentence& other)
          { return other.Text == text || other.IsOfKind(sentence); });
      const bool isNew = said.insert(text).second;
      if (known != merged.end())
      {
        if (isNew)
        {
          known->Merge(sentence);
        }
        next = static_cast<std::size_t>(known - merged.begin()) + 1;
      }
      else if (isNew)
      {
        merged.insert(merged.begin() + static_cast<std::ptrdiff_t>(next), sentence);
        ++next;
      }
    }
  }
  std::vector<std::string> texts;
  for (const CountedSentence& sentence : merged)
  {
    texts.push_back(sentence.Text);
  }
  return texts;
}
}
