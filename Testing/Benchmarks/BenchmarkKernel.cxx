// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// The kernel of closed surfaces of more and more triangles: balls, every triangle of which is a
// face of the kernel, and balls with bumps, few of which are. No other program here makes kernels.
// Usage: BenchmarkKernel [levels]
#include "BenchmarkCost.h"

#include "Base/Vector.h"
#include "vtkMeshKernel.h"

#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <initializer_list>
#include <random>

namespace
{
using camaron::Vector;

/// A ball of triangles, each with points of its own.
class Ball
{
public:
  Ball(int level, double bumps)
    : Bumps(bumps)
  {
    this->Points->SetDataTypeToDouble();
    for (int octant = 0; octant < 8; ++octant)
    {
      const Vector x = { octant & 1 ? -1.0 : 1.0, 0, 0 }, y = { 0, octant & 2 ? -1.0 : 1.0, 0 };
      const Vector z = { 0, 0, octant & 4 ? -1.0 : 1.0 };
      const bool isTurned = ((octant & 1) ^ (octant >> 1 & 1) ^ (octant >> 2)) != 0;
      this->Cut(x, isTurned ? z : y, isTurned ? y : z, level);
    }
    this->Surface->SetPoints(this->Points);
    this->Surface->SetPolys(this->Triangles);
  }
  vtkPolyData* Get() const { return this->Surface; }

private:
  // Cuts a triangle into four, again and again.
  void Cut(const Vector& a, const Vector& b, const Vector& c, int level)
  {
    if (level == 0)
    {
      this->Triangles->InsertNextCell({ this->AddPoint(a), this->AddPoint(b), this->AddPoint(c) });
      return;
    }
    const Vector ab = Unit(a + b), bc = Unit(b + c), ca = Unit(c + a);
    this->Cut(a, ab, ca, level - 1);
    this->Cut(ab, b, bc, level - 1);
    this->Cut(ca, bc, c, level - 1);
    this->Cut(ab, bc, ca, level - 1);
  }
  // The radius depends on the place, so that all triangles at a corner agree about it.
  vtkIdType AddPoint(const Vector& direction)
  {
    const auto digits = [](double x) { return static_cast<unsigned>(std::lround(1e4 * (x + 2))); };
    std::minstd_rand random(
      digits(direction.X) + 97 * digits(direction.Y) + 8191 * digits(direction.Z));
    random.discard(2);
    const double radius = 1 - this->Bumps * std::generate_canonical<double, 32>(random);
    return this->Points->InsertNextPoint(
      radius * direction.X, radius * direction.Y, radius * direction.Z);
  }

  double Bumps;
  vtkNew<vtkPoints> Points;
  vtkNew<vtkCellArray> Triangles;
  vtkNew<vtkPolyData> Surface;
};

//------------------------------------------------------------------------------
void Print(const char* name, int level, double bumps)
{
  const Ball ball(level, bumps);
  vtkIdType faces = 0;
  const camaron::Measurement cost = camaron::Measure(
    [&]
    {
      vtkNew<vtkMeshKernel> filter;
      filter->SetInputData(ball.Get());
      filter->Update();
      vtkNew<vtkCellArray> found;
      vtkUnstructuredGrid::SafeDownCast(filter->GetOutput())->GetPolyhedronFaces(0, found);
      faces = found->GetNumberOfCells();
    });
  const double triangles = static_cast<double>(ball.Get()->GetNumberOfPolys());
  std::printf(
    "%-16s %8.0f triangles, kernel of %7lld faces %8.3f s, processor %8.3f s %6.1f us/triangle, "
    "peak %6.1f MB\n",
    name, triangles, static_cast<long long>(faces), cost.Wall, cost.Processor,
    1e6 * cost.Processor / triangles, cost.Peak / 1e6);
  std::fflush(stdout);
}
}

//------------------------------------------------------------------------------
int main(int argc, char* argv[])
{
  const int levels = argc > 1 ? std::atoi(argv[1]) : 7;
  for (int level = 4; level <= levels; ++level)
  {
    Print("ball", level, 0);
    Print("ball with bumps", level, 0.05 * std::pow(0.25, level - 4));
  }
  return 0;
}
