#include "common/mesh/main_turn.h"

#include <cmath>
#include <cstdint>
#include <map>
#include <numbers>

namespace tilemend {
namespace {

constexpr double kTurnStep = 1e-3;  // radians: three of them are wider than what rounding turns edges by

}  // namespace

std::optional<double> MainTurn(const std::vector<Point2>& ways, double least_share) {
  struct Sum {
    double length = 0, weight = 0, turn = 0;
  };
  std::map<int64_t, Sum> at;  // by direction, in steps
  double whole = 0;
  for (const Point2& way : ways) {
    const double turn = std::remainder(std::atan2(way.y(), way.x()), std::numbers::pi / 2);
    Sum& sum = at[std::llround(turn / kTurnStep)];
    sum.length += way.norm();
    sum.weight += way.squaredNorm();
    sum.turn += way.squaredNorm() * turn;
    whole += way.norm();
  }
  Sum most;
  for (const auto& [step, unused] : at) {
    Sum three;
    for (const int64_t k : {step - 1, step, step + 1}) {
      const auto there = at.find(k);
      if (there == at.end()) continue;
      three.length += there->second.length;
      three.weight += there->second.weight;
      three.turn += there->second.turn;
    }
    if (three.length > most.length) most = three;
  }
  if (most.length <= least_share * whole || most.weight <= 0) return std::nullopt;
  return most.turn / most.weight;
}

}  // namespace tilemend
