#include "coordinator/jobs/job_proto.h"

#include "absl/strings/str_cat.h"
#include "absl/strings/strip.h"
#include "common/options/job_options.h"
#include "common/rpc/status_proto.h"

namespace tilemend {
namespace {

v1::JobState StateToProto(JobState state) {
  switch (state) {
    case JobState::kRunning:
      return v1::RUNNING;
    case JobState::kDone:
      return v1::DONE;
    case JobState::kPartial:
      return v1::PARTIAL;
    case JobState::kFailed:
      return v1::FAILED;
    case JobState::kCancelled:
      return v1::CANCELLED;
  }
  return v1::JOB_STATE_UNSPECIFIED;
}

void SetProgress(const Job& job, v1::Progress& proto) {
  proto.set_phase(job.progress.phase);
  proto.set_cells(job.progress.cells);
  proto.set_cells_done(job.progress.cells_done);
  proto.set_holes(job.progress.holes);
  proto.set_holes_filled(job.progress.holes_filled);
  proto.set_triangles(job.progress.triangles);
  proto.set_tasks(job.counts.added);
  proto.set_tasks_done(job.counts.settled());
  proto.set_tasks_running(job.counts.leased);
  proto.set_tasks_retried(job.counts.given_again());
  proto.set_tasks_quarantined(job.counts.quarantined);
  proto.set_tasks_taken_over(job.progress.taken_over);
}

absl::Time TimeOf(const google::protobuf::Timestamp& proto) {
  return absl::FromUnixSeconds(proto.seconds()) + absl::Nanoseconds(proto.nanos());
}

JobState StateFromProto(v1::JobState state) {
  switch (state) {
    case v1::DONE:
      return JobState::kDone;
    case v1::PARTIAL:
      return JobState::kPartial;
    case v1::FAILED:
      return JobState::kFailed;
    case v1::CANCELLED:
      return JobState::kCancelled;
    default:
      return JobState::kRunning;
  }
}

}  // namespace

void SetTime(absl::Time time, google::protobuf::Timestamp& proto) {
  const int64_t seconds = absl::ToUnixSeconds(time);
  proto.set_seconds(seconds);
  proto.set_nanos(static_cast<int32_t>(absl::ToInt64Nanoseconds(time - absl::FromUnixSeconds(seconds))));
}

void SetEnd(JobState state, absl::Time time, v1::Job& proto) {
  proto.set_state(StateToProto(state));
  if (IsOver(state)) SetTime(time, *proto.mutable_end_time());
}

v1::Job JobToProto(const Job& job, const JobSpec& spec, const JobOutcome& outcome, const absl::Status& error,
                   const JobOrigin& origin) {
  v1::Job proto;
  proto.set_owner(origin.owner);
  proto.set_trace(origin.trace);
  proto.set_name(absl::StrCat("jobs/", job.id));
  SetEnd(job.state, job.ended, proto);
  *proto.mutable_spec() = spec;
  SetProgress(job, *proto.mutable_progress());
  SetTime(job.created, *proto.mutable_create_time());
  if (job.started != absl::InfiniteFuture()) SetTime(job.started, *proto.mutable_start_time());
  if (!error.ok()) *proto.mutable_error() = StatusToProto(error);
  proto.set_message(outcome.message);
  proto.set_report(outcome.report);
  proto.set_cursor(job.version);
  proto.set_priority(job.priority);
  proto.set_paused(job.paused);
  proto.mutable_warnings()->Add(job.warnings.begin(), job.warnings.end());
  proto.mutable_warnings()->Add(outcome.warnings.begin(), outcome.warnings.end());
  return proto;
}

ToldJob JobFromProto(const v1::Job& proto) {
  ToldJob told;
  told.spec = WithDefaults(proto.spec());
  told.outcome.message = proto.message();
  told.outcome.report = proto.report();
  told.origin = {proto.owner(), proto.trace()};
  if (proto.has_error()) told.error = StatusFromProto(proto.error());
  Job& job = told.job;
  job.id = std::string(absl::StripPrefix(proto.name(), "jobs/"));
  job.state = StateFromProto(proto.state());
  job.created = TimeOf(proto.create_time());
  job.priority = proto.priority();
  job.paused = proto.paused();
  if (proto.has_start_time()) job.started = TimeOf(proto.start_time());
  job.warnings.assign(proto.warnings().begin(), proto.warnings().end());
  if (!IsOver(job.state)) return told;
  job.ended = TimeOf(proto.end_time());
  const v1::Progress& p = proto.progress();
  job.progress = {p.phase(),        p.cells(),     p.cells_done(),      p.holes(),
                  p.holes_filled(), p.triangles(), p.tasks_taken_over()};
  job.counts.added = p.tasks();
  job.counts.quarantined = p.tasks_quarantined();
  job.counts.committed = p.tasks_done() - p.tasks_quarantined();
  job.counts.retried = p.tasks_retried();
  return told;
}

}  // namespace tilemend
