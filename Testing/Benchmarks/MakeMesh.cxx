// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// Writes a large mesh to a binary Visf file.
// Usage: MakeMesh tetrahedra|polyhedra|triangles CELLS FILE.visf
#include "BenchmarkMeshes.h"

#include "vtkVisfWriter.h"

#include "vtkNew.h"

#include <cstdio>
#include <cstdlib>
#include <string>

int main(int argc, char* argv[])
{
  const std::string kind = argc == 4 ? argv[1] : "";
  const vtkIdType cells = argc == 4 ? std::atoll(argv[2]) : 0;
  if ((kind != "tetrahedra" && kind != "polyhedra" && kind != "triangles") || cells < 1)
  {
    std::fprintf(stderr, "Usage: MakeMesh tetrahedra|polyhedra|triangles CELLS FILE.visf\n");
    return 2;
  }
  const auto mesh = kind == "tetrahedra" ? camaron::MakeTetrahedra(cells)
    : kind == "triangles"                ? camaron::MakeSurface(cells)
                                         : camaron::MakeTruncatedOctahedra(cells);
  vtkNew<vtkVisfWriter> writer;
  writer->SetInputData(mesh);
  writer->SetFileName(argv[3]);
  writer->SetEncoding(vtkVisfWriter::BINARY_LITTLE_ENDIAN);
  return writer->Write() ? 0 : 1;
}
