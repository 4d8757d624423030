#include "common/util/flags.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tilemend {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

const std::vector<FlagSpec>& Specs() {
  static const std::vector<FlagSpec> specs = {{"out", "DIR", "folder", ""},
                                              {"workers", "N", "tasks", "2"},
                                              {"overwrite", "", "replace", ""},
                                              {"output", "FORMAT", "table or json", "table", 'o'}};
  return specs;
}

std::string ErrorOf(const std::vector<std::string>& words) {
  return std::string(Flags::Parse(Specs(), words).status().message());
}

TEST(FlagsTest, TakesBothFormsOfAValue) {
  const auto flags = Flags::Parse(Specs(), {"scene", "--out=a=b", "--workers", "3", "--overwrite", "-o", "json"});
  ASSERT_TRUE(flags.ok()) << flags.status();
  EXPECT_THAT(flags->arguments(), ElementsAre("scene"));
  EXPECT_EQ(flags->Text("out"), "a=b");
  EXPECT_EQ(*flags->Integer("workers", 1, 10), 3);
  EXPECT_TRUE(flags->Switch("overwrite"));
  EXPECT_EQ(flags->Text("output"), "json");
}

TEST(FlagsTest, GivesDefaults) {
  const auto flags = Flags::Parse(Specs(), {});
  EXPECT_EQ(*flags->Integer("workers", 1, 10), 2);
  EXPECT_FALSE(flags->IsGiven("workers"));
  EXPECT_FALSE(flags->Switch("overwrite"));
}

TEST(FlagsTest, EverythingAfterTwoDashesIsAnArgument) {
  EXPECT_THAT(Flags::Parse(Specs(), {"-", "--", "--out", "-x"})->arguments(), ElementsAre("-", "--out", "-x"));
}

TEST(FlagsTest, TakesValuesAsTheyStand) {
  const auto text = [](const std::vector<std::string>& words) { return Flags::Parse(Specs(), words)->Text("out"); };
  EXPECT_EQ(text({"--out", "[a,b]"}), "[a,b]") << "no list";
  EXPECT_EQ(text({"--out", "--overwrite"}), "--overwrite");
  EXPECT_EQ(text({"--out", "--"}), "--");
  EXPECT_EQ(text({"--out=first", "--out", "last"}), "last");
  EXPECT_EQ(text({"--out", "\"a b\""}), "\"a b\"");
  EXPECT_EQ(Flags::Parse(Specs(), {"-o=json"})->Text("output"), "json");
  EXPECT_THAT(Flags::Parse(Specs(), {"[a,b]", "%%", "a b"})->arguments(), ElementsAre("[a,b]", "%%", "a b"));
}

TEST(FlagsTest, ANegativeNumberIsAnArgument) {
  EXPECT_THAT(Flags::Parse(Specs(), {"job", "-5"})->arguments(), ElementsAre("job", "-5"));
}

TEST(FlagsTest, TwoValuesOfAFlagMayBeAnError) {
  const auto parse = [](const char* first, const char* last) {
    return Flags::Parse(Specs(), {"--out", first, "--out", last}, {}, TwoValues::kAreAnError);
  };
  EXPECT_EQ(parse("first", "last").status().message(),
            "--out is given twice, as first and as last; it takes one value");
  EXPECT_EQ(parse("same", "same")->Text("out"), "same");
}

TEST(FlagsTest, SaysWhatIsWrong) {
  EXPECT_EQ(ErrorOf({"--overwrit"}), "unknown flag --overwrit; did you mean --overwrite?");
  EXPECT_EQ(ErrorOf({"--completely-else"}), "unknown flag --completely-else");
  EXPECT_EQ(ErrorOf({"--out"}), "--out needs a value: DIR");
  EXPECT_EQ(ErrorOf({"--out", ""}), "--out is empty; expected DIR");
  EXPECT_EQ(ErrorOf({"--out="}), "--out is empty; expected DIR");
  EXPECT_EQ(ErrorOf({"--overwrite=yes"}), "--overwrite takes no value");
  EXPECT_EQ(ErrorOf({"scene", "-out", "x"}), "unknown flag -out; did you mean --out?");
  EXPECT_EQ(ErrorOf({"-out=x"}), "unknown flag -out; did you mean --out?");
}

TEST(FlagsTest, TakesSeveralLettersInOneWord) {
  std::vector<FlagSpec> specs = Specs();
  specs.push_back({"verbose", "", "more messages", "", 'v'});
  const auto flags = Flags::Parse(specs, {"-vo", "json"});
  ASSERT_TRUE(flags.ok()) << flags.status();
  EXPECT_TRUE(flags->Switch("verbose"));
  EXPECT_EQ(flags->Text("output"), "json");
  EXPECT_EQ(Flags::Parse(specs, {"scene", "-vo"}).status().message(), "--output needs a value: FORMAT");
}

TEST(FlagsTest, ChecksNumbers) {
  const auto flags = Flags::Parse(Specs(), {"--workers", "many", "--out", "nan"});
  EXPECT_THAT(std::string(flags->Integer("workers", 1, 10).status().message()), HasSubstr("from 1 to 10"));
  EXPECT_FALSE(flags->Number("out", 0, 1).ok());
  EXPECT_FALSE(Flags::Parse(Specs(), {"--workers", "11"})->Integer("workers", 1, 10).ok());
}

TEST(FlagsTest, ReadsNumbersInTheirRange) {
  const auto flags = Flags::Parse(Specs(), {"--out", "-0.5", "--workers=10"});
  EXPECT_EQ(*flags->Number("out", -1, 1), -0.5);
  EXPECT_FALSE(flags->Number("out", 0, 1).ok());
  EXPECT_EQ(*flags->Integer("workers", 1, 10), 10);
  EXPECT_EQ(flags->Text("not a flag"), "");
}

TEST(DidYouMeanTest, NamesTheNearestIfItIsNear) {
  EXPECT_EQ(DidYouMean("fil", {"run", "fill", "inspect"}), "; did you mean fill?");
  EXPECT_EQ(DidYouMean("inspectoins", {"run", "inspections"}), "; did you mean inspections?");
  EXPECT_EQ(DidYouMean("demolish", {"run", "fill"}), "");
  EXPECT_EQ(DidYouMean("run", {}), "");
  EXPECT_EQ(DidYouMean("largest", {"water", "largest_hole"}), "; did you mean largest_hole?");
  EXPECT_EQ(DidYouMean("largest", {"largest_lake", "largest_hole"}), "");
  EXPECT_EQ(DidYouMean("", {"largest_hole"}), "");
}

TEST(FlagsHelpTest, HasALineForEachFlag) {
  EXPECT_EQ(FlagsHelp(Specs()),
            "      --out DIR                   folder\n"
            "      --workers N                 tasks (default: 2)\n"
            "      --overwrite                 replace\n"
            "  -o, --output FORMAT             table or json (default: table)\n");
}

TEST(FlagsHelpTest, GroupsFlagsAndHidesThoseOfPapers) {
  std::vector<FlagSpec> specs = {
      {"closure", "", "papers", ""}, {"work", "", "advanced", ""}, {"out", "", "everyday", ""}};
  specs[0].group = FlagGroup::kPapers;
  specs[1].group = FlagGroup::kAdvanced;
  const std::string first =
      "      --out                       everyday\n"
      "\nAdvanced:\n"
      "      --work                      advanced\n\n";
  EXPECT_EQ(FlagsHelp(specs, 0, false), first + "--help-all shows 1 more flags, of published methods.\n");
  EXPECT_EQ(FlagsHelp(specs), first +
                                  "Published methods, for comparison:\n"
                                  "      --closure                   papers\n");
}

TEST(FlagsHelpTest, KeepsToTheColumnsOfATerminal) {
  const std::vector<FlagSpec> specs = {{"out", "DIR", "where to write what was asked for and more of it", "here"}};
  EXPECT_EQ(FlagsHelp(specs),
            "      --out DIR                   where to write what was asked for and more of it (default: here)\n");
  EXPECT_EQ(FlagsHelp(specs, 60),
            "      --out DIR                   where to write what was\n"
            "                                  asked for and more of it\n"
            "                                  (default: here)\n");
  EXPECT_EQ(FlagsHelp(specs, 30), FlagsHelp(specs));
  EXPECT_EQ(FlagsHelp({{"a", "", std::string(60, 'x') + " y", ""}}, 60),
            "      --a                         " + std::string(60, 'x') + " y\n");
}

}  // namespace
}  // namespace tilemend
