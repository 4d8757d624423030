#include "coordinator/plan/water/water.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "coordinator/plan/water/area_cover.h"
#include "coordinator/plan/water/given_line.h"
#include "coordinator/plan/water/hole_groups.h"
#include "coordinator/plan/water/rim_level.h"
#include "coordinator/plan/water/river.h"
#include "coordinator/plan/water/shore.h"

namespace tilemend {
namespace {

constexpr size_t kLeastStretch = 6;  // rim vertices
constexpr size_t kMostStretches = 32;
constexpr size_t kOddStretches = 8;          // one stretch in so many may be other than the rest: quays, trees, bridges
constexpr double kSmallHoleFall = 0.001;     // metre a metre of a small hole's extent
constexpr double kSure = 3;                  // standard errors
constexpr double kErrorOfMedian = 1.2533;    // of normal noise, times its deviation over the root of the count
constexpr double kErrorOfFall = 2.8284;      // of a plane's fall over a round shore: the root of eight, likewise
constexpr double kMostSwell = 1.5;           // tolerances
constexpr double kErrorOfQuartile = 1.3626;  // likewise
constexpr double kErrorOfRise = 1.4472;      // of the difference to the mean of three, likewise
constexpr double kFitWindow = 3;             // spreads about the level: what the plane is fitted to
constexpr double kWallAtWater = 1;           // metres
constexpr int kFitsWithoutBanks = 2;
constexpr double kAnyStep = 0x1p-20;  // metres

// What may be a body of water.
struct Candidate {
  WaterBody body;
  const WaterArea* area = nullptr;  // that decides on it; none: its rim does
  std::vector<int32_t> shore;
};

std::vector<double> HeightsOf(const Plan& plan, const std::vector<int32_t>& vertices) {
  std::vector<double> heights;
  for (const int32_t v : vertices) heights.push_back(plan.vertices[v].position.z());
  return heights;
}

// Whether the rim of a candidate, already known to gather at a height, is that of level water.
class LevelTest {
 public:
  LevelTest(const Plan& plan, const Candidate& candidate, const ShoreGround& ground, double tolerance)
      : plan_(plan),
        shore_(candidate.shore),
        heights_(HeightsOf(plan, shore_)),
        body_(candidate.body),
        bank_(ground.bank),
        noise_(ground.noise),
        tolerance_(tolerance) {
    Point2 lo = plan.vertices[shore_[0]].position.head<2>(), hi = lo;
    for (const int32_t v : shore_) {
      lo = lo.cwiseMin(plan.vertices[v].position.head<2>());
      hi = hi.cwiseMax(plan.vertices[v].position.head<2>());
    }
    middle_ = (lo + hi) / 2;
    extent_ = (hi - lo).norm();
    slack_ = std::min(tolerance, kSmallHoleFall * extent_);
  }

  bool Holds() const {
    const size_t n = shore_.size();
    return body_.spread <= slack_ + 2 * noise_ && FallOfPlane() <= slack_ + FallBySwell() &&
           MedianBank(0, n) >= body_.level - Swell(kErrorOfMedian) && StretchesAgree() &&
           (n >= kLongShore || MedianRise() > Noise(kErrorOfRise, n));
  }

 private:
  // What a figure of `count` heights, with `factor` times the error of their mean, may be off by noise alone.
  double Noise(double factor, size_t count) const { return Error(noise_, factor, count); }

  // The same of heights on the water, which is noisier than the ground around it.
  double Scatter(double factor, size_t count) const { return Error(std::max(noise_, body_.spread), factor, count); }

  // What a figure of the whole rim may be off by: its heights scatter together along a stretch of shore.
  double Swell(double factor) const { return Error(body_.spread, factor, Stretches()); }

  // A shore that lies on the bank along one side falls as much as the bank is high.
  double FallBySwell() const {
    const double swell = kSure * kErrorOfFall * body_.spread / std::sqrt(static_cast<double>(Stretches()));
    return std::min(kMostSwell * tolerance_, swell);
  }

  size_t Stretches() const { return std::min(shore_.size(), kMostStretches); }

  double Error(double deviation, double factor, size_t count) const {
    return std::min(tolerance_, kSure * factor * deviation / std::sqrt(static_cast<double>(count)));
  }

  // How far the plane through the heights near the level falls over the extent. A bank on one side of the water alone
  // tilts it: so the plane is fitted again without what lies higher above it than noise, and the flatter one counts.
  double FallOfPlane() const {
    const double window = kFitWindow * body_.spread + slack_;
    Eigen::Vector3d plane = PlaneThrough(Eigen::Vector3d::Zero(), window, window);
    double fall = plane.head<2>().norm();
    for (int again = 0; again < kFitsWithoutBanks; ++again) {
      plane = PlaneThrough(plane, window, body_.spread + kAnyStep);
      fall = std::min(fall, plane.head<2>().norm());
    }
    return fall;
  }

  // The plane (slopes over the extent, height above the level in the middle) through the heights that lie at most
  // `below` and `above` from another one.
  Eigen::Vector3d PlaneThrough(const Eigen::Vector3d& other, double below, double above) const {
    Eigen::Matrix3d a = Eigen::Matrix3d::Zero();
    Eigen::Vector3d b = Eigen::Vector3d::Zero();
    for (size_t i = 0; i < shore_.size(); ++i) {
      const Point2 p = (plan_.vertices[shore_[i]].position.head<2>() - middle_) / extent_;
      const Eigen::Vector3d row(p.x(), p.y(), 1);
      const double height = heights_[i] - body_.level, off = height - row.dot(other);
      if (off < -below || off > above) continue;
      a += row * row.transpose();
      b += row * height;
    }
    const Eigen::Vector3d plane = a.ldlt().solve(b);
    return plane.allFinite() ? plane : Eigen::Vector3d::Zero();
  }

  // The median of the banks of shore vertices [from, to); above everything if they have none.
  double MedianBank(size_t from, size_t to) const {
    std::vector<double> banks;
    std::copy_if(bank_.begin() + static_cast<ptrdiff_t>(from), bank_.begin() + static_cast<ptrdiff_t>(to),
                 std::back_inserter(banks), [](double z) { return !std::isnan(z); });
    return banks.empty() ? std::numeric_limits<double>::infinity() : Quantile(std::move(banks), 0.5);
  }

  // The median of how far the banks are above their own shore vertices.
  double MedianRise() const {
    std::vector<double> rises;
    for (size_t i = 0; i < bank_.size(); ++i) {
      if (!std::isnan(bank_[i])) rises.push_back(bank_[i] - heights_[i]);
    }
    return rises.empty() ? 0 : Quantile(std::move(rises), 0.5);
  }

  bool StretchesAgree() const {
    const size_t n = shore_.size(), length = std::max(kLeastStretch, (n + kMostStretches - 1) / kMostStretches);
    const size_t count = n / length;
    const double quartile = Quantile(heights_, 0.25);
    size_t odd = 0;
    for (size_t k = 0; k < count; ++k) {
      const size_t from = k * n / count, to = (k + 1) * n / count;
      const std::vector<double> heights(heights_.begin() + static_cast<ptrdiff_t>(from),
                                        heights_.begin() + static_cast<ptrdiff_t>(to));
      const bool off = std::abs(Quantile(heights, 0.25) - quartile) > slack_ + Scatter(kErrorOfQuartile, to - from);
      const bool falls = MedianBank(from, to) < body_.level - Scatter(kErrorOfMedian, to - from);
      odd += off || falls;
    }
    return odd <= count / kOddStretches;
  }

  const Plan& plan_;
  const std::vector<int32_t>& shore_;
  const std::vector<double> heights_;
  const WaterBody& body_;
  const std::vector<double>& bank_;
  const double noise_;
  const double tolerance_;
  Point2 middle_;
  double extent_ = 0;
  double slack_ = 0;
};

// The areas that cover more than half of the holes, ascending.
std::vector<size_t> AreasOver(const Plan& plan, const std::vector<int32_t>& holes,
                              const std::vector<WaterArea>& areas) {
  std::vector<size_t> over;
  if (areas.empty()) return over;
  const CoverLines region(BoundaryOf(plan, holes));
  for (size_t a = 0; a < areas.size(); ++a) {
    if (region.ShareIn(areas[a]) > 0.5) over.push_back(a);
  }
  return over;
}

std::vector<int32_t> GroundOf(const Plan& plan, std::vector<int32_t> shore) {
  std::erase_if(shore, [&](int32_t v) { return plan.vertices[v].on_object; });
  return shore;
}

// All that can be told without the bands.
std::vector<Candidate> FindCandidates(const WaterOptions& options, const Plan& plan, KnownWater& known) {
  std::vector<Candidate> candidates;
  if (!options.find && options.areas.empty()) return candidates;
  for (std::vector<int32_t>& holes : GroupHoles(plan)) {
    const std::vector<size_t> areas = AreasOver(plan, holes, options.areas);
    const bool may_be = areas.empty() ? options.find : options.areas[areas.back()].water;
    if (!may_be || (!areas.empty() && options.areas[areas.back()].level)) known.Forget(holes);
    if (!may_be || known.Decides(plan, holes)) continue;
    Candidate c;
    c.shore = GroundOf(plan, ShoreOf(plan, holes));
    c.body.forced = !areas.empty();
    if (c.body.forced) c.area = &options.areas[areas.back()];
    if (c.shore.size() < (c.body.forced ? 1 : kLeastShore)) continue;
    c.body.holes = std::move(holes);
    candidates.push_back(std::move(c));
  }
  return candidates;
}

Reach ReachOf(const Plan& plan, const Candidate& candidate, const ShoreGround& ground) {
  Reach reach;
  reach.boundary = BoundaryOf(plan, candidate.body.holes);
  for (const int32_t v : candidate.shore) reach.shore.push_back(plan.vertices[v].position);
  reach.bank = ground.bank;
  reach.noise = ground.noise;
  reach.forced = candidate.body.forced;
  if (candidate.area != nullptr) reach.centreline = candidate.area->centreline;
  return reach;
}

double OnLattice(const Plan& plan, double level) { return std::floor(level / plan.lattice_step) * plan.lattice_step; }

// What stands so high above the water stands beside or over it: a quay, a pier, a bridge.
void MarkWalls(const WaterBody& body, Plan& plan) {
  const auto mark = [&](const std::vector<RimSegment>& segments) {
    for (const RimSegment& s : segments) {
      for (const int32_t v : {s.from, s.to}) {
        PlanVertex& vertex = plan.vertices[v];
        if (vertex.index < 0) continue;
        const double above = vertex.position.z() - LevelAt(body, vertex.position.head<2>(), plan.lattice_step);
        if (above > kWallAtWater) vertex.on_object = true;
      }
    }
  };
  for (const int32_t h : body.holes) {
    mark(plan.holes[h].segments);
    for (const std::vector<RimSegment>& region : plan.holes[h].own_regions) mark(region);
  }
}

void StoreBody(WaterBody body, Plan& plan) {
  MarkWalls(body, plan);
  for (const int32_t h : body.holes) plan.holes[h].water = static_cast<int32_t>(plan.water.size());
  plan.water.push_back(std::move(body));
}

void DescribeRim(const std::vector<double>& heights, WaterBody& body) {
  body.rim_vertices = std::ssize(heights);
  body.lowest = *std::min_element(heights.begin(), heights.end());
  body.highest = *std::max_element(heights.begin(), heights.end());
}

bool HasGivenLevel(const Candidate& candidate) { return candidate.area != nullptr && candidate.area->level; }

double AreaOf(const Plan& plan, const Candidate& candidate) {
  double area = 0;
  for (const int32_t h : candidate.body.holes) area += plan.holes[h].area;
  return area;
}

// Describes the rim of a candidate and sets its level. Returns whether it is a lake by its rim and its size, or has a
// given level.
bool FitLevel(const Plan& plan, const WaterOptions& options, const ShoreGround& ground, Candidate& candidate) {
  const std::vector<double> heights = HeightsOf(plan, candidate.shore);
  const RimLevel fit = FitRimLevel(heights, ground.noise);
  candidate.body.level = OnLattice(plan, HasGivenLevel(candidate) ? *candidate.area->level : fit.level);
  candidate.body.shore_level = fit.level;
  candidate.body.spread = fit.spread;
  DescribeRim(heights, candidate.body);
  if (HasGivenLevel(candidate)) return true;
  return AreaOf(plan, candidate) >= options.profile.least_lake &&
         LevelTest(plan, candidate, ground, options.tolerance).Holds();
}

WaterBody RiverBody(const Plan& plan, const std::vector<Candidate>& candidates, River river) {
  WaterBody body;
  std::vector<double> heights, above;
  for (const size_t r : river.reaches) {
    const Candidate& c = candidates[r];
    body.holes.insert(body.holes.end(), c.body.holes.begin(), c.body.holes.end());
    body.forced = body.forced || c.body.forced;
    for (const int32_t v : c.shore) {
      const Point3& p = plan.vertices[v].position;
      heights.push_back(p.z());
      above.push_back(p.z() - LevelAt(river.profile.water, p.head<2>(), plan.lattice_step));
    }
  }
  std::sort(body.holes.begin(), body.holes.end());
  DescribeRim(heights, body);
  body.spread = FitRimLevel(above, 0).spread;
  body.level = OnLattice(plan, river.profile.water.stations.back().z());
  body.river = std::move(river.profile.water);
  body.removed_rises = std::move(river.profile.removed);
  return body;
}

// Of a river that does not fall a lake at the mean of its stations.
void MakeLevel(const Plan& plan, WaterBody& river) {
  double sum = 0;
  for (const Point3& station : river.river.stations) sum += station.z();
  river.level = river.shore_level = OnLattice(plan, sum / static_cast<double>(river.river.stations.size()));
  river.river = {};
  river.removed_rises.clear();
}

// One polygon is one water: what it covers beside its largest lake becomes a part of that where their shores have the
// same level, within what the rim of the largest tells. Marks those that are not bodies of their own any more.
void JoinLakesOfAreas(const Plan& plan, double tolerance, std::vector<Candidate>& candidates,
                      std::vector<bool>& is_part) {
  std::map<const WaterArea*, size_t> largest;
  for (size_t i = 0; i < candidates.size(); ++i) {
    if (is_part[i] || candidates[i].area == nullptr) continue;
    size_t& at = largest.try_emplace(candidates[i].area, i).first->second;
    if (AreaOf(plan, candidates[i]) > AreaOf(plan, candidates[at])) at = i;
  }
  for (size_t i = 0; i < candidates.size(); ++i) {
    if (is_part[i] || candidates[i].area == nullptr) continue;
    const size_t at = largest.at(candidates[i].area);
    const WaterBody& part = candidates[i].body;
    WaterBody& lake = candidates[at].body;
    const double off = std::abs(part.shore_level - lake.shore_level);
    if (at == i || off > tolerance + std::min(tolerance, lake.spread)) continue;
    is_part[i] = true;
    lake.holes.insert(lake.holes.end(), part.holes.begin(), part.holes.end());
    std::sort(lake.holes.begin(), lake.holes.end());
    lake.rim_vertices += part.rim_vertices;
    lake.lowest = std::min(lake.lowest, part.lowest);
    lake.highest = std::max(lake.highest, part.highest);
  }
}

// What is water among the candidates.
std::vector<WaterBody> FindBodies(const PlanInput& input, const WaterOptions& options, const Plan& plan,
                                  std::vector<Candidate> candidates) {
  if (candidates.empty()) return {};
  std::vector<std::vector<int32_t>> shores;
  for (const Candidate& c : candidates) shores.push_back(c.shore);
  const std::vector<ShoreGround> grounds = FindGround(plan, input, shores);
  std::vector<Reach> reaches;  // of the candidates that may be rivers
  std::vector<size_t> candidate_of;
  std::vector<bool> level;
  for (size_t i = 0; i < candidates.size(); ++i) {
    level.push_back(FitLevel(plan, options, grounds[i], candidates[i]));
    if (HasGivenLevel(candidates[i])) continue;
    reaches.push_back(ReachOf(plan, candidates[i], grounds[i]));
    candidate_of.push_back(i);
  }
  LeaveOtherWater(options.tolerance, reaches);
  std::vector<WaterBody> bodies;
  std::vector<bool> is_part(candidates.size(), false);
  for (River& river : FindRivers(reaches, options.tolerance, options.profile.least_river)) {
    for (size_t& r : river.reaches) r = candidate_of[r];
    const size_t first = river.reaches[0];
    if (!river.given && river.reaches.size() == 1 && level[first]) continue;
    const bool large = AreaOf(plan, candidates[first]) >= options.profile.least_lake;
    const bool is_lake = !river.given && !river.falls && large;
    for (const size_t r : river.reaches) is_part[r] = true;
    bodies.push_back(RiverBody(plan, candidates, std::move(river)));
    if (is_lake) MakeLevel(plan, bodies.back());
  }
  JoinLakesOfAreas(plan, options.tolerance, candidates, is_part);
  for (size_t i = 0; i < candidates.size(); ++i) {
    if (!is_part[i] && (level[i] || candidates[i].body.forced)) bodies.push_back(std::move(candidates[i].body));
  }
  return bodies;
}

void AddPartsOfKnown(const KnownWater& known, const Plan& plan, std::vector<WaterBody>& bodies) {
  std::vector<bool> is_water(plan.holes.size(), false);
  for (const WaterBody& body : bodies) {
    for (const int32_t h : body.holes) is_water[h] = true;
  }
  for (WaterBody& part : PartsOfKnown(known, is_water, plan)) bodies.push_back(std::move(part));
}

}  // namespace

void FindWater(const PlanInput& input, const WaterOptions& options, KnownWater known, Plan& plan) {
  std::vector<Candidate> candidates = FindCandidates(options, plan, known);
  std::vector<WaterBody> bodies = FindBodies(input, options, plan, std::move(candidates));
  AddPartsOfKnown(known, plan, bodies);
  std::sort(bodies.begin(), bodies.end(),
            [](const WaterBody& a, const WaterBody& b) { return a.holes.front() < b.holes.front(); });
  for (WaterBody& body : bodies) StoreBody(std::move(body), plan);
  if (!known.bodies.empty()) HoldLevelAtEdges(plan);
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
