// One option: what flags, checks, help, reference, report and messages between programs know of it.
#ifndef TILEMEND_COMMON_OPTIONS_OPTION_H_
#define TILEMEND_COMMON_OPTIONS_OPTION_H_

#include <string>
#include <variant>
#include <vector>

#include "common/util/flags.h"

namespace tilemend {

enum class OptionType {
  kSwitch,
  kNumber,       // in [min, max], or one of `words`
  kWholeNumber,  // likewise
  kWord,         // one of `words`
  kPath,         // of a file or folder, or one of `words`
  kColour,       // as ParseColour takes it
  kCells,        // as ParseCells takes it
};

// What an option is for. Given beside anything else it is refused, as it would have no effect.
enum class OptionNeeds {
  kNothing,
  kGrowth,             // triangles that grow: not beside `uniform`
  kWater,              // not beside `water` = off
  kThinPlate,          // the surface thin-plate
  kWang,               // the surface wang
  kWangOrMinimumArea,  // likewise, or the filler minimum-area
  kFront,              // a filler with an advancing front
  kFrontNormal,        // the filler advancing-front-normal
  kFrontCurvature,     // the filler advancing-front-curvature
  kSvm,                // the filler svm-laplacian
};

// Who has an option. Bits.
inline constexpr unsigned kOfJobs = 1;     // `tilemend run` and `submit`, the API
inline constexpr unsigned kOfFill = 2;     // `tilemend fill`
inline constexpr unsigned kOfInspect = 4;  // `tilemend inspect`

struct Option {
  const char* field;  // of v1::JobSpec; the flag has its name, with - for _
  OptionType type = OptionType::kSwitch;
  std::vector<std::string> words = {};  // that may be given
  const char* value_name = "";          // of any other value: "X", "FILE"
  double min = 0, max = 0;
  std::string default_value = {};  // as on the command line; "" if there is none to show
  const char* unit = "";           // of a number; "" if it has none
  std::string help = {};           // what it does: no range, no default
  FlagGroup group = FlagGroup::kAdvanced;
  OptionNeeds needs = OptionNeeds::kNothing;
  unsigned commands = kOfJobs;
  bool to_workers = false;  // tasks depend on it
  bool in_report = true;    // the output depends on it
};

// An option that the result depends on, by the name of its flag.
struct ReportedOption {
  std::string name;
  std::variant<bool, double, std::string> value;
};

// "size-limit" of "size_limit".
std::string FlagOf(const Option& option);

// What stands for its value in help: "auto|X"; "" for a switch. NAME for a choice of many words.
std::string ValueShown(const Option& option);

// "a number from 1 to 10", "city or usgs": what is allowed, for messages and the reference.
std::string Expected(const Option& option);

// All options, in the order in which they are checked, shown and reported.
const std::vector<Option>& AllOptions();

// Those of some commands (kOfJobs, ...) as flags, in the order of the table.
std::vector<FlagSpec> OptionFlags(unsigned commands);

// One of them. Precondition: there is an option of that name.
FlagSpec OptionFlag(const std::string& flag, unsigned commands);

}  // namespace tilemend

#endif  // TILEMEND_COMMON_OPTIONS_OPTION_H_
