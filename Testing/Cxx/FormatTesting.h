// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FormatTesting.h
 * @brief Shared by the tests of formats: files, readers and writers with their messages, comparison
 * of grids.
 */
#ifndef camaron_FormatTesting_h
#define camaron_FormatTesting_h

#include "Mesh/CellFacets.h"
#include "Mesh/CellShape.h"
#include "TemporaryFolder.h"
#include "vtkCamaronCompat.h"

#include "vtkCallbackCommand.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCommand.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVariant.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace camaron
{
namespace testing
{
//------------------------------------------------------------------------------
/// A file that the destructor removes, in a folder that is removed at the end of the program.
class File
{
public:
  explicit File(const std::string& bytes, const std::string& name = "test.mesh")
    : Path((GetFolder() / name).string())
  {
    std::ofstream(this->Path, std::ios::binary) << bytes;
  }
  ~File() { std::filesystem::remove(this->Path); }
  File(const File&) = delete;
  void operator=(const File&) = delete;

  static const std::filesystem::path& GetFolder()
  {
    static const TemporaryFolder folder;
    return folder.Path;
  }

  std::string Path;
};

//------------------------------------------------------------------------------
/// Result of reading a file.
struct Result
{
  vtkSmartPointer<vtkUnstructuredGrid> Grid;
  unsigned long ErrorCode = 0;
  std::vector<std::string> Errors;
  std::vector<std::string> Warnings;

  bool IsEmpty() const
  {
    return this->Grid->GetNumberOfPoints() == 0 && this->Grid->GetNumberOfCells() == 0;
  }
  /// Whether there is one error message, a code, and an empty grid.
  bool IsProperError() const
  {
    return this->Errors.size() == 1 && this->ErrorCode != 0 && this->IsEmpty();
  }
};

inline void Collect(vtkObject*, unsigned long, void* messages, void* text)
{
  static_cast<std::vector<std::string>*>(messages)->push_back(static_cast<const char*>(text));
}

inline void Observe(vtkObject* object, unsigned long event, std::vector<std::string>& messages)
{
  vtkNew<vtkCallbackCommand> command;
  command->SetCallback(Collect);
  command->SetClientData(&messages);
  object->AddObserver(event, command);
}

/// Reads a file with class @a Reader; @a configure sets its options.
template <typename Reader, typename Configure>
Result ReadWith(
  const std::string& path, int piece, int pieces, int ghostLevels, Configure&& configure)
{
  Result result;
  vtkNew<Reader> reader;
  reader->SetFileName(path.c_str());
  configure(reader.Get());
  Observe(reader, vtkCommand::ErrorEvent, result.Errors);
  Observe(reader, vtkCommand::WarningEvent, result.Warnings);
  reader->UpdatePiece(piece, pieces, ghostLevels);
  result.Grid = reader->GetOutput();
  result.ErrorCode = reader->GetErrorCode();
  return result;
}

template <typename Reader>
Result ReadWith(const std::string& path, int piece = 0, int pieces = 1, int ghostLevels = 0)
{
  return ReadWith<Reader>(path, piece, pieces, ghostLevels, [](Reader*) {});
}

//------------------------------------------------------------------------------
/// Result of writing a mesh.
struct Written
{
  int Success = 0;
  unsigned long ErrorCode = 0;
  std::vector<std::string> Errors;
  std::vector<std::string> Warnings;
  std::string Bytes; ///< of the file, from WriteWith
};

inline std::string GetBytes(const std::string& path)
{
  std::ostringstream bytes;
  bytes << std::ifstream(path, std::ios::binary).rdbuf();
  return bytes.str();
}

/// Writes a mesh with class @a Writer; @a configure sets its options.
template <typename Writer>
Written WriteTo(
  const std::string& path, vtkDataObject* mesh, const std::function<void(Writer*)>& configure = {})
{
  Written written;
  vtkNew<Writer> writer;
  writer->SetFileName(path.c_str());
  writer->SetInputDataObject(mesh);
  if (configure)
  {
    configure(writer);
  }
  Observe(writer, vtkCommand::ErrorEvent, written.Errors);
  Observe(writer, vtkCommand::WarningEvent, written.Warnings);
  written.Success = writer->Write();
  written.ErrorCode = writer->GetErrorCode();
  return written;
}

/// The same with the bytes of the file, which remain "before" if it is not written.
template <typename Writer>
Written WriteWith(
  vtkDataObject* mesh, const std::string& name, const std::function<void(Writer*)>& configure = {})
{
  const File file("before", name);
  Written written = WriteTo<Writer>(file.Path, mesh, configure);
  written.Bytes = GetBytes(file.Path);
  return written;
}

//------------------------------------------------------------------------------
inline ::testing::AssertionResult HaveSameValues(vtkDataArray* a, vtkDataArray* b)
{
  if (a->GetDataType() != b->GetDataType() || a->GetNumberOfValues() != b->GetNumberOfValues())
  {
    return ::testing::AssertionFailure()
      << a->GetClassName() << " of " << a->GetNumberOfValues() << " values, " << b->GetClassName()
      << " of " << b->GetNumberOfValues();
  }
  // Compared bit by bit, as NaN is not equal to itself.
  if (a->GetNumberOfValues() > 0 &&
    std::memcmp(a->GetVoidPointer(0), b->GetVoidPointer(0),
      static_cast<std::size_t>(a->GetNumberOfValues()) * a->GetDataTypeSize()) != 0)
  {
    return ::testing::AssertionFailure() << "values differ";
  }
  return ::testing::AssertionSuccess();
}

inline ::testing::AssertionResult HaveSameLists(vtkCellArray* a, vtkCellArray* b)
{
  const vtkIdType sizeOfA = a ? a->GetNumberOfCells() : 0, sizeOfB = b ? b->GetNumberOfCells() : 0;
  if (sizeOfA != sizeOfB)
  {
    return ::testing::AssertionFailure() << sizeOfA << " and " << sizeOfB << " lists";
  }
  if (sizeOfA == 0)
  {
    return ::testing::AssertionSuccess();
  }
  const auto offsets = HaveSameValues(a->GetOffsetsArray(), b->GetOffsetsArray());
  return offsets ? HaveSameValues(a->GetConnectivityArray(), b->GetConnectivityArray()) : offsets;
}

inline void ExpectSameArrays(vtkDataSetAttributes* a, vtkDataSetAttributes* b)
{
  ASSERT_EQ(a->GetNumberOfArrays(), b->GetNumberOfArrays());
  for (int i = 0; i < a->GetNumberOfArrays(); ++i)
  {
    const std::string name = a->GetAbstractArray(i)->GetName();
    ASSERT_NE(b->GetArray(name.c_str()), nullptr) << name;
    EXPECT_TRUE(HaveSameValues(a->GetArray(i), b->GetArray(name.c_str()))) << name;
  }
}

/// Expects the same points, types, connectivity, faces and arrays, bit by bit and in order.
inline void ExpectSameGrid(vtkUnstructuredGrid* a, vtkUnstructuredGrid* b)
{
  ASSERT_EQ(a->GetNumberOfPoints(), b->GetNumberOfPoints());
  ASSERT_EQ(a->GetNumberOfCells(), b->GetNumberOfCells());
  if (a->GetNumberOfPoints() > 0)
  {
    EXPECT_TRUE(HaveSameValues(a->GetPoints()->GetData(), b->GetPoints()->GetData()));
  }
  if (a->GetNumberOfCells() > 0)
  {
    EXPECT_TRUE(HaveSameValues(GetCellTypes(a), GetCellTypes(b)));
    EXPECT_TRUE(HaveSameLists(a->GetCells(), b->GetCells()));
    EXPECT_TRUE(HaveSameLists(a->GetPolyhedronFaces(), b->GetPolyhedronFaces()));
    EXPECT_TRUE(HaveSameLists(a->GetPolyhedronFaceLocations(), b->GetPolyhedronFaceLocations()));
  }
  ExpectSameArrays(a->GetPointData(), b->GetPointData());
  ExpectSameArrays(a->GetCellData(), b->GetCellData());
}

/// Number of cells of a type in a grid.
inline vtkIdType Count(vtkUnstructuredGrid* grid, int type)
{
  vtkIdType count = 0;
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    count += grid->GetCellType(cell) == type;
  }
  return count;
}

//------------------------------------------------------------------------------
/// All lists of point ids that define a cell, in ids of the whole mesh.
inline std::vector<std::vector<vtkIdType>> DescribeCell(
  vtkUnstructuredGrid* grid, vtkIdType cell, const std::vector<vtkIdType>& ids)
{
  const MeshView mesh(grid);
  std::vector<std::vector<vtkIdType>> lists(1);
  lists[0].push_back(grid->GetCellType(cell));
  for (vtkIdType i = 0; i < mesh.GetCellPoints(cell).Size; ++i)
  {
    lists[0].push_back(ids[mesh.GetCellPoints(cell)[i]]);
  }
  CellFacets(mesh).ForEach(cell,
    [&](const vtkIdType* points, vtkIdType size, vtkIdType)
    {
      lists.emplace_back();
      for (vtkIdType i = 0; i < size; ++i)
      {
        lists.back().push_back(ids[points[i]]);
      }
    });
  return lists;
}

//------------------------------------------------------------------------------
/// Volume of a 3D cell with plane faces, positive if these are oriented outward; area of a 2D cell
/// in the plane of x and y, positive if counterclockwise.
inline double GetMeasure(vtkUnstructuredGrid* grid, vtkIdType cell)
{
  const MeshView mesh(grid);
  double sum = 0;
  const auto getPoint = [&](vtkIdType id)
  {
    std::array<double, 3> x;
    mesh.GetPoint(id, x.data());
    return x;
  };
  const IndexRange points = mesh.GetCellPoints(cell);
  if (GetCellShape(mesh.GetCellType(cell)).Dimension == 2)
  {
    for (vtkIdType i = 0; i < points.Size; ++i)
    {
      const auto a = getPoint(points[i]), b = getPoint(points[(i + 1) % points.Size]);
      sum += (a[0] * b[1] - a[1] * b[0]) / 2;
    }
    return sum;
  }
  CellFacets(mesh).ForEach(cell,
    [&](const vtkIdType* ids, vtkIdType size, vtkIdType)
    {
      const auto a = getPoint(ids[0]);
      for (vtkIdType i = 1; i + 1 < size; ++i)
      {
        const auto b = getPoint(ids[i]), c = getPoint(ids[i + 1]);
        sum += (a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
                 a[2] * (b[0] * c[1] - b[1] * c[0])) /
          6;
      }
    });
  return sum;
}

//------------------------------------------------------------------------------
inline std::vector<vtkIdType> GetIds(vtkDataSetAttributes* data, vtkIdType size)
{
  std::vector<vtkIdType> ids(size);
  for (vtkIdType i = 0; i < size; ++i)
  {
    ids[i] = data->GetGlobalIds() ? static_cast<vtkIdType>(data->GetGlobalIds()->GetTuple1(i)) : i;
  }
  return ids;
}

//------------------------------------------------------------------------------
/// Expects a piece to have all arrays of the whole, with the same tuple for the same id.
inline void ExpectSameTuples(
  vtkDataSetAttributes* part, vtkIdType id, vtkDataSetAttributes* whole, vtkIdType wholeId)
{
  for (int a = 0; a < whole->GetNumberOfArrays(); ++a)
  {
    const char* const name = whole->GetAbstractArray(a)->GetName();
    vtkDataArray* const array = part->GetArray(name);
    ASSERT_NE(array, nullptr) << name;
    for (int c = 0; c < array->GetNumberOfComponents(); ++c)
    {
      const double x = array->GetComponent(id, c), y = whole->GetArray(a)->GetComponent(wholeId, c);
      EXPECT_TRUE(x == y || (x != x && y != y)) << name << " of " << wholeId;
    }
  }
}

//------------------------------------------------------------------------------
inline void ExpectSameFieldData(vtkFieldData* expected, vtkFieldData* found)
{
  ASSERT_EQ(expected->GetNumberOfArrays(), found->GetNumberOfArrays());
  for (int i = 0; i < expected->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* const a = expected->GetAbstractArray(i);
    vtkAbstractArray* const b = found->GetAbstractArray(a->GetName());
    ASSERT_NE(b, nullptr) << a->GetName();
    ASSERT_EQ(a->GetNumberOfValues(), b->GetNumberOfValues()) << a->GetName();
    for (vtkIdType value = 0; value < a->GetNumberOfValues(); ++value)
    {
      EXPECT_EQ(a->GetVariantValue(value).ToString(), b->GetVariantValue(value).ToString());
    }
  }
}

//------------------------------------------------------------------------------
/// Expects the pieces of a file, with points, cells, arrays and ghosts, to match the whole.
template <typename Reader>
void ExpectPiecesMakeTheWhole(const std::string& path, int pieces, int ghostLevels)
{
  const Result whole = ReadWith<Reader>(path);
  ASSERT_TRUE(whole.Errors.empty());
  EXPECT_EQ(whole.Grid->GetPointData()->GetGlobalIds(), nullptr);
  const auto allPoints = GetIds(whole.Grid->GetPointData(), whole.Grid->GetNumberOfPoints());
  std::set<vtkIdType> cells, points, ownedPoints;
  vtkIdType largest = 0;
  for (int piece = 0; piece < pieces; ++piece)
  {
    const Result part = ReadWith<Reader>(path, piece, pieces, ghostLevels);
    ASSERT_TRUE(part.Errors.empty());
    EXPECT_EQ(part.Warnings.size(), piece == 0 ? whole.Warnings.size() : 0u);
    vtkUnstructuredGrid* grid = part.Grid;
    ExpectSameFieldData(whole.Grid->GetFieldData(), grid->GetFieldData());
    const auto pointIds = GetIds(grid->GetPointData(), grid->GetNumberOfPoints());
    const auto cellIds = GetIds(grid->GetCellData(), grid->GetNumberOfCells());
    vtkUnsignedCharArray* ghosts = grid->GetCellGhostArray();
    vtkUnsignedCharArray* ghostPoints = grid->GetPointGhostArray();
    EXPECT_EQ(ghosts != nullptr, ghostLevels > 0 && pieces > 1);
    vtkIdType owned = 0;
    std::set<vtkIdType> mine, touched;
    for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
    {
      EXPECT_EQ(
        DescribeCell(grid, cell, pointIds), DescribeCell(whole.Grid, cellIds[cell], allPoints));
      if (!ghosts || !ghosts->GetValue(cell))
      {
        EXPECT_TRUE(cells.insert(cellIds[cell]).second) << "cell twice";
        ++owned;
        for (vtkIdType i = 0; i < MeshView(grid).GetCellPoints(cell).Size; ++i)
        {
          touched.insert(pointIds[MeshView(grid).GetCellPoints(cell)[i]]);
        }
      }
      ExpectSameTuples(grid->GetCellData(), cell, whole.Grid->GetCellData(), cellIds[cell]);
      mine.insert(cellIds[cell]);
    }
    largest = std::max(largest, owned);
    for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
    {
      double x[3], y[3];
      grid->GetPoint(i, x);
      whole.Grid->GetPoint(pointIds[i], y);
      EXPECT_TRUE(std::equal(x, x + 3, y));
      ExpectSameTuples(grid->GetPointData(), i, whole.Grid->GetPointData(), pointIds[i]);
      points.insert(pointIds[i]);
      if (ghostPoints && !ghostPoints->GetValue(i))
      {
        EXPECT_TRUE(ownedPoints.insert(pointIds[i]).second) << "point owned twice";
      }
    }
    if (ghostLevels > 0)
    {
      // Every cell that shares a point with an owned one must exist.
      for (vtkIdType cell = 0; cell < whole.Grid->GetNumberOfCells(); ++cell)
      {
        const IndexRange ids = MeshView(whole.Grid).GetCellPoints(cell);
        bool shares = false;
        for (vtkIdType i = 0; i < ids.Size; ++i)
        {
          shares = shares || touched.count(ids[i]);
        }
        EXPECT_TRUE(!shares || mine.count(cell)) << cell;
      }
    }
  }
  // Cells with the same first point, or in some formats the same smallest point, are not divided.
  std::map<vtkIdType, vtkIdType> cellsAtFirst, cellsAtSmallest;
  vtkIdType mostAtPoint = 0;
  for (vtkIdType cell = 0; cell < whole.Grid->GetNumberOfCells(); ++cell)
  {
    const IndexRange ids = MeshView(whole.Grid).GetCellPoints(cell);
    const vtkIdType first = ids.Size > 0 ? ids[0] : -1;
    vtkIdType smallest = first;
    for (const vtkIdType id : ids)
    {
      smallest = std::min(smallest, id);
    }
    mostAtPoint = std::max({ mostAtPoint, ++cellsAtFirst[first], ++cellsAtSmallest[smallest] });
  }
  EXPECT_LE(largest, 2 * whole.Grid->GetNumberOfCells() / pieces + mostAtPoint);
  EXPECT_EQ(static_cast<vtkIdType>(cells.size()), whole.Grid->GetNumberOfCells());
  EXPECT_EQ(static_cast<vtkIdType>(points.size()), whole.Grid->GetNumberOfPoints());
  if (ghostLevels > 0 && pieces > 1)
  {
    EXPECT_EQ(static_cast<vtkIdType>(ownedPoints.size()), whole.Grid->GetNumberOfPoints());
  }
}
}
}

#endif
