#include "coordinator/jobs/job_pipeline.h"

#include "common/util/status_macros.h"

namespace tilemend {

absl::StatusOr<std::string> WholeInput(const NewTask& task) {
  std::string whole = task.input;
  for (const InputPart& part : task.parts) {
    TILEMEND_ASSIGN_OR_RETURN(const std::string bytes, part.read());
    whole += bytes;
  }
  return whole;
}

}  // namespace tilemend
