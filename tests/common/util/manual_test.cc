#include "common/util/manual.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tilemend {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

Manual Tool() {
  FlagSpec server{"server", "HOST:PORT", "where it is", "here:1", 0, true};
  FlagSpec form{"output", "table|json", "format [of stdout]: either", "table", 'o'};
  return {"tool",
          "does things",
          "COMMAND ...",
          "~/.tool.conf",
          {{"run", "SCENE --out DIR", "fill it's holes", {{"out", "DIR", "where to", ""}, server}},
           {"list", "", "show all", {form, {"water", "auto|off|FILE", "which", ""}}}},
          {{"version", "", "show the release", ""}}};
}

TEST(ManualTest, ThePageHasEveryCommandFlagDefaultAndSetting) {
  const std::string page = ManPage(Tool());
  EXPECT_THAT(page, AllOf(HasSubstr(".TH TOOL 1"), HasSubstr("tool \\- does things\n"),
                          HasSubstr(".SS run SCENE \\-\\-out DIR\nfill it's holes.\n")));
  EXPECT_THAT(page, HasSubstr(".TP\n\\fB\\-\\-server\\fR \\fIHOST:PORT\\fR\nwhere it is (default: here:1)\n"));
  EXPECT_THAT(page, HasSubstr("\\fB\\-o\\fR, \\fB\\-\\-output\\fR \\fItable|json\\fR\n"));
  EXPECT_THAT(page, AllOf(HasSubstr("TILEMEND_SERVER."), Not(HasSubstr("TILEMEND_OUT"))));
  EXPECT_THAT(page, HasSubstr("~/.tool.conf"));
}

TEST(ManualTest, TextThatTroffWouldTakeForACommandIsText) {
  Manual manual = Tool();
  manual.commands[0].summary = ".so /etc/passwd";
  manual.commands[0].flags[0].help = "a\\b";
  EXPECT_THAT(ManPage(manual), AllOf(HasSubstr("\\&.so /etc/passwd"), HasSubstr("a\\eb")));
}

TEST(ManualTest, CompletionKnowsWhatAValueMayBe) {
  const std::string bash = BashCompletion(Tool());
  EXPECT_THAT(bash, HasSubstr("compgen -W 'help run list --version'"));
  EXPECT_THAT(bash, HasSubstr("list:--output|list:-o) COMPREPLY+=($(compgen -W 'table json' -- \"$cur\"))"));
  EXPECT_THAT(bash, HasSubstr("run:--out) compopt -o filenames"));
  const std::string zsh = ZshCompletion(Tool());
  EXPECT_THAT(zsh, HasSubstr("'run:fill it'\\''s holes'"));
  EXPECT_THAT(zsh, HasSubstr("'--output=[format \\[of stdout\\]\\: either]:table|json:(table json)'"));
  EXPECT_THAT(zsh, HasSubstr("'--water=[which]:auto|off|FILE:{compadd auto off; _files}'"));
  EXPECT_THAT(zsh, HasSubstr("'--out=[where to]:DIR:_files -/'"));
}

TEST(ManualTest, DescribesInFourForms) {
  EXPECT_EQ(*Describe(Tool(), "man"), ManPage(Tool()));
  EXPECT_EQ(*Describe(Tool(), "bash"), BashCompletion(Tool()));
  EXPECT_EQ(*Describe(Tool(), "zsh"), ZshCompletion(Tool()));
  EXPECT_EQ(*Describe(Tool(), "markdown"), MarkdownReference(Tool()));
  EXPECT_THAT(std::string(Describe(Tool(), "fish").status().message()),
              HasSubstr("expected man, bash, zsh or markdown"));
}

}  // namespace
}  // namespace tilemend
