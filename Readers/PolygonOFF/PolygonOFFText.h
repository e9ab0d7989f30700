// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PolygonOFFText.h
 * @brief Rows of OFF files in text: vertices, and faces with their colors.
 */
#ifndef camaron_PolygonOFFText_h
#define camaron_PolygonOFFText_h

#include "Intake/Rows/TextRows.h"
#include "PolygonOFFMesh.h"

namespace camaron
{
/// The numbers up to the end of a line.
struct OFFRest
{
  static constexpr int Most = 16; ///< numbers kept; vertices do not have more
  double Values[Most];
  bool AreReal[Most];        ///< whether they are written as real numbers
  int Count = 0;             ///< including those that are not kept
  const char* Odd = nullptr; ///< the first word that is not a number

  explicit OFFRest(TextRow& row);
  /// The color of the first numbers, at most four of them.
  OFFColor GetColor(int count) const;
};

/**
 * @class camaron::OFFRows
 * @brief The next rows of a text: lines, which are read in parallel, or one after the other, which
 * also reports errors.
 */
class OFFRows
{
public:
  /// Moves the scanner behind them if they are lines.
  OFFRows(TextScanner& scanner, const TextLines* lines, vtkIdType count)
    : Scanner(scanner)
    , Start(scanner)
    , Lines(lines)
    , Section(lines ? lines->Find(scanner.GetPosition(), count) : TextLines::Section())
    , Count(count)
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
  /// Calls @a visit(row, part, TextRow&) for all rows and moves the scanner behind them; false if a
  /// visit did, with the error in the scanner, or if stopped.
  template <typename Visit>
  bool ForEach(const Progress& progress, Visit&& visit);

private:
  TextScanner& Scanner;
  TextScanner Start;
  const TextLines* Lines;
  TextLines::Section Section;
  vtkIdType Count;
};

/// Finds the faces of a piece, and stores these. False with the error in the scanner, or if
/// stopped.
bool ReadTextFaces(OFFMesh& mesh, OFFRows& rows, const PieceRequest& request, CellMeshPiece& piece,
  const Progress& progress);

//------------------------------------------------------------------------------
template <typename Visit>
bool OFFRows::ForEach(const Progress& progress, Visit&& visit)
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
    TextRow text(scanner);
    isGood = progress.Report(static_cast<double>(row) / this->Count) &&
      visit(row, vtkIdType(0), text) && !scanner.HasFailed();
    if (isGood)
    {
      scanner.SkipLine();
    }
  }
  this->Scanner = scanner;
  return isGood && !progress.IsStopped();
}
}

#endif
