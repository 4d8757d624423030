#include "coordinator/plan/mesh/outlines.h"

#include <map>
#include <utility>

namespace tilemend {
namespace {

// A loop is an outline where openness and this share of how far it runs the wrong way round come to more than
// kOutline. Spheres cut at less than 81 degrees from their pole, cones wider than 35 degrees, reliefs, lids of boxes
// and rough terrain with four times the area of its plan are above it; cut limbs, necks and hoofs, tubes, cups and
// hemispheres are below.
constexpr double kShareOfTurn = 0.45;
constexpr double kOutline = 0.65;
// Loops that touch an outline belong to it if they run round the surface the wrong way by this much.
constexpr double kTurnsAlong = -0.5;

}  // namespace

std::vector<bool> FindOutlines(std::span<const MeshLoop> loops, std::span<const double> piece_areas) {
  std::map<int32_t, Eigen::Vector3d> open;  // by piece: the vector area of all its loops
  for (const MeshLoop& loop : loops) {
    open.try_emplace(loop.piece, Eigen::Vector3d::Zero()).first->second += loop.vector_area;
  }
  std::map<int32_t, size_t> widest;  // by piece: the loop that opens it most
  for (size_t l = 0; l < loops.size(); ++l) {
    const Eigen::Vector3d& way = open.at(loops[l].piece);
    const auto [it, fresh] = widest.try_emplace(loops[l].piece, l);
    if (!fresh && loops[l].vector_area.dot(way) > loops[it->second].vector_area.dot(way)) it->second = l;
  }
  std::map<std::pair<int32_t, int32_t>, std::vector<size_t>> touching;  // by piece and group
  for (size_t l = 0; l < loops.size(); ++l) touching[{loops[l].piece, loops[l].group}].push_back(l);
  std::vector<bool> outline(loops.size(), false);
  for (const auto& [piece, l] : widest) {
    const double area = piece_areas[static_cast<size_t>(piece)];
    const double openness = area > 0 ? open.at(piece).norm() / area : 1;
    outline[l] = openness - kShareOfTurn * loops[l].Turn() > kOutline;
    if (!outline[l]) continue;
    for (const size_t k : touching.at({piece, loops[l].group})) {
      if (!loops[k].IsSlit() && loops[k].Turn() < kTurnsAlong) outline[k] = true;
    }
  }
  return outline;
}

}  // namespace tilemend
