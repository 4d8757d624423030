#include "common/util/failpoint.h"

#include <atomic>
#include <csignal>
#include <cstdint>
#include <vector>

#include "absl/strings/numbers.h"
#include "absl/strings/str_cat.h"
#include "absl/strings/str_split.h"

namespace tilemend {
namespace {

struct Armed {
  std::string name;
  int64_t at = 0;  // the first time is 1
  bool fails = false;
  bool stops = false;
  std::atomic<int64_t> passed{0};
};

Armed& TheArmed() {
  static Armed armed;
  return armed;
}

std::atomic<bool> is_armed{false};

}  // namespace

bool FailPoint(std::string_view name) {
  if (!is_armed.load(std::memory_order_relaxed)) return false;
  Armed& armed = TheArmed();
  if (name != armed.name) return false;
  const int64_t times = armed.passed.fetch_add(1) + 1;
  if (armed.fails) return times >= armed.at;
  if (times == armed.at) ::raise(armed.stops ? SIGSTOP : SIGKILL);
  return false;
}

absl::Status ArmFailPoint(const std::string& spec) {
  is_armed.store(false);
  if (spec.empty()) return absl::OkStatus();
  const std::vector<std::string> parts = absl::StrSplit(spec, ':');
  Armed& armed = TheArmed();
  const bool fails = parts.size() == 3 && parts[2] == "error", stops = parts.size() == 3 && parts[2] == "stop";
  if (parts.size() < 2 || (parts.size() > 2 && !fails && !stops) || parts[0].empty() ||
      !absl::SimpleAtoi(parts[1], &armed.at) || armed.at < 1) {
    return absl::InvalidArgumentError(
        absl::StrCat("TILEMEND_FAILPOINT=", spec, ": expected NAME:N, NAME:N:error or NAME:N:stop"));
  }
  armed.name = parts[0];
  armed.fails = fails;
  armed.stops = stops;
  armed.passed.store(0);
  is_armed.store(true);
  return absl::OkStatus();
}

}  // namespace tilemend
