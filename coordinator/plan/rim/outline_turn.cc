#include "coordinator/plan/rim/outline_turn.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "common/mesh/main_turn.h"

namespace tilemend {
namespace {

// Radians: what is farther off, as the diagonals of a raster, is no convergence of meridians.
constexpr double kMostConvergence = 0.2;
constexpr double kLeastAlong = 0.1;  // of a boundary: it lies along outlines

// Of the boundary's edges seen from above: the direction that most of their length has, to a quarter turn.
std::optional<double> TurnOf(const SurveyRecord& record) {
  std::vector<Point2> ways;
  ways.reserve(record.edges.size());
  for (const BoundaryEdge& e : record.edges) {
    ways.emplace_back((record.vertices[e.to].position - record.vertices[e.from].position).head<2>());
  }
  return MainTurn(ways, kLeastAlong);
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
