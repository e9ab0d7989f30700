// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::Reducer
 * @brief Communication between ranks, for statistics and for meshes that are split into pieces.
 *
 * Every method is collective: all ranks must call it, in the same order and with the same sizes.
 * Only integers are added, so results do not depend on the number of ranks. This base class
 * implements a single rank; ControllerReducer uses a vtkMultiProcessController.
 */
#ifndef camaron_Reducer_h
#define camaron_Reducer_h

#include <cstddef>     // for std::size_t
#include <cstdint>     // for 64 bit integers
#include <cstring>     // for copies of bytes
#include <set>         // for distinct names
#include <string>      // for names
#include <type_traits> // for what can be sent as bytes
#include <utility>     // for std::move
#include <vector>      // for gathered bytes

namespace camaron
{
class Reducer
{
public:
  virtual ~Reducer() = default;

  virtual int GetNumberOfProcesses() const { return 1; }
  virtual int GetProcess() const { return 0; }

  ///@{
  /// Replaces each entry by its sum, minimum or maximum over all ranks.
  virtual void Sum(std::int64_t*, std::size_t) {}
  virtual void Min(std::int64_t*, std::size_t) {}
  virtual void Max(std::int64_t*, std::size_t) {}
  ///@}

  /// Concatenates the bytes of all ranks, in their order; @a sizes returns the number of bytes of
  /// each.
  virtual std::vector<char> Gather(const std::vector<char>& bytes, std::vector<std::size_t>& sizes)
  {
    sizes.assign(1, bytes.size());
    return bytes;
  }

  /// Gather for lists of plain structs. Use it for short lists only, because every rank receives
  /// all.
  template <typename Item>
  std::vector<Item> GatherItems(const std::vector<Item>& items)
  {
    static_assert(std::is_trivially_copyable<Item>::value, "items are sent as bytes");
    const char* begin = reinterpret_cast<const char*>(items.data());
    std::vector<std::size_t> sizes;
    const std::vector<char> bytes =
      this->Gather({ begin, begin + items.size() * sizeof(Item) }, sizes);
    std::vector<Item> result(bytes.size() / sizeof(Item));
    for (std::size_t i = 0; i < result.size(); ++i)
    {
      std::memcpy(&result[i], bytes.data() + i * sizeof(Item), sizeof(Item));
    }
    return result;
  }

  /// Sends list p to rank p; returns the lists received from all ranks, in their order.
  virtual std::vector<std::vector<char>> Exchange(std::vector<std::vector<char>>&& lists)
  {
    return std::move(lists);
  }

  /// Exchange for lists of plain structs.
  template <typename Item>
  std::vector<std::vector<Item>> ExchangeItems(std::vector<std::vector<Item>>&& lists)
  {
    static_assert(std::is_trivially_copyable<Item>::value, "items are sent as bytes");
    if (this->GetNumberOfProcesses() == 1)
    {
      return std::move(lists);
    }
    std::vector<std::vector<char>> bytes;
    for (std::vector<Item>& list : lists)
    {
      const char* begin = reinterpret_cast<const char*>(list.data());
      bytes.emplace_back(begin, begin + list.size() * sizeof(Item));
      std::vector<Item>().swap(list);
    }
    bytes = this->Exchange(std::move(bytes));
    std::vector<std::vector<Item>> result;
    for (std::vector<char>& list : bytes)
    {
      result.emplace_back(list.size() / sizeof(Item));
      if (!list.empty())
      {
        std::memcpy(result.back().data(), list.data(), list.size());
      }
      std::vector<char>().swap(list);
    }
    return result;
  }

  /**
   * Answers each question on the rank @a choose(question), and returns the answers in the order of
   * the questions. @a answer(lists) receives the questions of all ranks, and must return a list of
   * answers of the same size for each of them.
   */
  template <typename Question, typename Choose, typename Answer>
  auto Ask(const std::vector<Question>& questions, Choose&& choose, Answer&& answer)
  {
    const auto numberOfProcesses = static_cast<std::size_t>(this->GetNumberOfProcesses());
    std::vector<std::vector<Question>> sent(numberOfProcesses);
    for (const Question& question : questions)
    {
      sent[choose(question)].push_back(question);
    }
    const auto answers = this->ExchangeItems(answer(this->ExchangeItems(std::move(sent))));
    std::vector<std::size_t> next(numberOfProcesses, 0);
    std::decay_t<decltype(answers[0])> ordered;
    for (const Question& question : questions)
    {
      const auto process = static_cast<std::size_t>(choose(question));
      ordered.push_back(answers[process][next[process]++]);
    }
    return ordered;
  }

  /// The distinct names of all ranks, sorted. Names must not contain zero bytes.
  std::vector<std::string> GatherNames(const std::vector<std::string>& names)
  {
    std::vector<char> bytes;
    for (const std::string& name : names)
    {
      bytes.insert(bytes.end(), name.c_str(), name.c_str() + name.size() + 1);
    }
    std::vector<std::size_t> sizes;
    bytes = this->Gather(bytes, sizes);
    std::set<std::string> result;
    for (std::size_t i = 0; i < bytes.size(); i += std::strlen(&bytes[i]) + 1)
    {
      result.insert(&bytes[i]);
    }
    return { result.begin(), result.end() };
  }
};
}

#endif
