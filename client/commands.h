// The commands of `tilemend`.
#ifndef TILEMEND_CLIENT_COMMANDS_H_
#define TILEMEND_CLIENT_COMMANDS_H_

#include <functional>
#include <string>
#include <vector>

#include "common/util/flags.h"

namespace tilemend {

using Args = Flags;

struct Command {
  std::string name;
  std::string arguments;  // for the help: "SCENE --out DIR"
  std::string summary;    // one line
  size_t argument_count = 0;
  std::vector<std::string> required_flags;
  std::vector<FlagSpec> flags;
  std::function<int(const Args&)> run;     // gives the exit code
  size_t optional_arguments = 0;           // that may follow the others
  std::vector<std::string> examples = {};  // what follows "tilemend "
};

// Each prints data on stdout, progress and errors on stderr, and gives an exit code (common/util/exit_codes.h).
int InspectCommand(const Args& args);
int CheckCommand(const Args& args);
int AcceptanceCommand(const Args& args);
int RunCommand(const Args& args);
int FillCommand(const Args& args);
int AggregateCommand(const Args& args);
int SubmitCommand(const Args& args);
int GetCommand(const Args& args);
int ListCommand(const Args& args);
int WorkersCommand(const Args& args);
int WatchCommand(const Args& args);
int CancelCommand(const Args& args);
int PauseCommand(const Args& args);
int ResumeCommand(const Args& args);
int PrioritizeCommand(const Args& args);
int RetryCommand(const Args& args);
int ReportCommand(const Args& args);
int DemoCommand(const Args& args);

FlagSpec OutputFlag();

// All above, for the table of main.
std::vector<Command> ServiceCommands();

// Finds the command that the words after the program's name ask for and runs it. Also answers help, and --help,
// --help-all and --version, of a command as well.
int Dispatch(const std::vector<Command>& commands, const std::vector<std::string>& words);

}  // namespace tilemend

#endif  // TILEMEND_CLIENT_COMMANDS_H_
