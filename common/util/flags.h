// Command-line flags from a table; CLI11 parses the words.
//
//   --name VALUE   --name=VALUE   --name (a switch)   -x VALUE   --  (everything after it is an argument)
#ifndef TILEMEND_COMMON_UTIL_FLAGS_H_
#define TILEMEND_COMMON_UTIL_FLAGS_H_

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"

namespace tilemend {

// Where help shows a flag.
enum class FlagGroup {
  kEveryday,
  kAdvanced,
  kPapers,  // of published methods: with --help-all alone
};

struct FlagSpec {
  std::string name;           // without dashes
  std::string value;          // what stands for the value in the help, "DIR"; "" for a switch
  std::string help;           // one line
  std::string default_value;  // "" if there is none
  char letter = 0;            // short form, 0 if there is none
  bool setting = false;       // may be set outside the command line (settings.h)
  FlagGroup group = FlagGroup::kEveryday;
};

// A flag with two values: where services are started by scripts the last one counts; a person may mean both.
enum class TwoValues { kLastCounts, kAreAnError };

// What was given. Asking for a flag that is not in the table is a programmer's mistake and gives "".
class Flags {
 public:
  // Returns kInvalidArgument for an unknown flag (with the nearest name), a missing value, a value for a switch. The
  // `settings` are values by name, for what `words` do not give. The same error for two values of a flag, if they are
  // one.
  static absl::StatusOr<Flags> Parse(const std::vector<FlagSpec>& specs, const std::vector<std::string>& words,
                                     const std::map<std::string, std::string>& settings = {},
                                     TwoValues two_values = TwoValues::kLastCounts);

  const std::vector<std::string>& arguments() const { return arguments_; }
  bool IsGiven(const std::string& name) const { return given_.contains(name); }
  bool Switch(const std::string& name) const { return given_.contains(name); }
  std::string Text(const std::string& name) const;  // or its default
  // kInvalidArgument unless it is a number in [low, high].
  absl::StatusOr<int64_t> Integer(const std::string& name, int64_t low, int64_t high) const;
  absl::StatusOr<double> Number(const std::string& name, double low, double high) const;

 private:
  std::map<std::string, std::string> given_;
  std::map<std::string, std::string> defaults_;
  std::vector<std::string> arguments_;
};

// "; did you mean X?" for the name nearest to `word`, "" if none is near.
std::string DidYouMean(const std::string& word, const std::vector<std::string>& names);

// One line for each flag. With `columns`, those of a terminal, lines that are longer go on below where their text
// begins. Groups follow each other, each but the first under its title. Without `all` a line says how many flags of
// published methods are not shown.
std::string FlagsHelp(const std::vector<FlagSpec>& specs, size_t columns = 0, bool all = true);

}  // namespace tilemend

#endif  // TILEMEND_COMMON_UTIL_FLAGS_H_
