// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::MAPDLOutputTypes
 * @brief The element types of a deck to write, and which of them every cell has.
 *
 * Cells keep the type that the arrays TypeId and ElementType tell, if an element of that type would
 * be read as the same cell; others get the usual type of their shape.
 */
#ifndef camaron_MAPDLOutputTypes_h
#define camaron_MAPDLOutputTypes_h

#include "CellMesh/OutputMesh.h"
#include "MAPDLDeck.h"

#include <tuple> // for keys

class vtkDataSetAttributes;

namespace camaron
{
/// Integers of cells or points: values of an array, or the same everywhere.
class MAPDLNumbers
{
public:
  /**
   * Takes an array with one integer per tuple; without one, all are @a missing, as are numbers that
   * do not fit a column of ten characters.
   */
  MAPDLNumbers(vtkDataSetAttributes* attributes, const char* name, std::int32_t missing);
  /// The same, with a number besides that stands for something else, and becomes @a missing.
  MAPDLNumbers(vtkDataSetAttributes* attributes, const char* name, std::int32_t missing,
    std::int32_t reserved);
  bool HasArray() const { return this->Array != nullptr; }
  /// Whether a number of the array stays what it is.
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
  /// Whether the arrays decide about some cell, if there are cells.
  bool UsesArrays() const { return this->KeepsTypes || this->TypeOfKey.empty(); }
  /// Cells that have another type than the arrays say, if these say something of them.
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
