// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::MAPDLOutputTypes
 * @brief The element types of a deck to write, and the type of each cell.
 *
 * Cells keep the type given by the arrays TypeId and ElementType if an element of that type would
 * be read as the same cell; others get the usual type of their shape.
 */
#ifndef camaron_MAPDLOutputTypes_h
#define camaron_MAPDLOutputTypes_h

#include "Intake/CellMesh/OutputMesh.h"
#include "MAPDLDeck.h"

#include <tuple> // for keys

class vtkDataSetAttributes;

namespace camaron
{
/// Integers of cells or points: values of an array, or a constant.
class MAPDLNumbers
{
public:
  /**
   * Uses an array with one integer per tuple. Without an array, and for numbers that do not fit a
   * column of ten characters, the value is @a missing.
   */
  MAPDLNumbers(vtkDataSetAttributes* attributes, const char* name, std::int32_t missing);
  /// The same, but the number @a reserved, which has a special meaning, is replaced by @a missing.
  MAPDLNumbers(vtkDataSetAttributes* attributes, const char* name, std::int32_t missing,
    std::int32_t reserved);
  bool HasArray() const { return this->Array != nullptr; }
  /// Whether a number of the array is written unchanged.
  bool IsKept(vtkIdType i) const
  {
    return this->Values ? (*this)[i] == this->Values[i]
      : this->Array     ? (*this)[i] == this->Array->GetComponent(i, 0)
                        : true;
  }
  std::int32_t operator[](vtkIdType i) const
  {
    return this->Values ? this->Limit(this->Values[i])
      : this->Array     ? this->Limit(this->Array->GetComponent(i, 0))
                        : this->Missing;
  }

private:
  template <typename Number>
  std::int32_t Limit(Number value) const
  {
    constexpr Number Least = -999999999, Greatest = 2147483647;
    const bool fits = value >= Least && value <= Greatest;
    const std::int32_t number = fits ? static_cast<std::int32_t>(value) : this->Missing;
    return number == this->Reserved ? this->Missing : number;
  }

  vtkDataArray* Array = nullptr;
  const int* Values = nullptr; ///< if the array is of this type
  std::int32_t Missing;
  std::int32_t Reserved;
};

class MAPDLOutputTypes
{
public:
  MAPDLOutputTypes(vtkDataSet* mesh, const OutputMesh& output);

  const std::map<std::int32_t, MAPDLType>& GetTypes() const { return this->Types; }
  /// The type of a cell, and how its nodes are written.
  struct Choice
  {
    std::int32_t Id = 0;
    MAPDLForm Form;
  };
  const Choice& GetType(vtkIdType cell) const
  {
    return this->TypeOfKey.find(this->GetKey(cell))->second;
  }
  /// Whether the arrays determine the type of any cell, or there are no cells.
  bool UsesArrays() const { return this->KeepsTypes || this->TypeOfKey.empty(); }
  /// Cells whose type differs from that in the arrays, if these have a valid one.
  Tally FindOtherTypes() const;

private:
  using Key = std::tuple<std::int32_t, std::int32_t, unsigned char>; // type, element, shape
  Key GetKey(vtkIdType cell) const;

  const OutputMesh& Output;
  MAPDLNumbers TypeIds, Elements;
  std::map<std::int32_t, MAPDLType> Types;
  std::map<Key, Choice> TypeOfKey;
  bool KeepsTypes = false;
};
}

#endif
