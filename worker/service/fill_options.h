// Options of a message to those of the geometry that fills holes.
#ifndef TILEMEND_WORKER_SERVICE_FILL_OPTIONS_H_
#define TILEMEND_WORKER_SERVICE_FILL_OPTIONS_H_

#include "tilemend/v1/job_spec.pb.h"
#include "worker/fill/hole/fill_options.h"

namespace tilemend {

// All published methods are at hand. Precondition: the spec is WithDefaults and its values are in range
// (CheckOptionsForWorkers).
FillOptions FillOptionsOf(const v1::JobSpec& spec);

}  // namespace tilemend

#endif  // TILEMEND_WORKER_SERVICE_FILL_OPTIONS_H_
