// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CutPlacement.h
 * @brief The place of a cut as one number, for the slider of the card "View".
 *
 * A share of 0 to 1 within the bounds of a mesh: of a plane its place along its normal, of a sphere
 * or a box its size. Shapes have the names of their proxies: "Plane", "CuttingSphere" and
 * "CuttingBox"; their values are the properties of these.
 */
#ifndef camaron_CutPlacement_h
#define camaron_CutPlacement_h

#include <QMap>
#include <QString>
#include <QVariant>

#include <array> // for bounds

namespace camaron
{
using CutValues = QMap<QString, QVariant>;
using CutBounds = std::array<double, 6>;

/// A plane perpendicular to an axis, or, if that is negative or the bounds are flat there, to the
/// longest side of the bounds; a sphere around their center; a box from the corner of the smallest
/// coordinates.
CutValues MakeCut(const QString& shape, const CutBounds& bounds, int axis);

/// The share of a cut. Not within 0 and 1 if it is outside of the bounds.
double GetCutShare(const QString& shape, const CutBounds& bounds, const CutValues& values);

/// The cut at another share. A plane keeps its normal, a sphere its center, a box its corner and
/// its proportions.
CutValues MoveCut(
  const QString& shape, const CutBounds& bounds, const CutValues& values, double share);

/// The place of a plane along its normal, which is its coordinate if it is perpendicular to an
/// axis; the radius of a sphere; the share of a box.
QString SpellCut(const QString& shape, const CutBounds& bounds, const CutValues& values);
}

#endif
