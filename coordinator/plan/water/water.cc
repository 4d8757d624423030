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

// A cluster of open holes, or a closed hole.
struct Group {
  std::vector<int32_t> holes;
  double area = 0;                // m2
  std::optional<size_t> decider;  // DeciderOf
  HoleEvidence evidence;
  bool is_judged = false;
  bool is_known = false;  // the scene as a whole says what of it is water
};

// Whether a whole rim, of which `lowest` is known, stands higher than the surface that the area takes out, as on a
// bridge over cleared water.
bool LiesAbove(std::optional<double> lowest, const WaterArea& area) {
  if (!area.clear || !area.water || !area.level) return false;
  const double top = *area.level + area.clear_height;
  return lowest && *lowest > top;
}

// Of the original vertices on a rim; none: there are none.
std::optional<double> LowestOnRim(const Plan& plan, const std::vector<int32_t>& holes) {
  std::optional<double> lowest;
  for (const int32_t v : RimVerticesOf(plan, holes)) {
    const double z = plan.vertices[v].position.z();
    lowest = std::min(lowest.value_or(z), z);
  }
  return lowest;
}

std::optional<size_t> DeciderOf(const Plan& plan, const std::vector<int32_t>& holes,
                                const std::vector<WaterArea>& areas, const AreaIndex& index) {
  if (areas.empty()) return std::nullopt;
  const auto decision = plan.decisions.find(holes.front());
  if (decision != plan.decisions.end() && areas[decision->second].decision != ReviewDecision::kAccept)
    return decision->second;
  const CoverLines region(BoundaryOf(plan, holes));
  const auto is_of_water = [](const WaterArea& area) { return area.decision == ReviewDecision::kNone; };
  std::vector<AreaShare> shares = index.SharesOf(region, is_of_water);
  if (shares.empty()) return std::nullopt;
  const std::optional<double> lowest = LowestOnRim(plan, holes);
  std::erase_if(shares, [&](const AreaShare& s) { return LiesAbove(lowest, areas[s.area]); });
  const auto deciding = index.DeciderOf(region, shares);
  return deciding ? std::optional<size_t>(deciding->area) : std::nullopt;
}

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

class WaterFinder {
 public:
  WaterFinder(const PlanInput& input, const WaterOptions& options, KnownWater known, Plan& plan,
              const IsCancelled& is_cancelled)
      : input_(input), options_(options), known_(std::move(known)), plan_(plan), index_(options.areas, is_cancelled) {}

  void Run() {
    CollectGroups();
    FindGiven();
    if (options_.find) FindByEvidence();
    if (index_.cancelled()) return;
    AddKnown();
    std::ranges::sort(bodies_, {}, [](const WaterBody& body) { return body.holes.front(); });
    for (WaterBody& body : bodies_) StoreBody(std::move(body));
    for (Group& group : groups_) StoreEvidence(std::move(group));
    JudgeSlopes(options_.profile, plan_);
    if (!known_.bodies.empty()) HoldLevelAtEdges(plan_);
  }

 private:
  void CollectGroups() {
    for (std::vector<int32_t>& holes : GroupHoles(plan_)) {
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

  // The water that areas tell of.
  void FindGiven() {
    std::map<size_t, std::vector<size_t>> groups_of;
    for (size_t g = 0; g < groups_.size(); ++g) {
      const std::optional<size_t> area = groups_[g].decider;
      if (area && options_.areas[*area].water) groups_of[*area].push_back(g);
    }
    for (const auto& [area, groups] : groups_of) {
      if (index_.cancelled()) return;
      std::vector<GivenPart> parts;
      for (const size_t g : groups) {
        std::vector<RimChain> rim = RimChainsOf(plan_, groups_[g].holes);
        if (rim.empty()) continue;
        parts.push_back({g, groups_[g].area, BoundaryOf(plan_, groups_[g].holes), std::move(rim)});
      }
      for (GivenWater& water : WaterOfArea(options_.areas[area], std::move(parts), options_.profile.least_river)) {
        AddBody(water.parts, std::move(water.body));
        if (!options_.areas[area].is_as_found) continue;
        for (const size_t g : water.parts) KeepDoubt(water.evidence, groups_[g].evidence);
      }
    }
  }

  // Judges the groups that are large enough, and those near water, which may be stubs of it beyond a bridge.
  void FindByEvidence() {
    std::vector<Basin> basins;
    for (size_t g = 0; g < groups_.size(); ++g) {
      if (index_.cancelled()) return;
      if (groups_[g].is_judged) AddBasin(g, basins);
    }
    std::vector<Eigen::AlignedBox2d> boxes_of_level;
    for (const Basin& basin : basins) {
      if (basin.is_level()) boxes_of_level.push_back(SurroundingsOf(basin.outlines[0], basin.Width()));
    }
    for (size_t g = 0; g < groups_.size(); ++g) {
      if (index_.cancelled()) return;
      if (groups_[g].is_judged || groups_[g].holes.empty()) continue;
      const Eigen::AlignedBox2d box = SurroundingsOf(BoundaryOf(plan_, groups_[g].holes), std::sqrt(groups_[g].area));
      const auto meets = [&](const Eigen::AlignedBox2d& other) { return other.intersects(box); };
      if (std::ranges::any_of(boxes_of_level, meets)) AddBasin(g, basins);
    }
    if (index_.cancelled()) return;
    basins = JoinWater(std::move(basins), options_.profile.least_river, plan_, input_, index_);
    const std::vector<GroundAround> around = GroundAroundOf(basins, plan_, input_);
    for (size_t b = 0; b < basins.size(); ++b) Decide(basins[b], around[b]);
  }

  void AddBasin(size_t g, std::vector<Basin>& basins) {
    Group& group = groups_[g];
    if (group.decider || group.is_known) return;
    std::vector<RimChain> rim = RimChainsOf(plan_, group.holes);
    group.evidence.reason = kNoRim;
    if (rim.empty()) return;
    basins.push_back(
        MakeBasin(g, BoundaryOf(plan_, group.holes), std::move(rim), group.area, options_.profile.least_river));
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
    WaterBody body;
    body.kind = verdict == Verdict::kLevelGround ? BodyKind::kLevelGround : BodyKind::kWater;
    DescribeRim(basin.evidence, e.sigma(), body);
    body.level = body.shore_level = e.level;
    if (verdict == Verdict::kRiver) body.river = basin.river->water;
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

  void StoreBody(WaterBody body) {
    if (body.kind == BodyKind::kWater) MarkWalls(body, plan_);
    for (const int32_t h : body.holes) plan_.holes[h].water = static_cast<int32_t>(plan_.water.size());
    plan_.water.push_back(std::move(body));
  }

  void StoreEvidence(Group group) {
    if (!group.is_judged) return;
    for (const int32_t h : group.holes) plan_.holes[h].evidence = static_cast<int32_t>(plan_.evidence.size());
    plan_.evidence.push_back(std::move(group.evidence));
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
