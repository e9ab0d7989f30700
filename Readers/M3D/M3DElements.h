// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file M3DElements.h
 * @brief The elements of M3D, M2D and MVM files: letters, types, rows and materials.
 */
#ifndef camaron_M3DElements_h
#define camaron_M3DElements_h

#include "Mesh/CellShape.h"

#include "vtkCellType.h" // for the types of cells

#include <atomic>      // for what several threads see
#include <cstdint>     // for nodes
#include <mutex>       // for the first material
#include <string_view> // for its text

namespace camaron
{
class TextRow;

enum class M3DDialect
{
  M3D, ///< letters T, P, R, H
  M2D, ///< the same layout with letters t, q
  MVM  ///< no codes of nodes and no materials; 2D elements have letters T, Q
};

/// Numbers after every element; mesh generators write 1000.0 0.45 1.0.
constexpr int MaterialSize = 3;
constexpr char MaterialName[] = "Material";
constexpr char NodeCodeName[] = "NodeCode";
constexpr char ProjectionName[] = "Projection";

constexpr int MaxElementNodes = 8;

struct ElementKind
{
  char Letter;
  unsigned char Type;
  int NumberOfNodes;

  /// Position of each of VTK's nodes in the file, and vice versa.
  const int* GetOrder() const
  {
    static const int same[MaxElementNodes] = { 0, 1, 2, 3, 4, 5, 6, 7 };
    return this->Type == VTK_WEDGE ? GetExtrusionOrder(VTK_WEDGE) : same;
  }
};

///@{
/// The kind of element for a letter or for a cell type, or nullptr.
const ElementKind* FindElementKind(char letter, M3DDialect dialect);
const ElementKind* FindElementKind(unsigned char type, M3DDialect dialect);
///@}

/**
 * Reads a row of an element up to its material, with nodes in the order of the file; nullptr if it
 * is invalid.
 */
const ElementKind* ReadElement(
  TextRow& row, M3DDialect dialect, vtkIdType numberOfNodes, std::int32_t* nodes);

/**
 * @class camaron::MaterialTally
 * @brief Finds out whether all elements have a material, and whether it is always the same.
 *
 * Thread-safe; the result does not depend on the order of calls.
 */
class MaterialTally
{
public:
  /// @param end of the text
  explicit MaterialTally(const char* end)
    : End(end)
  {
  }

  /// Checks the numbers after the nodes of an element, until materials differ; then all have to be
  /// read.
  void Add(TextRow& row);
  /// Reads the material after the nodes of an element; false if it is missing.
  bool Read(TextRow& row, double* values);

  bool IsMissingSomewhere() const { return this->Missing; }
  bool IsFoundSomewhere() const { return this->Found; }
  bool Varies() const { return this->Different; }
  /// One of the materials found.
  const double* GetMaterial() const { return this->Values; }

private:
  const char* End;
  std::atomic<bool> Missing{ false };
  std::atomic<bool> Different{ false };
  std::atomic<bool> Found{ false };
  // One of the materials; the text of most others is identical.
  std::string_view Sample;
  double Values[MaterialSize] = {};
  std::mutex Mutex;
};
}

#endif
