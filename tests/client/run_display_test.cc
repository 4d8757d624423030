#include "client/run_display.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

namespace tilemend {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

v1::Job JobIn(const std::string& phase) {
  v1::Job job;
  v1::Progress& progress = *job.mutable_progress();
  progress.set_phase(phase);
  progress.set_cells(30);
  progress.set_cells_done(7);
  progress.set_holes(85);
  progress.set_holes_filled(12);
  progress.set_tasks(60);
  return job;
}

TEST(StageTextTest, StagesAreInWordsOfTheUser) {
  EXPECT_EQ(StageText(JobIn("survey")), "look at the tiles");
  EXPECT_EQ(StageText(JobIn("sample layer 2 of 3")), "fit the surface");
  EXPECT_EQ(StageText(JobIn("fill")), "fill the holes, 12 of 85 holes");
  EXPECT_EQ(StageText(JobIn("assemble")), "write the tiles, 7 of 30 cells");
  EXPECT_EQ(StageText(JobIn("verify")), "verify the tiles");
  EXPECT_EQ(StageText(JobIn("a new phase")), "a new phase");
}

TEST(EndWithoutReportTest, SaysWhatWasFoundWithItsWarnings) {
  v1::Job job = JobIn("plan");
  job.set_state(v1::DONE);
  job.set_message("3 holes found");
  job.add_warnings("no area");
  EXPECT_EQ(EndWithoutReport(job), "warning: no area\n3 holes found\n");
  job.set_state(v1::CANCELLED);
  EXPECT_THAT(EndWithoutReport(job), ::testing::EndsWith("cancelled\n"));
  job.set_state(v1::FAILED);
  EXPECT_EQ(EndWithoutReport(job), "") << "the error is shown";
}

TEST(ResultTextTest, SaysWhatWasFilledWhereTheWaterIsAndWhereToLook) {
  const auto report = nlohmann::ordered_json::parse(R"({
    "per_hole": [{"id": 0, "cell": [0, 0], "centre": [1, 2], "area_m2": 20.5, "outcome": "filled"},
                 {"id": 1, "cell": [0, 0], "centre": [3, 4], "area_m2": 0.2, "outcome": "left"}],
    "warnings": ["a warning"], "look_at": [{"hole": 0, "cell": [0, 0], "centre": [1, 2], "area_m2": 20.5, "why": "doubt"}],
    "water": [{"kind": "lake", "level_m": 7.125, "area_m2": 20.5, "sigma_m": 0.1, "rim_m": [7, 8], "rim_vertices": 9,
               "cells": 1, "decided_by": "area", "removed_rises": []}],
    "left": [{"cell": [0, 0], "reason": "no way", "hole": 1, "open_edges": 4}], "not_holes": []})");
  const std::string text = ResultText(report);
  EXPECT_THAT(text, StartsWith("1 of 2 holes filled, 20.5 m2\nwarning: a warning\n"));
  for (const char* shown : {"7.125", "polygon", "1 place to look at", "1 left open", "no way"}) {
    EXPECT_THAT(text, HasSubstr(shown));
  }
  EXPECT_THAT(text, Not(HasSubstr("task")));
}

TEST(ResultTextTest, CountsTheHolesOfTheCellsThatWereChosen) {
  const auto report = nlohmann::ordered_json::parse(R"({
    "per_hole": [{"id": 0, "area_m2": 20.5, "outcome": "filled"},
                 {"id": 1, "area_m2": 0.02, "outcome": "left", "reason": "no way"},
                 {"id": 2, "area_m2": 9, "outcome": "left", "reason": "in a cell that was not chosen"}]})");
  EXPECT_THAT(ResultText(report),
              StartsWith("1 of 2 holes filled, 20.5 m2; 1 left open is smaller than 0.05 m2 and does not count\n"));
}

TEST(ResultTextTest, AReportOfAnotherReleaseIsNoFault) {
  EXPECT_THAT(ResultText(nlohmann::ordered_json::object()), StartsWith("0 of 0 holes filled"));
}

}  // namespace
}  // namespace tilemend
