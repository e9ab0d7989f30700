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
  }

  /// False with the error in the fault, or if aborted.
  bool Walk();

private:
  /// A command with an effect on the mesh.
  struct Effect
  {
    const char* Name;
    bool (MAPDLWalker::*Execute)();
    bool DefinesMesh = true; ///< is skipped in branches and loops, with a warning
  };
  static const Effect Effects[];
  bool Execute();

  ///@{
  /// Effects; false with a fault, or if aborted.
  bool DefineNode();
  bool DefineElement();
  bool DefineNumberedElement();
  bool ContinueElement();
  bool ReadNodeBlock();
  bool ReadElementBlock();
  bool ReadComponent();
  bool ReadTypeBlock();
  bool DefineType();
  bool DefineKeyOption();
  template <std::int32_t MAPDLElement::* Attribute>
  bool SetAttribute();
  bool SetParameter();
  bool SetSystem();
  bool BeginBranch();
  bool EndBranch();
  bool Clear();
  bool Finish();
  ///@}

  bool AddNode(std::int32_t id, std::size_t firstCoordinate);
  bool DefineUnblockedElement();
  bool AddElement(std::int32_t id);
  bool AddElementNodes(std::size_t firstField);
  template <typename Block>
  static std::int32_t GetNext(
    const std::vector<Block>& blocks, std::size_t& known, std::int32_t& greatest);
  std::int32_t GetNextNode();
  std::int32_t GetNextElement();

  /// Number in a field; 0 if it is blank; counts unknown values.
  MAPDLParameters::Value ReadField(std::size_t i, std::int32_t& value);
  double GetProgress(const char* text) const
  {
    return static_cast<double>(text - this->Begin) / static_cast<double>(this->End - this->Begin);
  }
  /// Reads the key of a block: an index into @a keys, counted from 1, or 0 if blank; false with a
  /// fault for other keys.
  bool TakeKey(const char* command, std::initializer_list<std::string_view> keys, int& key);
  /// Reads the format line of a block, which begins with at least so many integer columns.
  bool TakeFormat(int integers, MAPDLRowFormat& format);
  bool Measure(FunctionRef<int(const Line&)> getFurtherLines, MAPDLExtent& extent);
  /// Number of rows that a block declares, 0 if it does not.
  std::int32_t GetPromisedRows() const;
  /// Moves behind a block; false with a fault if it neither has an end mark nor the declared number
  /// of rows, perhaps because of an error in a row.
  template <typename Block>
  bool TakeEnd(const Block& block, const char* expected);
  bool FindFurtherLines(MAPDLElementFormat& format);

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
  bool DefinesItem = false; ///< the previous command defines a node or an element
  bool IsGlobal = true;     ///< the coordinate system
  MAPDLElement Current;     ///< attributes for E and EN
  bool AttributesChanged = true;
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
