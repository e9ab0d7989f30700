// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::RowSequence
 * @brief The next rows of a text, to be read as often as needed: lines, in parallel, or one after
 * the other, which also reports errors.
 */
#ifndef camaron_RowSequence_h
#define camaron_RowSequence_h

#include "Intake/Rows/TextRows.h"

namespace camaron
{
class RowSequence
{
public:
  /**
   * Moves the scanner behind them if they are lines.
   * @param lines of a text large enough for parallel reading, else nullptr
   * @param skipsRest whether to ignore the rest of the line after every row; otherwise the next row
   * begins there
   */
  RowSequence(TextScanner& scanner, const TextLines* lines, vtkIdType count,
    RowLayout layout = RowLayout::Free, bool skipsRest = true)
    : Scanner(scanner)
    , Start(scanner)
    , Lines(lines)
    , Section(lines ? lines->Find(scanner.GetPosition(), count) : TextLines::Section())
    , Count(count)
    , Layout(layout)
    , SkipsRest(skipsRest)
  {
    if (this->Section)
    {
      scanner.SetPosition(this->Section.End);
    }
  }

  vtkIdType GetCount() const { return this->Count; }
  bool AreLines() const { return this->Lines != nullptr; }
  /// Whether the rows exist, as far as is known.
  explicit operator bool() const { return !this->Lines || this->Section; }
  const TextLines::Section& GetSection() const { return this->Section; }
  TextScanner& GetScanner() const { return this->Scanner; }

  /// Number of parts; the rows of a part are visited in order by one thread.
  std::size_t GetNumberOfParts() const
  {
    return this->Lines ? static_cast<std::size_t>(this->Lines->GetNumberOfPieces(this->Section))
                       : 1;
  }
  /// Calls @a visit(row, part, TextRow&) for all rows, and moves the scanner behind them if it is
  /// before; false if a visit did, with the error in the scanner, or if stopped.
  template <typename Visit>
  bool ForEach(const Progress& progress, Visit&& visit);

private:
  TextScanner& Scanner;
  TextScanner Start;
  const TextLines* Lines;
  TextLines::Section Section;
  vtkIdType Count;
  RowLayout Layout;
  bool SkipsRest;
};

//------------------------------------------------------------------------------
template <typename Visit>
bool RowSequence::ForEach(const Progress& progress, Visit&& visit)
{
  if (this->Lines)
  {
    return VisitRows(*this->Lines, this->Section, this->Start.GetComment(), progress, visit);
  }
  TextScanner scanner = this->Start;
  bool isGood = true;
  for (vtkIdType row = 0; row < this->Count && isGood; ++row)
  {
    scanner.SkipSpace();
    TextRow text(scanner, this->Layout);
    isGood = progress.Report(static_cast<double>(row) / this->Count) &&
      visit(row, vtkIdType(0), text) && !scanner.HasFailed();
    if (isGood && this->SkipsRest)
    {
      scanner.SkipLine();
    }
  }
  if (!isGood || scanner.GetPosition() > this->Scanner.GetPosition())
  {
    this->Scanner = scanner;
  }
  return isGood && !progress.IsStopped();
}
}

#endif
