#include "client/hole_columns.h"

#include <gtest/gtest.h>

#include <vector>

namespace tilemend {
namespace {

using Json = nlohmann::ordered_json;

Json ReportOf(const Json& centre, const std::vector<double>& areas) {
  Json report;
  for (const double area : areas) {
    report["per_hole"].push_back({{"centre", centre}, {"area_m2", area}, {"perimeter_m", 10 * area}});
  }
  return report;
}

TEST(HoleColumnsTest, AColumnOfASmallMeshHasOneForm) {
  const Json report = ReportOf({0.1, 0.2, 0.3}, {0.00702, 0.00001, 0});
  const HoleColumns columns(report);
  EXPECT_EQ(columns.Area(report["per_hole"][0]), "0.007020");
  EXPECT_EQ(columns.Area(report["per_hole"][1]), "0.000010");
  EXPECT_EQ(columns.Area(report["per_hole"][2]), "0.000000");
  EXPECT_EQ(columns.Area(0.0123456), "0.012346");
  EXPECT_EQ(columns.Area(0.0000004), "< 0.000001");
  EXPECT_EQ(columns.Rim(report["per_hole"][0]), "0.07020");
  EXPECT_EQ(columns.Rim(report["per_hole"][1]), "0.00010");
  EXPECT_EQ(columns.Area(Json::parse(R"({"area_m2": null})")), "-");
}

TEST(HoleColumnsTest, AMeshHasNoCells) {
  EXPECT_EQ(HoleColumns(ReportOf({1, 2, 3}, {5})).TableOf({"hole", "cell", "why"}, {{"7", "[0,0]", "x"}}),
            "hole  why\n   7  x\n");
  EXPECT_EQ(HoleColumns(ReportOf({1, 2}, {5})).TableOf({"hole", "cell", "why"}, {{"7", "[0,0]", "x"}}),
            "hole  cell   why\n   7  [0,0]  x\n");
}

TEST(HoleColumnsTest, ASceneIsInMetres) {
  const Json report = ReportOf({1, 2}, {20.5, 0.025, 0.00001});
  EXPECT_EQ(HoleColumns(report).Area(report["per_hole"][0]), "20.5");
  EXPECT_EQ(HoleColumns(report).Area(report["per_hole"][1]), "< 0.1");
  EXPECT_EQ(HoleColumns(report).Area(report["per_hole"][2]), "< 0.1");
  EXPECT_EQ(HoleColumns(report).Area(1234.56), "1234.6");
  EXPECT_EQ(HoleColumns(report).Rim(report["per_hole"][0]), "205.0");
}

}  // namespace
}  // namespace tilemend
