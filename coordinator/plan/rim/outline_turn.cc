#include "coordinator/plan/rim/outline_turn.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <numbers>
#include <optional>
#include <vector>

namespace tilemend {
namespace {

// Radians: what is farther off, as the diagonals of a raster, is no convergence of meridians.
constexpr double kMostConvergence = 0.2;
constexpr double kTurnStep = 1e-3;   // radians: three of them are wider than what rounding turns edges by
constexpr double kLeastAlong = 0.1;  // of a boundary: it lies along outlines

// Of the boundary's edges seen from above: the direction that most of their length has, to a quarter turn. Long edges
// tell it best.
std::optional<double> TurnOf(const SurveyRecord& record) {
  struct Sum {
    double length = 0, weight = 0, turn = 0;
  };
  std::map<int64_t, Sum> at;  // by direction, in steps
  double whole = 0;
  for (const BoundaryEdge& e : record.edges) {
    const Point2 way = (record.vertices[e.to].position - record.vertices[e.from].position).head<2>();
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
  if (most.length <= kLeastAlong * whole || most.weight <= 0) return std::nullopt;
  return most.turn / most.weight;
}

}  // namespace

double TurnOfTiles(const PlanInput& input) {
  std::vector<double> turns;
  for (const auto& [cell, record] : input.cells) {
    if (record == nullptr) continue;
    if (const std::optional<double> turn = TurnOf(*record.Outline())) turns.push_back(*turn);
  }
  if (turns.empty()) return 0;
  std::ranges::nth_element(turns, turns.begin() + std::ssize(turns) / 2);
  const double turn = turns[turns.size() / 2];
  return std::abs(turn) >= kLeastTurn && std::abs(turn) <= kMostConvergence ? turn : 0;
}

}  // namespace tilemend
