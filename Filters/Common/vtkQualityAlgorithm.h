// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkQualityAlgorithm
 * @brief A filter that evaluates cells: its input, and how criteria are evaluated.
 *
 * The first input is any vtkDataSet or composite data set. A filter that needs only some of the
 * options has only those as properties; the others keep their defaults.
 */
#ifndef vtkQualityAlgorithm_h
#define vtkQualityAlgorithm_h

#include "vtkDataObjectAlgorithm.h"

namespace camaron
{
struct EvaluationOptions;
}

class vtkQualityAlgorithm : public vtkDataObjectAlgorithm
{
public:
  vtkTypeMacro(vtkQualityAlgorithm, vtkDataObjectAlgorithm);

  ///@{
  /**
   * On: assume that the faces of polyhedra point outward, so that an inverted cell has a negative
   * volume. Off (default): first orient the faces consistently and outward, because many files do
   * not.
   */
  vtkSetMacro(TrustFaceOrientation, bool);
  vtkGetMacro(TrustFaceOrientation, bool);
  ///@}

  ///@{
  /**
   * Edges shorter than this fraction of the cell diameter are treated as degenerate, and faces and
   * cells accordingly. Range: 0 to 1. 0 (default) means the larger of 1e-12 and 8 times the machine
   * epsilon of double.
   */
  vtkSetMacro(DegeneracyTolerance, double);
  vtkGetMacro(DegeneracyTolerance, double);
  ///@}

  ///@{
  /// Angles may exceed 180 degrees by this much in a cell that CellStatus and IsConvex consider
  /// convex. Always in degrees, whatever the unit of angles is. Range: 0 to 180. Default: 1e-4.
  vtkSetMacro(ConvexityTolerance, double);
  vtkGetMacro(ConvexityTolerance, double);
  ///@}

  ///@{
  /// Largest warpage (see MaxWarpage) of a face that CellStatus considers planar. Range: 0 to 1.
  /// Default: 0.1.
  vtkSetMacro(PlanarityTolerance, double);
  vtkGetMacro(PlanarityTolerance, double);
  ///@}

  ///@{
  /**
   * Treat cells of different blocks as neighbors if their faces have the same points: by global ids
   * if all points have them, else by equal coordinates. Partitions of one block are always
   * connected. Default: off.
   */
  vtkSetMacro(ConnectBlocks, bool);
  vtkGetMacro(ConnectBlocks, bool);
  ///@}

  /// Takes all these options from another filter.
  void SetEvaluationOptions(const vtkQualityAlgorithm* other);

  /// Values of AngleUnits.
  enum AngleUnitsType
  {
    DEGREES = 0,
    RADIANS = 1
  };
  /// Unit of plane angles, DEGREES (default) or RADIANS. Solid angles are always in steradians.
  vtkSetClampMacro(AngleUnits, int, DEGREES, RADIANS);

  /// Add a mask to each array of a criterion, with the reason why a value is undefined; see
  /// vtkElementQuality. Default: off.
  vtkSetMacro(WriteUndefinedMask, bool);

protected:
  vtkQualityAlgorithm() = default;
  ~vtkQualityAlgorithm() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;

  /// The options for Core. Throws std::invalid_argument if one is out of its range.
  camaron::EvaluationOptions GetEvaluationOptions() const;

  /// For RequestUpdateExtent: requests a layer of ghost cells if some pieces do not exist at the
  /// same time as this one. Otherwise none are needed.
  static void RequestGhostCells(vtkInformationVector** inputs, vtkInformationVector* outputs);

  bool WriteUndefinedMask = false;

private:
  vtkQualityAlgorithm(const vtkQualityAlgorithm&) = delete;
  void operator=(const vtkQualityAlgorithm&) = delete;

  bool TrustFaceOrientation = false;
  double DegeneracyTolerance = 0;
  double ConvexityTolerance = 1e-4;
  double PlanarityTolerance = 0.1;
  bool ConnectBlocks = false;
  int AngleUnits = DEGREES;
};

#endif
