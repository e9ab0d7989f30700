// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkQualityColors
 * @brief The color map of a criterion, tied to its acceptable range, for the window and for
 * reports.
 *
 * Acceptable values are light and calm. At a limit the map steps to warm colors, which get darker
 * and more saturated the farther a value is outside. Without limits, the map is sequential in a
 * neutral hue, dark at the worse end. Good and bad colors also differ for people who see fewer
 * colors, by hue and by lightness.
 */
#ifndef vtkQualityColors_h
#define vtkQualityColors_h

#include "CamaronFiltersModule.h" // for export macro
#include "vtkNew.h"               // for the points
#include "vtkObject.h"

#include <array> // for the ends

class vtkDoubleArray;

class CAMARONFILTERS_EXPORT vtkQualityColors : public vtkObject
{
public:
  static vtkQualityColors* New();
  vtkTypeMacro(vtkQualityColors, vtkObject);

  /// The values that the map covers. Default: 0 to 1.
  vtkSetVector2Macro(Range, double);

  /// The acceptable range, limits included; infinite, or the largest double, for no limit. Default:
  /// no limits.
  vtkSetVector2Macro(Acceptable, double);

  /// 1 if larger values are better, -1 if smaller ones are, 0 (default) if neither.
  vtkSetMacro(Better, int);

  ///@{
  /// Whether values are undefined, and whether there are cells that the range does not judge.
  /// Default: none.
  vtkSetMacro(HasUndefined, bool);
  vtkSetMacro(HasNotJudged, bool);
  ///@}

  /// Value, red, green and blue of the control points, to be interpolated in the color space RGB.
  vtkDoubleArray* GetPoints();

  /// Values that a legend labels: the limits, the ends of the map and round numbers, as far as they
  /// have room.
  vtkDoubleArray* GetLabels();

  /// The significant digits of these labels: three, or as many as tell them apart.
  int GetLabelDigits();

  /// Whether a control point of this color is beyond a limit.
  static bool IsBeyond(const double color[3]);

  /// Color of undefined values, which is none of the others: red, green and blue. That of cells
  /// that are not judged if only these exist.
  vtkDoubleArray* GetUndefinedColor();

  /// Color of cells that are not judged, which is none of the others.
  vtkDoubleArray* GetNotJudgedColor();

  /// The annotation of undefined values in a vertical legend. With cells that are not judged, too,
  /// whose color is in the swatch above: a line for each.
  const char* GetUndefinedText() const;

protected:
  vtkQualityColors();
  ~vtkQualityColors() override;

private:
  vtkQualityColors(const vtkQualityColors&) = delete;
  void operator=(const vtkQualityColors&) = delete;

  /// The first and the last value of the map.
  std::array<double, 2> GetEnds();

  double Range[2] = { 0, 1 };
  double Acceptable[2];
  int Better = 0;
  bool HasUndefined = false;
  bool HasNotJudged = false;
  vtkNew<vtkDoubleArray> Points;
  vtkNew<vtkDoubleArray> Labels;
  vtkNew<vtkDoubleArray> UndefinedColor;
  vtkNew<vtkDoubleArray> NotJudgedColor;
};

#endif
