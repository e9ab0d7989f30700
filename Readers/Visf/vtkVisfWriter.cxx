// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkVisfWriter.h"

#include "Base/Buffer.h"
#include "Base/Parallel.h"
#include "Intake/CellMesh/OutputWarnings.h"
#include "Intake/FaceMesh/SharedFaces.h"
#include "Intake/Write/NumberEncoder.h"
#include "Intake/Write/WriteRows.h"
#include "Scan/MappedFile.h"

#include "vtkDataSet.h"
#include "vtkObjectFactory.h"

#include <algorithm>
#include <stdexcept>

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
// The polygons and polyhedra of a mesh, or just its points.
class VisfLists : public SharedFaces
{
public:
  VisfLists(vtkDataSet* mesh, Warnings& warnings)
    : SharedFaces(mesh, GetUsualRoles())
  {
    if (!this->IsCloud(warnings))
    {
      this->Build();
    }
  }

  int GetType() const { return this->Polyhedra.Count > 0 ? 2 : this->Polygons.Count > 0 ? 1 : 0; }

private:
  bool IsCloud(Warnings& warnings) const;
};

//------------------------------------------------------------------------------
bool VisfLists::IsCloud(Warnings& warnings) const
{
  const MeshView& mesh = this->GetMesh();
  bool isCloud = true; // all points, in their order
  Tally higherOrder, small, empty, others;
  vtkIdType corners = 0;
  for (vtkIdType cell = 0; cell < mesh.GetNumberOfCells(); ++cell)
  {
    const CellShape& shape = GetCellShape(mesh.GetCellType(cell));
    const FaceRole role = this->GetRole(cell);
    const IndexRange points = mesh.GetCellPoints(cell);
    for (vtkIdType i = 0; isCloud && i < points.Size; ++i)
    {
      isCloud = points[i] == corners++;
    }
    if (shape.IsHigherOrder && role != FaceRole::None)
    {
      higherOrder.Add(cell);
    }
    if (shape.Dimension != 0)
    {
      isCloud = false;
    }
    if (role == FaceRole::None)
    {
      others.Add(cell);
    }
    else if (shape.Dimension == 0 || shape.Dimension == 1)
    {
      (points.Size > shape.Dimension ? small : empty).Add(cell);
    }
  }
  // Every point of a cloud becomes a cell when read.
  const bool coversPoints = mesh.GetNumberOfCells() == 0 || corners == mesh.GetNumberOfPoints();
  if (isCloud && coversPoints)
  {
    return true;
  }
  warnings.Add(higherOrder, "cell", "cells", "of higher order, written as linear cells");
  warnings.Add(
    small, "cell", "cells", "of dimension 0 or 1, written as polygons with one or two vertices");
  warnings.Add(empty, "cell", "cells", "with too few points for their type, omitted");
  warnings.Add(others, "cell", "cells", "of types that Visf cannot store, omitted");
  return false;
}

//------------------------------------------------------------------------------
// For every polygon, the polygons that share at least two vertices with it.
WordLists FindNeighbors(const WordLists& polygons, vtkIdType numberOfPoints)
{
  std::vector<vtkIdType> begins; // word of every polygon
  std::vector<vtkIdType> ends(static_cast<std::size_t>(numberOfPoints) + 1, 0);
  const auto getIds = [&](vtkIdType polygon, std::vector<std::int32_t>& ids)
  {
    const std::int32_t* word = polygons.Words.data() + begins[polygon];
    ids.assign(word + 1, word + 1 + *word);
    std::sort(ids.begin(), ids.end());
    ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  };
  std::vector<std::int32_t> ids;
  vtkIdType at = 0;
  for (vtkIdType polygon = 0; polygon < polygons.Count; ++polygon)
  {
    begins.push_back(at);
    getIds(polygon, ids);
    for (const std::int32_t id : ids)
    {
      ++ends[id + 1];
    }
    at += 1 + polygons.Words[at];
  }
  for (std::size_t id = 1; id < ends.size(); ++id)
  {
    ends[id] += ends[id - 1];
  }
  Buffer<std::int32_t> polygonsOf(ends.back());
  for (vtkIdType polygon = 0; polygon < polygons.Count; ++polygon)
  {
    getIds(polygon, ids);
    for (const std::int32_t id : ids)
    {
      polygonsOf[ends[id]++] = static_cast<std::int32_t>(polygon);
    }
  }

  // ends[id] is now the end of the polygons of id, and the begin of the next.
  const vtkIdType numberOfChunks = (polygons.Count + MediumGrain - 1) / MediumGrain;
  std::vector<std::vector<std::int32_t>> chunks(static_cast<std::size_t>(numberOfChunks));
  Progress().For(numberOfChunks,
    [&](vtkIdType first, vtkIdType last)
    {
      std::vector<std::int32_t> points, candidates;
      for (vtkIdType chunk = first; chunk < last; ++chunk)
      {
        std::vector<std::int32_t>& words = chunks[chunk];
        const vtkIdType end = std::min((chunk + 1) * MediumGrain, polygons.Count);
        for (vtkIdType polygon = chunk * MediumGrain; polygon < end; ++polygon)
        {
          getIds(polygon, points);
          candidates.clear();
          for (const std::int32_t id : points)
          {
            candidates.insert(candidates.end(), polygonsOf.data() + (id > 0 ? ends[id - 1] : 0),
              polygonsOf.data() + ends[id]);
          }
          std::sort(candidates.begin(), candidates.end());
          const std::size_t size = words.size();
          words.push_back(0);
          for (std::size_t i = 1; i < candidates.size(); ++i)
          {
            const bool isSecond =
              candidates[i] == candidates[i - 1] && (i < 2 || candidates[i] != candidates[i - 2]);
            if (isSecond && candidates[i] != polygon)
            {
              words.push_back(candidates[i]);
              ++words[size];
            }
          }
        }
      }
    });
  WordLists neighbors;
  neighbors.Count = polygons.Count;
  neighbors.Starts.push_back(0);
  for (const auto& words : chunks)
  {
    neighbors.Starts.push_back(neighbors.Starts.back() + static_cast<vtkIdType>(words.size()));
  }
  neighbors.Words = Buffer<std::int32_t>(neighbors.Starts.back());
  for (std::size_t chunk = 0; chunk < chunks.size(); ++chunk)
  {
    std::copy(
      chunks[chunk].begin(), chunks[chunk].end(), neighbors.Words.data() + neighbors.Starts[chunk]);
  }
  return neighbors;
}

//------------------------------------------------------------------------------
// Converts the parts of a file to bytes.
class VisfOutput
{
public:
  VisfOutput(OutputFile& file, int encoding)
    : File(file)
    , Encoder(encoding == vtkVisfWriter::ASCII, encoding == vtkVisfWriter::BINARY_BIG_ENDIAN)
  {
    const char first[] = { '2', '1', '0', '\1' }; // by encoding
    this->File.Write(&first[encoding], 1);
    if (this->Encoder.IsText())
    {
      this->File.Write(" ", 1);
    }
  }

  void WriteCount(vtkIdType count)
  {
    std::string bytes;
    this->Encoder.Append(bytes, static_cast<std::int32_t>(count));
    this->Encoder.EndRow(bytes);
    this->File.Write(bytes);
  }

  bool WritePoints(const MeshView& mesh, const Progress& progress)
  {
    return WriteRows(this->File, mesh.GetNumberOfPoints(), progress,
      [&](vtkIdType id, std::string& bytes)
      {
        double x[3];
        mesh.GetPoint(id, x);
        this->Encoder.Append<float>(
          bytes, 3, [&x](std::ptrdiff_t c) { return static_cast<float>(x[c]); });
        this->Encoder.EndRow(bytes);
      });
  }

  bool WriteLists(const WordLists& lists, const Progress& progress)
  {
    return WriteChunks(this->File, lists.GetNumberOfChunks(), progress,
      [&](vtkIdType chunk, std::string& bytes)
      {
        const std::int32_t* word = lists.Words.data() + lists.Starts[chunk];
        const std::int32_t* const end = lists.Words.data() + lists.Starts[chunk + 1];
        while (word < end)
        {
          const std::int32_t size = *word + 1;
          this->Encoder.Append<std::int32_t>(
            bytes, size, [word](std::ptrdiff_t i) { return word[i]; });
          this->Encoder.EndRow(bytes);
          word += size;
        }
      });
  }

private:
  OutputFile& File;
  NumberEncoder Encoder;
};

//------------------------------------------------------------------------------
bool Write(OutputFile& file, const std::string& path, vtkDataSet* mesh, int encoding,
  bool neighbors, Warnings& warnings, ScanError& error, const Progress& progress)
{
  const VisfLists lists(mesh, warnings);
  WarnOfArrays(mesh, "Visf", warnings);
  WarnOfInvertedCells(mesh, "Visf", warnings);
  if (!CheckSinglePrecision(mesh, path, warnings, error) || !progress.Report(0.3))
  {
    return false;
  }
  VisfOutput output(file, encoding);
  output.WriteCount(lists.GetType());
  output.WriteCount(lists.GetMesh().GetNumberOfPoints());
  bool good = output.WritePoints(lists.GetMesh(), progress.Part(0.3, 0.4));
  if (good && (lists.Polygons.Count > 0 || lists.Polyhedra.Count > 0))
  {
    output.WriteCount(lists.Polygons.Count);
    good = output.WriteLists(lists.Polygons, progress.Part(0.4, 0.7));
    if (good && lists.Polygons.Count > 0)
    {
      output.WriteCount(neighbors ? 1 : 0);
      good = !neighbors ||
        output.WriteLists(FindNeighbors(lists.Polygons, lists.GetMesh().GetNumberOfPoints()),
          progress.Part(0.7, 0.8));
    }
  }
  if (good && lists.Polyhedra.Count > 0)
  {
    output.WriteCount(lists.Polyhedra.Count);
    good = output.WriteLists(lists.Polyhedra, progress.Part(0.8, 1));
  }
  return good;
}
}
}

vtkStandardNewMacro(vtkVisfWriter);

//------------------------------------------------------------------------------
int vtkVisfWriter::GetDigitsOfCoordinates() const
{
  return camaron::DigitsOfFloat;
}

//------------------------------------------------------------------------------
bool vtkVisfWriter::WriteMesh(const std::string& path, vtkDataSet* mesh,
  camaron::Warnings& warnings, camaron::ScanError& error, const camaron::Progress& progress)
{
  camaron::OutputFile file(path);
  const bool good = !file.HasFailed() &&
    camaron::Write(
      file, path, mesh, this->Encoding, this->WriteNeighbors, warnings, error, progress);
  return file.Finish(good, error);
}

//------------------------------------------------------------------------------
void vtkVisfWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Encoding: " << this->Encoding << "\n";
  os << indent << "WriteNeighbors: " << this->WriteNeighbors << "\n";
}
