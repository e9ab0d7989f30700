// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::PLYTextRows
 * @brief Rows of a PLY file in text.
 *
 * In large files with one row per line, rows are read in parallel. Without lines rows are read
 * serially, one per line or as a sequence of numbers; errors are reported this way.
 */
#ifndef camaron_PLYTextRows_h
#define camaron_PLYTextRows_h

#include "Intake/Rows/TextRows.h"
#include "PLYRows.h"

namespace camaron
{
class PLYTextRows : public PLYRows
{
public:
  /// @param lines of the text if it is read in parallel, else nullptr
  PLYTextRows(
    const PLYElement& element, TextScanner& scanner, const TextLines* lines, RowLayout layout);

  bool Locate(const Progress& progress) override;
  bool Check(const Progress& progress) override;
  bool ReadSizes(int property, PLYSizes& sizes, const Progress& progress) override;
  bool ReadIds(
    int property, const PLYIds& expected, const PLYLists& lists, const Progress& progress) override;
  bool ReadColumns(const std::vector<PLYColumn>& columns, const PLYTargets& targets,
    const Progress& progress) override;
  bool FailAt(vtkIdType row, int property, ErrorKind kind, const std::string& expected,
    const std::string& found) override;

private:
  template <typename Visit>
  bool ForEachRow(const Progress& progress, Visit&& visit);
  bool ReadLength(TextRow& row, int property, std::int64_t& length) const;
  bool SkipValues(TextRow& row, int property, std::int64_t number) const;
  /// Skips properties.
  bool Skip(TextRow& row, int begin, int end) const;
  /// Skips the properties from one on, if the end of the row is unknown or not yet checked.
  bool SkipRest(TextRow& row, int property) const;
  void Finish(vtkIdType row, TextRow& text);
  bool ReadValue(TextRow& row, const PLYColumn& column, vtkIdType tuple) const;
  bool ReadList(TextRow& row, int property, const std::vector<const PLYColumn*>& columns,
    vtkIdType tuple) const;
  int GetNumberOfProperties() const { return static_cast<int>(this->Element.Properties.size()); }

  TextScanner& Scanner;
  const TextLines* Lines;
  RowLayout Layout;
  TextLines::Section Section;
  TextScanner Begin; ///< at the start of the rows
  bool IsChecked = false;
  std::vector<std::string> Values;  ///< of properties, for messages
  std::vector<std::string> Lengths; ///< of lists, for messages
};
}

#endif
