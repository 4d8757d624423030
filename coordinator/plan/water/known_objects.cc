#include "coordinator/plan/water/known_objects.h"

#include <algorithm>

#include "common/mesh/position_index.h"
#include "coordinator/plan/water/ground_points.h"
#include "coordinator/plan/water/hole_groups.h"

namespace tilemend {
namespace {

// What is said of places. Vertices are told by them: where tiles overlap some are crossings of outlines, which each
// plan numbers for itself.
class MarkedPlaces {
 public:
  void Add(const PlanVertex& vertex) {
    if (places_.Insert(vertex.position) == std::ssize(marks_)) marks_.push_back(vertex.on_object);
  }

  std::optional<bool> At(const PlanVertex& vertex) const {
    const int32_t place = vertex.index < 0 ? -1 : places_.Find(vertex.position);
    if (place < 0) return std::nullopt;
    return marks_[place];
  }

 private:
  PositionIndex places_;
  std::vector<bool> marks_;
};

}  // namespace

const KnownShore* KnownObjects::ShoreOf(const std::vector<int32_t>& holes) const {
  if (shores.empty()) return nullptr;
  const auto found = std::ranges::find_if(holes, [&](int32_t h) { return shore_of[h] >= 0; });
  return found == holes.end() ? nullptr : &shores[shore_of[*found]];
}

void KnownObjects::Forget(const Plan& plan, const std::vector<int32_t>& holes) {
  for (const int32_t h : holes) shore_of[h] = -1;
  std::vector<int32_t> others;
  for (int32_t h = 0; h < std::ssize(shore_of); ++h) {
    if (!std::ranges::binary_search(holes, h)) others.push_back(h);
  }
  const std::vector<int32_t> stay = RimVerticesOf(plan, others);
  for (const int32_t v : RimVerticesOf(plan, holes)) {
    if (!std::ranges::binary_search(stay, v)) on_object[v] = std::nullopt;
  }
}

KnownObjects FindKnownObjects(const Plan& whole, const Plan& plan) {
  KnownObjects known;
  MarkedPlaces places;
  std::vector<int32_t> shore_of(whole.holes.size(), -1);
  for (const std::vector<int32_t>& holes : GroupHoles(whole)) {
    for (const int32_t v : RimVerticesOf(whole, holes)) {
      places.Add(whole.vertices[v]);
      known.any = known.any || whole.vertices[v].on_object;
    }
    const PlannedHole& first = whole.holes[holes.front()];
    if (first.water >= 0) continue;
    for (const int32_t h : holes) shore_of[h] = static_cast<int32_t>(known.shores.size());
    known.shores.push_back({first.among_objects, GroundOfShore(whole, holes)});
  }
  for (const PlanVertex& vertex : plan.vertices) known.on_object.push_back(places.At(vertex));
  known.shore_of = GroupsCovering(plan, whole, shore_of);
  return known;
}

}  // namespace tilemend
