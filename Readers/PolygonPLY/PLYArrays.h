// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PLYArrays.h
 * @brief Which arrays the properties of elements become, and their memory.
 */
#ifndef camaron_PLYArrays_h
#define camaron_PLYArrays_h

#include "PLYRows.h"

#include "vtkDataArray.h"
#include "vtkSmartPointer.h"

#include <string> // for names
#include <vector> // for arrays

class vtkDataSetAttributes;
class vtkFieldData;

namespace camaron
{
/// Exactly sized memory, not initialized.
vtkSmartPointer<vtkDataArray> MakeArray(PLYType type, int components, vtkIdType tuples);

/// The array that some properties of an element become.
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
  PLYType Type = PLYType::Float;
  PLYConversion Conversion = PLYConversion::Value;
  std::vector<int> Properties; ///< one per component, -1 for none
  bool AreItems = false;       ///< the components are the items of a list
  bool IsPadded = false;       ///< of which some have fewer
};

/// What elements are about.
enum class PLYSubject
{
  Points,
  Cells,
  Other
};

/**
 * The arrays that an element has, except of the properties marked in @a used. Coordinates come
 * first and are of points only.
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
  /// Adds the arrays of an element; those of a name that another has too become one where they can.
  void Add(std::vector<PLYArrayPlan>& plans);
  bool IsEmpty() const { return this->Arrays.empty(); }
  /**
   * Provides the memory. Tuples that no element sets are nan, or 0 in integers.
   * @param isCovered whether every tuple is set by an element that has all the arrays
   */
  void Allocate(vtkIdType tuples, bool isCovered);
  /// Where the properties of an element go.
  std::vector<PLYColumn> GetColumns(const std::vector<PLYArrayPlan>& plans) const;
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
