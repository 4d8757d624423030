#include "coordinator/plan/water/verdict_words.h"

#include <cmath>
#include <cstdint>

#include "coordinator/plan/water/low_ground.h"

namespace tilemend {
namespace {

std::string Rounded(double value) { return std::to_string(std::llround(value)); }

std::string Centimetres(double metres) {
  const int64_t cm = std::llround(100 * std::abs(metres));
  const std::string rest = std::to_string(cm % 100);
  return std::to_string(cm / 100) + "." + (rest.size() < 2 ? "0" : "") + rest + " m";
}

std::string LowGround(double share) {
  if (share == 0) return "no ground near it is as low";
  const std::string limit = share > kMaxLowGround ? "; water has at most " + Rounded(100 * kMaxLowGround) + " %" : "";
  return Rounded(100 * share) + " % of the ground near it is as low" + limit;
}

std::string Agreement(const LevelEvidence& e) {
  if (!e.agrees()) {
    return "its rim is level within the noise of its heights: a dry surface would be " + Centimetres(e.dry_difference) +
           " off the level in the mean, less than three times the noise of " + Centimetres(e.noise);
  }
  return "the far sides of the rim tell the same level within " + Centimetres(e.disagreement);
}

}  // namespace

std::string DecidedBy(const WaterArea& area) {
  if (area.is_as_found) return area.label + " says that it is water, as an earlier run found";
  if (area.decision != ReviewDecision::kNone) return "your " + area.label + (area.water ? ": water" : ": ground");
  return area.label + (area.water ? " says that it is water" : " says that it is no water");
}

std::string ReasonFor(HoleEvidence::Verdict verdict, const Basin& basin, double low_ground,
                      const WaterProfile& profile) {
  const LevelEvidence& e = basin.river ? basin.river->evidence : basin.evidence;
  switch (verdict) {
    case HoleEvidence::Verdict::kLake:
      return Agreement(e) + (e.agrees() ? "" : "; " + LowGround(low_ground));
    case HoleEvidence::Verdict::kRiver:
      return "its rim falls evenly, within " + Centimetres(e.disagreement);
    case HoleEvidence::Verdict::kLevelGround:
      if (basin.area < profile.least_lake)
        return Agreement(e) + "; smaller than " + Rounded(profile.least_lake) +
               " m2, so not called water; a polygon can say that it is";
      return Agreement(e) + "; " + LowGround(low_ground);
    case HoleEvidence::Verdict::kNoWater:
      break;
  }
  if (!basin.evidence.is_enough()) {
    return "too little of its rim tells a level: " + std::to_string(basin.evidence.windows) + " places tell one, " +
           std::to_string(kMinWindows) + " are needed";
  }
  if (!basin.is_level()) {
    return "the far sides of the rim differ by " + Centimetres(e.disagreement) +
           " in their level, and a dry surface by " + Centimetres(e.dry_difference);
  }
  const bool is_lower = low_ground > 0;
  return is_lower ? LowGround(low_ground) : "smaller than " + Rounded(profile.least_level) + " m2";
}

}  // namespace tilemend
