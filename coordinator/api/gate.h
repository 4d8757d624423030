// Where every RPC of the coordinator comes in: who calls is found out, counted, and put down where it matters.
#ifndef TILEMEND_COORDINATOR_API_GATE_H_
#define TILEMEND_COORDINATOR_API_GATE_H_

#include <array>
#include <functional>
#include <map>
#include <string>
#include <string_view>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "common/metrics/metrics.h"
#include "common/util/log.h"
#include "coordinator/api/access.h"

namespace tilemend {

// Thread-safe.
class Gate {
 public:
  // `audit` gets a line for each call that changes something, and for each that was refused. All outlive the gate.
  Gate(Access access, MetricsRegistry& metrics, Log& audit);

  // Admits a call or refuses it.
  absl::StatusOr<Caller> Admit(std::string_view rpc, const Claims& claims, const std::string& address);
  // A call came to its end.
  void Ended(std::string_view rpc, const absl::Status& status, absl::Duration took);
  // A call that changes something did, or could not. `what` says what it was to change, and how.
  void Audit(std::string_view rpc, const Caller& caller, const std::string& address, const LogFields& what,
             const absl::Status& status);

 private:
  struct PerRpc {
    std::array<Counter*, 17> ended;  // by code
    Histogram* seconds;
  };
  Access access_;
  Log& audit_;
  std::map<std::string, PerRpc, std::less<>> rpcs_;
};

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_API_GATE_H_
