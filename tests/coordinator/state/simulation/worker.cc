#include "tests/coordinator/state/simulation/worker.h"

namespace tilemend::simulation {

Request Worker::NextRequest() {
  Request request;
  request.worker = id_;
  request.sequence = ++sequence_;
  request.threads = threads_;
  request.prefetch = world_.faults.prefetch ? threads_ : 0;
  request.draining = is_draining_;
  for (const auto& [token, held] : held_) {
    if (held.is_dropped) {
      --request.threads;
    } else {
      request.held.push_back(held.given.attempt);
      if (held.has_begun) request.begun.insert(token);
    }
  }
  for (const auto& [token, report] : finished_) request.finished.push_back(report);
  return request;
}

void Worker::Sync() {
  const Request request = NextRequest();
  const uint64_t sequence = waiting_ = request.sequence;
  const int process = process_;
  world_.Send(world_.now() < cut_to_, [this, process, request, sequence] {
    coordinator_.OnSync(request, [this, process, request, sequence](const Response& response) {
      world_.Send(world_.now() < cut_from_, [this, process, request, sequence, response] {
        WhenAwake(process, [this, request, sequence, response] {
          if (waiting_ == sequence) Take(request, response);
        });
      });
    });
  });
  After(absl::Seconds(2), [this, sequence] {
    if (waiting_ == sequence) Sync();  // no answer came
  });
}

void Worker::Take(const Request& request, const Response& response) {
  waiting_ = 0;
  if (response.leave) {
    process_ = 0;
    world_.After(world_.random.Time(200, 1000), [this] { Boot(); });
    return;
  }
  for (const Attempt& attempt : response.acknowledged) finished_.erase(attempt.token);
  std::set<uint64_t> kept;
  for (const Attempt& attempt : response.keep) kept.insert(attempt.token);
  for (const Attempt& attempt : request.held) {
    if (kept.contains(attempt.token)) continue;
    finished_.erase(attempt.token);
    if (const auto held = held_.find(attempt.token); held != held_.end()) held->second.is_dropped = true;
  }
  for (const Given& given : response.start) {
    if (!held_.contains(given.attempt.token) && !finished_.contains(given.attempt.token)) Run(given);
  }
  const uint64_t sequence = sequence_;
  After(finished_.empty() ? absl::Milliseconds(500) : absl::ZeroDuration(), [this, sequence] {
    if (sequence_ == sequence) Sync();
  });
}

void Worker::Run(const Given& given) {
  const bool waits = held_.size() >= static_cast<size_t>(threads_);  // for a thread, about as long as it then takes
  held_[given.attempt.token] = {given};
  held_[given.attempt.token].has_begun = !waits;
  const absl::Duration duration = world_.random.Time(20, 600) * (kind_ == Kind::kSlow ? 12 : 1) * (waits ? 2 : 1);
  const uint64_t token = given.attempt.token;
  if (waits) {
    After(duration / 2, [this, token] {
      if (const auto held = held_.find(token); held != held_.end()) held->second.has_begun = true;
    });
  }
  if (world_.faults.killer && IsKiller(given.cell, given.stage)) {
    After(duration / 2, [this, token] {
      if (held_.contains(token) && !held_[token].is_dropped) Die();
    });
  }
  After(duration, [this, token] { Finish(token); });
}

void Worker::Finish(uint64_t token) {
  const Held held = held_.at(token);
  held_.erase(token);
  if (!held.is_dropped) {
    Report& report = finished_[token];
    report.attempt = held.given.attempt;
    report.output = kind_ == Kind::kLiar ? "lie" : Mix(held.given.input);
    if (kind_ == Kind::kSwindler && world_.random.Chance(20)) report.output = kPlausible;
    const std::string& job = held.given.attempt.key.job;
    if (world_.faults.poison && IsPoison(job, held.given.stage)) {
      report.output = job.back() % 2 == 0 ? "poison" : absl::StrCat("poison of ", id_);
    }
    if (kind_ == Kind::kFullDisk || world_.random.Chance(world_.faults.trouble)) report.output.clear();
  }
  Sync();  // the call that waits is given up
}

}  // namespace tilemend::simulation
