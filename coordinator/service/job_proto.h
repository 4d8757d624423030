// Plain records of jobs <-> messages of the client API.
#ifndef TILEMEND_COORDINATOR_SERVICE_JOB_PROTO_H_
#define TILEMEND_COORDINATOR_SERVICE_JOB_PROTO_H_

#include "absl/status/status.h"
#include "coordinator/service/job_pipeline.h"
#include "coordinator/state/job.h"
#include "tilemend/v1/jobs.pb.h"

namespace tilemend {

// Fields that are not set get JobSpec's defaults. Not checked.
JobSpec SpecFromProto(const v1::JobSpec& proto);
v1::JobSpec SpecToProto(const JobSpec& spec);

v1::Job JobToProto(const Job& job, const JobSpec& spec, const JobOutcome& outcome, const absl::Status& error);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_SERVICE_JOB_PROTO_H_
