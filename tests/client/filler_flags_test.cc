#include "client/filler_flags.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace tilemend {
namespace {

using testing::HasSubstr;

absl::StatusOr<FillOptions> Read(Filler filler, const std::vector<std::string>& words) {
  const auto args = Flags::Parse(FillerFlags(), words);
  if (!args.ok()) return args.status();
  FillOptions options;
  options.filler = filler;
  const absl::Status status = ReadFillerFlags(*args, options);
  if (!status.ok()) return status;
  return options;
}

const ReportedOption* Find(const std::vector<ReportedOption>& options, const std::string& name) {
  for (const ReportedOption& option : options) {
    if (option.name == name) return &option;
  }
  return nullptr;
}

TEST(FillerFlagsTest, ReadsAndReportsTheOptionsOfAFiller) {
  const auto options = Read(Filler::kSvmLaplacian, {"--front-steps", "printed", "--front-merge", "0.4", "--svm-rings",
                                                    "5", "--svm-gamma", "2.5", "--filler-work", "1e3"});
  ASSERT_TRUE(options.ok()) << options.status();
  EXPECT_EQ(options->filling.steps, FrontSteps::kPrinted);
  EXPECT_EQ(options->filling.merge, 0.4);
  EXPECT_EQ(options->filling.rings, 5);
  EXPECT_EQ(options->filling.most_work, 1000);
  const std::vector<ReportedOption> reported = ReportedFillerOptions(*options);
  const auto value = [&](const char* name) { return Find(reported, name)->value; };
  EXPECT_EQ(value("filler"), decltype(ReportedOption::value)(std::string("svm-laplacian")));
  EXPECT_EQ(value("front-steps"), decltype(ReportedOption::value)(std::string("printed")));
  EXPECT_EQ(value("svm-rings"), decltype(ReportedOption::value)(5.0));
  EXPECT_EQ(value("svm-gamma"), decltype(ReportedOption::value)(2.5));
  EXPECT_EQ(Find(reported, "front-bend"), nullptr) << "of another filler";
  EXPECT_EQ(Find(reported, "longest-loop"), nullptr);
}

TEST(FillerFlagsTest, ReportsWhatIsLeftToTheProgram) {
  const auto bend = ReportedFillerOptions(*Read(Filler::kAdvancingFrontNormal, {}));
  EXPECT_EQ(Find(bend, "front-bend")->value, decltype(ReportedOption::value)(std::string("auto")));
  EXPECT_EQ(Find(bend, "front-steps")->value, decltype(ReportedOption::value)(std::string("steady")));
  EXPECT_EQ(ReportedFillerOptions(*Read(Filler::kAuto, {})).size(), 2U) << "surface and filler";
  FillOptions wang;
  wang.surface = Surface::kWang;
  EXPECT_EQ(Find(ReportedFillerOptions(wang), "fairing-steps")->value, decltype(ReportedOption::value)(10.0));
  EXPECT_NE(Find(ReportedFillerOptions(*Read(Filler::kMinimumArea, {})), "longest-loop"), nullptr);
}

TEST(FillerFlagsTest, ReadsWhichLaplaciansAreLearnt) {
  const auto scale = [](const std::vector<std::string>& words) {
    return Read(Filler::kSvmLaplacian, words)->filling.scale;
  };
  EXPECT_EQ(scale({}), LaplacianScale::kArea);
  EXPECT_EQ(scale({"--svm-laplacian", "mean"}), LaplacianScale::kMean);
  EXPECT_EQ(scale({"--svm-laplacian", "area"}), LaplacianScale::kArea);
}

TEST(FillerFlagsTest, SaysWhatIsWrong) {
  const auto wrong = [](Filler filler, const std::vector<std::string>& words) {
    return std::string(Read(filler, words).status().message());
  };
  EXPECT_THAT(wrong(Filler::kAuto, {"--front-steps", "printed"}), HasSubstr("or choose advancing-front-normal"));
  EXPECT_THAT(wrong(Filler::kMinimumArea, {"--svm-rings", "2"}), HasSubstr("or choose svm-laplacian"));
  EXPECT_THAT(wrong(Filler::kSvmLaplacian, {"--front-steps", "bold"}), HasSubstr("'bold': expected steady or printed"));
  EXPECT_THAT(wrong(Filler::kSvmLaplacian, {"--svm-laplacian", "x"}), HasSubstr("'x': expected area or mean"));
  EXPECT_THAT(wrong(Filler::kMinimumArea, {"--svm-laplacian", "mean"}), HasSubstr("or choose svm-laplacian"));
  EXPECT_THAT(wrong(Filler::kSvmLaplacian, {"--svm-gamma", "1e9"}), HasSubstr("--svm-gamma"));
  EXPECT_THAT(wrong(Filler::kSvmLaplacian, {"--svm-width", "0.1"}), HasSubstr("--svm-width"));
  EXPECT_THAT(wrong(Filler::kSvmLaplacian, {"--svm-rings", "2.7"}), HasSubstr("expected a whole number"));
  EXPECT_THAT(wrong(Filler::kSvmLaplacian, {"--svm-rings", "21"}), HasSubstr("--svm-rings"));
  EXPECT_EQ(wrong(Filler::kSvmLaplacian, {"--svm-rings", "20"}), "");
}

}  // namespace
}  // namespace tilemend
