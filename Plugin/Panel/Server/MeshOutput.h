// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::MeshOutput
 * @brief An output with a mesh, and what the client knows of it without computing.
 */
#ifndef camaron_MeshOutput_h
#define camaron_MeshOutput_h

#include "pqOutputPort.h" // for the pointer to it

#include "vtkDataObject.h" // for associations

#include <QCoreApplication> // for translations
#include <QPointer>
#include <QStringList> // for names

class pqDataRepresentation;
class pqRenderView;
class vtkPVArrayInformation;
class vtkPVDataInformation;
class vtkSMProxy;
class vtkSMSourceProxy;

namespace camaron
{
class MeshOutput
{
  Q_DECLARE_TR_FUNCTIONS(MeshOutput)

public:
  /// nullptr for no mesh.
  explicit MeshOutput(pqOutputPort* port)
    : Port(port)
  {
  }

  pqOutputPort* port() const { return this->Port; }

  /// Information about the data without an update; nullptr without a mesh.
  vtkPVDataInformation* information() const;

  /// Information about an array; nullptr if there is none of this name.
  vtkPVArrayInformation* array(const QString& name, int association = vtkDataObject::CELL) const;

  /// One-component cell arrays.
  QStringList cellArrays() const;

  /// How tables of the server identify elements: "Global id" if the mesh has them, else "Index".
  QString idSpace() const;

  /// Whether the mesh is small enough for computations without request: it has at most the number
  /// of cells in ParaView's settings.
  bool isSmall() const;

  /// Its active selection; nullptr if there is none.
  vtkSMSourceProxy* selection() const;

  ///@{
  /// Element type of the cells of the mesh: "Cell", or "Face", "Edge" or "Vertex" of Mesh Elements;
  /// and what texts call a number of them, such as "face" or, by default, "faces".
  QString elementType() const;
  QString elements(qint64 count = 0) const;
  ///@}

  /// Types of the outputs of Mesh Elements.
  static const QStringList ElementTypes;

  /// The output with another type of elements of the mesh; nullptr if there is no Mesh Elements.
  pqOutputPort* elementsPort(const QString& type) const;

  /// The active view, or another one that shows the mesh if that does not.
  pqRenderView* view() const;

  /// The representation of the mesh in that view; nullptr if it has none.
  pqDataRepresentation* representation() const;

protected:
  /// The page "Mesh Inspector" of ParaView's settings; nullptr without a server.
  static vtkSMProxy* settings();

  QPointer<pqOutputPort> Port;
};
}

#endif
