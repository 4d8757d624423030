#include "coordinator/plan/water/verdict_chance.h"

#include <algorithm>

namespace tilemend {
namespace {

constexpr double kUntested = 0.5;  // a coin: neither side is likelier

double Square(double x) { return x * x; }

}  // namespace

double ChanceOfError(HoleEvidence::Verdict verdict, const LevelEvidence& evidence) {
  if (!evidence.is_enough()) return kUntested;
  const double water = Square(evidence.dry_difference / 2), ground = Square(evidence.disagreement);
  if (water + ground <= 0) return kUntested;
  const bool is_ground = verdict == HoleEvidence::Verdict::kNoWater;
  return std::min(kUntested, (is_ground ? water : ground) / (water + ground));
}

}  // namespace tilemend
