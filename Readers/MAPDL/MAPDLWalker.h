// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::MAPDLWalker
 * @brief Walks through the commands of a deck and records its contents.
 */
#ifndef camaron_MAPDLWalker_h
#define camaron_MAPDLWalker_h

#include "MAPDLCommands.h"
#include "MAPDLDeck.h"

#include <initializer_list> // for the keys of a block

namespace camaron
{
class MAPDLWalker
{
public:
  /// Measures large blocks in parallel, in chunks of @a chunk bytes.
  MAPDLWalker(const char* begin, const char* end, vtkIdType chunk, const Progress& progress,
    MAPDLDeck& deck, MAPDLFault& fault)
    : Begin(begin)
    , End(end)
    , Text(begin)
    , Chunk(chunk)
    , Report(progress)
    , Deck(deck)
    , Fault(fault)
  {
    this->Deck.Attributes.emplace_back();
  }

  /// False with the error in the fault, or if aborted.
  bool Walk();

private:
  bool Execute();
  bool ExecuteInBranch();
  static constexpr std::int32_t NoSystem = -2, UnknownSystem = -1;
  std::int32_t GetNewSystem();
  /// Counts the command if it has one of these names.
  template <typename Names>
  void NoteSkipped(const Names& names, MAPDLSkipped& skipped);
  /// Discards everything read so far.
  void Clear();
  bool ReadNodeBlock();
  bool ReadElementBlock();
  /// Reads the key of a block: an index into @a keys, counted from 1, or 0 if blank; false with a
  /// fault for other keys.
  bool TakeKey(const char* command, std::initializer_list<std::string_view> keys, int& key);
  /// Number of fields of the next row of a block.
  int CountFieldsOfRow() const;
  /// Finds out over how many lines elements of a compact block extend; false with a fault if that
  /// is unknown.
  bool FindFurtherLines(MAPDLElementFormat& format);
  void ReadComponent();
  void ReadTypeBlock();
  bool DefineNode();
  bool AddNode(std::int32_t id, std::size_t firstCoordinate);
  bool DefineElement(bool isNumbered);
  void AddElement(std::int32_t id);
  bool AddElementNodes(std::size_t firstField);
  void DefineType();
  void DefineKeyOption();
  void SetAttribute(std::int32_t MAPDLElement::* attribute);
  std::int32_t GetNextNode();
  std::int32_t GetNextElement();

  /// Number in a field; 0 if it is blank; counts unknown values.
  MAPDLParameters::Value ReadField(std::size_t i, std::int32_t& value);
  double GetProgress(const char* text) const
  {
    return static_cast<double>(text - this->Begin) / static_cast<double>(this->End - this->Begin);
  }
  Progress GetRest() const { return this->Report.Part(this->GetProgress(this->Text), 1); }
  /// Reads the format line of a block, if there is one, with at least @a columns integer columns.
  MAPDLRowFormat TakeFormat(int integers, int columns);
  /// Number of rows that a block declares, 0 if it does not.
  std::int32_t GetPromisedRows() const;
  /**
   * Checks the end of a block; false with a fault if it is neither an end mark, nor a command, nor
   * after the declared number of rows.
   * @param checkRows reports an error in a row, which may be why there is no end
   */
  template <typename CheckRows>
  bool CheckEnd(const MAPDLExtent& extent, const char* expected, CheckRows&& checkRows);

  const char* Begin;
  const char* End;
  const char* Text;
  const char* LineBegin = nullptr;
  vtkIdType Chunk;
  Progress Report;
  MAPDLDeck& Deck;
  MAPDLFault& Fault;
  MAPDLCommand Command;
  MAPDLParameters Parameters;
  int Depth = 0; ///< of branches and loops that are skipped
  bool Ended = false;
  bool Defines = false; ///< the previous command defined a node or an element
  std::int32_t CoordinateSystem = 0;
  MAPDLElement Current; ///< attributes for E and EN
  bool AttributesChanged = false;
  bool ElementIsOpen = false; ///< EMORE may follow
  int ElementLines = 0;       ///< of nodes of the open element
  ///@{
  /// Greatest ids of the first KnownNodeBlocks blocks; updated when a command without id needs
  /// them.
  std::int32_t GreatestNode = 0, GreatestElement = 0;
  std::size_t KnownNodeBlocks = 0, KnownElementBlocks = 0;
  ///@}
  bool NextNodeIsKnown = true; ///< false after an N with unknown id, which may be the greatest
};
}

#endif
