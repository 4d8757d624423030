#include "client/report_agreement.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tilemend {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using Json = nlohmann::ordered_json;

Json Report() {
  return Json::parse(R"({
    "holes": {"closed": 1, "I": {"A": 0, "B": 2}, "II": {}},
    "filled": {"closed": 1, "I": {"A": 0, "B": 1}, "II": {}},
    "water": [{"level_m": 1.03125, "holes": [4]}],
    "per_hole": [
      {"id": 3, "outcome": "filled", "method": "over the ground"},
      {"id": 4, "outcome": "filled", "method": "water", "level_m": 1.03125},
      {"id": 5, "outcome": "left", "level_m": 7}]})");
}

TEST(ReportAgreementTest, AReportAgreesWithItself) {
  EXPECT_THAT(ReportContradictions(Report()), IsEmpty());
  EXPECT_THAT(ReportContradictions(Json::object()), IsEmpty());
}

TEST(ReportAgreementTest, AnotherLevelIsNamed) {
  Json report = Report();
  report["water"][0]["level_m"] = 1.04125;
  EXPECT_THAT(ReportContradictions(report),
              ElementsAre("report.json: hole 4: level 1.03125 m, in its row of `water` 1.04125 m"));
}

TEST(ReportAgreementTest, RowsOfWaterAreThere) {
  Json report = Report();
  report["water"] = Json::array();
  EXPECT_THAT(ReportContradictions(report), ElementsAre(HasSubstr("hole 4: filled as water, and in no row")));
  report = Report();
  report["water"][0]["holes"] = {3, 4};
  EXPECT_THAT(ReportContradictions(report), ElementsAre(HasSubstr("hole 3: in a row of `water`, and not filled")));
}

TEST(ReportAgreementTest, HolesAreAsManyAsTheirRows) {
  Json report = Report();
  report["per_hole"].erase(0);
  EXPECT_THAT(ReportContradictions(report), ElementsAre("report.json: `holes` counts 3, `per_hole` has 2",
                                                        "report.json: `filled` counts 2, `per_hole` has 1"));
}

}  // namespace
}  // namespace tilemend
