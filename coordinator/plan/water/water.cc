#include "coordinator/plan/water/water.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <numbers>
#include <optional>
#include <ranges>
#include <string>
#include <utility>

#include "coordinator/plan/water/area_index.h"
#include "coordinator/plan/water/basins.h"
#include "coordinator/plan/water/decided_holes.h"
#include "coordinator/plan/water/given_water.h"
#include "coordinator/plan/water/hole_groups.h"
#include "coordinator/plan/water/low_ground.h"
#include "coordinator/plan/water/rim_chains.h"
#include "coordinator/plan/water/verdict_chance.h"
#include "coordinator/plan/water/verdict_words.h"

namespace tilemend {
namespace {

constexpr double kWallAtWater = 1;  // metres
constexpr double kJudged = 100;     // m2: smaller holes are not judged unless an area decides, or beside water

using Verdict = HoleEvidence::Verdict;

// The words here: a *group* is a cluster of open holes, or a closed hole. A *basin* is a group, or several that may
// hold one water, with what its rim tells. A *body* is what is filled flat. *Known* is water of the whole scene, where
// an area takes a part of it. An *open lake* has been given without a level.

// A cluster of open holes, or a closed hole.
struct Group {
  std::vector<int32_t> holes;
  double area = 0;                // m2
  std::optional<size_t> decider;  // DeciderOf
  HoleEvidence evidence;
  bool is_judged = false;
  bool is_known = false;                           // the scene as a whole says what of it is water
  std::optional<size_t> open_lake = std::nullopt;  // of which OpenLake it is a part
};

Eigen::AlignedBox2d SurroundingsOf(const std::vector<PlaneSegment>& outline, double margin) {
  Eigen::AlignedBox2d box;
  for (const auto& [a, b] : outline) box.extend(a).extend(b);
  box.min().array() -= margin;
  box.max().array() += margin;
  return box;
}

// Of a rim, or a part of that of `basin`.
Shore ShoreOf(const Basin& basin, const std::vector<RimChain>& rim) {
  Shore shore;
  const LevelEvidence& e = basin.river ? basin.river->evidence : basin.evidence;
  const double above = std::max(e.noise, kMinSigma);
  shore.noise = e.noise;
  shore.mean_edge = e.length / static_cast<double>(e.edges);
  for (const RimChain& chain : rim) {
    for (const ChainEdge& edge : chain) {
      const Point2 at = edge.middle.head<2>();
      const double level = basin.river ? LevelAt(basin.river->water, at, 0x1p-20) : e.level;
      const bool is_at_water = edge.middle.z() <= level + above;
      shore.edges.emplace_back(at.x(), at.y(), is_at_water ? level : std::numeric_limits<double>::quiet_NaN());
    }
  }
  return shore;
}

std::vector<GroundAround> GroundAroundOf(const std::vector<Basin>& basins, const Plan& plan, const PlanInput& input) {
  std::vector<Shore> shores;
  for (const Basin& basin : basins) shores.push_back(basin.is_level() ? ShoreOf(basin, basin.rim) : Shore());
  return GroundAroundShores(plan, input, shores);
}

// For each water that was joined from several of `basins`: its part with the largest share of low ground, if that
// exceeds kMaxLowGround. Their numbers, ascending.
std::vector<size_t> PartsWithLowGround(const std::vector<Basin>& basins, const std::vector<Basin>& joined,
                                       const Plan& plan, const PlanInput& input) {
  std::vector<size_t> whole_of;
  std::vector<Shore> shores;
  for (const Basin& part : basins) {
    const auto has_it = [&](const Basin& whole) { return std::ranges::binary_search(whole.members, part.members[0]); };
    const auto whole = std::ranges::find_if(joined, has_it);
    whole_of.push_back(static_cast<size_t>(whole - joined.begin()));
    const bool is_part = whole->members.size() > 1 && whole->is_level();
    shores.push_back(is_part ? ShoreOf(*whole, part.rim) : Shore());
  }
  const std::vector<GroundAround> around = GroundAroundShores(plan, input, shores);
  std::map<size_t, size_t> worst;  // by the whole
  for (size_t b = 0; b < basins.size(); ++b) {
    if (around[b].low <= kMaxLowGround) continue;
    const auto [it, fresh] = worst.try_emplace(whole_of[b], b);
    if (!fresh && around[b].low > around[it->second].low) it->second = b;
  }
  std::vector<size_t> numbers;
  for (const auto& [whole, b] : worst) numbers.push_back(b);
  std::ranges::sort(numbers);
  return numbers;
}

// What has ground around it that is no higher than the water, as a yard behind a dyke, joins none. Ends, as each round
// takes out a basin.
std::vector<Basin> JoinWater(std::vector<Basin> basins, double least_river, const Plan& plan, const PlanInput& input,
                             const AreaIndex& index) {
  std::vector<Basin> apart;
  while (true) {
    std::vector<Basin> joined = JoinBasins(basins, least_river);
    const std::vector<size_t> leaving =
        index.cancelled() ? std::vector<size_t>() : PartsWithLowGround(basins, joined, plan, input);
    if (leaving.empty()) {
      std::ranges::move(apart, std::back_inserter(joined));
      return joined;
    }
    for (const size_t b : leaving | std::views::reverse) {
      apart.push_back(std::move(basins[b]));
      basins.erase(basins.begin() + static_cast<std::ptrdiff_t>(b));
    }
  }
}

// What stands so high above the water stands beside or over it: a quay, a pier, a bridge.
void MarkWalls(const WaterBody& body, Plan& plan) {
  ForRimAboveWater(body, plan, [](PlanVertex& vertex, double above) {
    if (above > kWallAtWater) vertex.on_object = true;
  });
}

// Large holes on slopes are no water, and need no test.
void JudgeSlopes(const WaterProfile& profile, Plan& plan) {
  for (PlannedHole& hole : plan.holes) {
    if (!plan.upright || !hole.failure.empty() || hole.evidence >= 0 || hole.kind != HoleKind::kClosed) continue;
    const double slope = SlopeOf(plan, hole);
    if (hole.area < profile.least_level || slope >= std::numbers::pi / 2) continue;
    const std::string degrees = std::to_string(std::lround(slope * 180 / std::numbers::pi));
    hole.evidence = static_cast<int32_t>(plan.evidence.size());
    plan.evidence.push_back({.reason = "it lies on a slope of " + degrees + " degrees"});
  }
}

// Who gives an earlier run's holes back unchanged decides nothing: they are as doubtful as before.
void KeepDoubt(const LevelEvidence& rim, HoleEvidence& evidence) {
  evidence.area = -1;
  evidence.dry_difference = rim.dry_difference;
  evidence.chance_wrong = ChanceOfError(evidence.verdict, rim);
}

void StoreBody(WaterBody body, Plan& plan) {
  if (body.kind == BodyKind::kWater) MarkWalls(body, plan);
  for (const int32_t h : body.holes) plan.holes[h].water = static_cast<int32_t>(plan.water.size());
  plan.water.push_back(std::move(body));
}

void StoreEvidence(Group group, Plan& plan) {
  if (!group.is_judged || !plan.holes[group.holes.front()].failure.empty()) return;
  for (const int32_t h : group.holes) plan.holes[h].evidence = static_cast<int32_t>(plan.evidence.size());
  plan.evidence.push_back(std::move(group.evidence));
}

// The water of a basin; `falls`: as a river.
WaterBody BodyOf(const Basin& basin, bool falls) {
  const LevelEvidence& e = basin.river ? basin.river->evidence : basin.evidence;
  WaterBody body;
  DescribeRim(basin.evidence, e.sigma(), body);
  body.level = body.shore_level = e.level;
  if (falls) body.river = basin.river->water;
  return body;
}

// A lake of an area that gives no level. On both sides of a bridge it is that of one water, whoever says so.
struct OpenLake {
  GivenWater alone;
  Basin basin;
  bool may_fall;
};

class WaterFinder {
 public:
  WaterFinder(const PlanInput& input, const WaterOptions& options, KnownWater known, Plan& plan,
              const IsCancelled& is_cancelled)
      : input_(input), options_(options), known_(std::move(known)), plan_(plan), index_(options.areas, is_cancelled) {}

  void Run() {
    CollectGroups();
    std::vector<OpenLake> lakes = FindGiven();
    FindByEvidence(std::move(lakes));
    if (index_.cancelled()) return;
    AddKnown();
    std::ranges::sort(bodies_, {}, [](const WaterBody& body) { return body.holes.front(); });
    for (WaterBody& body : bodies_) StoreBody(std::move(body), plan_);
    for (Group& group : groups_) StoreEvidence(std::move(group), plan_);
    JudgeSlopes(options_.profile, plan_);
    if (!known_.bodies.empty()) HoldLevelAtEdges(plan_);
  }

 private:
  void CollectGroups() {
    for (std::vector<int32_t>& holes : GroupHoles(plan_, true)) {
      if (index_.cancelled()) return;
      const std::optional<size_t> decider = DeciderOf(plan_, holes, options_.areas, index_);
      const WaterArea* area = decider ? &options_.areas[*decider] : nullptr;
      if (area != nullptr && (!area->water || area->level)) known_.Forget(holes);
      const auto rest = std::stable_partition(holes.begin(), holes.end(), [&](int32_t h) { return known_.IsPart(h); });
      if (rest != holes.begin()) groups_.push_back(KnownGroup({holes.begin(), rest}));
      if (rest != holes.end()) groups_.push_back(OpenGroup({rest, holes.end()}, decider));
    }
  }

  Group OpenGroup(std::vector<int32_t> holes, std::optional<size_t> decider) const {
    Group group;
    for (const int32_t h : holes) group.area += plan_.holes[h].area;
    group.holes = std::move(holes);
    group.decider = decider;
    group.is_judged = decider || group.area >= kJudged;
    if (!options_.find) group.evidence.reason = kNotLookedFor;
    if (!decider) return group;
    group.evidence.reason = DecidedBy(options_.areas[*decider]);
    group.evidence.area = static_cast<int32_t>(*decider);
    return group;
  }

  // Holes that are parts of water of the whole scene.
  Group KnownGroup(std::vector<int32_t> holes) const {
    const WaterBody& body = known_.bodies[known_.body_of[holes.front()]];
    const Verdict verdict = body.river.stations.empty() ? Verdict::kLake : Verdict::kRiver;
    Group group = OpenGroup(std::move(holes), std::nullopt);
    group.is_known = true;
    group.evidence = {verdict, true, body.level, body.sigma, body.reason};
    group.evidence.is_of_whole_scene = true;
    return group;
  }

  // The parts of the scene's water in holes that are none yet.
  void AddKnown() {
    std::vector<bool> is_water(plan_.holes.size(), false);
    for (const WaterBody& body : bodies_) {
      for (const int32_t h : body.holes) is_water[h] = true;
    }
    for (WaterBody& part : PartsOfKnown(known_, is_water, plan_)) bodies_.push_back(std::move(part));
  }

  // The water that areas tell of. Lakes without a level are given back.
  std::vector<OpenLake> FindGiven() {
    std::vector<OpenLake> lakes;
    std::map<size_t, std::vector<size_t>> groups_of;
    for (size_t g = 0; g < groups_.size(); ++g) {
      const std::optional<size_t> area = groups_[g].decider;
      if (area && options_.areas[*area].water) groups_of[*area].push_back(g);
    }
    for (const auto& [number, groups] : groups_of) {
      if (index_.cancelled()) break;
      const WaterArea& area = options_.areas[number];
      std::vector<GivenPart> parts;
      for (const size_t g : groups) {
        std::vector<RimChain> rim = RimChainsOf(plan_, groups_[g].holes);
        if (rim.empty()) continue;
        parts.push_back({g, groups_[g].area, BoundaryOf(plan_, groups_[g].holes), std::move(rim)});
      }
      for (GivenWater& water : WaterOfArea(area, std::move(parts), options_.profile.least_river)) {
        if (!area.level && area.kind != WaterKind::kRiver && water.body.river.stations.empty()) {
          for (const size_t g : water.parts) groups_[g].open_lake = lakes.size();
          Basin basin = *BasinOf(water.parts);  // each part has a rim
          if (area.kind == WaterKind::kLake) basin.river.reset();
          lakes.push_back({std::move(water), std::move(basin), area.kind != WaterKind::kLake});
          continue;
        }
        AddBody(water.parts, std::move(water.body));
        if (!area.is_as_found) continue;
        for (const size_t g : water.parts) KeepDoubt(water.evidence, groups_[g].evidence);
      }
    }
    return lakes;
  }

  // Judges the groups that are large enough, and those near water, which may be stubs of it beyond a bridge.
  void FindByEvidence(std::vector<OpenLake> lakes) {
    std::vector<Basin> basins;
    for (const OpenLake& lake : lakes) basins.push_back(lake.basin);
    for (size_t g = 0; g < groups_.size(); ++g) {
      if (index_.cancelled()) return;
      if (groups_[g].area >= kJudged) AddBasin(g, basins);
    }
    std::vector<Eigen::AlignedBox2d> boxes_of_level;
    for (const Basin& basin : basins) {
      if (!basin.is_level()) continue;
      for (const std::vector<PlaneSegment>& outline : basin.outlines) {
        boxes_of_level.push_back(SurroundingsOf(outline, basin.Width()));
      }
    }
    for (size_t g = 0; g < groups_.size(); ++g) {
      if (index_.cancelled()) return;
      if (groups_[g].area >= kJudged || groups_[g].holes.empty()) continue;
      const Eigen::AlignedBox2d box = SurroundingsOf(BoundaryOf(plan_, groups_[g].holes), std::sqrt(groups_[g].area));
      const auto meets = [&](const Eigen::AlignedBox2d& other) { return other.intersects(box); };
      if (std::ranges::any_of(boxes_of_level, meets)) AddBasin(g, basins);
    }
    if (index_.cancelled()) return;
    basins = JoinWater(std::move(basins), options_.profile.least_river, plan_, input_, index_);
    const std::vector<GroundAround> around = GroundAroundOf(basins, plan_, input_);
    for (size_t b = 0; b < basins.size(); ++b) {
      DecideLakes(basins[b], lakes);
      std::erase_if(basins[b].members, [&](size_t g) { return groups_[g].decider.has_value(); });
      if (!basins[b].members.empty()) Decide(basins[b], around[b]);
    }
  }

  // Those of the lakes that are part of the basin have its level, whatever else it is taken for.
  void DecideLakes(const Basin& basin, std::vector<OpenLake>& lakes) {
    std::vector<size_t> joined;
    for (const size_t g : basin.members) {
      if (!groups_[g].open_lake) continue;
      OpenLake& lake = lakes[*groups_[g].open_lake];
      const std::vector<size_t>& groups = lake.basin.members;
      const bool is_alone = basin.members.size() == groups.size() || (basin.river && !lake.may_fall);
      if (!is_alone) joined.push_back(g);
      if (is_alone && g == groups[0]) AddBody(lake.alone.parts, std::move(lake.alone.body));
    }
    if (joined.empty()) return;
    WaterBody body = BodyOf(basin, basin.river.has_value());
    body.forced = true;
    AddBody(joined, std::move(body));
  }

  // Holes that a reviewer decides on as well: their rims go on telling of the water that they were part of.
  void AddBasin(size_t g, std::vector<Basin>& basins) {
    Group& group = groups_[g];
    const bool is_given = group.decider && options_.areas[*group.decider].decision == ReviewDecision::kNone;
    if (is_given || group.open_lake || group.is_known || !options_.find) return;
    if (std::optional<Basin> basin = BasinOf({g})) {
      basins.push_back(*std::move(basin));
    } else if (!group.decider) {
      group.evidence.reason = kNoRim;
    }
  }

  // Of groups that are one; none if they have no original edge on their rims.
  std::optional<Basin> BasinOf(std::vector<size_t> groups) const {
    std::ranges::sort(groups);
    std::vector<int32_t> holes;
    double area = 0;
    for (const size_t g : groups) {
      holes.insert(holes.end(), groups_[g].holes.begin(), groups_[g].holes.end());
      area += groups_[g].area;
    }
    std::vector<RimChain> rim = RimChainsOf(plan_, holes);
    if (rim.empty()) return std::nullopt;
    std::vector<std::vector<PlaneSegment>> outlines;
    for (const size_t g : groups) outlines.push_back(BoundaryOf(plan_, groups_[g].holes));
    return MakeBasin(std::move(groups), std::move(outlines), std::move(rim), area, options_.profile.least_river);
  }

  void Decide(const Basin& basin, const GroundAround& around) {
    const LevelEvidence& e = basin.river ? basin.river->evidence : basin.evidence;
    const bool is_lowest = around.low <= kMaxLowGround;
    const bool is_within_noise = !basin.river && e.is_within_noise() && around.sunk <= kMaxSunkGround;
    const bool is_flat = basin.is_level() && (is_lowest || is_within_noise);
    const bool is_large = basin.area >= options_.profile.least_lake;
    Verdict verdict = Verdict::kNoWater;
    if (basin.river && is_lowest) {
      verdict = Verdict::kRiver;
    } else if (is_flat && is_lowest && is_large) {
      verdict = Verdict::kLake;
    } else if (is_flat && basin.area >= options_.profile.least_level) {
      verdict = Verdict::kLevelGround;
    }
    for (const size_t g : basin.members) {
      groups_[g].is_judged = groups_[g].is_judged || verdict != Verdict::kNoWater;
      HoleEvidence& evidence = groups_[g].evidence;
      evidence = {verdict, true, e.level, e.sigma(), ReasonFor(verdict, basin, around.low, options_.profile)};
      evidence.dry_difference = basin.evidence.dry_difference;
      evidence.chance_wrong = ChanceOfError(verdict, basin.evidence);
    }
    if (verdict == Verdict::kNoWater) return;
    WaterBody body = BodyOf(basin, verdict == Verdict::kRiver);
    body.kind = verdict == Verdict::kLevelGround ? BodyKind::kLevelGround : BodyKind::kWater;
    AddBody(basin.members, std::move(body));
  }

  void AddBody(const std::vector<size_t>& groups, WaterBody body) {
    if (!body.river.stations.empty()) body.level = body.river.stations.back().z();
    body.level = std::round(body.level / plan_.lattice_step) * plan_.lattice_step;
    for (const size_t g : groups) {
      body.holes.insert(body.holes.end(), groups_[g].holes.begin(), groups_[g].holes.end());
      if (!groups_[g].decider) continue;
      HoleEvidence& evidence = groups_[g].evidence;
      evidence.verdict = body.river.stations.empty() ? Verdict::kLake : Verdict::kRiver;
      evidence.has_level = true;
      evidence.level = body.level;
      evidence.sigma = body.level_is_given ? std::nullopt : std::optional(body.sigma);
    }
    body.reason = groups_[groups.front()].evidence.reason;
    std::ranges::sort(body.holes);
    body.rim_vertices = std::ssize(RimVerticesOf(plan_, body.holes));
    bodies_.push_back(std::move(body));
  }

  const PlanInput& input_;
  const WaterOptions& options_;
  KnownWater known_;
  Plan& plan_;
  const AreaIndex index_;  // of options_.areas
  std::vector<Group> groups_;
  std::vector<WaterBody> bodies_;
};

}  // namespace

void FindWater(const PlanInput& input, const WaterOptions& options, KnownWater known, Plan& plan,
               const std::function<bool()>& is_cancelled) {
  WaterFinder(input, options, std::move(known), plan, is_cancelled).Run();
}

void SettleWater(const Plan& plan, SeamHeights& heights) {
  const auto settle = [&](const std::vector<RimSegment>& segments, const auto& level_at) {
    for (const RimSegment& s : segments) {
      for (const int32_t v : {s.from, s.to}) {
        const PlanVertex& vertex = plan.vertices[v];
        if (vertex.index < 0 && !vertex.height_known) heights.height[v] = level_at(vertex.position);
      }
    }
  };
  for (const WaterBody& body : plan.water) {
    const auto level_at = [&](const Point3& p) { return LevelAt(body, p.head<2>(), plan.lattice_step); };
    for (const int32_t h : body.holes) {
      settle(plan.holes[h].segments, level_at);
      for (const std::vector<RimSegment>& region : plan.holes[h].own_regions) settle(region, level_at);
    }
  }
}

}  // namespace tilemend
