#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <new>

#include "absl/strings/str_cat.h"
#include "client/commands.h"
#include "client/output.h"
#include "common/util/exit_codes.h"
#include "common/util/manual.h"
#include "common/util/object_store.h"
#include "common/util/settings.h"
#include "common/util/standard_streams.h"
#include "common/util/text.h"
#include "common/util/version.h"

namespace tilemend {
namespace {

// Of `tilemend` without a command.
std::vector<FlagSpec> OwnFlags() {
  return {DescribeFlag(), {"version", "", "show the release", ""}, {"help", "", "show this", "", 'h'}};
}

// `code`, unless what was printed does not reach standard output, as on a full disk.
int AfterPrinting(int code) {
  const absl::Status printed = FlushOutput();
  return printed.ok() ? code : PrintError(printed);
}

int PrintVersion() {
  std::printf("tilemend %s\n", Version());
  return AfterPrinting(kExitDone);
}

int PrintDescription(const std::vector<Command>& commands, const std::string& form) {
  Manual manual{"tilemend",
                "fills the holes of very large triangle meshes that are stored as tiles",
                "COMMAND ...",
                "~/.config/tilemend.conf",
                {},
                OwnFlags()};
  for (const Command& command : commands) {
    manual.commands.push_back({command.name, command.arguments, command.summary, command.flags, command.examples});
  }
  const auto text = Describe(manual, form);
  std::fputs(text.ok() ? text->c_str() : absl::StrCat("tilemend: ", std::string(text.status().message()), "\n").c_str(),
             text.ok() ? stdout : stderr);
  return AfterPrinting(text.ok() ? kExitDone : kExitUsage);
}

std::string Help(const std::vector<Command>& commands) {
  std::string text =
      "Fills the holes of very large triangle meshes that are stored as tiles.\n\nUsage: tilemend COMMAND ...\n\n";
  for (const Command& command : commands) {
    std::string left = absl::StrCat("  ", command.name, " ", command.arguments);
    left.resize(std::max<size_t>(left.size() + 2, 34), ' ');
    absl::StrAppend(&text, left, command.summary, "\n");
  }
  absl::StrAppend(&text,
                  "  help COMMAND                    show the flags of a command; COMMAND --help-all shows all\n"
                  "\n",
                  FlagsHelp(OwnFlags(), ColumnsOfHelp(STDOUT_FILENO)),
                  "\n"
                  "Exit codes: 0 done, 2 usage, 3 not found, 4 invalid input, 5 try again, 6 failed, 7 cancelled,\n"
                  "100 done but some holes or cells are left.\n");
  return text;
}

std::string UsageOf(const Command& command) {
  return absl::StrCat("tilemend ", command.name, command.arguments.empty() ? "" : " ", command.arguments);
}

std::string HelpOf(const Command& command, bool all) {
  std::string text = absl::StrCat("Usage: ", UsageOf(command), " [FLAGS]\n\n", command.summary, "\n\n",
                                  FlagsHelp(command.flags, ColumnsOfHelp(STDOUT_FILENO), all));
  if (!command.examples.empty()) absl::StrAppend(&text, "\nExamples:\n");
  for (const std::string& example : command.examples) absl::StrAppend(&text, "  tilemend ", example, "\n");
  return text;
}

bool Has(const std::vector<std::string>& words, const char* word) {
  return std::ranges::find(words, word) != words.end();
}

int UsageError(const std::string& text) {
  std::fprintf(stderr, "tilemend: %s\nTry `tilemend help`.\n", Printable(text).c_str());
  return kExitUsage;
}

// Whether a command that works on folders alone is given an object of a store.
bool NamesObjects(const Command& command, const std::vector<std::string>& words) {
  constexpr const char* kForObjects[] = {"run", "submit", "inspect", "report", "check"};
  if (std::ranges::find(kForObjects, command.name) != std::end(kForObjects)) return false;
  return std::ranges::any_of(words, [](const std::string& word) {
    return IsObjectPath(word) || IsObjectPath(word.substr(word.find('=') + 1));
  });
}

int RunParsed(const Command& command, const std::vector<std::string>& words) {
  auto settings = ReadSettings(command.flags, UsualFile(std::getenv), std::getenv);
  // As under sudo, where it is the file of another user. One that is named is wanted.
  if (absl::IsPermissionDenied(settings.status()) && std::getenv("TILEMEND_CONFIG") == nullptr) {
    std::fprintf(stderr, "tilemend: warning: %s; its settings are not used\n",
                 std::string(settings.status().message()).c_str());
    settings = ReadSettings(command.flags, "", std::getenv);
  }
  if (!settings.ok()) return UsageError(std::string(settings.status().message()));
  const auto args = Args::Parse(command.flags, words, *settings, TwoValues::kAreAnError);
  if (!args.ok()) return UsageError(absl::StrCat(command.name, ": ", std::string(args.status().message())));
  const size_t given = args->arguments().size(), least = command.argument_count,
               most = least + command.optional_arguments;
  if (given < least || given > most) {
    return UsageError(absl::StrCat(command.name, ": expected ", least, most > least ? absl::StrCat(" or ", most) : "",
                                   most == 1 ? " argument" : " arguments", ", got ", given,
                                   "; usage: ", UsageOf(command)));
  }
  for (const std::string& argument : args->arguments()) {
    if (argument.empty()) return UsageError(absl::StrCat(command.name, ": an argument is empty"));
  }
  for (const std::string& name : command.required_flags) {
    if (!args->Text(name).empty()) continue;
    const char* hint = name == "out" ? " (-o is the form of what is printed)" : "";
    return UsageError(absl::StrCat(command.name, ": --", name, " is needed", hint));
  }
  if (NamesObjects(command, words)) {
    return UsageError(
        absl::StrCat(command.name, ": s3:// paths are for run, submit, inspect, report and check; copy to a folder"));
  }
  try {
    return AfterPrinting(command.run(*args));
  } catch (const std::bad_alloc&) {
    std::fprintf(stderr, "tilemend: %s: out of memory; use larger triangles (no --uniform) or a larger machine\n",
                 command.name.c_str());
    return kExitRetryable;
  }
}

}  // namespace

int Dispatch(const std::vector<Command>& commands, const std::vector<std::string>& words) {
  if (words.empty()) {
    std::fputs(Help(commands).c_str(), stderr);
    return kExitUsage;
  }
  if (words[0] == "--version" || words[0] == "version") return PrintVersion();
  if (words[0] == "--describe") return PrintDescription(commands, words.size() > 1 ? words[1] : "");
  const bool help = words[0] == "help" || words[0] == "--help" || words[0] == "-h";
  if (help && words.size() == 1) {
    std::fputs(Help(commands).c_str(), stdout);
    return AfterPrinting(kExitDone);
  }
  const std::string& name = help ? words[1] : words[0];
  std::vector<std::string> names = {"help"};
  for (const Command& command : commands) {
    names.push_back(command.name);
    if (command.name != name) continue;
    const std::vector<std::string> rest(words.begin() + (help ? 2 : 1), words.end());
    if (Has(rest, "--version")) return PrintVersion();
    const bool all = Has(rest, "--help-all");
    if (!help && !all && !Has(rest, "--help") && !Has(rest, "-h")) return RunParsed(command, rest);
    std::fputs(HelpOf(command, all).c_str(), stdout);
    return AfterPrinting(kExitDone);
  }
  return UsageError(absl::StrCat("unknown command '", name, "'", DidYouMean(name, names)));
}

}  // namespace tilemend
