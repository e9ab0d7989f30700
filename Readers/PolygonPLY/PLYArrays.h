// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PLYArrays.h
 * @brief The arrays that the properties of elements become, and their memory.
 */
#ifndef camaron_PLYArrays_h
#define camaron_PLYArrays_h

#include "PLYHeader.h"

#include "vtkDataArray.h"
#include "vtkSmartPointer.h"

#include <string> // for names
#include <vector> // for arrays

class vtkDataSetAttributes;
class vtkFieldData;

namespace camaron
{
/// An array, and the properties of an element that it is read from.
struct PLYArrayPlan
{
  enum class Role
  {
    Scalars,
    Points,
    Normals,
    TextureCoordinates
  };
  Role Kind = Role::Scalars;
  std::string Name;
  ValueType Type = ValueType::Float;
  ValueConversion Conversion = ValueConversion::Value;
  std::vector<int> Properties; ///< one per component, -1 for none
  bool AreItems = false;       ///< the components are the items of a list
  bool IsPadded = false;       ///< some lists have fewer items
};

/// The array of lists that are not points or faces: it has the number of components of the longest
/// list.
struct PLYListShape
{
  std::int32_t Components = 0; ///< 0 for no array
  bool Varies = false;         ///< some are shorter
};

/// The kind of data that elements describe.
enum class PLYSubject
{
  Points,
  Cells,
  Other
};

/**
 * The arrays of an element, excluding the properties marked in @a used. Coordinates come first and
 * exist for points only.
 * @param lists shapes of the properties that are lists
 */
std::vector<PLYArrayPlan> PlanArrays(const PLYElement& element, PLYSubject subject,
  const std::map<std::string, int>& components, std::vector<bool> used,
  const std::vector<PLYListShape>& lists);

/**
 * @class camaron::PLYArrays
 * @brief Arrays of points or cells, to which several elements may contribute.
 */
class PLYArrays
{
public:
  /// Adds the arrays of an element; arrays of the same name are joined if possible.
  void Add(std::vector<PLYArrayPlan>& plans);
  bool IsEmpty() const { return this->Arrays.empty(); }
  /**
   * Allocates memory. Tuples that no element sets are NaN, or 0 for integers.
   * @param isCovered whether every tuple is set by an element that has all the arrays
   */
  void Allocate(vtkIdType tuples, bool isCovered);
  /// The targets of the properties of an element.
  std::vector<TableColumn> GetColumns(const std::vector<PLYArrayPlan>& plans) const;
  vtkDataArray* Get(const std::string& name) const;
  void MoveTo(vtkDataSetAttributes* attributes);
  void MoveTo(vtkFieldData* fields, const std::string& prefix);

private:
  struct Entry
  {
    PLYArrayPlan Plan;
    vtkSmartPointer<vtkDataArray> Array;
  };
  std::vector<Entry> Arrays;
};
}

#endif
