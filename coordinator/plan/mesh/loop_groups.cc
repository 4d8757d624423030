#include "coordinator/plan/mesh/loop_groups.h"

#include <algorithm>
#include <optional>
#include <set>

#include "coordinator/plan/hole/closed_loops.h"
#include "coordinator/plan/hole/hole_types.h"

namespace tilemend {
namespace {

// Loops whose middles are further apart than so many times both radii neither face each other nor lie in one another:
// twice as far as FaceEachOther allows.
constexpr double kReach = 4;

class Grouper {
 public:
  Grouper(const Rim& rim, std::span<const MeshLoop> loops, const std::vector<bool>& is_outline,
          const DislocationLimit& dislocation)
      : rim_(rim), loops_(loops), is_outline_(is_outline), dislocation_(dislocation), partner_(loops.size()) {
    for (const RimPoint& p : rim.points) position_.push_back(p.position);
    for (const MeshLoop& loop : loops) {
      double radius = 0;
      for (const RimSegment& s : loop.segments) {
        radius = std::max(radius, (position_[s.from] - loop.middle).norm());
      }
      radius_.push_back(radius);
    }
  }

  LoopGroups Run() {
    FindPairs();
    for (size_t l = 0; l < loops_.size(); ++l) {
      if (!is_outline_[l] && !partner_[l]) holes_.push_back(l);
    }
    LoopGroups groups;
    std::vector<size_t> hole_of(loops_.size(), loops_.size());
    for (size_t l = 0; l < loops_.size(); ++l) {
      if (partner_[l] ? *partner_[l] < l : is_outline_[l]) continue;
      hole_of[l] = groups.holes.size();
      groups.holes.push_back({l, {}});
      if (partner_[l]) groups.holes.back().others.push_back(*partner_[l]);
    }
    for (size_t l = 0; l < loops_.size(); ++l) {
      if (!is_outline_[l] || partner_[l]) continue;
      const std::optional<size_t> around = HoleAround(l);
      if (around) {
        groups.holes[hole_of[*around]].others.push_back(l);
      } else {
        groups.outlines.push_back(l);
      }
    }
    for (MeshHole& hole : groups.holes) hole.single = KindOf(hole);
    return groups;
  }

 private:
  LoopLine LineOf(size_t l) const {
    LoopLine line;
    for (const RimSegment& s : loops_[l].segments) {
      line.corners.push_back(position_[s.from]);
      const Eigen::Vector3d& normal = rim_.points[s.from].normal;
      line.normals.push_back(normal.norm() > 0 ? Eigen::Vector3d(normal.normalized()) : normal);
    }
    return line;
  }

  // Loops that face each other, each the other's nearest.
  void FindPairs() {
    std::vector<size_t> by_x(loops_.size());
    for (size_t l = 0; l < by_x.size(); ++l) by_x[l] = l;
    const auto west = [&](size_t l) { return loops_[l].middle.x() - kReach * radius_[l]; };
    const auto east = [&](size_t l) { return loops_[l].middle.x() + kReach * radius_[l]; };
    std::sort(by_x.begin(), by_x.end(), [&](size_t a, size_t b) { return west(a) < west(b); });
    std::vector<std::optional<size_t>> nearest(loops_.size());
    const auto distance = [&](size_t a, size_t b) { return (loops_[a].middle - loops_[b].middle).norm(); };
    for (size_t i = 0; i < by_x.size(); ++i) {
      for (size_t k = i + 1; k < by_x.size() && west(by_x[k]) <= east(by_x[i]); ++k) {
        const size_t a = by_x[i], b = by_x[k];
        if (!MightFace(a, b) || !Face(a, b)) continue;
        for (const auto& [one, other] : {std::pair(a, b), std::pair(b, a)}) {
          if (!nearest[one] || distance(one, other) < distance(one, *nearest[one])) nearest[one] = other;
        }
      }
    }
    for (size_t l = 0; l < loops_.size(); ++l) {
      if (nearest[l] && nearest[*nearest[l]] == l) partner_[l] = nearest[l];
    }
  }

  bool Face(size_t a, size_t b) const {
    return FaceEachOther(LineOf(a), LineOf(b), loops_[a].piece == loops_[b].piece);
  }

  // However the mesh is turned.
  bool AreNear(size_t a, size_t b) const {
    return (loops_[a].middle - loops_[b].middle).norm() <= kReach * (radius_[a] + radius_[b]);
  }

  // What is cheap to see.
  bool MightFace(size_t a, size_t b) const {
    return AreNear(a, b) && loops_[a].vector_area.dot(loops_[b].vector_area) < 0 && loops_[a].group != loops_[b].group;
  }

  // The smallest hole that a piece lies in.
  std::optional<size_t> HoleAround(size_t outline) const {
    const std::set<CellId> area;
    const GridLines lines;
    const HoleSite site{area, lines, rim_, position_};
    std::optional<size_t> best;
    for (const size_t l : holes_) {
      if (loops_[l].piece == loops_[outline].piece) continue;
      if (best && loops_[l].vector_area.norm() >= loops_[*best].vector_area.norm()) continue;
      if (AreNear(l, outline) && LiesIn(site, AsClosed(outline), AsClosed(l))) best = l;
    }
    return best;
  }

  ClosedLoop AsClosed(size_t l) const {
    return {loops_[l].segments, loops_[l].vector_area, loops_[l].normal.normalized()};
  }

  SingleType KindOf(const MeshHole& hole) const {
    const LoopLine line = LineOf(hole.loop);
    if (hole.others.empty()) {
      if (IsCrack(line)) return SingleType::kCrack;
      return IsDislocation(line, dislocation_) ? SingleType::kDislocation : SingleType::kSimple;
    }
    if (partner_[hole.loop]) return SingleType::kAnnular;
    std::vector<std::vector<RimSegment>> islands;
    for (const size_t l : hole.others) islands.push_back(loops_[l].segments);
    return ClassifySingle(loops_[hole.loop].segments, islands, position_);
  }

  const Rim& rim_;
  std::span<const MeshLoop> loops_;
  const std::vector<bool>& is_outline_;
  const DislocationLimit& dislocation_;
  std::vector<Point3> position_;                // of rim points
  std::vector<double> radius_;                  // of each loop, about its middle
  std::vector<std::optional<size_t>> partner_;  // the loop that each one faces
  std::vector<size_t> holes_;                   // loops that are neither outlines nor have a partner
};

}  // namespace

LoopGroups GroupLoops(const Rim& rim, std::span<const MeshLoop> loops, const std::vector<bool>& is_outline,
                      const DislocationLimit& dislocation) {
  return Grouper(rim, loops, is_outline, dislocation).Run();
}

}  // namespace tilemend
