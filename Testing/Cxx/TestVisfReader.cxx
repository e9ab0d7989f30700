#include <gtest/gtest.h>
#include "vtkVisfReader.h"
#include "vtkNew.h"
#include "vtkUnstructuredGrid.h"
#include "vtkCellTypes.h"
#include <map>
TEST(Smoke, All)
{
  vtkNew<vtkVisfReader> r;
  r->SetFileName(getenv("F"));
  r->Update();
  auto g = r->GetOutput();
  std::map<int,int> t;
  for (int i=0;i<g->GetNumberOfCells();++i) t[g->GetCellType(i)]++;
  printf("%d can, %lld points %lld cells err %lu:", r->CanReadFile(getenv("F")), g->GetNumberOfPoints(), g->GetNumberOfCells(), r->GetErrorCode());
  for (auto p: t) printf(" %d:%d", p.first,p.second);
  printf("\n");
}
