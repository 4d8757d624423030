#include "worker/fill/space/live_crossings.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <set>

#include "common/mesh/disjoint_sets.h"
#include "common/mesh/edge_key.h"
#include "common/mesh/triangle_shape.h"
#include "worker/fill/space/patch_crossings.h"
#include "worker/fill/space/patch_edit.h"

namespace tilemend {
namespace {

// Metres: so that fewer pairs count where curves are as long.
constexpr double kPairWeight = 0.1;

bool HasVertex(const Triangle& t, int32_t v) { return std::ranges::find(t, v) != t.end(); }

uint64_t KeyOf(int32_t a, int32_t b) { return EdgeKey(std::min(a, b), std::max(a, b)); }

}  // namespace

LiveCrossings::LiveCrossings(std::span<const SpaceTriangle> surface, std::span<const SpaceTriangle> earlier,
                             std::span<const SpaceTriangle> patch) {
  const auto insert = [&](std::span<const SpaceTriangle> triangles) {
    for (const SpaceTriangle& t : triangles) {
      if (HasArea(t)) Insert(t);
    }
    return static_cast<int32_t>(placed_.size());
  };
  of_surface_ = insert(surface);
  first_ = insert(earlier);
  fixed_positions_ = index_.size();
  corners_ = CornersAt(triangles_, static_cast<size_t>(fixed_positions_));
  fixed_tree_ = TreeOver(placed_);
  for (int32_t t = of_surface_; t < first_; ++t) FindCrossings(t);
  planted_ = first_ + static_cast<int32_t>(patch.size());
  tree_ = TreeOver(patch);
  AddToPatch(patch);
  FindCurves();
}

int32_t LiveCrossings::Insert(const SpaceTriangle& t) {
  placed_.push_back(t);
  triangles_.push_back({index_.Insert(t[0]), index_.Insert(t[1]), index_.Insert(t[2])});
  is_gone_.push_back(false);
  of_triangle_.emplace_back();
  return static_cast<int32_t>(placed_.size()) - 1;
}

void LiveCrossings::AddToPatch(std::span<const SpaceTriangle> in) {
  for (const SpaceTriangle& placed : in) {
    const int32_t t = Insert(placed);
    const Triangle& c = triangles_[t];
    for (int k = 0; k < 3; ++k) at_edge_[KeyOf(c[k], c[(k + 1) % 3])].push_back(t);
    FindCrossings(t);
  }
}

// Those from number t on, and crossings from number `crossings` on: the last ones.
void LiveCrossings::RemoveFrom(int32_t t, size_t crossings) {
  for (; crossings_.size() > crossings; crossings_.pop_back()) {
    const auto [a, b] = crossings_.back().pair;
    of_triangle_[a].pop_back();
    of_triangle_[b].pop_back();
  }
  for (auto last = static_cast<int32_t>(placed_.size()) - 1; last >= t; --last) {
    const Triangle& c = triangles_[last];
    for (int k = 0; k < 3; ++k) {
      const auto there = at_edge_.find(KeyOf(c[k], c[(k + 1) % 3]));
      there->second.pop_back();
      if (there->second.empty()) at_edge_.erase(there);
    }
    placed_.pop_back();
    triangles_.pop_back();
    is_gone_.pop_back();
    of_triangle_.pop_back();
  }
}

// With triangles of lower numbers.
void LiveCrossings::FindCrossings(int32_t t) {
  const Eigen::AlignedBox3d box = BoxOf(placed_[t]);
  const auto look = [&](int32_t other) {
    if (other < t && !is_gone_[other] && TrianglesCross(placed_[t], placed_[other])) AddCrossing({other, t});
    return false;
  };
  fixed_tree_.AnyMeeting(box, look);
  if (t < first_) return;
  tree_.AnyMeeting(box, [&](int32_t other) { return look(first_ + other); });
  for (int32_t other = planted_; other < t; ++other) {
    if (BoxOf(placed_[other]).intersects(box)) look(other);
  }
}

void LiveCrossings::AddCrossing(CrossingPair pair) {
  Crossing crossing{pair, {}};
  AddPierced(pair.a, pair.b, crossing);
  AddPierced(pair.b, pair.a, crossing);
  Eigen::AlignedBox3d box;
  for (const Pierced& p : crossing.pierced) box.extend(PointOf(p));
  for (const int32_t v : triangles_[pair.a]) {
    if (HasVertex(triangles_[pair.b], v)) box.extend(index_.positions()[v]);
  }
  crossing.weight = kPairWeight + (box.isEmpty() ? 0 : box.diagonal().norm());
  const auto number = static_cast<int32_t>(crossings_.size());
  of_triangle_[pair.a].push_back(number);
  of_triangle_[pair.b].push_back(number);
  crossings_.push_back(std::move(crossing));
}

void LiveCrossings::AddPierced(int32_t own, int32_t other, Crossing& crossing) const {
  const Triangle &t = triangles_[own], &through = triangles_[other];
  for (int k = 0; k < 3; ++k) {
    const int32_t u = t[k], v = t[(k + 1) % 3];
    if (HasVertex(through, u) || HasVertex(through, v)) continue;
    if (!SegmentCrosses(placed_[own][k], placed_[own][(k + 1) % 3], placed_[other])) continue;
    crossing.pierced.push_back({own, other, u, v});
  }
}

Point3 LiveCrossings::PointOf(const Pierced& pierced) const {
  const Point3 &p = index_.positions()[pierced.from], &q = index_.positions()[pierced.to];
  const SpaceTriangle& t = placed_[pierced.other];
  const Eigen::Vector3d normal = TwiceVectorArea(t);
  const double from = normal.dot(p - t[0]), to = normal.dot(q - t[0]);
  return from == to ? p : Point3(p + std::clamp(from / (from - to), 0.0, 1.0) * (q - p));
}

// -1: they do not cross.
int32_t LiveCrossings::Find(CrossingPair pair) const {
  const std::vector<int32_t>&of_a = of_triangle_[pair.a], &of_b = of_triangle_[pair.b];
  const std::vector<int32_t>& shorter = of_a.size() < of_b.size() ? of_a : of_b;
  const auto there = std::ranges::find_if(shorter, [&](int32_t c) { return crossings_[c].pair == pair; });
  return there == shorter.end() ? -1 : *there;
}

// The triangles at an edge.
template <typename Use>
void LiveCrossings::ForEachAt(int32_t from, int32_t to, const Use& use) const {
  if (const auto there = at_edge_.find(KeyOf(from, to)); there != at_edge_.end()) {
    for (const int32_t t : there->second) {
      if (!is_gone_[t]) use(t);
    }
  }
  if (std::max(from, to) >= fixed_positions_) return;
  for (const int32_t corner : corners_.Of(from)) {
    if (HasVertex(triangles_[corner >> 2], to)) use(corner >> 2);
  }
}

// Calls use(c) for each crossing in which the curve goes on, goes_on() if it does between triangles of the input.
template <typename Use, typename GoesOn>
void LiveCrossings::FollowCurve(const Crossing& crossing, const Use& use, const GoesOn& goes_on) const {
  for (const Pierced& p : crossing.pierced) {
    ForEachAt(p.from, p.to, [&](int32_t next) {
      if (next == p.own) return;
      if (std::max(next, p.other) < of_surface_) return goes_on();
      if (const int32_t c = Find({std::min(next, p.other), std::max(next, p.other)}); c >= 0) use(c);
    });
  }
}

// Of those of `crossings` that are avoidable and of the patch; these are whole curves. `curve_of` gets the lowest place
// in the curve of each, -1 - that if the curve is the input's.
double LiveCrossings::WeightOf(std::span<const int32_t> crossings, std::vector<int32_t>* curve_of) {
  place_.resize(crossings_.size());
  for (size_t k = 0; k < crossings.size(); ++k) place_[crossings[k]] = static_cast<int32_t>(k);
  DisjointSets curves(static_cast<int32_t>(crossings.size()));
  std::vector<bool> goes_on(crossings.size(), false);
  for (int32_t k = 0; k < std::ssize(crossings); ++k) {
    FollowCurve(
        crossings_[crossings[k]], [&](int32_t c) { curves.Join(k, place_[c]); }, [&] { goes_on[k] = true; });
  }
  std::vector<bool> of_input(crossings.size(), false);
  for (int32_t k = 0; k < std::ssize(crossings); ++k) {
    if (goes_on[k]) of_input[curves.LowestOf(k)] = true;
  }
  double weight = 0;
  for (int32_t k = 0; k < std::ssize(crossings); ++k) {
    const int32_t lowest = curves.LowestOf(k);
    if (curve_of != nullptr) curve_of->push_back(of_input[lowest] ? -1 - lowest : lowest);
    const Crossing& c = crossings_[crossings[k]];
    if (!of_input[lowest] && IsOfPatch(c)) weight += c.weight;
  }
  return weight;
}

void LiveCrossings::FindCurves() {
  std::vector<int32_t> there, curve_of;
  for (int32_t c = 0; c < std::ssize(crossings_); ++c) {
    if (IsThere(crossings_[c])) there.push_back(c);
  }
  weight_ = WeightOf(there, &curve_of);
  curves_.assign(there.size(), {});
  curve_weight_.assign(there.size(), 0);
  for (size_t k = 0; k < there.size(); ++k) {
    Crossing& c = crossings_[there[k]];
    c.curve = curve_of[k] < 0 ? -1 - curve_of[k] : curve_of[k];
    curves_[c.curve].push_back(there[k]);
    if (curve_of[k] >= 0 && IsOfPatch(c)) curve_weight_[c.curve] += c.weight;
  }
}

double LiveCrossings::WeightWith(std::span<const int32_t> out, std::span<const SpaceTriangle> in) {
  const auto first_triangle = static_cast<int32_t>(placed_.size());
  const size_t first = crossings_.size();
  std::set<int32_t> changed;
  for (const int32_t t : out) {
    for (const int32_t c : of_triangle_[first_ + t]) {
      if (IsThere(crossings_[c])) changed.insert(crossings_[c].curve);
    }
  }
  for (const int32_t t : out) is_gone_[first_ + t] = true;
  AddToPatch(in);
  for (size_t c = first; c < crossings_.size(); ++c) {
    FollowCurve(
        crossings_[c],
        [&](int32_t other) {
          if (other < static_cast<int32_t>(first)) changed.insert(crossings_[other].curve);
        },
        [] {});
  }
  double weight = weight_;
  std::vector<int32_t> crossings;
  for (const int32_t curve : changed) {
    weight -= curve_weight_[curve];
    for (const int32_t c : curves_[curve]) {
      if (IsThere(crossings_[c])) crossings.push_back(c);
    }
  }
  for (size_t c = first; c < crossings_.size(); ++c) crossings.push_back(static_cast<int32_t>(c));
  weight += WeightOf(crossings);
  RemoveFrom(first_triangle, first);
  for (const int32_t t : out) is_gone_[first_ + t] = false;
  return weight;
}

void LiveCrossings::Change(std::span<const int32_t> out, std::span<const SpaceTriangle> in) {
  for (const int32_t t : out) is_gone_[first_ + t] = true;
  AddToPatch(in);
  FindCurves();
}

void LiveCrossings::Undo(std::span<const int32_t> out, int32_t first) {
  size_t crossings = crossings_.size();
  while (crossings > 0 && crossings_[crossings - 1].pair.b >= first_ + first) --crossings;
  RemoveFrom(first_ + first, crossings);
  for (const int32_t t : out) is_gone_[first_ + t] = false;
  FindCurves();
}

std::vector<PatchCrossing> LiveCrossings::Avoidable() const {
  std::vector<PatchCrossing> avoidable;
  for (const Crossing& c : crossings_) {
    if (!IsThere(c) || !IsOfPatch(c) || curve_weight_[c.curve] == 0) continue;
    PatchCrossing& crossing = avoidable.emplace_back(PatchCrossing{{c.pair.a - first_, c.pair.b - first_}, {}});
    for (const Pierced& p : c.pierced) crossing.points.push_back(PointOf(p));
  }
  return avoidable;
}

}  // namespace tilemend
