// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file MAPDLDeck.h
 * @brief Contents of a deck of Mechanical APDL commands, and their positions in the text.
 */
#ifndef camaron_MAPDLDeck_h
#define camaron_MAPDLDeck_h

#include "MAPDLBlocks.h"

#include <deque> // for what single commands define; vectors would grow by copying
#include <map>   // for types
#include <set>   // for names

namespace camaron
{
/// Nodes or elements of a block, or of consecutive commands.
template <typename RowFormat, typename RowItem>
struct MAPDLBlock
{
  RowFormat Format;
  MAPDLExtent Extent;         ///< empty for commands
  vtkIdType FirstCommand = 0; ///< among MAPDLDeck::Nodes or MAPDLDeck::Elements
  vtkIdType NumberOfCommands = 0;

  /// Calls @a visit(item) for all rows of the block, in order; false with the first fault.
  template <typename Visit>
  bool ForEachRow(MAPDLFault& fault, Visit&& visit) const
  {
    RowItem item;
    return ForEachMAPDLRow(this->Extent, fault,
      [&](const Line& line, vtkIdType)
      {
        const char* const next = this->Format.Read(line, this->Extent.End, item, fault);
        if (next)
        {
          visit(item);
        }
        return next;
      });
  }
};
using MAPDLNodeBlock = MAPDLBlock<MAPDLNodeFormat, MAPDLNode>;
using MAPDLElementBlock = MAPDLBlock<MAPDLElementFormat, MAPDLElement>;

/// An element type of the deck.
struct MAPDLType
{
  int Element = 0; ///< number of the element, 0 if unknown
  int Shape = 0;   ///< KEYOPT(1)
};

/// A named set of nodes or elements.
struct MAPDLComponent
{
  std::string Name; ///< in upper case
  bool OfNodes = true;
  MAPDLRowFormat Fields;
  const char* Begin = nullptr;
  const char* End = nullptr;
  std::int64_t NumberOfValues = -1; ///< as declared, or -1
  bool IsEnded = true;              ///< not by the end of the file
};

/// Commands that are not executed although the mesh may depend on them.
struct MAPDLSkipped
{
  vtkIdType Number = 0;
  std::set<std::string> Names;
  void Add(const char* name)
  {
    ++this->Number;
    this->Names.insert(name);
  }
};

/// "NGEN, VMESH".
std::string JoinMAPDLNames(const std::set<std::string>& names);

struct MAPDLDeck
{
  std::vector<MAPDLNodeBlock> NodeBlocks;
  std::deque<MAPDLNode> Nodes; ///< of N commands
  std::vector<MAPDLElementBlock> ElementBlocks;
  std::map<std::int64_t, MAPDLType> Types;
  MAPDLType GetType(std::int64_t id) const
  {
    const auto found = this->Types.find(id);
    return found == this->Types.end() ? MAPDLType() : found->second;
  }
  std::vector<MAPDLComponent> Components;

  ///@{
  /// Elements of E and EN commands; their nodes are stored consecutively.
  struct Element
  {
    std::int32_t Id;
    std::int32_t Attributes; ///< index of the attributes
    vtkIdType FirstNode;
    const char* Place;
  };
  std::deque<Element> Elements;
  std::deque<std::int32_t> ElementNodes;
  std::vector<MAPDLElement> Attributes; ///< without id and nodes
  MAPDLElement GetElement(vtkIdType i) const;
  /// Position of the first node; beyond the last element, their total number.
  vtkIdType GetFirstNode(vtkIdType element) const
  {
    return element < static_cast<vtkIdType>(this->Elements.size())
      ? this->Elements[element].FirstNode
      : static_cast<vtkIdType>(this->ElementNodes.size());
  }
  vtkIdType GetNumberOfNodes(vtkIdType element) const
  {
    return this->GetFirstNode(element + 1) - this->GetFirstNode(element);
  }
  ///@}

  ///@{
  /// Data for warnings. Skipped are commands in branches and loops, Ignored all others.
  vtkIdType NumberOfUnknownParameters = 0;
  vtkIdType NumberOfMiscountedBlocks = 0; ///< whose number of rows differs from that declared
  vtkIdType NumberOfTurnedNodes = 0; ///< given in a coordinate system other than the global one
  MAPDLSkipped Skipped, Ignored;
  std::set<std::int32_t> SkippedNodes; ///< whose coordinates are unknown
  /// Why a node of an element may be undefined, as the end of a sentence; empty if nothing was
  /// skipped.
  std::string GetReasonForMissing(std::int32_t node) const;
  ///@}
};

/// What a text may be, by its first part; decks of Abaqus have the same extension.
enum class MAPDLGuess
{
  Deck, ///< with a mesh
  Abaqus,
  Other
};
MAPDLGuess GuessMAPDL(const char* begin, const char* end);
}

#endif
