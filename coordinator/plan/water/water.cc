#include "coordinator/plan/water/water.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <utility>

#include "coordinator/plan/water/area_cover.h"
#include "coordinator/plan/water/rim_level.h"
#include "coordinator/plan/water/shore.h"

namespace tilemend {
namespace {

constexpr size_t kLeastShore = 24;   // rim vertices: fewer tell too little
constexpr size_t kLeastStretch = 6;  // rim vertices
constexpr size_t kMostStretches = 32;
constexpr size_t kOddStretches = 8;          // one stretch in so many may be other than the rest: quays, trees, bridges
constexpr double kSmallHoleFall = 0.001;     // metre a metre of a small hole's extent
constexpr size_t kLongShore = 96;            // rim vertices: shorter ones need a bank that rises
constexpr double kSure = 3;                  // standard errors
constexpr double kErrorOfMedian = 1.2533;    // of normal noise, times its deviation over the root of the count
constexpr double kErrorOfFall = 2.8284;      // of a plane's fall over a round shore: the root of eight, likewise
constexpr double kErrorOfQuartile = 1.3626;  // likewise
constexpr double kErrorOfRise = 1.4472;      // of the difference to the mean of three, likewise
constexpr double kFitWindow = 3;             // spreads about the level: what the plane is fitted to
constexpr double kFacesUp = 0.9;             // cosine of a closed hole's slope

// What may be a body of water.
struct Candidate {
  WaterBody body;
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
    return body_.spread <= slack_ + 2 * noise_ && FallOfPlane() <= slack_ + Noise(kErrorOfFall, n) &&
           MedianBank(0, n) >= body_.level - Noise(kErrorOfMedian, n) && StretchesAgree() &&
           (n >= kLongShore || MedianRise() > Noise(kErrorOfRise, n));
  }

 private:
  // What a figure of `count` heights, with `factor` times the error of their mean, may be off by noise alone.
  double Noise(double factor, size_t count) const {
    return std::min(tolerance_, kSure * factor * noise_ / std::sqrt(static_cast<double>(count)));
  }

  // How far the plane through the heights near the level falls over the extent.
  double FallOfPlane() const {
    Eigen::Matrix3d a = Eigen::Matrix3d::Zero();
    Eigen::Vector3d b = Eigen::Vector3d::Zero();
    const double window = kFitWindow * body_.spread + slack_;
    for (size_t i = 0; i < shore_.size(); ++i) {
      const double above = heights_[i] - body_.level;
      if (std::abs(above) > window) continue;
      const Point2 p = (plan_.vertices[shore_[i]].position.head<2>() - middle_) / extent_;
      const Eigen::Vector3d row(p.x(), p.y(), 1);
      a += row * row.transpose();
      b += row * above;
    }
    const Eigen::Vector3d plane = a.ldlt().solve(b);
    return plane.allFinite() ? plane.head<2>().norm() : 0;
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
      const bool off = std::abs(Quantile(heights, 0.25) - quartile) > slack_ + Noise(kErrorOfQuartile, to - from);
      const bool falls = MedianBank(from, to) < body_.level - Noise(kErrorOfMedian, to - from);
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

// The clusters of open holes, and the closed holes that face up; each in order of their first hole.
std::vector<std::vector<int32_t>> GroupHoles(const Plan& plan) {
  const auto faces_up = [&](const PlannedHole& hole) {
    Eigen::Vector3d area = Eigen::Vector3d::Zero();
    const Point3 origin = plan.vertices[hole.segments[0].from].position;
    for (const RimSegment& s : hole.segments) {
      area += (plan.vertices[s.from].position - origin).cross(plan.vertices[s.to].position - origin);
    }
    return area.z() > kFacesUp * area.norm();
  };
  std::vector<std::vector<int32_t>> groups;
  std::map<int32_t, size_t> group_of_cluster;
  for (size_t h = 0; h < plan.holes.size(); ++h) {
    const PlannedHole& hole = plan.holes[h];
    if (!hole.failure.empty()) continue;
    if (hole.kind == HoleKind::kClosed) {
      if (hole.projects && faces_up(hole)) groups.push_back({static_cast<int32_t>(h)});
      continue;
    }
    const auto [it, fresh] = group_of_cluster.try_emplace(hole.cluster, groups.size());
    if (fresh) groups.emplace_back();
    groups[it->second].push_back(static_cast<int32_t>(h));
  }
  return groups;
}

// The areas that cover more than half of the holes, ascending.
std::vector<size_t> AreasOver(const Plan& plan, const std::vector<int32_t>& holes,
                              const std::vector<WaterArea>& areas) {
  std::vector<size_t> over;
  if (areas.empty()) return over;
  std::vector<PlaneSegment> boundary;
  for (const int32_t h : holes) {
    for (const RimSegment& s : plan.holes[h].segments) {
      boundary.emplace_back(plan.vertices[s.from].position.head<2>(), plan.vertices[s.to].position.head<2>());
    }
  }
  for (size_t a = 0; a < areas.size(); ++a) {
    if (CoveredShare(boundary, areas[a]) > 0.5) over.push_back(a);
  }
  return over;
}

// All that can be told without the bands. Fills plan.idle_water_areas.
std::vector<Candidate> FindCandidates(const WaterOptions& options, Plan& plan) {
  std::vector<Candidate> candidates;
  if (!options.find && options.areas.empty()) return candidates;
  std::set<size_t> idle;
  for (size_t a = 0; a < options.areas.size(); ++a) idle.insert(a);
  for (std::vector<int32_t>& holes : GroupHoles(plan)) {
    const std::vector<size_t> areas = AreasOver(plan, holes, options.areas);
    for (const size_t a : areas) idle.erase(a);
    if (!(areas.empty() ? options.find : options.areas[areas.back()].water)) continue;
    Candidate c;
    c.shore = ShoreOf(plan, holes);
    c.body.forced = !areas.empty();
    if (c.shore.size() < (c.body.forced ? 1 : kLeastShore)) continue;
    const std::vector<double> heights = HeightsOf(plan, c.shore);
    if (!c.body.forced && FitRimLevel(heights, 0).spread > options.tolerance) continue;
    c.body.holes = std::move(holes);
    c.body.rim_vertices = std::ssize(heights);
    c.body.lowest = *std::min_element(heights.begin(), heights.end());
    c.body.highest = *std::max_element(heights.begin(), heights.end());
    candidates.push_back(std::move(c));
  }
  plan.idle_water_areas.assign(idle.begin(), idle.end());
  return candidates;
}

}  // namespace

void FindWater(const PlanInput& input, const WaterOptions& options, Plan& plan) {
  std::vector<Candidate> candidates = FindCandidates(options, plan);
  if (candidates.empty()) return;
  std::vector<std::vector<int32_t>> shores;
  for (const Candidate& c : candidates) shores.push_back(c.shore);
  const std::vector<ShoreGround> grounds = FindGround(plan, input, shores);
  for (size_t i = 0; i < candidates.size(); ++i) {
    WaterBody& body = candidates[i].body;
    const RimLevel fit = FitRimLevel(HeightsOf(plan, candidates[i].shore), grounds[i].noise);
    body.level = std::floor(fit.level / plan.lattice_step) * plan.lattice_step;
    body.spread = fit.spread;
    if (!body.forced && !LevelTest(plan, candidates[i], grounds[i], options.tolerance).Holds()) continue;
    for (const int32_t h : body.holes) plan.holes[h].water = static_cast<int32_t>(plan.water.size());
    plan.water.push_back(std::move(body));
  }
}

void SettleWater(const Plan& plan, SeamHeights& heights) {
  for (const WaterBody& body : plan.water) {
    for (const int32_t h : body.holes) {
      for (const RimSegment& s : plan.holes[h].segments) {
        for (const int32_t v : {s.from, s.to}) {
          if (plan.vertices[v].index < 0) heights.height[v] = body.level;
        }
      }
    }
  }
}

}  // namespace tilemend
