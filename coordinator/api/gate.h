// Where every RPC of the coordinator comes in: who calls is found out, counted, and put down where it matters.
#ifndef TILEMEND_COORDINATOR_API_GATE_H_
#define TILEMEND_COORDINATOR_API_GATE_H_

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <mutex>
#include <string>
#include <string_view>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "common/metrics/metrics.h"
#include "common/util/log.h"
#include "coordinator/api/access.h"

namespace tilemend {

inline constexpr int kRefusalsAtOnce = 100;  // as many as a person looks through
inline constexpr int kRefusalsASecond = 1;   // 30 MB a day at most

// Thread-safe.
class Gate {
 public:
  // `audit` gets a line for each call that changes something, and for each that was refused, up to a limit. All outlive
  // the gate.
  Gate(Access access, MetricsRegistry& metrics, Log& audit);

  // Admits a call or refuses it.
  absl::StatusOr<Caller> Admit(std::string_view rpc, const Claims& claims, const std::string& address);
  // A call came to its end.
  void Ended(std::string_view rpc, const absl::Status& status, absl::Duration took);
  // A call that changes something did, or could not. `what` says what it was to change, and how.
  void Audit(std::string_view rpc, const Caller& caller, const std::string& address, const LogFields& what,
             const absl::Status& status);

 private:
  // The refused calls that are written down: kRefusalsAtOnce, and kRefusalsASecond more each second. Who tries tokens
  // or certificates must not fill a disk. All are counted by the metrics.
  bool MayWriteRefusal(absl::Time now);

  struct PerRpc {
    std::array<Counter*, 17> ended;  // by code
    Histogram* seconds;
  };
  Access access_;
  Log& audit_;
  std::map<std::string, PerRpc, std::less<>> rpcs_;
  std::mutex mutex_;  // guards all below
  absl::Time last_refusal_ = absl::InfinitePast();
  double refusals_left_ = 0;  // that may be written at last_refusal_
  int64_t not_written_ = 0;
};

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_API_GATE_H_
