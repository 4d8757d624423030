// The reference of a program's flags as Markdown.
#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include "absl/strings/str_cat.h"
#include "absl/strings/str_replace.h"
#include "common/util/manual.h"

namespace tilemend {
namespace {

std::string Cell(const std::string& text) { return absl::StrReplaceAll(text, {{"|", "\\|"}}); }

const char* TitleOf(FlagGroup group) {
  switch (group) {
    case FlagGroup::kEveryday:
      return "everyday";
    case FlagGroup::kAdvanced:
      return "advanced";
    case FlagGroup::kPapers:
      break;
  }
  return "papers";
}

std::string FlagTable(std::vector<FlagSpec> flags) {
  std::ranges::stable_sort(flags, {}, &FlagSpec::group);
  std::string text = "| flag | value | default | group | what it does |\n|---|---|---|---|---|\n";
  for (const FlagSpec& flag : flags) {
    absl::StrAppend(&text, "| ", flag.letter == 0 ? "" : absl::StrCat("`-", std::string(1, flag.letter), "` "), "`--",
                    flag.name, "` | ", Cell(flag.value), " | ", Cell(flag.default_value), " | ", TitleOf(flag.group),
                    " | ", Cell(flag.help), " |\n");
  }
  return text;
}

std::string ExampleLines(const std::string& program, const std::vector<std::string>& examples) {
  if (examples.empty()) return "";
  std::string text = "\n```sh\n";
  for (const std::string& example : examples) absl::StrAppend(&text, program, " ", example, "\n");
  return text + "```\n";
}

}  // namespace

std::string MarkdownReference(const Manual& manual) {
  std::string text = absl::StrCat("## ", manual.program, "\n\n`", manual.program, " ", manual.usage,
                                  "`: ", manual.summary, ".\n\n", FlagTable(manual.flags));
  std::map<std::string, std::string> first_with;  // heading by table
  for (const ManualCommand& command : manual.commands) {
    const std::string heading = absl::StrCat(manual.program, " ", command.name);
    const std::string table = FlagTable(command.flags);
    const auto [first, is_new] = first_with.try_emplace(table, heading);
    absl::StrAppend(&text, "\n### ", heading, "\n\n`", heading, command.arguments.empty() ? "" : " ", command.arguments,
                    "`: ", command.summary, ".",
                    is_new ? absl::StrCat("\n\n", table) : absl::StrCat(" Flags as of `", first->second, "`.\n"),
                    ExampleLines(manual.program, command.examples));
  }
  return text;
}

}  // namespace tilemend
