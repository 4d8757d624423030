// Plain records of jobs <-> messages of the client API.
#ifndef TILEMEND_COORDINATOR_JOBS_JOB_PROTO_H_
#define TILEMEND_COORDINATOR_JOBS_JOB_PROTO_H_

#include "absl/status/status.h"
#include "coordinator/jobs/job_pipeline.h"
#include "coordinator/state/job.h"
#include "tilemend/v1/jobs.pb.h"

namespace tilemend {

v1::Job JobToProto(const Job& job, const JobSpec& spec, const JobOutcome& outcome, const absl::Status& error,
                   const JobOrigin& origin = {});

void SetTime(absl::Time time, google::protobuf::Timestamp& proto);

// Makes the message tell that the job is over.
void SetEnd(JobState state, absl::Time time, v1::Job& proto);

// What a message tells of a job, for a coordinator that starts again.
struct ToldJob {
  Job job;  // without request_id, number and version; progress and counts only if it is over
  JobSpec spec;
  JobOutcome outcome;
  JobOrigin origin;
  absl::Status error;
};
ToldJob JobFromProto(const v1::Job& proto);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_JOBS_JOB_PROTO_H_
