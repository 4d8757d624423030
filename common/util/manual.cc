#include "common/util/manual.h"

#include <algorithm>
#include <cctype>
#include <set>

#include "absl/strings/ascii.h"
#include "absl/strings/str_cat.h"
#include "absl/strings/str_join.h"
#include "absl/strings/str_replace.h"
#include "absl/strings/str_split.h"
#include "common/util/settings.h"
#include "common/util/version.h"

namespace tilemend {
namespace {

// What may stand for a value or an argument.
struct Values {
  std::vector<std::string> words;
  bool files = false;
  bool folders = false;
};

Values ValuesOf(const std::string& shown) {
  Values values;
  const std::string first = shown.substr(0, shown.find_first_of(" ["));
  const std::vector<std::string> parts = absl::StrSplit(first, '|');
  for (const std::string& part : parts) {
    if (part == "FILE" || part == "MESH") values.files = true;
    if (part == "SCENE") values.files = values.folders = true;
    if (part == "DIR") values.folders = true;
    if (!part.empty() && std::islower(static_cast<unsigned char>(part[0])) != 0) values.words.push_back(part);
  }
  return values;
}

// A program without commands is a command without a name.
std::vector<ManualCommand> CommandsOf(const Manual& manual) {
  if (!manual.commands.empty()) return manual.commands;
  return {{"", "", "", manual.flags}};
}

std::string FunctionOf(const Manual& manual) {
  return absl::StrCat("_", absl::StrReplaceAll(manual.program, {{"-", "_"}}));
}

std::string Troff(const std::string& text) {
  const bool is_request = !text.empty() && (text[0] == '.' || text[0] == '\'');
  return absl::StrCat(is_request ? "\\&" : "", absl::StrReplaceAll(text, {{"\\", "\\e"}, {"-", "\\-"}}));
}

void AppendFlags(const std::vector<FlagSpec>& flags, std::string& page) {
  for (const FlagSpec& flag : flags) {
    absl::StrAppend(&page, ".TP\n");
    if (flag.letter != 0) absl::StrAppend(&page, "\\fB\\-", std::string(1, flag.letter), "\\fR, ");
    absl::StrAppend(&page, "\\fB\\-\\-", Troff(flag.name), "\\fR");
    if (!flag.value.empty()) absl::StrAppend(&page, " \\fI", Troff(flag.value), "\\fR");
    absl::StrAppend(&page, "\n", Troff(flag.help));
    if (!flag.default_value.empty()) absl::StrAppend(&page, " (default: ", Troff(flag.default_value), ")");
    absl::StrAppend(&page, "\n");
  }
}

void AppendEnvironment(const Manual& manual, std::string& page) {
  std::set<std::string> names;
  for (const ManualCommand& command : CommandsOf(manual)) {
    for (const FlagSpec& flag : command.flags) {
      if (flag.setting) names.insert(VariableOf(flag.name));
    }
  }
  absl::StrAppend(&page, ".SH ENVIRONMENT\nEach of these stands for the flag of its name, where that is not given:\n",
                  Troff(absl::StrJoin(names, ", ")),
                  ".\n.PP\nTILEMEND_CONFIG names a file with lines \\fINAME = VALUE\\fR ",
                  "for the same flags, which the environment goes before.\n");
  if (!manual.settings_file.empty()) {
    absl::StrAppend(&page, "Without it that is ", Troff(manual.settings_file), ".\n");
  }
}

std::string BashReply(const std::string& shown) {
  const Values values = ValuesOf(shown);
  std::string reply;
  if (!values.words.empty()) {
    absl::StrAppend(&reply, "COMPREPLY+=($(compgen -W '", absl::StrJoin(values.words, " "), "' -- \"$cur\")); ");
  }
  if (values.files || values.folders) {
    absl::StrAppend(&reply,
                    "compopt -o filenames 2>/dev/null; mapfile -t -O \"${#COMPREPLY[@]}\" COMPREPLY < <(compgen ",
                    values.files ? "-f" : "-d", " -- \"$cur\"); ");
  }
  return reply;
}

std::string BashFlags(const std::vector<FlagSpec>& flags) {
  std::vector<std::string> words;
  for (const FlagSpec& flag : flags) {
    if (flag.letter != 0) words.push_back(absl::StrCat("-", std::string(1, flag.letter)));
    words.push_back(absl::StrCat("--", flag.name));
  }
  return absl::StrJoin(words, " ");
}

// The branches for one command: values of its flags, then flags, then its argument.
std::string BashBranches(const ManualCommand& command) {
  std::string text;
  for (const FlagSpec& flag : command.flags) {
    if (flag.value.empty()) continue;
    const std::string names =
        flag.letter == 0 ? "" : absl::StrCat("|", command.name, ":-", std::string(1, flag.letter));
    absl::StrAppend(&text, "    ", command.name, ":--", flag.name, names, ") ", BashReply(flag.value), "return ;;\n");
  }
  absl::StrAppend(&text, "    ", command.name, ":*)\n      if [[ $cur == -* ]]; then COMPREPLY=($(compgen -W '",
                  BashFlags(command.flags), "' -- \"$cur\")); return; fi\n      ", BashReply(command.arguments),
                  "return ;;\n");
  return text;
}

std::string ZshText(const std::string& text) {
  return absl::StrReplaceAll(text, {{"'", "'\\''"}, {"[", "\\["}, {"]", "\\]"}, {":", "\\:"}});
}

std::string ZshAction(const std::string& shown) {
  const Values values = ValuesOf(shown);
  const std::string words = absl::StrJoin(values.words, " ");
  if (values.files && !values.words.empty()) return absl::StrCat("{compadd ", words, "; _files}");
  if (!values.words.empty()) return absl::StrCat("(", words, ")");
  if (values.files) return "_files";
  return values.folders ? "_files -/" : " ";
}

std::string ZshArguments(const ManualCommand& command) {
  std::string text = "_arguments -s";
  for (const FlagSpec& flag : command.flags) {
    std::string rest = absl::StrCat("[", ZshText(flag.help), "]");
    if (!flag.value.empty()) absl::StrAppend(&rest, ":", ZshText(flag.value), ":", ZshAction(flag.value));
    absl::StrAppend(&text, " \\\n      '--", flag.name, flag.value.empty() ? "" : "=", rest, "'");
    if (flag.letter != 0) absl::StrAppend(&text, " \\\n      '-", std::string(1, flag.letter), rest, "'");
  }
  const std::string argument = command.arguments.substr(0, command.arguments.find(' '));
  if (!argument.empty()) absl::StrAppend(&text, " \\\n      '1:", ZshText(argument), ":", ZshAction(argument), "'");
  return text;
}

}  // namespace

std::string ManPage(const Manual& manual) {
  std::string page =
      absl::StrCat(".TH ", absl::AsciiStrToUpper(manual.program), " 1 \"\" \"tilemend ", Version(),
                   "\" \"User Commands\"\n.SH NAME\n", Troff(manual.program), " \\- ", Troff(manual.summary),
                   "\n.SH SYNOPSIS\n\\fB", Troff(manual.program), "\\fR ", Troff(manual.usage), "\n");
  if (!manual.commands.empty()) absl::StrAppend(&page, ".SH COMMANDS\n");
  for (const ManualCommand& command : manual.commands) {
    absl::StrAppend(&page, ".SS ", Troff(absl::StrCat(command.name, " ", command.arguments)), "\n",
                    Troff(command.summary), ".\n");
    AppendFlags(command.flags, page);
    if (!command.examples.empty()) absl::StrAppend(&page, ".PP\nExamples:\n");
    for (const std::string& example : command.examples) {
      absl::StrAppend(&page, ".PP\n", Troff(absl::StrCat(manual.program, " ", example)), "\n");
    }
  }
  absl::StrAppend(&page, ".SH OPTIONS\n");
  AppendFlags(manual.flags, page);
  AppendEnvironment(manual, page);
  absl::StrAppend(&page, ".SH EXIT STATUS\n0 done, 2 usage, 3 not found, 4 invalid input, 5 try again, 6 failed, ",
                  "7 cancelled, 100 done but some holes or cells are left.\n.SH SEE ALSO\n");
  std::vector<std::string> others;
  for (const char* name : {"tilemend", "tilemend-coordinator", "tilemend-worker"}) {
    if (manual.program != name) others.push_back(absl::StrCat("\\fB", Troff(name), "\\fR(1)"));
  }
  absl::StrAppend(&page, absl::StrJoin(others, ", "), "\n.PP\n/usr/share/doc/tilemend/docs has the user guide.\n");
  return page;
}

std::string BashCompletion(const Manual& manual) {
  const std::string function = FunctionOf(manual);
  std::string text = absl::StrCat(
      "# Completion of ", manual.program, " for bash.\n", function, "() {\n",
      "  local cur=${COMP_WORDS[COMP_CWORD]} prev=${COMP_WORDS[COMP_CWORD-1]} command= i\n", "  COMPREPLY=()\n",
      "  if [[ $cur == = ]]; then cur=; elif [[ $prev == = ]]; then prev=${COMP_WORDS[COMP_CWORD-2]}; fi\n");
  std::vector<std::string> names = {"help"};
  for (const ManualCommand& command : manual.commands) names.push_back(command.name);
  if (!manual.commands.empty()) {
    absl::StrAppend(&text, "  if ((COMP_CWORD > 1)); then command=${COMP_WORDS[1]}; fi\n",
                    "  if ((COMP_CWORD == 1)) || [[ $command == help ]]; then\n    COMPREPLY=($(compgen -W '",
                    absl::StrJoin(names, " "), " ", BashFlags(manual.flags), "' -- \"$cur\"))\n    return\n  fi\n");
  }
  absl::StrAppend(&text, "  case $command:$prev in\n");
  for (const ManualCommand& command : CommandsOf(manual)) absl::StrAppend(&text, BashBranches(command));
  return absl::StrCat(text, "  esac\n}\ncomplete -F ", function, " ", manual.program, "\n");
}

std::string ZshCompletion(const Manual& manual) {
  std::string text = absl::StrCat("#compdef ", manual.program, "\n# Completion of ", manual.program, " for zsh.\n");
  if (manual.commands.empty()) return absl::StrCat(text, ZshArguments({"", "", "", manual.flags}), "\n");
  absl::StrAppend(&text, "local curcontext=$curcontext state line\nlocal -a commands\ncommands=(\n");
  for (const ManualCommand& command : manual.commands) {
    absl::StrAppend(&text, "  '", command.name, ":", ZshText(command.summary), "'\n");
  }
  absl::StrAppend(&text, "  'help:show the flags of a command'\n)\n",
                  "_arguments -C '1:command:->command' '*::argument:->argument'\ncase $state in\n",
                  "  command) _describe command commands ;;\n  argument)\n    case $words[1] in\n",
                  "    help) _describe command commands ;;\n");
  for (const ManualCommand& command : manual.commands) {
    absl::StrAppend(&text, "    ", command.name, ") ", ZshArguments(command), " ;;\n");
  }
  return absl::StrCat(text, "    esac ;;\nesac\n");
}

FlagSpec DescribeFlag() {
  return {"describe", "man|bash|zsh|markdown", "print a manual page, completion for a shell or the reference, and end",
          ""};
}

absl::StatusOr<std::string> Describe(const Manual& manual, const std::string& form) {
  if (form == "man") return ManPage(manual);
  if (form == "bash") return BashCompletion(manual);
  if (form == "zsh") return ZshCompletion(manual);
  if (form == "markdown") return MarkdownReference(manual);
  return absl::InvalidArgumentError(absl::StrCat("--describe '", form, "': expected man, bash, zsh or markdown"));
}

}  // namespace tilemend
