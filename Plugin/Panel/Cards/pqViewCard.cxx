// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pqViewCard.h"

#include "CardTools.h"
#include "CutPlacement.h"
#include "NumberText.h"
#include "pqInspectedMesh.h"
#include "pqMeshDisplay.h"
#include "pqMeshQuestions.h"

#include "pqUndoStack.h"

#include <QComboBox>
#include <QCoreApplication>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QSlider>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace
{
constexpr int SliderSteps = 200;
constexpr int Digits = 3;
constexpr double MostExploded = 2;
constexpr int ExactCut = 4; // of CutBy
}

//------------------------------------------------------------------------------
pqViewCard::pqViewCard(pqInspectorState* state, QWidget* parent)
  : Superclass("View", tr("View"), false, state, parent)
  , ModeButtons(new QGridLayout)
  , CutShape(camaron::Make<QComboBox>(this->content(), "CutShape"))
  , CutBy(camaron::Make<QComboBox>(this->content(), "CutBy"))
{
  this->contentLayout()->addLayout(this->ModeButtons);
  this->makeCut();
  this->makeModes();
  this->makeSliders();
  QObject::connect(
    this->display(), &pqMeshDisplay::displayChanged, this, &pqViewCard::refreshWhenVisible);
}

//------------------------------------------------------------------------------
void pqViewCard::makeModes()
{
  constexpr int columns = 8;
  const QList<camaron::InspectionMode> modes = camaron::FindInspectionModes();
  for (const camaron::InspectionMode& mode : modes)
  {
    const int place = this->Modes.size();
    const QString text = QCoreApplication::translate("ServerManagerXML", qPrintable(mode.Text));
    QToolButton* button = camaron::MakeTool(this->content(), qPrintable(mode.Name), text);
    button->setText(text); // without an icon
    button->setCheckable(true);
    this->ModeButtons->addWidget(button, place / columns, place % columns);
    this->Modes << Mode{ { mode }, button };
    QObject::connect(button, &QToolButton::clicked, this,
      [this, mode](bool on) { this->display()->set({ { mode.Property, on ? mode.On : 0 } }); });
  }
  if (modes.isEmpty())
  {
    return; // the server has no plugin yet
  }
  QToolButton* plain =
    camaron::MakeTool(this->content(), "Plain", tr("Plain: back to a surface with edges"));
  QObject::connect(plain, &QToolButton::clicked, this, &pqViewCard::showPlain);
  this->ModeButtons->addWidget(plain, modes.size() / columns, modes.size() % columns);
  this->ModeButtons->setColumnStretch(columns, 1);
  const QSignalBlocker blocker(this->CutBy);
  this->CutBy->addItems(camaron::FindInspectionChoices("CutBy"));
}

//------------------------------------------------------------------------------
void pqViewCard::makeCut()
{
  this->CutBy->setToolTip(
    tr("Which cells the cut removes: whole cells by their centroid, any or all of their "
       "vertices; or exactly what is outside"));
  this->CutShape->addItem(tr("Plane"), "Plane");
  this->CutShape->addItem(tr("Sphere"), "CuttingSphere");
  this->CutShape->addItem(tr("Box"), "CuttingBox");
  this->CutShape->setPlaceholderText(
    tr("Half-spaces")); // around a cell, or of the Properties panel
  this->CutShape->setToolTip(tr("Shape of the cut; its widget is in the Properties panel"));
  QHBoxLayout* layout = this->addRow();
  layout->addWidget(new QLabel(tr("Cut by"), this->content()));
  layout->addWidget(this->CutBy, 2);
  layout->addWidget(this->CutShape, 1);
  QObject::connect(this->CutBy, &QComboBox::currentIndexChanged, this,
    [this](int way)
    {
      const pqScopedUndoSet undo(tr("Change Cut"));
      const bool isCut =
        this->display()->isInspected() && this->display()->value("CutBy").toInt() != 0;
      this->display()->set({ { "CutBy", way } });
      if (way != 0 && !isCut) // else the cut stays where it is
      {
        this->cutAnew();
      }
    });
  QObject::connect(this->CutShape, &QComboBox::currentIndexChanged, this, &pqViewCard::cutAnew);
}

//------------------------------------------------------------------------------
QSlider* pqViewCard::addSlider(QHBoxLayout* row, const char* name, const QString& label,
  const QString& tip, const std::function<QString(double share)>& spell)
{
  auto* slider = camaron::Make<QSlider>(this->content(), name, Qt::Horizontal);
  slider->setRange(0, SliderSteps);
  slider->setToolTip(tip);
  slider->setAccessibleName(label);
  auto* text = new QLabel(label, this->content());
  text->setMinimumWidth(text->fontMetrics().horizontalAdvance(tr("Isosurface ")));
  row->addWidget(text);
  row->addWidget(slider, 1);
  auto* value = camaron::Make<QLabel>(this->content(), QString(name) + "Value");
  value->setMinimumWidth(value->fontMetrics().horizontalAdvance("-0.000"));
  row->addWidget(value);
  this->Spellings << [=] { value->setText(spell(double(slider->value()) / SliderSteps)); };
  QObject::connect(slider, &QSlider::valueChanged, value, this->Spellings.back());
  return slider;
}

//------------------------------------------------------------------------------
void pqViewCard::makeSliders()
{
  QHBoxLayout* row = this->addRow();
  this->CutPosition = this->addSlider(row, "CutPosition", tr("Cut"),
    tr("Position or size of the cut"), [this](double) { return this->spellCut(); });
  const char* const names[] = { "CutX", "CutY", "CutZ" };
  for (int axis = 0; axis < 3; ++axis)
  {
    const QString letter = QString("XYZ").mid(axis, 1);
    this->Axes << this->addTool(row, names[axis],
      tr("Cut by a plane perpendicular to the %1 axis").arg(letter),
      [this, axis] { this->cutAcross(axis); });
    this->Axes.back()->setText(letter);
  }
  this->Flip = this->addTool(row, "Flip", tr("Keep the other side of the cut"), [this]
    { this->display()->set({ { "CutKeeps", 1 - this->display()->value("CutKeeps").toInt() } }); });
  this->Handles = this->addTool(row, "Handles", tr("Handles of the cut in the view"),
    [this] { this->display()->set({ { "CutHandles", this->Handles->isChecked() ? 1 : 0 } }); });
  this->Handles->setCheckable(true);
  this->Shrink = this->addSlider(this->addRow(), "Shrink", tr("Shrink"),
    tr("Shrinks each cell toward its center"),
    [](double share) { return camaron::FormatPercent(share, 1); });
  this->Explode =
    this->addSlider(this->addRow(), "Explode", tr("Explode"), tr("Moves the cells apart"),
      [](double share) { return camaron::ShortNumber(MostExploded * share, Digits); });
  this->Isosurface = this->addSlider(this->addRow(), "Isosurface", tr("Isosurface"),
    tr("Value of the isosurface within the range of its array"),
    [this](double share)
    {
      return this->display()->isosurfaceArray().isEmpty()
        ? QString()
        : camaron::ShortNumber(this->isosurfaceAt(share), Digits);
    });
  this->CutPosition->setValue(SliderSteps / 2);
  this->connectSlider(
    this->Shrink, [](double share) { return Properties{ { "ShrinkFactor", 1 - share } }; });
  this->connectSlider(this->Explode,
    [](double share) { return Properties{ { "ExplodeFactor", MostExploded * share } }; });
  this->connectSlider(this->Isosurface,
    [this](double share)
    {
      return Properties{ { "DrawIsosurfaces", 1 },
        { "IsosurfaceValues", QVariantList{ this->isosurfaceAt(share) } } };
    });
  this->connectSlider(this->CutPosition, [this](double) { return this->cutValues(); });
}

//------------------------------------------------------------------------------
void pqViewCard::connectSlider(
  QSlider* slider, const std::function<Properties(double share)>& toProperties)
{
  const bool isOfCut = slider == this->CutPosition;
  const auto present = [=] { return toProperties(double(slider->value()) / SliderSteps); };
  const auto preview = [=](const Properties& values)
  { isOfCut ? this->display()->previewCut(values) : this->display()->preview(values); };
  const auto set = [=] { isOfCut ? this->cut() : this->display()->set(present()); };
  QObject::connect(slider, &QSlider::sliderPressed, this,
    [=]
    {
      const QStringList names = present().keys();
      if (isOfCut)
      {
        this->Before = this->display()->cut(names);
        return;
      }
      this->display()->set({}); // Mesh Inspection
      this->Before.clear();
      for (const QString& name : names)
      {
        this->Before[name] = this->display()->value(name);
      }
    });
  QObject::connect(slider, &QSlider::valueChanged, this,
    [=] { slider->isSliderDown() ? preview(present()) : set(); });
  QObject::connect(slider, &QSlider::sliderReleased, this,
    [=]
    {
      preview(this->Before); // to which undo goes back
      set();
    });
}

//------------------------------------------------------------------------------
double pqViewCard::isosurfaceAt(double share) const
{
  const QPair<double, double> range = this->display()->isosurfaceRange();
  return range.first + share * (range.second - range.first);
}

//------------------------------------------------------------------------------
QString pqViewCard::spellCut() const
{
  if (!this->CutPosition->isEnabled())
  {
    return QString();
  }
  return camaron::SpellCut(this->CutShape->currentData().toString(),
    this->questions()->summary().Bounds, this->cutValues());
}

//------------------------------------------------------------------------------
void pqViewCard::cut()
{
  this->display()->setCut(this->CutShape->currentData().toString(), this->cutValues());
}

//------------------------------------------------------------------------------
void pqViewCard::cutAnew()
{
  this->Cut.clear();
  this->cut();
}

//------------------------------------------------------------------------------
void pqViewCard::cutAcross(int axis)
{
  const pqScopedUndoSet undo(tr("Change Cut"));
  this->Axis = axis;
  if (this->CutBy->currentIndex() == 0)
  {
    this->display()->set({ { "CutBy", ExactCut } });
  }
  {
    const QSignalBlocker blocker(this->CutShape);
    this->CutShape->setCurrentIndex(this->CutShape->findData("Plane"));
  }
  this->cutAnew();
}

//------------------------------------------------------------------------------
pqViewCard::Properties pqViewCard::cutValues() const
{
  const QString shape = this->CutShape->currentData().toString();
  const camaron::CutBounds bounds = this->questions()->summary().Bounds;
  if (!this->Cut.isEmpty() && this->CutPosition->value() == this->CutPlace)
  {
    return this->Cut; // exactly, not rounded to the steps of the slider
  }
  return camaron::MoveCut(shape, bounds,
    this->Cut.isEmpty() ? camaron::MakeCut(shape, bounds, this->Axis) : this->Cut,
    double(this->CutPosition->value()) / SliderSteps);
}

//------------------------------------------------------------------------------
void pqViewCard::showCut()
{
  if (this->CutPosition->isSliderDown())
  {
    return; // which moves the cut
  }
  this->Cut.clear();
  if (!this->CutPosition->isEnabled())
  {
    return;
  }
  const QString shape = this->CutShape->currentData().toString();
  const camaron::CutBounds bounds = this->questions()->summary().Bounds;
  this->Cut = this->display()->cut(camaron::MakeCut(shape, bounds, this->Axis).keys());
  const double share = camaron::GetCutShare(shape, bounds, this->Cut);
  if (std::isfinite(share))
  {
    const QSignalBlocker blocker(this->CutPosition);
    this->CutPosition->setValue(
      static_cast<int>(std::lround(std::clamp(share, 0.0, 1.0) * SliderSteps)));
  }
  this->CutPlace = this->CutPosition->value();
}

//------------------------------------------------------------------------------
void pqViewCard::showPlain()
{
  Properties plain = { { "Representation", QString("Surface With Edges") }, { "CutBy", 0 },
    { "ShrinkFactor", 1.0 }, { "ExplodeFactor", 0.0 } };
  for (const Mode& mode : this->Modes)
  { // else the next switch would bring back the others
    plain[mode.Property] = mode.Plain;
  }
  this->display()->set(plain);
}

//------------------------------------------------------------------------------
void pqViewCard::refresh()
{
  const bool isShown = this->mesh()->representation() != nullptr;
  const bool isInspected = this->display()->isInspected();
  if (this->Modes.isEmpty())
  {
    this->makeModes();
  }
  for (const Mode& mode : this->Modes)
  {
    const int value = this->display()->value(mode.Property).toInt();
    mode.Button->setChecked(isInspected && value == mode.On);
  }
  this->content()->setEnabled(isShown && this->display()->canInspect());
  const QSignalBlocker blocker(this->CutBy);
  this->CutBy->setCurrentIndex(isInspected ? this->display()->value("CutBy").toInt() : 0);
  const bool isCut = this->CutBy->currentIndex() > 0;
  const int shape = isCut ? this->CutShape->findData(this->display()->cutShape())
                          : qMax(0, this->CutShape->currentIndex());
  {
    const QSignalBlocker shapes(this->CutShape);
    this->CutShape->setCurrentIndex(shape);
  }
  if (this->mesh()->meshVersion() != this->CutMesh)
  { // the axis was for another one
    this->CutMesh = this->mesh()->meshVersion();
    this->Axis = -1;
  }
  const camaron::CutBounds bounds = this->questions()->summary().Bounds;
  for (int axis = 0; axis < 3; ++axis)
  {
    camaron::SetEnabled(this->Axes[axis], bounds[2 * axis + 1] > bounds[2 * axis],
      tr("The mesh is flat in this direction."));
  }
  const QString reason = isCut ? tr("Half-spaces are edited in the Properties panel.")
                               : tr("The mesh is not cut: choose a kind of cut or an axis first.");
  camaron::SetEnabled(this->CutPosition, isCut && shape >= 0, reason);
  this->showCut();
  camaron::SetEnabled(this->CutShape, isCut, reason);
  camaron::SetEnabled(this->Flip, isCut, reason);
  camaron::SetEnabled(this->Handles, isCut && this->display()->hasCutHandles(),
    isCut
      ? tr("The Properties panel, which has the handles, does not show the display of the mesh.")
      : reason);
  this->Handles->setChecked(isCut && this->display()->value("CutHandles").toBool());
  const bool hasValues = !this->display()->isosurfaceArray().isEmpty();
  const QString noValues = tr("The mesh has no point array.");
  camaron::SetEnabled(this->Isosurface, hasValues, noValues);
  for (const Mode& mode : this->Modes)
  {
    camaron::SetEnabled(mode.Button, hasValues || !mode.NeedsPoints, noValues);
  }
  const auto show = [](QSlider* slider, double share)
  {
    const QSignalBlocker blocker(slider);
    slider->setValue(static_cast<int>(std::lround(share * SliderSteps)));
  };
  show(this->Shrink, isInspected ? 1 - this->display()->value("ShrinkFactor").toDouble() : 0);
  show(this->Explode,
    isInspected ? this->display()->value("ExplodeFactor").toDouble() / MostExploded : 0);
  for (const auto& spell : this->Spellings)
  {
    spell();
  }
}
