// Manual pages and completion for shells, written from the tables of flags that --help prints.
#ifndef TILEMEND_COMMON_UTIL_MANUAL_H_
#define TILEMEND_COMMON_UTIL_MANUAL_H_

#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "common/util/flags.h"

namespace tilemend {

struct ManualCommand {
  std::string name;
  std::string arguments;  // "SCENE --out DIR"
  std::string summary;    // one line
  std::vector<FlagSpec> flags;
  std::vector<std::string> examples = {};  // what follows the program's name
};

struct Manual {
  std::string program;
  std::string summary;                  // one line, without a full stop
  std::string usage;                    // what follows the program's name
  std::string settings_file;            // that the program reads by itself; "" if TILEMEND_CONFIG alone names one
  std::vector<ManualCommand> commands;  // empty for a program without commands
  std::vector<FlagSpec> flags;          // of the program itself
};

// A page for man(1): troff with the macros of man(7).
std::string ManPage(const Manual& manual);
// A script for completions of bash-completion, and a function for zsh's fpath.
std::string BashCompletion(const Manual& manual);
std::string ZshCompletion(const Manual& manual);

// Sections of docs/reference.md: a table of flags for each command.
std::string MarkdownReference(const Manual& manual);

// --describe man|bash|zsh|markdown, which every program has.
FlagSpec DescribeFlag();
// What it prints; kInvalidArgument for another form.
absl::StatusOr<std::string> Describe(const Manual& manual, const std::string& form);

}  // namespace tilemend

#endif  // TILEMEND_COMMON_UTIL_MANUAL_H_
