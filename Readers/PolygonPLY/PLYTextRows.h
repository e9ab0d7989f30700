// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::PLYTextRows
 * @brief Rows of a PLY file in text.
 *
 * In large files one row per line is read in parallel. Without lines rows are read one after the
 * other, which also words the errors: each on a line, or just as numbers one after the other.
 */
#ifndef camaron_PLYTextRows_h
#define camaron_PLYTextRows_h

#include "PLYRows.h"
#include "Scan/TextRows.h"

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
  bool ReadUnsignedId(TextRow& row, std::int64_t& id, const std::string& what) const;
  bool Fail(TextRow& row, const char* place, ErrorKind kind, const std::string& expected) const;
  bool SkipValues(TextRow& row, int property, std::int64_t number) const;
  bool Skip(TextRow& row, int property) const;
  /// Skips the properties from one on, where the end of the row is not known or not yet checked.
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
  TextScanner Begin; ///< where the rows start
  bool IsChecked = false;
  std::vector<std::string> Values;  ///< of properties, for messages
  std::vector<std::string> Lengths; ///< of lists, for messages
};
}

#endif
