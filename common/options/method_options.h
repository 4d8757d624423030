// Options of published methods: of a message to the structs that their geometry reads.
#ifndef TILEMEND_COMMON_OPTIONS_METHOD_OPTIONS_H_
#define TILEMEND_COMMON_OPTIONS_METHOD_OPTIONS_H_

#include "common/records/filler.h"
#include "common/records/surface.h"
#include "tilemend/v1/job_spec.pb.h"

namespace tilemend {

// Absent fields and unknown names give the defaults of the structs.
WangOptions WangOptionsOf(const v1::JobSpec& spec);
FillerOptions FillerOptionsOf(const v1::JobSpec& spec);

}  // namespace tilemend

#endif  // TILEMEND_COMMON_OPTIONS_METHOD_OPTIONS_H_
