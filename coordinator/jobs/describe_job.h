// A job as clients and the journal see it.
#ifndef TILEMEND_COORDINATOR_JOBS_DESCRIBE_JOB_H_
#define TILEMEND_COORDINATOR_JOBS_DESCRIBE_JOB_H_

#include "coordinator/jobs/cluster.h"
#include "tilemend/v1/jobs.pb.h"

namespace tilemend {

// `job` is one of the cluster. Needs the lock. Cost: O(workers).
v1::Job DescribeJob(const Cluster& cluster, const Job& job);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_JOBS_DESCRIBE_JOB_H_
