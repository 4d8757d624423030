#include "common/options/job_options.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "common/options/option.h"
#include "common/options/option_field.h"
#include "common/records/filler.h"
#include "common/records/surface.h"
#include "common/util/error_info.h"

namespace tilemend {
namespace {

using v1::JobSpec;

const std::string kNotUtf8 = "\xff";

JobSpec Valid() {
  JobSpec spec = WithDefaults({});
  spec.set_scene(std::string("/scene"));
  spec.set_out(std::string("/out"));
  return spec;
}

// The field that CheckJob names, "" if it finds no fault.
std::string Fault(const std::function<void(JobSpec&)>& change) {
  JobSpec spec = Valid();
  change(spec);
  const absl::Status status = CheckJob(spec);
  if (status.ok()) return "";
  EXPECT_TRUE(absl::IsInvalidArgument(status)) << status;
  EXPECT_EQ(ErrorReason(status), "INVALID_SPEC");
  return GetErrorInfo(status)->metadata.at("field");
}

TEST(JobOptionsTest, ObjectsHaveNoSlashAtTheirEnd) {
  JobSpec spec;
  spec.set_scene("s3://city/scene/");
  spec.set_out("s3://city/out//");
  spec = WithDefaults(spec);
  EXPECT_EQ(spec.scene(), "s3://city/scene");
  EXPECT_EQ(spec.out(), "s3://city/out");
}

TEST(JobOptionsTest, TheDefaultsNeedOnlyPaths) {
  EXPECT_TRUE(CheckJob(Valid()).ok());
  EXPECT_EQ(Fault([](JobSpec& s) { s.clear_scene(); }), "scene");
  EXPECT_EQ(Fault([](JobSpec& s) { s.clear_out(); }), "out");
  EXPECT_EQ(Fault([](JobSpec& s) { s.clear_out(), s.set_dry_run(true); }), "") << "a dry run writes nothing";
}

TEST(JobOptionsTest, RefusesCellsThatAreNone) {
  EXPECT_EQ(Fault([](JobSpec& s) { s.set_cells("3,4 0,0-5,9"); }), "");
  EXPECT_EQ(Fault([](JobSpec& s) { s.set_cells("3;4"); }), "cells");
  const auto many = [](size_t bytes) {
    std::string cells;
    while (cells.size() + 4 <= bytes) cells += "3,4 ";
    return cells;
  };
  EXPECT_EQ(Fault([&](JobSpec& s) { s.set_cells(many(64 << 10)); }), "");
  EXPECT_EQ(Fault([&](JobSpec& s) { s.set_cells(many((64 << 10) + 4)); }), "cells");
}

TEST(JobOptionsTest, RefusesPathsThatAreNotUtf8) {
  EXPECT_EQ(Fault([](JobSpec& s) { s.set_scene(kNotUtf8); }), "scene");
  EXPECT_EQ(Fault([](JobSpec& s) { s.set_out(kNotUtf8); }), "out");
  EXPECT_EQ(Fault([](JobSpec& s) { s.set_water(kNotUtf8); }), "water");
  EXPECT_EQ(Fault([](JobSpec& s) { s.set_area(kNotUtf8); }), "area");
}

TEST(JobOptionsTest, RefusesPathsThatTheSystemWouldCut) {
  const std::string path("/a\0b", 4);
  EXPECT_EQ(Fault([&](JobSpec& s) { s.set_scene(path); }), "scene");
  EXPECT_EQ(Fault([&](JobSpec& s) { s.set_out(path); }), "out");
  EXPECT_EQ(Fault([&](JobSpec& s) { s.set_water(path); }), "water");
  EXPECT_EQ(Fault([&](JobSpec& s) { s.set_area(path); }), "area");
}

TEST(JobOptionsTest, RefusesPathsThatMeanSomethingElseElsewhere) {
  for (const std::string& path : {std::string("a/b"), std::string("./a"), "/" + std::string(5000, 'x')}) {
    EXPECT_EQ(Fault([&](JobSpec& s) { s.set_scene(path); }), "scene");
    EXPECT_EQ(Fault([&](JobSpec& s) { s.set_out(path); }), "out");
    EXPECT_EQ(Fault([&](JobSpec& s) { s.set_water(path); }), "water");
    EXPECT_EQ(Fault([&](JobSpec& s) { s.set_area(path); }), "area");
  }
  EXPECT_EQ(Fault([](JobSpec& s) { s.set_scene(std::string("s3://bucket/scene")); }), "");
}

TEST(JobOptionsTest, KnowsTheSurfacesByName) {
  for (const Surface surface : {Surface::kThinPlate, Surface::kWang}) {
    EXPECT_EQ(Fault([&](JobSpec& s) { s.set_surface(SurfaceName(surface)); }), "");
  }
  EXPECT_EQ(Fault([](JobSpec& s) { s.clear_surface(); }), "surface");
  EXPECT_EQ(Fault([](JobSpec& s) { s.set_surface(std::string("Wang")); }), "surface");
}

TEST(JobOptionsTest, KnowsTheWaterProfilesByName) {
  for (const std::string name : {"city", "usgs"}) {
    EXPECT_EQ(Fault([&](JobSpec& s) { s.set_water_profile(name); }), "");
  }
  EXPECT_EQ(Fault([](JobSpec& s) { s.set_water_profile("USGS"); }), "water_profile");
}

TEST(JobOptionsTest, OnlyThinPlateHasATension) {
  EXPECT_EQ(Fault([](JobSpec& s) { s.set_tension(1); }), "");
  EXPECT_EQ(Fault([](JobSpec& s) { s.set_tension(1), s.set_surface(SurfaceName(Surface::kWang)); }), "tension");
  EXPECT_EQ(Fault([](JobSpec& s) { s.set_tension(-1); }), "tension");
  EXPECT_EQ(Fault([](JobSpec& s) { s.set_tension(1001); }), "tension");
}

TEST(JobOptionsTest, OnlyFrontsHaveSteps) {
  const auto fault = [](Filler filler, const char* steps) {
    return Fault([&](JobSpec& s) { s.set_filler(FillerName(filler)), s.set_front_steps(steps); });
  };
  EXPECT_EQ(fault(Filler::kSvmLaplacian, "printed"), "");
  EXPECT_EQ(fault(Filler::kSvmLaplacian, "bold"), "front_steps");
  EXPECT_EQ(fault(Filler::kAuto, "printed"), "front_steps");
  EXPECT_EQ(fault(Filler::kMinimumArea, "steady"), "front_steps");
}

TEST(JobOptionsTest, RefusesWhatHasNoEffect) {
  EXPECT_EQ(Fault([](JobSpec& s) { s.set_uniform(true); }), "");
  EXPECT_EQ(Fault([](JobSpec& s) { s.set_uniform(true), s.set_gradation(2); }), "gradation");
  EXPECT_EQ(Fault([](JobSpec& s) { s.set_uniform(true), s.set_size_limit(2); }), "size_limit");
  EXPECT_EQ(Fault([](JobSpec& s) { s.set_water("off"); }), "");
  EXPECT_EQ(Fault([](JobSpec& s) { s.set_water("off"), s.set_water_profile("usgs"); }), "water_profile");
  EXPECT_EQ(Fault([](JobSpec& s) { s.set_water("off"), s.set_water_colour("1,2,3"); }), "water_colour");
}

TEST(JobOptionsTest, OnlyWangSmoothsSeams) {
  const auto fault = [](double gamma, Surface surface) {
    return Fault([&](JobSpec& s) { s.set_seam_smoothing(gamma), s.set_surface(SurfaceName(surface)); });
  };
  EXPECT_EQ(fault(0, Surface::kWang), "");
  EXPECT_EQ(fault(1, Surface::kWang), "");
  EXPECT_EQ(fault(0.5, Surface::kThinPlate), "seam_smoothing");
  EXPECT_EQ(fault(-0.01, Surface::kWang), "seam_smoothing");
  EXPECT_EQ(fault(1.01, Surface::kWang), "seam_smoothing");
}

TEST(JobOptionsTest, SaysWhatToDoWithAnOptionOfTheOtherSurface) {
  JobSpec tense = Valid(), smooth = Valid();
  tense.set_tension(1);
  tense.set_surface(SurfaceName(Surface::kWang));
  smooth.set_seam_smoothing(0.5);
  smooth.set_surface(SurfaceName(Surface::kThinPlate));
  for (const JobSpec& spec : {tense, smooth}) {
    EXPECT_THAT(std::string(CheckJob(spec).message()), ::testing::HasSubstr("; leave it out, or choose that surface"));
  }
}

TEST(JobOptionsTest, OnlyWangProjectsSeamPoints) {
  const auto fault = [](const char* points, Surface surface) {
    return Fault([&](JobSpec& s) { s.set_seam_points(points), s.set_surface(SurfaceName(surface)); });
  };
  for (const char* points : {"projected", "spaced"}) EXPECT_EQ(fault(points, Surface::kWang), "") << points;
  EXPECT_EQ(fault("spaced", Surface::kThinPlate), "seam_points");
  EXPECT_EQ(fault("else", Surface::kWang), "seam_points");
}

TEST(JobOptionsTest, OnlyWangHasClosures) {
  const auto fault = [](const char* closure, Surface surface) {
    return Fault([&](JobSpec& s) { s.set_closure(closure), s.set_surface(SurfaceName(surface)); });
  };
  for (const char* closure : {"buffers", "line"}) EXPECT_EQ(fault(closure, Surface::kWang), "") << closure;
  EXPECT_EQ(fault("line", Surface::kThinPlate), "closure");
  EXPECT_EQ(fault("else", Surface::kWang), "closure");
}

TEST(JobOptionsTest, NumbersMayBeBothEndsOfTheirRangesAndNothingBeyond) {
  int numbers = 0;
  for (const Option& option : AllOptions()) {
    if (option.type != OptionType::kNumber || (option.commands & kOfJobs) == 0) continue;
    ++numbers;
    const auto fault = [&](double value) {
      return Fault([&](JobSpec& spec) {
        if (option.needs == OptionNeeds::kWang) spec.set_surface("wang");
        OptionField(option).SetNumber(value, spec);
      });
    };
    EXPECT_EQ(fault(option.min), "");
    EXPECT_EQ(fault(option.max), "");
    EXPECT_EQ(fault(std::nextafter(option.min, -1e9)), option.field);
    EXPECT_EQ(fault(std::nextafter(option.max, 1e9)), option.field);
    EXPECT_EQ(fault(std::numeric_limits<double>::quiet_NaN()), option.field);
  }
  EXPECT_GE(numbers, 3);
}

TEST(JobOptionsTest, FieldsThatAreNotSetHaveTheDefaults) {
  const JobSpec spec = WithDefaults({});
  EXPECT_EQ(spec.gradation(), 1.3);
  EXPECT_EQ(spec.size_limit(), 16);
  EXPECT_EQ(spec.surface(), "thin-plate");
  EXPECT_EQ(spec.water(), "auto");
  EXPECT_FALSE(spec.has_tension());
  EXPECT_TRUE(AreEqual(WithDefaults(spec), spec));
}

// As journals of earlier releases have it.
TEST(JobOptionsTest, TheToleranceOfWaterIsReadOver) {
  const std::string field("\x61\x9a\x99\x99\x99\x99\x99\xc9\x3f", 9);  // 12, a double: 0.2
  JobSpec read;
  ASSERT_TRUE(read.ParseFromString(Valid().SerializeAsString() + field));
  EXPECT_TRUE(AreEqual(WithDefaults(read), Valid()));
}

TEST(JobOptionsTest, RefusesWhatIsOfFillAlone) {
  EXPECT_EQ(Fault([](JobSpec& s) { s.set_weld(0.1); }), "weld");
  EXPECT_EQ(Fault([](JobSpec& s) { s.set_allow_creases(true); }), "allow_creases");
  EXPECT_EQ(Fault([](JobSpec& s) { s.set_filler("svm-laplacian"), s.set_svm_rings(2); }), "svm_rings");
}

Flags Parsed(unsigned commands, const std::vector<std::string>& words) {
  return Flags::Parse(OptionFlags(commands), words).value();
}

// What is wrong with flags of `fill`.
std::string FlagFault(std::vector<std::string> words) {
  const Flags flags = Parsed(kOfFill, words);
  const auto spec = SpecFromFlags(flags, kOfFill);
  if (!spec.ok()) return std::string(spec.status().message());
  const auto given = [&](const Option& option) { return flags.IsGiven(FlagOf(option)); };
  return std::string(NamedAsFlag(CheckOptions(*spec, kOfFill, given)).message());
}

TEST(JobOptionsTest, MessagesNameTheFlagItsValueAndWhatIsAllowed) {
  using testing::HasSubstr;
  EXPECT_EQ(FlagFault({"--gradation", "0.5"}), "--gradation '0.5': expected a number from 1 to 10");
  EXPECT_EQ(FlagFault({"--gradation", "big"}), "--gradation 'big': expected a number from 1 to 10");
  EXPECT_EQ(FlagFault({"--tension", "-1"}), "--tension '-1': expected auto or a number from 0 to 1000");
  EXPECT_EQ(FlagFault({"--water-profile", "x"}), "--water-profile 'x': expected city or usgs");
  EXPECT_EQ(FlagFault({"--water-colour", "x"}), "--water-colour 'x': expected R,G,B, each 0 to 255, or #rrggbb");
  EXPECT_EQ(FlagFault({"--svm-rings", "2.7", "--filler", "svm-laplacian"}),
            "--svm-rings '2.7': expected a whole number from 1 to 20");
  EXPECT_THAT(FlagFault({"--filler", "svm-laplacian", "--front-steps", "bold"}),
              HasSubstr("'bold': expected steady or printed"));
  EXPECT_THAT(FlagFault({"--front-steps", "printed"}), HasSubstr("or choose advancing-front-normal"));
  EXPECT_THAT(FlagFault({"--svm-rings", "2", "--filler", "minimum-area"}), HasSubstr("or choose svm-laplacian"));
  EXPECT_EQ(FlagFault({"--svm-rings", "20", "--filler", "svm-laplacian"}), "");
}

TEST(JobOptionsTest, AFlagWithItsDefaultIsGiven) {
  EXPECT_THAT(FlagFault({"--uniform", "--gradation", "1.3"}), testing::HasSubstr("--gradation: uniform"));
  EXPECT_EQ(FlagFault({"--uniform"}), "");
}

TEST(JobOptionsTest, WordsOfNumbersLeaveThemToTheProgram) {
  const auto spec =
      SpecFromFlags(Parsed(kOfFill, {"--tension", "auto", "--weld", "off", "--largest-hole=any"}), kOfFill);
  ASSERT_TRUE(spec.ok());
  EXPECT_FALSE(spec->has_tension() || spec->has_weld() || spec->has_largest_hole());
  EXPECT_EQ(SpecFromFlags(Parsed(kOfFill, {"--largest-hole=40"}), kOfFill)->largest_hole(), 40);
}

TEST(JobOptionsTest, TextsGiveTheSameAsFlags) {
  const auto texts = SpecFromTexts({{"tension", "2.5"}, {"uniform", "true"}, {"weld", "off"}}, kOfFill);
  const auto flags = SpecFromFlags(Parsed(kOfFill, {"--tension", "2.5", "--uniform", "--weld=off"}), kOfFill);
  ASSERT_TRUE(texts.ok()) << texts.status();
  EXPECT_TRUE(AreEqual(*texts, *flags));
}

TEST(JobOptionsTest, TextsThatAreNoneNameTheField) {
  const auto fault = [](const std::map<std::string, std::string>& texts) {
    const absl::Status status = SpecFromTexts(texts, kOfFill).status();
    EXPECT_TRUE(status.ok() || GetErrorInfo(status)->metadata.at("field") == texts.begin()->first);
    return std::string(status.message());
  };
  EXPECT_EQ(fault({{"gradation", "big"}}), "gradation 'big': expected a number from 1 to 10");
  EXPECT_EQ(fault({{"uniform", "1"}}), "uniform '1': expected true or false");
  EXPECT_EQ(fault({{"gradatoin", "2"}}), "gradatoin: there is no such option; did you mean gradation?");
  EXPECT_EQ(fault({{"cells", "0,0"}}).substr(0, 33), "cells: there is no such option");
}

TEST(JobOptionsTest, WorkersGetWhatTheirTasksDependOnAlone) {
  JobSpec spec = Valid();
  spec.set_gradation(2);
  spec.set_tension(0);
  spec.set_overwrite(true);
  const JobSpec sent = OptionsForWorkers(spec);
  EXPECT_EQ(sent.gradation(), 2);
  EXPECT_TRUE(sent.has_tension());
  EXPECT_TRUE(sent.scene().empty() && sent.out().empty() && !sent.overwrite());
  EXPECT_TRUE(CheckOptionsForWorkers(WithDefaults(sent)).ok());
  spec.set_fairing_steps(1 << 20);
  EXPECT_FALSE(CheckOptionsForWorkers(spec).ok());
}

const ReportedOption* Find(const std::vector<ReportedOption>& options, const std::string& name) {
  const auto found = std::ranges::find(options, name, &ReportedOption::name);
  return found == options.end() ? nullptr : &*found;
}

TEST(JobOptionsTest, ReportsWhatTheOutputDependsOn) {
  using Value = decltype(ReportedOption::value);
  JobSpec spec = Valid();
  const auto jobs = ReportedOptions(spec, kOfJobs);
  EXPECT_EQ(Find(jobs, "tension")->value, Value(std::string("auto")));
  EXPECT_EQ(Find(jobs, "size-limit")->value, Value(16.0));
  EXPECT_EQ(Find(jobs, "uniform")->value, Value(false));
  for (const char* name : {"out", "overwrite", "closure", "front-steps", "weld"}) EXPECT_EQ(Find(jobs, name), nullptr);
  spec.set_filler("svm-laplacian");
  spec.set_svm_gamma(2.5);
  const auto fill = ReportedOptions(spec, kOfFill);
  EXPECT_EQ(Find(fill, "svm-gamma")->value, Value(2.5));
  EXPECT_EQ(Find(fill, "svm-rings")->value, Value(3.0)) << "its default";
  EXPECT_EQ(Find(fill, "weld")->value, Value(std::string("off")));
  EXPECT_EQ(Find(fill, "longest-loop"), nullptr) << "of another filler";
}

}  // namespace
}  // namespace tilemend
