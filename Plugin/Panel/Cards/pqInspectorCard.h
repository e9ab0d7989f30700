// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class pqInspectorCard
 * @brief A section of the Mesh Inspector that folds.
 *
 * A card shows one subject of the inspected mesh and is useful alone. A subclass creates its
 * widgets in content(), and shows the mesh in refresh(), which is called when the mesh has changed
 * and the card is visible: a folded card, or one in a hidden dock, costs nothing. Cards read and
 * change the mesh only through the services of pqMeshServices.
 *
 * Whether a card is open is kept in the settings.
 */
#ifndef pqInspectorCard_h
#define pqInspectorCard_h

#include "pqInspectorState.h" // for what cards share
#include "pqMeshServices.h"   // for the services

#include <QWidget>

#include <functional> // for clicks

class pqExpanderButton;
class QComboBox;
class QHBoxLayout;
class QPushButton;
class QToolButton;
class QVBoxLayout;

class pqInspectorCard : public QWidget
{
  Q_OBJECT
  typedef QWidget Superclass;
  Q_PROPERTY(bool open READ isOpen WRITE setOpen)

public:
  ///@{
  bool isOpen() const;
  void setOpen(bool open);
  ///@}

  /// Refreshes at once if the card is visible, else when it becomes visible.
  void refreshWhenVisible();

protected:
  /**
   * @param name of the card in settings and GUI tests, such as "Worst"
   * @param title that the user sees
   * @param isOpen whether the card is open until the user decides otherwise
   */
  pqInspectorCard(const QString& name, const QString& title, bool isOpen, pqInspectorState* state,
    QWidget* parent);

  /// True if tables of all cells may be computed now. If the mesh has values, but too many cells to
  /// compute without request, shows a button for the request instead.
  bool mayCompute(bool hasValues);

  /// Grays out the presets of a list that judge no cell of the mesh, if its cells are known.
  void grayPresets(QComboBox* presets) const;

  /// Opens the card and scrolls to it.
  void reveal();

  /// Shows the mesh, which may be none.
  virtual void refresh() = 0;

  /// Shows the same texts in the colors of another palette.
  virtual void recolor() {}

  pqInspectorState* state() const { return this->State; }

  ///@{
  /// The services about the mesh, see pqMeshServices.
  pqInspectedMesh* mesh() const { return this->State->services().Mesh; }
  pqMeshQuestions* questions() const { return this->State->services().Questions; }
  pqMeshFilters* filters() const { return this->State->services().Filters; }
  pqMeshSelection* selection() const { return this->State->services().Selection; }
  pqMeshDisplay* display() const { return this->State->services().Display; }
  ///@}

  ///@{
  /// Where subclasses put their widgets.
  QWidget* content() const { return this->Content; }
  QVBoxLayout* contentLayout() const { return this->Layout; }
  ///@}

  /// A row at the end of the content.
  QHBoxLayout* addRow();

  /// camaron::MakeTool at the end of a row, with what a click does.
  QToolButton* addTool(QHBoxLayout* row, const char* name, const QString& tip,
    const std::function<void()>& click = {});

  void changeEvent(QEvent* event) override;
  void showEvent(QShowEvent* event) override;

  /// Folds and unfolds by keyboard, and shows the focus of the title.
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  pqInspectorState* State;
  pqExpanderButton* Button;
  QWidget* Content;
  QVBoxLayout* Layout;
  QPushButton* Compute = nullptr; ///< the request
  bool IsStale = true;
};

#endif
