#include "coordinator/api/coordinator.h"

#include <chrono>
#include <filesystem>
#include <functional>
#include <system_error>
#include <utility>
#include <vector>

#include "absl/strings/str_cat.h"
#include "absl/time/clock.h"
#include "common/rpc/limits.h"
#include "common/util/status_macros.h"
#include "coordinator/journal/journal.h"

namespace tilemend {
namespace {

std::function<absl::Time()> SteadyWallClock() {
  return [wall = absl::Now(), steady = std::chrono::steady_clock::now()] {
    return wall + absl::FromChrono(std::chrono::steady_clock::now() - steady);
  };
}

}  // namespace

absl::StatusOr<std::unique_ptr<Coordinator>> Coordinator::Create(CoordinatorOptions options, PipelineFactory factory,
                                                                 MetricsRegistry& metrics) {
  if (options.lease <= 2 * kMaxPoll) {
    return absl::InvalidArgumentError(absl::StrCat("a lease of ", absl::FormatDuration(options.lease),
                                                   " is too short: workers renew once a second, so more than 2 s"));
  }
  std::error_code error;
  std::filesystem::create_directories(options.work_folder, error);
  if (error) {
    return absl::PermissionDeniedError(
        absl::StrCat(options.work_folder, ": cannot create the work folder: ", error.message()));
  }
  if (!options.clock) options.clock = SteadyWallClock();
  if (options.journal == nullptr) options.journal = NewForgetfulJournal();
  options.state.epoch = options.journal->epoch();
  std::unique_ptr<Coordinator> impl(new Coordinator(std::move(options), std::move(factory), metrics));
  TILEMEND_RETURN_IF_ERROR(impl->restorer_.Restore());
  if (impl->cluster_.options.background_ticks) impl->housekeeping_.StartTicking();
  return impl;
}

Coordinator::Coordinator(CoordinatorOptions options, PipelineFactory factory, MetricsRegistry& metrics)
    : cluster_(std::move(options), metrics),
      journal_(cluster_),
      updates_(cluster_, journal_),
      runs_(cluster_, updates_, journal_, std::move(factory)),
      calls_{JobsHandler(cluster_, updates_, journal_, runs_), WatchHandler(cluster_),
             WorkHandler(cluster_, updates_, journal_), BlobsHandler(cluster_), ClusterHandler(cluster_)},
      restorer_(cluster_, updates_, journal_, runs_),
      housekeeping_(cluster_, updates_, [this](absl::Time now) { calls_.blobs.Tick(now); }) {}

Coordinator::~Coordinator() {
  StopWaiting();
  housekeeping_.StopTicking();
  restorer_.StopSweeping();
  std::vector<std::unique_ptr<JobRunner>> runners;
  {
    const ClusterLock lock(cluster_.mutex);
    for (auto& [id, entry] : cluster_.jobs) {
      if (entry.runner != nullptr) runners.push_back(std::move(entry.runner));
    }
  }
  for (const auto& runner : runners) runner->Abandon();
  runners.clear();  // joins; their sinks take the lock
}

}  // namespace tilemend
