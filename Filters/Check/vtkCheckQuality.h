// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkCheckQuality
 * @brief Checks a mesh against rules for quality criteria.
 *
 * Input: any vtkDataSet or composite data set. The filter evaluates the criteria of its rules
 * itself and ignores arrays of the input with the same names, which may be out of date. It keeps
 * the values for later executions, so that changing only the rules does not evaluate the mesh
 * again. Ghost cells are ignored.
 *
 * The rules are those of RulesFile and Rules, and of Preset. Documentation/check.md describes their
 * language, and the columns of the outputs, each a vtkTable:
 * 0. one row per rule: its range and cells, counts, verdict and worst cell. The field data has the
 *    verdict on all rules, "Verdict" ("pass", "warn", "fail", or "empty" if no rule has a cell to
 *    check), the numbers of cells and rules, "Cells", "Rules", "Failed", "Warned" and "Empty", and
 *    sentences about verdicts that may surprise, "Notes".
 * 1. one row per rule and failing cell, worst first
 *
 * Wrong rules are an error with all problems in its message, before anything is evaluated;
 * GetProblems() has them without executing the filter. A block or cell array of a rule that the
 * mesh does not have is an error, too.
 *
 * Parallel: the tables are complete on process 0, and empty with all columns on the others. Every
 * number is the same, to the last bit, for any number of threads and processes.
 *
 * Cost: that of vtkElementQuality for the criteria, and a few passes over the values per criterion
 * and scope. Memory: 8 bytes per cell and criterion.
 */
#ifndef vtkCheckQuality_h
#define vtkCheckQuality_h

#include "vtkQualityAlgorithm.h"

#include "vtkNew.h"          // for the evaluating filter
#include "vtkSmartPointer.h" // for names
#include "vtkStringArray.h"  // for names

#include <string>  // for rules
#include <utility> // for their names
#include <vector>  // for texts

class vtkElementQuality;
class vtkMeshElements;
namespace camaron
{
struct ParsedRules;
struct RulesText;
class Reducer;
}

class vtkCheckQuality : public vtkQualityAlgorithm
{
public:
  static vtkCheckQuality* New();
  vtkTypeMacro(vtkCheckQuality, vtkQualityAlgorithm);

  ///@{
  /// Rules in UTF-8, one per line. Default: empty.
  void SetRules(const char* text) { this->SetText(this->Rules, text); }
  const char* GetRules() const { return this->Rules.c_str(); }
  ///@}

  ///@{
  /// Further rules, which come after those of Rules, such as those of standard input. Messages have
  /// the name and the line; a name such as "--rule 2" is that of an option with a single rule, and
  /// stands alone.
  void AddNamedRules(const char* name, const char* text);
  void ClearNamedRules();
  ///@}

  ///@{
  /// File of rules of at most 1 MiB, which come before those of Rules. Process 0 reads it. Default:
  /// empty, no file.
  void SetRulesFile(const char* path) { this->SetText(this->RulesFile, path); }
  const char* GetRulesFile() const { return this->RulesFile.c_str(); }
  ///@}

  ///@{
  /**
   * Preset whose acceptable ranges are rules, too; rules for the same criterion and cells replace
   * them. "Automatic" (default): "General" if there are no other rules, else none. "None": no
   * preset.
   */
  void SetPreset(const char* name) { this->SetText(this->Preset, name); }
  const char* GetPreset() const { return this->Preset.c_str(); }
  /// All valid values of Preset.
  vtkStringArray* GetPresetNames() { return this->PresetNames; }
  ///@}

  ///@{
  /// Tolerance of rules that give none: a percentage such as "0.1%", or a number of cells. Default:
  /// empty, which means 0.
  void SetTolerate(const char* amount) { this->SetText(this->Tolerate, amount); }
  const char* GetTolerate() const { return this->Tolerate.c_str(); }
  ///@}

  ///@{
  /// Maximum number of failing cells to list for each rule, 0 or more. Default: 10.
  vtkSetMacro(NumberOfWorst, int);
  vtkGetMacro(NumberOfWorst, int);
  ///@}

  ///@{
  /**
   * The rules that the present properties mean, without executing the filter, on this process. For
   * each problem three texts: the name of the file, "rules", or the name of a property; the line,
   * "0" if none; and the reason. For each rule, if there are no problems, four texts: the name of
   * the file or "rules", the line, the preset, and the rule as a line.
   */
  vtkStringArray* GetProblems();
  vtkStringArray* GetParsedRules();
  ///@}

  /// Estimated time in seconds to evaluate the criteria of the rules for the present input; 0 if
  /// there are problems.
  double GetEstimatedSeconds();

protected:
  vtkCheckQuality();
  ~vtkCheckQuality() override;

  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkCheckQuality(const vtkCheckQuality&) = delete;
  void operator=(const vtkCheckQuality&) = delete;

  void SetText(std::string& member, const char* text);
  /// The rules of this process, which reads the file unless @a file is its text already.
  camaron::ParsedRules Parse(const camaron::RulesText* file = nullptr) const;
  /// Collective. Process 0 reads the file.
  camaron::ParsedRules ParseCollectively(camaron::Reducer& reducer) const;
  void ChooseCriteria(const camaron::ParsedRules& parsed);
  /// Collective. The input with arrays of the criteria; nullptr if that failed or was aborted.
  vtkDataObject* Evaluate(vtkDataObject* input, vtkInformation* outInfo);
  /// Collective. Creates the elements other than cells that rules are about, with their arrays;
  /// false if that failed or was aborted.
  bool MakeElements(
    vtkDataObject* input, const camaron::ParsedRules& parsed, vtkInformation* outInfo);
  /// Collective. False if the evaluation failed.
  bool Check(vtkDataObject* input, const camaron::ParsedRules& parsed,
    vtkInformationVector* outputVector, camaron::Reducer& reducer);
  void ForwardProgress();

  std::string Rules;
  std::string RulesFile;
  std::vector<std::pair<std::string, std::string>> NamedRules;
  std::string Preset = "Automatic";
  std::string Tolerate;
  int NumberOfWorst = 10;

  const vtkSmartPointer<vtkStringArray> PresetNames;
  vtkNew<vtkStringArray> Problems;
  vtkNew<vtkStringArray> ParsedRules;
  vtkNew<vtkElementQuality> Evaluator;
  vtkNew<vtkMeshElements> Elements;
};

#endif
