#include "coordinator/report/report_key.h"

#include <gtest/gtest.h>

#include <map>
#include <set>
#include <string>
#include <variant>

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

TEST(DecidedHolesInTest, AreTheRowsWithADecision) {
  EXPECT_EQ(DecidedHolesIn(R"({"decision": "open", "per_hole": [{"id": 0, "decision": "open"}, {"id": 1},
                               {"id": 7, "water": {"id": 1, "decision": 1}, "decision": "water"}],
                               "left": [{"id": 2, "decision": "open"}]})"),
            (std::set<int32_t>{0, 7}));
  for (const char* text : {"", "{", "[]", R"({"per_hole": [7]})", R"({"per_hole": [{"decision": "open"}])"}) {
    EXPECT_TRUE(DecidedHolesIn(text).empty()) << text;
  }
}

TEST(JobInReportTest, HasItsOptionsWithTheirTypes) {
  const auto job = JobInReport(R"({"scene": "/s", "per_hole": [{"options": 1}], "files": {"water": "ab"},
                                   "options": {"cells": "1,2", "tension": 0.5, "overwrite": true}})");
  ASSERT_TRUE(job.has_value());
  EXPECT_EQ(job->scene, "/s");
  EXPECT_EQ(job->files, (std::map<std::string, std::string>{{"water", "ab"}}));
  ASSERT_EQ(job->options.size(), 3U);
  EXPECT_EQ(std::get<std::string>(job->options[0].value), "1,2");
  EXPECT_EQ(std::get<double>(job->options[1].value), 0.5);
  EXPECT_EQ(std::get<bool>(job->options[2].value), true);
}

TEST(JobInReportTest, IsNoneWithoutOptions) {
  for (const char* text : {"", "{", "[]", "7", R"({"options": 7})", R"({"scene": "/s"})"}) {
    EXPECT_FALSE(JobInReport(text).has_value()) << text;
  }
}

}  // namespace
}  // namespace tilemend
