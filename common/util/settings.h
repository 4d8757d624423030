// Flags that are set where no command line is: in the environment and in a file.
//
//   TILEMEND_TLS_CA=/etc/tilemend/ca.pem      stands for --tls-ca, if that is not given
//   tls-ca = /etc/tilemend/ca.pem             a line of the file that TILEMEND_CONFIG names; below the environment
#ifndef TILEMEND_COMMON_UTIL_SETTINGS_H_
#define TILEMEND_COMMON_UTIL_SETTINGS_H_

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "common/util/flags.h"

namespace tilemend {

using Settings = std::map<std::string, std::string>;  // by the flag's name

// The value of an environment variable, null if there is none: std::getenv.
using Environment = std::function<const char*(const char*)>;

// What stands in the environment and in the file for the flags whose `setting` is true; of a switch "true" alone.
// Without TILEMEND_CONFIG the file is `usual_file`, which need not be there. A line of the file for another flag of
// tilemend is passed over, since several programs and commands share it. Returns kInvalidArgument, with the line, if it
// is none at all, or if its name is nearly that of one of these flags. The same for a switch that is neither true nor
// false.
absl::StatusOr<Settings> ReadSettings(const std::vector<FlagSpec>& specs, const std::string& usual_file,
                                      const Environment& environment);

// "TILEMEND_TLS_CA" for "tls-ca".
std::string VariableOf(const std::string& flag);

// $XDG_CONFIG_HOME/tilemend.conf or ~/.config/tilemend.conf; "" without a home.
std::string UsualFile(const Environment& environment);

// All flags but --help, --version and --describe, for a program without commands.
std::vector<FlagSpec> AllAsSettings(std::vector<FlagSpec> specs);

}  // namespace tilemend

#endif  // TILEMEND_COMMON_UTIL_SETTINGS_H_
