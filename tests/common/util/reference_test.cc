#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/util/manual.h"

namespace tilemend {
namespace {

using testing::HasSubstr;

TEST(ReferenceTest, HasATableForTheProgramAndEachCommand) {
  FlagSpec paper = {"closure", "buffers|line", "of wang", "buffers"};
  paper.group = FlagGroup::kPapers;
  const Manual manual = {"tool",
                         "does things",
                         "COMMAND ...",
                         "",
                         {{"run", "SCENE", "fill it", {paper, {"output", "F", "format", "", 'o'}}, {"run scene"}},
                          {"walk", "", "go", {}},
                          {"stroll", "", "go on", {}}},
                         {{"version", "", "show the release", ""}}};
  const std::string text = MarkdownReference(manual);
  EXPECT_THAT(text, HasSubstr("## tool\n\n`tool COMMAND ...`: does things.\n"));
  EXPECT_THAT(text, HasSubstr("| `--version` |  |  | everyday | show the release |\n"));
  EXPECT_THAT(text, HasSubstr("### tool run\n\n`tool run SCENE`: fill it.\n"));
  EXPECT_THAT(text, HasSubstr("| `-o` `--output` | F |  | everyday | format |\n"
                              "| `--closure` | buffers\\|line | buffers | papers | of wang |\n"))
      << "everyday flags first";
  EXPECT_THAT(text, HasSubstr("`tool stroll`: go on. Flags as of `tool walk`.\n"));
  EXPECT_THAT(text, HasSubstr("```sh\ntool run scene\n```\n"));
}

}  // namespace
}  // namespace tilemend
