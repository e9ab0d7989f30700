// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GatheredMesh.h"

#include "Base/Text.h"
#include "GatheredPieces.h"
#include "Intake/FaceMesh/GridArrays.h"
#include "Scan/ScanError.h"

#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <functional>
#include <iterator>
#include <limits>
#include <string>

namespace camaron
{
namespace
{
using Piece = GatheredPieces::Piece;

//------------------------------------------------------------------------------
IndexRange GetFaces(const Piece& piece, vtkIdType cell)
{
  return piece.View.GetCellType(cell) == VTK_POLYHEDRON ? piece.View.GetPolyhedronFaces(cell)
                                                        : IndexRange();
}

//------------------------------------------------------------------------------
// Sizes of the kept cells.
Extent Measure(const GatheredPieces& pieces)
{
  Extent sizes;
  pieces.ForEachCell(
    [&sizes](const Piece& piece, vtkIdType cell)
    {
      sizes.Points += piece.View.GetCellPoints(cell).Size;
      const IndexRange faces = GetFaces(piece, cell);
      sizes.PolyhedronFaces += faces.Size;
      for (vtkIdType f = 0; f < faces.Size; ++f)
      {
        sizes.PolyhedronFacePoints += piece.View.GetPolyhedronFacePoints(faces[f]).Size;
      }
    });
  return sizes;
}

//------------------------------------------------------------------------------
template <typename Id>
void MergeCells(const GatheredPieces& pieces, const Extent& sizes, vtkUnstructuredGrid* grid)
{
  Arrays<Id> arrays(pieces.GetNumberOfNewCells(), sizes, false);
  Id next = 0, point = 0, face = 0, corner = 0;
  pieces.ForEachCell(
    [&](const Piece& piece, vtkIdType cell)
    {
      const auto add = [&](Buffer<Id>& ids, Id& end, const IndexRange& points)
      {
        for (vtkIdType i = 0; i < points.Size; ++i)
        {
          ids[end++] = static_cast<Id>(pieces.GetNewPoint(piece, points[i]));
        }
      };
      arrays.Types[next] = piece.View.GetCellType(cell);
      arrays.Offsets[next] = point;
      add(arrays.Connectivity, point, piece.View.GetCellPoints(cell));
      if (sizes.PolyhedronFaces > 0)
      {
        arrays.LocationOffsets[next] = face;
        const IndexRange faces = GetFaces(piece, cell);
        for (vtkIdType f = 0; f < faces.Size; ++f)
        {
          arrays.Locations[face] = face;
          arrays.FaceOffsets[face++] = corner;
          add(arrays.FaceConnectivity, corner, piece.View.GetPolyhedronFacePoints(faces[f]));
        }
      }
      ++next;
    });
  arrays.MoveTo(grid);
}

//------------------------------------------------------------------------------
void MergePoints(const GatheredPieces& pieces, vtkUnstructuredGrid* grid)
{
  bool single = true;
  for (const Piece& piece : pieces.GetPieces())
  {
    single = single && (piece.View.HasFloatPoints() || piece.View.GetNumberOfPoints() == 0);
  }
  vtkNew<vtkPoints> points;
  points->SetDataType(single ? VTK_FLOAT : VTK_DOUBLE);
  points->SetNumberOfPoints(pieces.GetNumberOfNewPoints());
  for (vtkIdType i = 0; i < pieces.GetNumberOfNewPoints(); ++i)
  {
    points->SetPoint(i, pieces.GetPlace(pieces.GetOldPoint(i)).data());
  }
  grid->SetPoints(points);
}

//------------------------------------------------------------------------------
// The arrays with one name; nullptr for parts that lack it.
struct PartArrays
{
  std::string Name;
  int Attribute; ///< such as normals, if it is that in all parts that have it, otherwise -1
  std::vector<vtkAbstractArray*> OfParts;

  bool IsComplete() const
  {
    return std::find(this->OfParts.begin(), this->OfParts.end(), nullptr) == this->OfParts.end();
  }

  /// An array for all parts, filled with the value for "undefined"; nullptr if they do not match.
  vtkSmartPointer<vtkAbstractArray> MakeJoint(vtkIdType size) const
  {
    vtkAbstractArray* model = nullptr;
    bool areNumbers = true, haveOneType = true;
    for (vtkAbstractArray* const array : this->OfParts)
    {
      model = model ? model : array;
      if (!array)
      {
        continue;
      }
      if (array->GetNumberOfComponents() != model->GetNumberOfComponents())
      {
        return nullptr;
      }
      areNumbers =
        areNumbers && vtkDataArray::SafeDownCast(array) && array->GetDataType() != VTK_BIT;
      haveOneType = haveOneType && array->GetDataType() == model->GetDataType();
    }
    if (!areNumbers && !(haveOneType && this->IsComplete()))
    {
      return nullptr;
    }
    const int type = haveOneType ? model->GetDataType() : VTK_DOUBLE;
    auto joint = vtkSmartPointer<vtkAbstractArray>::Take(vtkAbstractArray::CreateArray(type));
    joint->SetName(this->Name.c_str());
    joint->SetNumberOfComponents(model->GetNumberOfComponents());
    joint->CopyComponentNames(model);
    joint->SetNumberOfTuples(size);
    if (!this->IsComplete())
    {
      const bool isReal = type == VTK_FLOAT || type == VTK_DOUBLE;
      vtkDataArray::SafeDownCast(joint)->Fill(
        isReal ? std::numeric_limits<double>::quiet_NaN() : 0);
    }
    return joint;
  }
};

//------------------------------------------------------------------------------
// The arrays that all parts have, then the others, in the order of the parts.
std::vector<PartArrays> FindArrays(const std::vector<vtkDataSetAttributes*>& parts)
{
  const bool haveIds = std::all_of(
    parts.begin(), parts.end(), [](vtkDataSetAttributes* part) { return part->GetGlobalIds(); });
  std::vector<PartArrays> found;
  for (std::size_t part = 0; part < parts.size(); ++part)
  {
    for (int i = 0; i < parts[part]->GetNumberOfArrays(); ++i)
    {
      vtkAbstractArray* const array = parts[part]->GetAbstractArray(i);
      const std::string name = array->GetName() ? array->GetName() : "";
      if (name.empty() || name == vtkDataSetAttributes::GhostArrayName() ||
        (array == parts[part]->GetGlobalIds() && !haveIds))
      {
        continue;
      }
      const int attribute = parts[part]->IsArrayAnAttribute(i);
      auto known = std::find_if(found.begin(), found.end(),
        [&name](const PartArrays& other) { return other.Name == name; });
      if (known == found.end())
      {
        known = found.insert(known, { name, attribute, {} });
        known->OfParts.resize(parts.size());
      }
      known->OfParts[part] = array;
      known->Attribute = known->Attribute == attribute ? attribute : -1;
    }
  }
  std::stable_partition(
    found.begin(), found.end(), [](const PartArrays& arrays) { return arrays.IsComplete(); });
  return found;
}

//------------------------------------------------------------------------------
// Where a point or cell of the merged mesh comes from.
struct TupleSource
{
  std::size_t Part;
  vtkIdType Tuple;
};

//------------------------------------------------------------------------------
// Merges the arrays of points or cells, see MergeParts; adds the names of those that cannot be
// joined to @a leftOut: strings, bits, or different numbers of components.
void Merge(const std::vector<vtkDataSetAttributes*>& parts, vtkIdType size,
  const std::function<TupleSource(vtkIdType)>& getSource, vtkDataSetAttributes* merged,
  std::vector<std::string>& leftOut)
{
  for (const PartArrays& arrays : FindArrays(parts))
  {
    const vtkSmartPointer<vtkAbstractArray> joint = arrays.MakeJoint(size);
    if (!joint)
    {
      leftOut.push_back(arrays.Name);
      continue;
    }
    for (vtkIdType i = 0; i < size; ++i)
    {
      const TupleSource source = getSource(i);
      if (vtkAbstractArray* const array = arrays.OfParts[source.Part])
      {
        joint->SetTuple(i, source.Tuple, array);
      }
    }
    const int index = merged->AddArray(joint);
    if (arrays.Attribute >= 0 && arrays.IsComplete())
    {
      merged->SetActiveAttribute(index, arrays.Attribute);
    }
  }
}

//------------------------------------------------------------------------------
// Copies the values of points and cells from the pieces to a grid, which was merged from them.
// Warns about arrays that cannot be joined.
void MergeArrays(const GatheredPieces& pieces, vtkUnstructuredGrid* grid, Warnings& warnings)
{
  std::vector<vtkDataSetAttributes*> ofPoints, ofCells;
  for (const Piece& piece : pieces.GetPieces())
  {
    ofPoints.push_back(piece.Mesh->GetPointData());
    ofCells.push_back(piece.Mesh->GetCellData());
  }
  const auto getSource = [&pieces](vtkIdType id, vtkIdType Piece::* first)
  {
    const Piece& piece = pieces.FindPiece(id, first);
    return TupleSource{ pieces.GetIndex(piece), id - piece.*first };
  };
  std::vector<std::string> leftOut;
  Merge(
    ofPoints, pieces.GetNumberOfNewPoints(),
    [&](vtkIdType i) { return getSource(pieces.GetOldPoint(i), &Piece::FirstPoint); },
    grid->GetPointData(), leftOut);
  Merge(
    ofCells, grid->GetNumberOfCells(), [&](vtkIdType i)
    { return getSource(pieces.GetOldCell(i), &Piece::FirstCell); }, grid->GetCellData(), leftOut);
  std::string names;
  for (const std::string& name : leftOut)
  {
    names += (names.empty() ? "" : ", ") + name;
  }
  if (!names.empty())
  {
    warnings.Add(
      "arrays that some parts of the mesh lack or store in another form are omitted: " + names);
  }
}

//------------------------------------------------------------------------------
// Merges field data; of arrays with the same name, the one of the first part is used.
void MergeFieldData(const std::vector<MeshPart>& parts, vtkFieldData* merged)
{
  for (const MeshPart& part : parts)
  {
    vtkFieldData* const data = part.Mesh->GetFieldData();
    for (int i = 0; i < data->GetNumberOfArrays(); ++i)
    {
      vtkAbstractArray* const array = data->GetAbstractArray(i);
      if (array->GetName() && !merged->HasArray(array->GetName()))
      {
        merged->AddArray(array);
      }
    }
  }
}
}

//------------------------------------------------------------------------------
bool HasSeams(vtkDataSet* mesh)
{
  return (mesh->GetCellGhostArray() || mesh->GetPointData()->GetGlobalIds() ||
           mesh->GetCellData()->GetGlobalIds()) &&
    !GatheredPieces({ { mesh } }).IsUnchanged();
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkUnstructuredGrid> MergeParts(
  const std::vector<MeshPart>& parts, Warnings& warnings)
{
  // Processes or blocks without points may lack arrays that the others have.
  std::vector<MeshPart> filled;
  std::copy_if(parts.begin(), parts.end(), std::back_inserter(filled),
    [](const MeshPart& part) { return part.Mesh->GetNumberOfPoints() > 0; });
  if (filled.empty() && !parts.empty())
  {
    filled.push_back(parts.front());
  }
  const GatheredPieces pieces(filled);
  auto merged = vtkSmartPointer<vtkUnstructuredGrid>::New();
  const Extent sizes = Measure(pieces);
  if (std::max({ pieces.GetNumberOfNewCells(), sizes.Points, sizes.PolyhedronFaces,
        sizes.PolyhedronFacePoints }) <= VTK_TYPE_INT32_MAX)
  {
    MergeCells<vtkTypeInt32>(pieces, sizes, merged);
  }
  else
  {
    MergeCells<vtkTypeInt64>(pieces, sizes, merged);
  }
  MergePoints(pieces, merged);
  MergeArrays(pieces, merged, warnings);
  MergeFieldData(parts, merged->GetFieldData());
  if (pieces.GetNumberOfTwins() > 0)
  {
    warnings.Add(CountOf(pieces.GetNumberOfTwins(),
      "point of a piece without global ids was merged with a point of another piece at the same "
      "position",
      "points of pieces without global ids were merged with points of other pieces at the same "
      "position"));
  }
  if (pieces.GetNumberOfUnclearPlaces() > 0)
  {
    warnings.Add("the mesh may be disconnected at " +
      CountOf(pieces.GetNumberOfUnclearPlaces(), "position", "positions") +
      " where pieces without global ids have several points");
  }
  return merged;
}
}
