// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// Statistics on one thread against a sort (what is needed for quantiles otherwise) and ParaView's
// histogram, in the same run. Times are of the processor, which other programs disturb least.
// Usage: BenchmarkStatistics [million values]
#include "BenchmarkCost.h"

#include "Statistics/Histogram.h"
#include "Statistics/Quantiles.h"
#include "Statistics/Summary.h"
#include "Statistics/Worst.h"

#include "vtkDataObject.h"
#include "vtkDoubleArray.h"
#include "vtkExtractHistogram.h"
#include "vtkNew.h"
#include "vtkSMPTools.h"
#include "vtkTable.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <random>
#include <vector>

namespace
{
//------------------------------------------------------------------------------
void Compare(const char* name, std::size_t size, const std::function<double()>& next)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName("X");
  array->SetNumberOfValues(static_cast<vtkIdType>(size));
  std::generate(array->GetPointer(0), array->GetPointer(0) + size, next);
  vtkNew<vtkTable> table;
  table->AddColumn(array);

  camaron::ValueBlock block;
  block.Values = array->GetPointer(0);
  block.Size = static_cast<vtkIdType>(size);
  const camaron::Population population = { block };
  // Nanoseconds per value.
  const auto measure = [&](const char* work, const char* by, const std::function<void()>& compute)
  {
    const camaron::Measurement cost = camaron::Measure(compute);
    camaron::Record(work, std::string(name) + " values", by, static_cast<double>(size), cost);
    return 1e9 * cost.Processor / static_cast<double>(size);
  };
  camaron::Reducer reducer;
  camaron::Summary summary;
  const double summarize = measure("summary, one thread", camaron::Ours,
    [&] { summary = camaron::Summarize(population, camaron::ValueRange(), reducer); });
  const double quantiles = measure("9 quantiles, one thread", camaron::Ours,
    [&]
    {
      camaron::GetQuantiles(
        population, summary, { 0, 0.01, 0.05, 0.25, 0.5, 0.75, 0.95, 0.99, 1 }, reducer);
    });
  const camaron::Bins linear = camaron::MakeBins(summary, camaron::BinSettings());
  camaron::BinSettings settings;
  settings.Scale = camaron::BinScale::Logarithmic;
  const camaron::Bins logarithmic = camaron::MakeBins(summary, settings);
  const double countLinear = measure("histogram of 50 bins, one thread", camaron::Ours,
    [&] { camaron::CountBins(population, linear, reducer); });
  const double countLogarithmic = measure("histogram of 50 logarithmic bins, one thread",
    camaron::Ours, [&] { camaron::CountBins(population, logarithmic, reducer); });
  const double worst = measure("worst 10, one thread", camaron::Ours,
    [&]
    {
      camaron::FindWorst(
        population, 10, camaron::WorstEnd::Largest, reducer, [](camaron::WorstElement&) {});
    });
  const double sort = measure("9 quantiles, one thread", "std::sort",
    [&]
    {
      std::vector<double> copy(block.Values, block.Values + size);
      std::sort(copy.begin(), copy.end());
    });
  const double peer = measure("histogram of 50 bins, one thread", "vtkExtractHistogram",
    [&]
    {
      vtkNew<vtkExtractHistogram> histogram;
      histogram->SetInputData(table);
      histogram->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_ROWS, "X");
      histogram->SetBinCount(50);
      histogram->Update();
    });
  std::printf("%-12s %8.1f %10.1f %8.1f %8.1f %8.1f %10.1f %13.1f\n", name, summarize, quantiles,
    countLinear, countLogarithmic, worst, sort, peer);
  std::fflush(stdout);
}
}

//------------------------------------------------------------------------------
int main(int argc, char* argv[])
{
  const auto size = static_cast<std::size_t>((argc > 1 ? std::atof(argv[1]) : 4) * 1e6);
  std::printf("%zu values on one thread, ns per value\n", size);
  std::printf("%-12s %8s %10s %8s %8s %8s %10s %13s\n", "values", "summary", "quantiles", "50 bins",
    "log bins", "worst 10", "(std::sort", "vtkHistogram)");
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> uniform(0, 1);
  std::normal_distribution<double> normal(0, 1);
  vtkSMPTools::LocalScope(vtkSMPTools::Config{ 1, "Sequential", false },
    [&]
    {
      Compare("uniform", size, [&] { return uniform(random); });
      Compare("normal", size, [&] { return normal(random); });
      Compare("long tail", size, [&] { return std::exp(3 * normal(random)); });
      Compare("integers", size, [&] { return std::floor(14 + 3 * normal(random)); });
      Compare("10 % null", size,
        [&] { return uniform(random) < 0.1 ? std::nan("") : 60 + 10 * normal(random); });
    });
  return EXIT_SUCCESS;
}
