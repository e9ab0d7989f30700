// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SelectionParameters.h
 * @brief The properties of vtkSelectElements and their defaults.
 */
#ifndef camaron_SelectionParameters_h
#define camaron_SelectionParameters_h

#include "vtkImplicitFunction.h" // for a shape
#include "vtkSmartPointer.h"     // for a shape

#include <string> // for texts
#include <vector> // for planes

namespace camaron
{
/// All properties of vtkSelectElements, which documents them. Each strategy reads its own.
struct SelectionParameters
{
  std::string ElementType = "Cells";
  std::string Strategy = "By criterion";
  std::string Combination = "Replace";
  std::string Ids;
  std::string IdSpace = "Index";
  std::string Array;
  std::string PointArray;
  std::string Side = "Outside";
  std::string Range = "Acceptable";
  std::string Preset = "Default ranges";
  std::string RangesFile;
  std::string LowerLimit;
  std::string UpperLimit;
  int NumberOfWorst = 10;
  double WorstPercentage = 1;
  std::string WorstValues = "By criterion";
  std::string StatusBits;
  std::string CellTypes;
  std::string Counted = "Faces";
  std::string Counts;
  int NumberOfFailures = 1;
  std::string Rules;
  bool ByTopology = false;
  bool ExcludeUndefined = false;
  bool Quiet = false;
  std::string Placement = "Centroid inside";
  bool InsideOut = false;
  std::string Adjacency = "Face";
  int NumberOfLayers = 1;
  double FeatureAngle = 180;
  bool OnlyBoundary = false;
  bool OnlyInRange = false;
  int ComponentNumber = 1;
  std::string Quantifier = "Any";
  vtkSmartPointer<vtkImplicitFunction> Shape;
  std::string ShapeFile;
  std::string SetFile;
  std::string SetName;
  std::vector<double> Planes; ///< six numbers per plane: a point and the outward normal
};
}

#endif
