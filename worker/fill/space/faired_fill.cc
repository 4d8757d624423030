#include "worker/fill/space/faired_fill.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <utility>

#include "common/mesh/rounding.h"
#include "common/mesh/triangle_shape.h"
#include "worker/fill/shape/new_patch.h"
#include "worker/fill/shape/refine_patch.h"
#include "worker/fill/space/bend_patch.h"

namespace tilemend {
namespace {

// Of a patch; more take longer to bend than they are worth.
constexpr double kMostTriangles = 60'000;
// Of an equilateral triangle, over its edge squared.
const double kUnitArea = std::sqrt(3.0) / 4;
constexpr int kRounds = 10;
// How much of the bending the corners of crossed triangles keep in each round, those beside them at least, and what is
// too little to keep.
constexpr double kKept = 0.5;
constexpr double kStep = 0.25;
constexpr double kLeastKept = 0.1;

class FairedFiller {
 public:
  FairedFiller(const LocalHole& hole, const FillOptions& options, CrossingCheck& check)
      : hole_(hole), options_(options), check_(check) {}

  LocalPatch Run(const std::vector<Triangle>& triangles) {
    for (const bool any_chord : {true, false}) {
      if (options_.refine.cancelled()) break;
      Refine(triangles, any_chord);
      LocalPatch patch = Bend();
      if (patch.ok()) return patch;
    }
    return {FillFailure::kNotApplicable};
  }

 private:
  LocalPatch Bend() {
    flat_.assign(patch_.points.begin() + hole_.size(), patch_.points.end());
    std::optional<std::vector<Point3>> bent = BendPatch(hole_, patch_.points, flat_, patch_.triangles);
    kept_.assign(flat_.size(), bent ? 1 : 0);
    bent_ = bent ? *std::move(bent) : flat_;
    for (int round = 0; round < kRounds; ++round) {
      LocalPatch patch = Make();
      if (FaultOf(hole_, patch) == FillFailure::kNone) {
        const std::vector<int32_t> crossed = check_.Crossed(patch);
        if (crossed.empty()) return patch;
        if (!TakeBack(crossed)) break;
      } else if (!TakeAllBack()) {
        break;
      }
    }
    return {FillFailure::kNotApplicable};
  }

  //   any_chord  edges may be turned to run from rim to rim; else those that do are triangles' own
  void Refine(const std::vector<Triangle>& triangles, bool any_chord) {
    patch_ = {};
    patch_.rim_count = hole_.size();
    patch_.points = hole_.positions;
    patch_.sizes = hole_.sizes;
    patch_.projects = false;
    patch_.spreads = true;
    double area = 0, edges = 0;
    for (const Triangle& t : triangles) {
      area += TriangleArea(patch_.points[t[0]], patch_.points[t[1]], patch_.points[t[2]]);
    }
    for (const double size : patch_.sizes) edges += size / static_cast<double>(patch_.sizes.size());
    RefineOptions refine = options_.refine;
    const double least = std::sqrt(area / kMostTriangles / kUnitArea) / edges;
    if (least > 1) {
      refine.uniform = false;
      refine.gradation = std::max(refine.gradation, RefineOptions().gradation);
      refine.size_limit = std::max(refine.size_limit, least);
    }
    patch_.triangles = triangles;
    std::set<VertexPair> own;
    for (const Triangle& t : triangles) {
      for (int k = 0; k < 3; ++k) own.insert(Undirected(t[k], t[(k + 1) % 3]));
    }
    RefinePatch(
        refine, [&](int32_t a, int32_t b) { return any_chord ? hole_.MayJoin(a, b) : own.contains(Undirected(a, b)); },
        patch_);
  }

  LocalPatch Make() const {
    LocalPatch patch;
    patch.triangles = patch_.triangles;
    for (size_t k = 0; k < flat_.size(); ++k) {
      const Point3 p = flat_[k] + kept_[k] * (bent_[k] - flat_[k]);
      patch.new_points.push_back(RoundedToLattice(p, hole_.cell->lattice_step));
    }
    return patch;
  }

  // False if there is nothing to take back.
  bool TakeBack(const std::vector<int32_t>& crossed) {
    bool any = false;
    for (const int32_t t : crossed) {
      for (const int32_t v : patch_.triangles[t]) {
        if (v < hole_.size() || kept_[v - hole_.size()] <= 0) continue;
        double& kept = kept_[v - hole_.size()];
        kept = kept > kLeastKept ? kKept * kept : 0;
        any = true;
      }
    }
    // So that the patch does not crease there.
    for (int round = 0; round < static_cast<int>(1 / kStep); ++round) {
      for (const Triangle& t : patch_.triangles) {
        double least = 1;
        for (const int32_t v : t) least = std::min(least, v < hole_.size() ? 1 : kept_[v - hole_.size()]);
        for (const int32_t v : t) {
          if (v >= hole_.size()) kept_[v - hole_.size()] = std::min(kept_[v - hole_.size()], least + kStep);
        }
      }
    }
    return any;
  }

  bool TakeAllBack() {
    const bool any = std::any_of(kept_.begin(), kept_.end(), [](double kept) { return kept > 0; });
    std::fill(kept_.begin(), kept_.end(), 0);
    return any;
  }

  const LocalHole& hole_;
  const FillOptions& options_;
  CrossingCheck& check_;
  NewPatch patch_;
  std::vector<Point3> flat_, bent_;  // the new points
  std::vector<double> kept_;         // of the way from the one to the other
};

}  // namespace

LocalPatch FillFaired(const std::vector<Triangle>& triangles, const LocalHole& hole, const FillOptions& options,
                      CrossingCheck& check) {
  return FairedFiller(hole, options, check).Run(triangles);
}

}  // namespace tilemend
