// Names of tasks in messages.
#ifndef TILEMEND_COORDINATOR_API_TASK_REF_H_
#define TILEMEND_COORDINATOR_API_TASK_REF_H_

#include "coordinator/state/job.h"
#include "tilemend/v1/work.pb.h"

namespace tilemend {

inline TaskKey KeyOf(const v1::TaskRef& ref) { return {ref.job(), ref.task()}; }

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_API_TASK_REF_H_
