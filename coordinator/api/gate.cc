#include "coordinator/api/gate.h"

#include <algorithm>
#include <utility>

#include "absl/strings/ascii.h"
#include "absl/time/clock.h"
#include "common/util/error_info.h"

namespace tilemend {

Gate::Gate(Access access, MetricsRegistry& metrics, Log& audit) : access_(std::move(access)), audit_(audit) {
  for (const RpcNeed& need : RpcNeeds()) {
    if (need.role == Role::kAnybody) continue;  // gRPC answers these by itself
    const std::string rpc(need.rpc);
    PerRpc& one = rpcs_[rpc];
    for (size_t code = 0; code < one.ended.size(); ++code) {
      const std::string name = absl::StatusCodeToString(static_cast<absl::StatusCode>(code));
      one.ended[code] =
          metrics.AddCounter("tilemend_coordinator_rpcs_total", "Calls that ended so.", {{"rpc", rpc}, {"code", name}});
    }
    one.seconds = metrics.AddHistogram("tilemend_coordinator_rpc_seconds", "Time of a call, with what it waits for.",
                                       {{"rpc", rpc}}, Histogram::ScaledBounds(0.001, 4, 8));
  }
}

absl::StatusOr<Caller> Gate::Admit(std::string_view rpc, const Claims& claims, const std::string& address) {
  auto caller = access_.Admit(rpc, claims, absl::Now());
  if (!caller.ok() && MayWriteRefusal(absl::Now())) {
    audit_.Warn("refused", {{"rpc", rpc},
                            {"certificate", claims.certificate_name},
                            {"address", address},
                            {"reason", ErrorReason(caller.status())},
                            {"message", std::string(caller.status().message())}});
  }
  return caller;
}

bool Gate::MayWriteRefusal(absl::Time now) {
  std::lock_guard<std::mutex> lock(mutex_);
  const double earned = kRefusalsASecond * absl::ToDoubleSeconds(now - last_refusal_);
  refusals_left_ = std::clamp(refusals_left_ + earned, 0.0, double{kRefusalsAtOnce});
  last_refusal_ = now;
  if (refusals_left_ < 1) {
    ++not_written_;
    return false;
  }
  refusals_left_ -= 1;
  if (not_written_ > 0) audit_.Warn("refused calls not listed", {{"calls", not_written_}});
  not_written_ = 0;
  return true;
}

void Gate::Ended(std::string_view rpc, const absl::Status& status, absl::Duration took) {
  const auto found = rpcs_.find(rpc);
  if (found == rpcs_.end()) return;
  found->second.ended.at(static_cast<size_t>(status.raw_code()) % found->second.ended.size())->Increment();
  found->second.seconds->Observe(absl::ToDoubleSeconds(took));
}

void Gate::Audit(std::string_view rpc, const Caller& caller, const std::string& address, const LogFields& what,
                 const absl::Status& status) {
  LogFields fields = {{"rpc", rpc}, {"who", caller.name}, {"address", address}};
  fields.insert(fields.end(), what.begin(), what.end());
  fields.emplace_back("code", absl::StatusCodeToString(status.code()));
  fields.emplace_back("reason", ErrorReason(status));
  audit_.Info("audit", fields);
}

}  // namespace tilemend
