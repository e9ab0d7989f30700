// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// What the XML of Quality Statistics and Select Elements repeats from C++: defaults and choices.
#include "AcceptableRanges.h"
#include "Criteria/Criterion.h"
#include "Strategies/Strategy.h"
#include "vtkCheckQuality.h"
#include "vtkCompareQuality.h"
#include "vtkCorrelateQuality.h"
#include "vtkQualityRegions.h"
#include "vtkQualityStatistics.h"
#include "vtkSelectElements.h"

#include "vtkNew.h"

#include <gtest/gtest.h>

#include <fstream>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

namespace
{
std::string ReadFilterFile(const std::string& name)
{
  std::ifstream file(CAMARON_SOURCE_DIR "/Filters/" + name, std::ios::binary);
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

// The element of a property in the XML of a proxy.
std::string ReadProperty(const std::string& proxy, const std::string& property)
{
  std::string xml;
  for (const char* folder : { "Check/", "Compare/", "Select/", "Statistics/" })
  {
    xml += ReadFilterFile(folder + proxy + ".xml");
  }
  if (xml.find("&" + property + ";") != std::string::npos)
  {
    xml = ReadFilterFile("Common/SharedProperties.ent");
  }
  const std::size_t begin = xml.find(" name=\"" + property + "\"");
  EXPECT_NE(begin, std::string::npos) << proxy << " has no property " << property;
  const std::size_t end = xml.find("VectorProperty>", begin);
  return begin == std::string::npos ? "" : xml.substr(begin, end - begin);
}

std::string ReadDefault(const std::string& proxy, const std::string& property)
{
  std::smatch match;
  const std::string element = ReadProperty(proxy, property);
  return std::regex_search(element, match, std::regex("default_values=\"([^\"]*)\""))
    ? match[1].str()
    : "missing";
}

std::vector<std::string> ReadChoices(const std::string& proxy, const std::string& property)
{
  const std::string element = ReadProperty(proxy, property);
  const std::regex choice("<String value=\"([^\"]*)\"");
  std::vector<std::string> choices;
  for (std::sregex_iterator it(element.begin(), element.end(), choice), end; it != end; ++it)
  {
    choices.push_back((*it)[1]);
  }
  return choices;
}
}

//------------------------------------------------------------------------------
TEST(QualityStatisticsProxy, AgreesWithClass)
{
  const std::string proxy = "QualityStatistics";
  vtkNew<vtkQualityStatistics> filter;
  EXPECT_EQ(ReadDefault(proxy, "Preset"), filter->GetPreset());
  EXPECT_EQ(ReadDefault(proxy, "ElementType"), filter->GetElementType());
  EXPECT_EQ(ReadDefault(proxy, "OnlySelected"), std::to_string(filter->GetOnlySelected()));
  EXPECT_EQ(ReadDefault(proxy, "SelectionArray"), filter->GetSelectionArray());
  EXPECT_EQ(ReadDefault(proxy, "AllTimeSteps"), std::to_string(filter->GetAllTimeSteps()));
  EXPECT_EQ(ReadDefault(proxy, "CurvePoints"), std::to_string(filter->GetCurvePoints()));
  EXPECT_TRUE(filter->GetCurveValues().empty());
  EXPECT_EQ(ReadDefault(proxy, "GroupBy"), filter->GetGroupBy());
  EXPECT_EQ(ReadDefault(proxy, "Ranges"), filter->GetRanges());
  EXPECT_EQ(ReadDefault(proxy, "WeightArray"), filter->GetWeightArray());
  EXPECT_EQ(ReadDefault(proxy, "NumberOfBins"), std::to_string(filter->GetNumberOfBins()));
  EXPECT_EQ(ReadDefault(proxy, "HistogramRange"), filter->GetHistogramRange());
  EXPECT_EQ(ReadDefault(proxy, "HistogramScale"), filter->GetHistogramScale());
  EXPECT_EQ(ReadDefault(proxy, "NumberOfWorst"), std::to_string(filter->GetNumberOfWorst()));
  EXPECT_EQ(ReadDefault(proxy, "WorstValues"), filter->GetWorstValues());
  EXPECT_EQ(ReadDefault(proxy, "CustomRange"), "0 1");
  EXPECT_EQ(filter->GetCustomRange()[0], 0);
  EXPECT_EQ(filter->GetCustomRange()[1], 1);
  std::ostringstream quantiles;
  for (const double percent : filter->GetQuantiles())
  {
    quantiles << (quantiles.tellp() > 0 ? " " : "") << percent;
  }
  EXPECT_EQ(ReadDefault(proxy, "Quantiles"), quantiles.str());
}

//------------------------------------------------------------------------------
TEST(CheckQualityProxy, AgreesWithClass)
{
  const std::string proxy = "CheckQuality";
  vtkNew<vtkCheckQuality> filter;
  EXPECT_EQ(ReadDefault(proxy, "Preset"), filter->GetPreset());
  EXPECT_EQ(ReadDefault(proxy, "Preset"), filter->GetPresetNames()->GetValue(0));
  EXPECT_EQ(filter->GetPresetNames()->GetValue(1), "None");
  EXPECT_EQ(ReadDefault(proxy, "Rules"), filter->GetRules());
  EXPECT_EQ(ReadDefault(proxy, "RulesFile"), filter->GetRulesFile());
  EXPECT_EQ(ReadDefault(proxy, "Tolerate"), filter->GetTolerate());
  EXPECT_EQ(ReadDefault(proxy, "NumberOfWorst"), std::to_string(filter->GetNumberOfWorst()));
  EXPECT_EQ(ReadDefault(proxy, "ConnectBlocks"), std::to_string(filter->GetConnectBlocks()));
  EXPECT_EQ(
    ReadDefault(proxy, "TrustFaceOrientation"), std::to_string(filter->GetTrustFaceOrientation()));
  EXPECT_EQ(std::stod(ReadDefault(proxy, "DegeneracyTolerance")), filter->GetDegeneracyTolerance());
  EXPECT_EQ(std::stod(ReadDefault(proxy, "ConvexityTolerance")), filter->GetConvexityTolerance());
  EXPECT_EQ(std::stod(ReadDefault(proxy, "PlanarityTolerance")), filter->GetPlanarityTolerance());
}

//------------------------------------------------------------------------------
TEST(CompareQualityProxy, AgreesWithClass)
{
  const std::string proxy = "CompareQuality";
  vtkNew<vtkCompareQuality> filter;
  EXPECT_EQ(ReadDefault(proxy, "Preset"), filter->GetPreset());
  EXPECT_EQ(ReadDefault(proxy, "RangesFile"), filter->GetRangesFile());
  EXPECT_EQ(ReadDefault(proxy, "NumberOfBins"), std::to_string(filter->GetNumberOfBins()));
  EXPECT_EQ(ReadDefault(proxy, "HistogramScale"), filter->GetHistogramScale());
  EXPECT_EQ(std::stod(ReadDefault(proxy, "Tolerance")), filter->GetTolerance());
  EXPECT_EQ(ReadDefault(proxy, "GroupBy"), filter->GetGroupBy());
  EXPECT_EQ(ReadChoices(proxy, "GroupBy"), ReadChoices("QualityStatistics", "GroupBy"));
  EXPECT_EQ(ReadDefault(proxy, "AllTimeSteps"), std::to_string(filter->GetAllTimeSteps()));
}

//------------------------------------------------------------------------------
TEST(CorrelateQualityProxy, AgreesWithClass)
{
  const std::string proxy = "CorrelateQuality";
  vtkNew<vtkCorrelateQuality> filter;
  EXPECT_EQ(ReadDefault(proxy, "Preset"), filter->GetPreset());
  EXPECT_EQ(ReadDefault(proxy, "RangesFile"), filter->GetRangesFile());
  EXPECT_EQ(ReadDefault(proxy, "GroupBy"), filter->GetGroupBy());
  EXPECT_EQ(ReadChoices(proxy, "GroupBy"), ReadChoices("QualityStatistics", "GroupBy"));
  EXPECT_EQ(ReadDefault(proxy, "AllTimeSteps"), std::to_string(filter->GetAllTimeSteps()));
}

//------------------------------------------------------------------------------
TEST(QualityRegionsProxy, AgreesWithClass)
{
  const std::string proxy = "QualityRegions";
  vtkNew<vtkQualityRegions> filter;
  EXPECT_EQ(ReadDefault(proxy, "Range"), filter->GetRange());
  EXPECT_EQ(ReadChoices(proxy, "Range"), ReadChoices("SelectElements", "Range"));
  EXPECT_EQ(ReadDefault(proxy, "Preset"), filter->GetPreset());
  EXPECT_EQ(ReadDefault(proxy, "RangesFile"), filter->GetRangesFile());
  EXPECT_EQ(ReadDefault(proxy, "LowerLimit"), filter->GetLowerLimit());
  EXPECT_EQ(ReadDefault(proxy, "UpperLimit"), filter->GetUpperLimit());
  EXPECT_EQ(ReadDefault(proxy, "IncludeUndefined"), std::to_string(filter->GetIncludeUndefined()));
  EXPECT_EQ(ReadDefault(proxy, "Adjacency"), filter->GetAdjacency());
  EXPECT_EQ(ReadChoices(proxy, "Adjacency"), ReadChoices("SelectElements", "Adjacency"));
  EXPECT_EQ(ReadDefault(proxy, "NumberOfRegions"), std::to_string(filter->GetNumberOfRegions()));
  EXPECT_STREQ(filter->GetArray(), "");
}

//------------------------------------------------------------------------------
TEST(SelectElementsProxy, AgreesWithClass)
{
  const std::string proxy = "SelectElements";
  vtkNew<vtkSelectElements> filter;
  EXPECT_EQ(ReadDefault(proxy, "Strategy"), filter->GetStrategy());
  EXPECT_EQ(ReadDefault(proxy, "ElementType"), filter->GetElementType());
  EXPECT_EQ(ReadDefault(proxy, "Combination"), filter->GetCombination());
  EXPECT_EQ(ReadDefault(proxy, "Placement"), filter->GetPlacement());
  EXPECT_EQ(ReadChoices(proxy, "Placement"), camaron::GetPlacementNames());
  EXPECT_EQ(ReadDefault(proxy, "Adjacency"), filter->GetAdjacency());
  EXPECT_EQ(ReadDefault(proxy, "NumberOfLayers"), std::to_string(filter->GetNumberOfLayers()));
  EXPECT_EQ(std::stod(ReadDefault(proxy, "FeatureAngle")), filter->GetFeatureAngle());
  EXPECT_EQ(ReadDefault(proxy, "ComponentNumber"), std::to_string(filter->GetComponentNumber()));
  EXPECT_EQ(ReadDefault(proxy, "OnlyBoundary"), std::to_string(filter->GetOnlyBoundary()));
  EXPECT_EQ(ReadDefault(proxy, "OnlyInRange"), std::to_string(filter->GetOnlyInRange()));
  EXPECT_EQ(std::stod(ReadDefault(proxy, "WorstPercentage")), filter->GetWorstPercentage());
  EXPECT_EQ(ReadDefault(proxy, "CellTypes"), filter->GetCellTypes());
  EXPECT_EQ(ReadDefault(proxy, "ByTopology"), std::to_string(filter->GetByTopology()));
  EXPECT_EQ(ReadDefault(proxy, "StatusBits"), filter->GetStatusBits());
  EXPECT_EQ(ReadDefault(proxy, "InsideOut"), std::to_string(filter->GetInsideOut()));
  EXPECT_EQ(ReadDefault(proxy, "ExcludeUndefined"), std::to_string(filter->GetExcludeUndefined()));
  EXPECT_EQ(ReadDefault(proxy, "Ids"), filter->GetIds());
  EXPECT_EQ(ReadDefault(proxy, "IdSpace"), filter->GetIdSpace());
  EXPECT_EQ(ReadDefault(proxy, "Side"), filter->GetSide());
  EXPECT_EQ(ReadDefault(proxy, "Range"), filter->GetRange());
  EXPECT_EQ(ReadDefault(proxy, "Preset"), filter->GetPreset());
  EXPECT_EQ(ReadDefault(proxy, "LowerLimit"), filter->GetLowerLimit());
  EXPECT_EQ(ReadDefault(proxy, "UpperLimit"), filter->GetUpperLimit());
  EXPECT_EQ(ReadDefault(proxy, "NumberOfWorst"), std::to_string(filter->GetNumberOfWorst()));
  EXPECT_EQ(ReadDefault(proxy, "WorstValues"), filter->GetWorstValues());
  EXPECT_STREQ(filter->GetArray(), "");
}
