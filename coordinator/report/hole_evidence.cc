#include "coordinator/report/hole_evidence.h"

#include "coordinator/report/rounded.h"

namespace tilemend {
namespace {

constexpr int kDigits = 4;  // tenths of millimetres

}  // namespace

const char* VerdictName(HoleEvidence::Verdict verdict) {
  switch (verdict) {
    case HoleEvidence::Verdict::kLake:
      return "lake";
    case HoleEvidence::Verdict::kRiver:
      return "river";
    case HoleEvidence::Verdict::kLevelGround:
      return "level ground";
    case HoleEvidence::Verdict::kNoWater:
      return "ground";
  }
  return "";
}

nlohmann::ordered_json HoleEvidenceJson(const HoleEvidence& evidence) {
  nlohmann::ordered_json json = {{"taken_for", VerdictName(evidence.verdict)}};
  if (evidence.has_level) {
    json["level_m"] = Rounded(evidence.level, kDigits);
    if (evidence.sigma) json["sigma_m"] = Rounded(*evidence.sigma, kDigits);
  }
  json["reason"] = evidence.reason;
  return json;
}

}  // namespace tilemend
