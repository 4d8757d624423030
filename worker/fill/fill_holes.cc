#include "worker/fill/fill_holes.h"

#include <algorithm>
#include <cstdint>
#include <functional>
#include <numbers>
#include <optional>
#include <utility>

#include "worker/fill/crease/crease_fill.h"
#include "worker/fill/hole/cell_band.h"
#include "worker/fill/hole/facing.h"
#include "worker/fill/hole/local_patch.h"
#include "worker/fill/hole/projection_frame.h"
#include "worker/fill/plane/folded_fill.h"
#include "worker/fill/plane/plane_fill.h"
#include "worker/fill/space/earlier_patches.h"
#include "worker/fill/space/mend_crossings.h"
#include "worker/fill/space/patch_creases.h"
#include "worker/fill/space/patch_soundness.h"
#include "worker/fill/space/rim_junctions.h"
#include "worker/fill/space/space_fill.h"
#include "worker/fill/space/unrolled_fill.h"

namespace tilemend {
namespace {

// No triangle closes what such a hole leaves.
constexpr char kJunction[] = "a vertex of its boundary lies on an edge of the other side (a T-junction)";
constexpr char kWeld[] = "; `tilemend fill --weld TOLERANCE` splits such edges";  // of single meshes
constexpr char kRepair[] = "; repair the mesh there";                             // of scenes, which are not welded

// Mean turn at the rim of a patch that goes on from its surroundings.
constexpr double kLittleTurn_rad = 5.0 * std::numbers::pi / 180;

// What a patch is checked for beside FaultOf.
enum class Check {
  kNothing,    // it is a height field
  kPublished,  // as kCrossings; it might also go anywhere
  kCrossings,  // it might pass through itself or the surface around it
  kFreely,     // it might also go astray, or face down where heights fill the hole
};

FillWay WayOf(Filler filler) {
  switch (filler) {
    case Filler::kAuto:
      break;
    case Filler::kAdvancingFrontNormal:
      return FillWay::kAdvancingFrontNormal;
    case Filler::kAdvancingFrontCurvature:
      return FillWay::kAdvancingFrontCurvature;
    case Filler::kAdvancingFrontPoisson:
      return FillWay::kAdvancingFrontPoisson;
    case Filler::kSvmLaplacian:
      return FillWay::kSvmLaplacian;
    case Filler::kMinimumArea:
      return FillWay::kMinimumArea;
  }
  return FillWay::kNone;
}

struct Way {
  FillWay name;
  Check check;
  std::function<LocalPatch()> fill;
};

class HoleFiller {
 public:
  // `max_vertices` is the limit of the cell, options.refine.max_new_points what is left of it for this hole.
  HoleFiller(const CellHoles& cell, const CellHole& hole, const CellBand& band, const FillOptions& options,
             int64_t max_vertices, const SurfaceNear& near, const EarlierPatches& earlier)
      : options_(options),
        max_vertices_(max_vertices),
        hole_(MakeLocalHole(cell, band, hole)),
        crossings_(hole_, ReachOf(cell, hole), near, &earlier) {}

  HolePatch Run() {
    FillFailure failure = FillFailure::kNoArea;
    if (HasUnknownHeight()) return Failed(FillFailure::kUnknownHeights);
    for (const Way& way : Ways()) {
      if (best_ && best_rank_.faults == 0 && way.name != FillWay::kSpace) continue;
      LocalPatch patch = Checked(way, way.fill());
      if (options_.refine.cancelled()) break;
      // A way that refines up to the limit takes seconds and up to a gigabyte: no other one is tried.
      if (patch.failure == FillFailure::kTooLarge && !best_) return Failed(patch.failure);
      if (patch.ok()) {
        Keep(way.name, std::move(patch));
        if (best_rank_.faults == 0 && !MayGoOnBetterInSpace()) break;
        continue;
      }
      // That a patch was only crossed tells most of why the hole stays open.
      if (patch.failure != FillFailure::kNotApplicable && failure != FillFailure::kCrosses) failure = patch.failure;
    }
    if (best_ && !options_.refine.cancelled()) {
      best_->rim_is_crossed = crossings_.rim_is_crossed();
      return FoldsBack() ? Failed(FillFailure::kFoldsBack) : *std::move(best_);
    }
    const bool crosses = failure == FillFailure::kCrosses || failure == FillFailure::kPatchCrosses;
    const bool by_rim = crosses && crossings_.rim_is_crossed();
    return Failed(by_rim ? FillFailure::kRimIsCrossed : failure);
  }

 private:
  // The less, the better.
  struct Rank {
    int32_t faults = 0;
    double turn = 0;  // at the rim, radians
    auto operator<=>(const Rank&) const = default;
  };

  // The patch of a way, with a failure if it is too large or unsound.
  LocalPatch Checked(const Way& way, LocalPatch patch) {
    if (patch.ok() && !Fits(patch)) patch.failure = FillFailure::kTooLarge;
    if (!patch.ok() || options_.refine.cancelled()) return patch;
    if (way.check == Check::kFreely && GoesAstray(patch)) return {FillFailure::kNotApplicable};
    if (way.check == Check::kPublished && GoesFar(patch)) return {FillFailure::kGoesFar};
    if (const FillFailure fault = FaultOf(hole_, patch); fault != FillFailure::kNone) return {fault};
    if (way.check != Check::kNothing && crossings_.Crosses(patch)) {
      return {way.check == Check::kPublished ? FillFailure::kPatchCrosses : FillFailure::kCrosses};
    }
    if (way.check != Check::kNothing || !MayCross(way)) return patch;
    patch = MendCrossings(hole_, std::move(patch), crossings_, options_.refine.is_cancelled);
    if (patch.ok() && !Fits(patch)) patch.failure = FillFailure::kTooLarge;
    return patch;
  }

  // The first sound patch is the best; in a mesh that may lie in any way the one with the fewest creases and spikes,
  // and of those the one that goes on most nearly as the surface beside it.
  void Keep(FillWay way, LocalPatch patch) {
    Rank rank;
    if (ShunsFolds()) {
      rank.faults = CountCreases(hole_, patch);
      if (rank.faults > 0) {
        patch = BevelCreases(hole_, std::move(patch), crossings_);
        rank.faults = CountCreases(hole_, patch);
      }
      rank.faults += CountSpikes(hole_, patch);
      rank.turn = TurnAtRim(hole_, patch);
    }
    if (best_ && !(rank < best_rank_)) return;
    best_rank_ = rank;
    const bool is_bare = patch.is_bare;
    const int32_t crossings = patch.crossings;
    const int32_t creases = IsAsPublished(way) ? CountCreases(hole_, patch) : 0;
    best_ = ToHolePatch(hole_, std::move(patch));
    best_->creases = creases;
    best_->crossings = crossings;
    best_->way = is_bare ? FillWay::kBare : way;
  }

  // Heights over a plane may stand against what is steep beside them.
  bool MayGoOnBetterInSpace() const {
    const bool by_heights = best_->way == FillWay::kOwnPlane || best_->way == FillWay::kFacingPlane;
    return by_heights && ShunsFolds() && best_rank_.turn > kLittleTurn_rad && IsSteep(hole_);
  }

  // By a named filler, or in a single mesh by the published surface.
  bool IsAsPublished(FillWay way) const {
    return way >= FillWay::kAdvancingFrontNormal || (options_.surface == Surface::kWang && !hole_.cell->upright);
  }

  // What is published makes its patches as published.
  bool ShunsFolds() const {
    const bool is_ours = options_.surface == Surface::kThinPlate && options_.filler == Filler::kAuto;
    return is_ours && !hole_.cell->upright;
  }

  // Whether all patches do. Creases that go on from those of the surface are right; others are worse than the hole.
  bool FoldsBack() const { return best_rank_.faults > 0 && best_->way != FillWay::kCreases && !options_.allow_creases; }

  std::vector<Way> Ways() {
    if (options_.filler != Filler::kAuto && !hole_.open && !hole_.level) return {AsNamed()};
    std::vector<Way> ways;
    if (FillsOverGround()) {
      AddPlanes(false, ways);
      if (!IsHoleInGround()) ways.push_back(InSpace());
      AddPlanes(true, ways);
      return ways;
    }
    const bool smooth = options_.surface == Surface::kThinPlate, steep = smooth && IsSteep(hole_);
    if (smooth) ways.push_back({FillWay::kCreases, Check::kFreely, [&] { return FillAlongCreases(hole_, options_); }});
    const Way unrolled{FillWay::kUnrolled, Check::kFreely, [&] { return FillUnrolled(FreeHole(), options_); }};
    if (steep) ways.push_back(unrolled);
    AddPlanes(false, ways);
    if (smooth) {
      ways.push_back(
          {FillWay::kFacingPlane, Check::kFreely, [&] { return FillOverFacingPlane(FreeHole(), options_); }});
    }
    if (smooth && !steep) ways.push_back(unrolled);
    ways.push_back(InSpace());
    AddPlanes(true, ways);
    return ways;
  }

  // Water, open holes, and holes whose rim stands on objects.
  bool FillsOverGround() const { return IsHoleInGround() || !hole_.on_object.empty(); }

  // Filled as heights even where the rim folds: the surface around them crosses itself there as well.
  bool IsHoleInGround() const { return hole_.open || hole_.level || hole_.in_ground; }

  // Whether a patch that is not checked for crossings is more than heights over the ground: cut folds, walls.
  bool MayCross(const Way& way) const { return way.name == FillWay::kFoldsCut || hole_.own_outline; }

  Way AsNamed() {
    return {WayOf(options_.filler), Check::kPublished,
            [&] { return options_.published->by_name(hole_, options_, [&] { return crossings_.Surface(); }); }};
  }

  Way InSpace() {
    return {FillWay::kSpace, Check::kCrossings, [&] { return FillInSpace(FreeHole(), options_, crossings_); }};
  }

  void AddPlanes(bool cut_folds, std::vector<Way>& ways) {
    const auto add = [&](FillWay name, Check check, const ProjectionFrame& frame) {
      ways.push_back({cut_folds ? FillWay::kFoldsCut : name, check, [this, frame, cut_folds] {
                        return cut_folds ? FillFolded(hole_, frame, options_, crossings_)
                                         : FillOverPlane(hole_, frame, options_, {});
                      }});
    };
    const Check over_ground = cut_folds && !IsHoleInGround() ? Check::kCrossings : Check::kNothing;
    if (FillsOverGround()) {
      add(hole_.level ? FillWay::kWater : FillWay::kGround, over_ground, ProjectionFrame::Upright());
      return;
    }
    const Eigen::Vector3d area = hole_.VectorArea();
    if (hole_.cell->upright && FacesUp(hole_, ProjectionFrame::Upright()) && area.z() > 0) {
      add(FillWay::kGround, over_ground, ProjectionFrame::Upright());
    }
    if (area.norm() > 0) add(FillWay::kOwnPlane, Check::kCrossings, FrameAcross(hole_, area));
  }

  // The hole, without an equation at folds.
  const LocalHole& FreeHole() {
    if (!free_hole_) FreeAtFolds(free_hole_.emplace(hole_));
    return *free_hole_;
  }

  // A patch with as many new vertices as it may have was not refined to the end.
  bool Fits(const LocalPatch& patch) const { return std::ssize(patch.new_points) < options_.refine.max_new_points; }

  bool GoesAstray(const LocalPatch& patch) const {
    if (!crossings_.StaysNear(patch)) return true;
    const ProjectionFrame heights = FrameOfHeights(hole_);
    return FacesDown(hole_, patch, heights) && LiesInHeightField(hole_, heights);
  }

  // Whether the patch leaves the extent of the boundary by more than that is wide: no surface needs that for its hole.
  bool GoesFar(const LocalPatch& patch) const {
    Eigen::AlignedBox3d box;
    for (const Point3& p : hole_.positions) box.extend(p);
    const Point3 reach = Point3::Constant(box.diagonal().norm());
    box = {box.min() - reach, box.max() + reach};
    return !std::ranges::all_of(patch.new_points, [&](const Point3& p) { return box.contains(p); });
  }

  bool HasUnknownHeight() const {
    return std::any_of(hole_.vertices.begin(), hole_.vertices.end(),
                       [&](int32_t v) { return !hole_.cell->vertices[v].height_known; });
  }

  HolePatch Failed(FillFailure failure) const {
    HolePatch patch;
    patch.failure = TextOf(failure, {hole_.segments.size(), max_vertices_, !options_.is_single_mesh});
    if (hole_.open || !HasJunction(hole_)) return patch;
    patch.failure = std::string(kJunction) + (hole_.cell->upright ? kRepair : kWeld);
    return patch;
  }

  const FillOptions& options_;
  const int64_t max_vertices_;
  const LocalHole hole_;
  CrossingCheck crossings_;
  std::optional<LocalHole> free_hole_;
  std::optional<HolePatch> best_;
  Rank best_rank_;
};

}  // namespace

std::vector<HolePatch> FillHoles(const CellHoles& cell, const FillOptions& options, const SurfaceNear& near,
                                 const std::function<void()>& hole_done) {
  CellBand band(cell);
  std::vector<HolePatch> patches;
  EarlierPatches earlier(cell, patches);
  FillOptions rest = options;  // with what the patches before leave of the limit
  rest.refine.max_new_points -= std::ssize(cell.vertices);
  for (const CellHole& hole : cell.holes) {
    if (options.refine.cancelled()) break;
    HolePatch patch = HoleFiller(cell, hole, band, rest, options.refine.max_new_points, near, earlier).Run();
    rest.refine.max_new_points -= std::ssize(patch.new_points);
    patch.hole = hole.id;
    if (&hole != &cell.holes.back()) band.Add(hole, patch);
    patches.push_back(std::move(patch));
    earlier.TakeLast();
    if (hole_done) hole_done();
  }
  return patches;
}

}  // namespace tilemend
