// What a hole was taken for, and why, as the report says it.
#ifndef TILEMEND_COORDINATOR_REPORT_HOLE_EVIDENCE_H_
#define TILEMEND_COORDINATOR_REPORT_HOLE_EVIDENCE_H_

#include <nlohmann/json.hpp>

#include "coordinator/plan/types/plan_types.h"

namespace tilemend {

// "lake", "river", "level ground" or "ground".
const char* VerdictName(HoleEvidence::Verdict verdict);

// A JSON object: `taken_for`, `level_m` and `sigma_m` to a tenth of a millimetre where the rim has a level, `reason`.
nlohmann::ordered_json HoleEvidenceJson(const HoleEvidence& evidence);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_REPORT_HOLE_EVIDENCE_H_
