#include "coordinator/report/report_key.h"

#include <gtest/gtest.h>

namespace tilemend {
namespace {

TEST(KeyInReportTest, IsTheMemberOfTheReportItself) {
  EXPECT_EQ(KeyInReport(R"({"per_hole": [{"key": "row"}], "options": {"key": "option"}, "key": "own"})"), "own");
  EXPECT_EQ(KeyInReport(R"({"key": "own", "per_hole": [[]], "options": {}})"), "own");
}

TEST(KeyInReportTest, IsEmptyWhereThereIsNone) {
  for (const char* text :
       {"", "{", "[]", "7", R"({"options": {"key": "option"}})", R"({"key": 7})", R"({"key": null})"}) {
    EXPECT_EQ(KeyInReport(text), "") << text;
  }
}

}  // namespace
}  // namespace tilemend
