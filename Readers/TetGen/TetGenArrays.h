// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::TetGenArrays
 * @brief The arrays of points or cells that become attributes and markers in TetGen files.
 *
 * Attributes are numbers without names. Arrays named by the reader are written in that order;
 * others follow in the order of the mesh.
 */
#ifndef camaron_TetGenArrays_h
#define camaron_TetGenArrays_h

#include "Base/Number.h"

#include "vtkDataArray.h"
#include "vtkSmartPointer.h"

#include <algorithm> // for std::any_of
#include <cmath>     // for std::isnan
#include <string>    // for text
#include <vector>    // for columns

class vtkDataSetAttributes;

namespace camaron
{
class TetGenArrays
{
public:
  TetGenArrays() = default;
  /**
   * Selects arrays.
   * @param first the name that the reader gives to the first attribute
   * @param hasMarkers whether there is a column for markers; if not, they become an attribute
   */
  TetGenArrays(vtkDataSetAttributes* attributes, const std::string& first, bool hasMarkers);

  std::size_t GetNumberOfAttributes() const { return this->Attributes.size(); }
  bool HasMarkers() const { return this->Marker.Array != nullptr; }

  ///@{
  /// Appends a blank and the value of each attribute.
  void AppendAttributes(std::string& text, vtkIdType tuple) const
  {
    for (const Column& column : this->Attributes)
    {
      column.Append(text, tuple);
    }
  }
  /// Likewise the marker, if there is one.
  void AppendMarker(std::string& text, vtkIdType tuple) const
  {
    if (this->HasMarkers())
    {
      this->Marker.Append(text, tuple);
    }
  }
  ///@}

  ///@{
  /// Whether any value to write is not zero.
  bool HasAttributes(vtkIdType tuple) const
  {
    return std::any_of(this->Attributes.begin(), this->Attributes.end(),
      [tuple](const Column& column) { return column.HasValue(tuple); });
  }
  bool HasMarker(vtkIdType tuple) const
  {
    return this->HasMarkers() && this->Marker.HasValue(tuple);
  }
  ///@}

  /// Adds the names of arrays that are written.
  void AddNames(std::vector<std::string>& names) const;
  /// Arrays that the reader will name differently, as "Pressure as attr_0, ...".
  std::string DescribeRenamed() const;

private:
  /// One component in contiguous memory, so that writing a number needs no virtual call.
  struct Column
  {
    vtkSmartPointer<vtkDataArray> Array;
    const void* Values = nullptr;
    std::string Name;

    void Set(vtkDataArray* array);
    bool HasValue(vtkIdType tuple) const
    {
      const double value = this->Array->GetComponent(tuple, 0);
      return value != 0 && !std::isnan(value);
    }
    void Append(std::string& text, vtkIdType tuple) const
    {
      text += ' ';
      switch (this->Array->GetDataType())
      {
        vtkTemplateMacro(AppendNumber(text, static_cast<const VTK_TT*>(this->Values)[tuple]));
        default:
          text += '0';
      }
    }
  };

  std::vector<Column> Attributes;
  Column Marker;
  std::string First;
};
}

#endif
