#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <string>

#include "common/util/error_info.h"
#include "coordinator/jobs/job_pipeline.h"

namespace tilemend {
namespace {

const std::string kNotUtf8 = "\xff";

JobSpec Valid() {
  JobSpec spec;
  spec.scene = std::string("/scene");
  spec.out = std::string("/out");
  return spec;
}

// The field that Check names, "" if it finds no fault.
std::string Fault(const std::function<void(JobSpec&)>& change) {
  JobSpec spec = Valid();
  change(spec);
  const absl::Status status = spec.Check();
  if (status.ok()) return "";
  EXPECT_TRUE(absl::IsInvalidArgument(status)) << status;
  EXPECT_EQ(ErrorReason(status), "INVALID_SPEC");
  return GetErrorInfo(status)->metadata.at("field");
}

TEST(JobSpecTest, TheDefaultsNeedOnlyPaths) {
  EXPECT_TRUE(Valid().Check().ok());
  EXPECT_EQ(Fault([](JobSpec& s) { s.scene.clear(); }), "scene");
  EXPECT_EQ(Fault([](JobSpec& s) { s.out.clear(); }), "out");
  EXPECT_EQ(Fault([](JobSpec& s) { s.out.clear(), s.dry_run = true; }), "") << "a dry run writes nothing";
}

TEST(JobSpecTest, RefusesCellsThatAreNone) {
  EXPECT_EQ(Fault([](JobSpec& s) { s.cells = "3,4 0,0-5,9"; }), "");
  EXPECT_EQ(Fault([](JobSpec& s) { s.cells = "3;4"; }), "cells");
  const auto many = [](size_t bytes) {
    std::string cells;
    while (cells.size() + 4 <= bytes) cells += "3,4 ";
    return cells;
  };
  EXPECT_EQ(Fault([&](JobSpec& s) { s.cells = many(64 << 10); }), "");
  EXPECT_EQ(Fault([&](JobSpec& s) { s.cells = many((64 << 10) + 4); }), "cells");
}

TEST(JobSpecTest, RefusesPathsThatAreNotUtf8) {
  EXPECT_EQ(Fault([](JobSpec& s) { s.scene = kNotUtf8; }), "scene");
  EXPECT_EQ(Fault([](JobSpec& s) { s.out = kNotUtf8; }), "out");
  EXPECT_EQ(Fault([](JobSpec& s) { s.water = kNotUtf8; }), "water");
  EXPECT_EQ(Fault([](JobSpec& s) { s.area = kNotUtf8; }), "area");
}

TEST(JobSpecTest, RefusesPathsThatTheSystemWouldCut) {
  const std::string path("/a\0b", 4);
  EXPECT_EQ(Fault([&](JobSpec& s) { s.scene = path; }), "scene");
  EXPECT_EQ(Fault([&](JobSpec& s) { s.out = path; }), "out");
  EXPECT_EQ(Fault([&](JobSpec& s) { s.water = path; }), "water");
  EXPECT_EQ(Fault([&](JobSpec& s) { s.area = path; }), "area");
}

TEST(JobSpecTest, RefusesPathsThatMeanSomethingElseElsewhere) {
  for (const std::string& path : {std::string("a/b"), std::string("./a"), "/" + std::string(5000, 'x')}) {
    EXPECT_EQ(Fault([&](JobSpec& s) { s.scene = path; }), "scene");
    EXPECT_EQ(Fault([&](JobSpec& s) { s.out = path; }), "out");
    EXPECT_EQ(Fault([&](JobSpec& s) { s.water = path; }), "water");
    EXPECT_EQ(Fault([&](JobSpec& s) { s.area = path; }), "area");
  }
  EXPECT_EQ(Fault([](JobSpec& s) { s.scene = std::string("s3://bucket/scene"); }), "");
}

TEST(JobSpecTest, KnowsTheSurfacesByName) {
  for (const Surface surface : {Surface::kThinPlate, Surface::kWang}) {
    EXPECT_EQ(Fault([&](JobSpec& s) { s.surface = SurfaceName(surface); }), "");
  }
  EXPECT_EQ(Fault([](JobSpec& s) { s.surface.clear(); }), "surface");
  EXPECT_EQ(Fault([](JobSpec& s) { s.surface = std::string("Wang"); }), "surface");
}

TEST(JobSpecTest, KnowsTheWaterProfilesByName) {
  for (const std::string name : {"city", "usgs"}) {
    EXPECT_EQ(Fault([&](JobSpec& s) { s.water_profile = name; }), "");
  }
  EXPECT_EQ(Fault([](JobSpec& s) { s.water_profile = "USGS"; }), "water_profile");
}

TEST(JobSpecTest, OnlyThinPlateHasATension) {
  EXPECT_EQ(Fault([](JobSpec& s) { s.tension = 1; }), "");
  EXPECT_EQ(Fault([](JobSpec& s) { s.tension = 1, s.surface = SurfaceName(Surface::kWang); }), "tension");
  EXPECT_EQ(Fault([](JobSpec& s) { s.tension = -1; }), "tension");
  EXPECT_EQ(Fault([](JobSpec& s) { s.tension = 1001; }), "tension");
}

TEST(JobSpecTest, OnlyFrontsHaveSteps) {
  const auto fault = [](Filler filler, const char* steps) {
    return Fault([&](JobSpec& s) { s.filler = FillerName(filler), s.front_steps = steps; });
  };
  EXPECT_EQ(fault(Filler::kSvmLaplacian, "printed"), "");
  EXPECT_EQ(fault(Filler::kSvmLaplacian, "bold"), "front_steps");
  EXPECT_EQ(fault(Filler::kAuto, "printed"), "front_steps");
  EXPECT_EQ(fault(Filler::kMinimumArea, "steady"), "front_steps");
}

TEST(JobSpecTest, RefusesWhatHasNoEffect) {
  EXPECT_EQ(Fault([](JobSpec& s) { s.uniform = true; }), "");
  EXPECT_EQ(Fault([](JobSpec& s) { s.uniform = true, s.gradation = 2; }), "gradation");
  EXPECT_EQ(Fault([](JobSpec& s) { s.uniform = true, s.size_limit = 2; }), "size_limit");
  EXPECT_EQ(Fault([](JobSpec& s) { s.water = "off"; }), "");
  EXPECT_EQ(Fault([](JobSpec& s) { s.water = "off", s.water_profile = "usgs"; }), "water_profile");
  EXPECT_EQ(Fault([](JobSpec& s) { s.water = "off", s.water_colour = "1,2,3"; }), "water_colour");
}

TEST(JobSpecTest, OnlyWangSmoothsSeams) {
  const auto fault = [](double gamma, Surface surface) {
    return Fault([&](JobSpec& s) { s.seam_smoothing = gamma, s.surface = SurfaceName(surface); });
  };
  EXPECT_EQ(fault(0, Surface::kWang), "");
  EXPECT_EQ(fault(1, Surface::kWang), "");
  EXPECT_EQ(fault(0.5, Surface::kThinPlate), "seam_smoothing");
  EXPECT_EQ(fault(-0.01, Surface::kWang), "seam_smoothing");
  EXPECT_EQ(fault(1.01, Surface::kWang), "seam_smoothing");
}

TEST(JobSpecTest, SaysWhatToDoWithAnOptionOfTheOtherSurface) {
  JobSpec tense = Valid(), smooth = Valid();
  tense.tension = 1;
  tense.surface = SurfaceName(Surface::kWang);
  smooth.seam_smoothing = 0.5;
  smooth.surface = SurfaceName(Surface::kThinPlate);
  for (const JobSpec& spec : {tense, smooth}) {
    EXPECT_THAT(std::string(spec.Check().message()), ::testing::HasSubstr("; leave it out, or choose that surface"));
  }
}

TEST(JobSpecTest, OnlyWangProjectsSeamPoints) {
  const auto fault = [](const char* points, Surface surface) {
    return Fault([&](JobSpec& s) { s.seam_points = points, s.surface = SurfaceName(surface); });
  };
  for (const char* points : {"", "projected", "spaced"}) EXPECT_EQ(fault(points, Surface::kWang), "") << points;
  EXPECT_EQ(fault("", Surface::kThinPlate), "");
  EXPECT_EQ(fault("spaced", Surface::kThinPlate), "seam_points");
  EXPECT_EQ(fault("else", Surface::kWang), "seam_points");
}

TEST(JobSpecTest, OnlyWangHasClosures) {
  const auto fault = [](const char* closure, Surface surface) {
    return Fault([&](JobSpec& s) { s.closure = closure, s.surface = SurfaceName(surface); });
  };
  for (const char* closure : {"", "buffers", "line"}) EXPECT_EQ(fault(closure, Surface::kWang), "") << closure;
  EXPECT_EQ(fault("line", Surface::kThinPlate), "closure");
  EXPECT_EQ(fault("else", Surface::kWang), "closure");
}

struct Range {
  const char* field;
  double JobSpec::*value;
  double low, high;
};

class JobSpecRangeTest : public ::testing::TestWithParam<Range> {};

TEST_P(JobSpecRangeTest, TakesBothEndsAndNothingBeyond) {
  const Range& range = GetParam();
  const auto fault = [&](double value) { return Fault([&](JobSpec& s) { s.*range.value = value; }); };
  EXPECT_EQ(fault(range.low), "");
  EXPECT_EQ(fault(range.high), "");
  EXPECT_EQ(fault(std::nextafter(range.low, -1e9)), range.field);
  EXPECT_EQ(fault(std::nextafter(range.high, 1e9)), range.field);
  EXPECT_EQ(fault(std::numeric_limits<double>::quiet_NaN()), range.field);
}

INSTANTIATE_TEST_SUITE_P(Fields, JobSpecRangeTest,
                         ::testing::Values(Range{"gradation", &JobSpec::gradation, 1, 10},
                                           Range{"size_limit", &JobSpec::size_limit, 1, 1e6}),
                         [](const auto& test) { return std::string(test.param.field); });

}  // namespace
}  // namespace tilemend
