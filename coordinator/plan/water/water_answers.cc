#include "coordinator/plan/water/water_answers.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "common/mesh/polygon_index.h"
#include "common/mesh/polygon_tree.h"
#include "coordinator/plan/water/area_index.h"
#include "coordinator/plan/water/centreline.h"
#include "coordinator/plan/water/given_line.h"
#include "coordinator/plan/water/hole_groups.h"
#include "coordinator/plan/water/level_evidence.h"

namespace tilemend {
namespace {

constexpr double kSureLevel = 0.25;  // metres of sigma, as in the report's look_at
constexpr double kReach = 25;        // metres: what is no longer is no reach of a river
constexpr double kAlong = 0.5;       // of a river's length: a centreline that runs along less may run across it
constexpr int kParts = 64;           // of a piece of centreline: each is in the area or not
constexpr char kMostlyOpen[] =
    "most of it was a hole already, so what was taken out may be banks, and its level is that of what stands around "
    "it; "
    "leave \"clear\" out, or give level_m";
constexpr char kMaybeSurface[] = ". If the water is there as surface, add \"clear\": true";
constexpr char kOutside[] = "it lies outside the scene; are its coordinates those of this scene?";
constexpr char kTakenOut[] = "; surface was taken out under it all the same";
constexpr double kCovers = 0.9;   // share of what an area decides on that lies under it
constexpr double kNoticed = 0.1;  // share of a hole: a decision that covers less was drawn there by accident
constexpr size_t kMostHolesNamed = 5;

// Holes that are one body if they are water: a cluster, or a closed hole.
struct Body {
  std::vector<int32_t> holes;
  std::vector<PlaneSegment> boundary;
  double area = 0;          // m2
  int32_t decided_by = -1;  // FindDecidingArea; a decision of Plan::decisions before all others
  bool together = false;    // with others that say the same,
  double share = 0;         // which cover so much of it
  int32_t decision = -1;    // that of Plan::decisions, also one that accepts
};

std::vector<Body> BodiesOf(const Plan& plan) {
  std::vector<Body> bodies;
  for (std::vector<int32_t>& holes : GroupAllHoles(plan)) {
    std::vector<PlaneSegment> boundary = BoundaryOf(plan, holes);
    double area = 0;
    for (const int32_t h : holes) area += plan.holes[h].area;
    bodies.push_back({std::move(holes), std::move(boundary), area});
  }
  return bodies;
}

std::string Number(double value) { return std::to_string(static_cast<int64_t>(std::llround(value))); }

std::string Place(const Point2& at) {
  std::string text(1, '(');
  text += Number(at.x());
  text += ", ";
  text += Number(at.y());
  text += ')';
  return text;
}

std::string HoleAt(const Plan& plan, int32_t hole) {
  return "hole " + std::to_string(hole) + " at " + Place(plan.holes[hole].centre);
}

// "hole 4 at (3, 4), which is filled as one", or "holes 0, 2 and 3 more, which are decided on together".
std::string NameOf(const Plan& plan, const Body& body) {
  if (body.holes.size() == 1) {
    return HoleAt(plan, body.holes.front()) + ", which is filled as one";
  }
  const size_t named = std::min(body.holes.size(), kMostHolesNamed);
  std::string text = "holes ";
  for (size_t i = 0; i < named; ++i) {
    const char* const before = i == 0 ? "" : i + 1 == body.holes.size() ? " and " : ", ";
    text += before + std::to_string(body.holes[i]);
  }
  if (named < body.holes.size()) text += " and " + std::to_string(body.holes.size() - named) + " more";
  return text + ", which are decided on together";
}

std::string Decimals(double value) {
  const int64_t tenths = std::llround(10 * std::abs(value));
  std::string text = value < 0 ? "-" : "";
  text += std::to_string(tenths / 10);
  text += '.';
  text += std::to_string(tenths % 10);
  return text;
}

// Why a body that is under an area of water is not level water; "" if it is.
std::string WhyNoWater(const Plan& plan, const Body& body) {
  const PlannedHole& first = plan.holes[body.holes.front()];
  for (const int32_t h : body.holes) {
    if (plan.holes[h].water >= 0) return "";
  }
  if (!first.failure.empty()) return "the hole that it covers is left: " + first.failure;
  if (first.kind == HoleKind::kClosed) return "it covers no hole that faces up";
  return "the hole that it covers has no shore";
}

// Whether the bounds of the polygon meet those of the scene.
bool Meets(const PlanePolygon& polygon, const PlaneBounds& scene) {
  const Eigen::AlignedBox3d box = FlatBoxOf(polygon);
  return (box.min().head<2>().array() <= scene.high.array()).all() &&
         (box.max().head<2>().array() >= scene.low.array()).all();
}

// How much of its centreline lies in an area.
double LengthInside(const WaterArea& area) {
  const PolygonIndex inside(area.polygon);
  double length = 0;
  for (size_t i = 1; i < area.centreline.size(); ++i) {
    const Point2 &a = area.centreline[i - 1], step = (area.centreline[i] - a) / kParts;
    for (int k = 0; k < kParts; ++k) {
      if (inside.Contains(a + (k + 0.5) * step)) length += step.norm();
    }
  }
  return length;
}

// Why a decision is not on a body, as DecideHoles took it; "" if it is.
std::string WhyNoDecision(const Plan& plan, const std::vector<WaterArea>& areas, int32_t a, const Body& body,
                          double share) {
  const WaterArea& area = areas[a];
  if (body.decision == a || (body.decision >= 0 && SayTheSame(area, areas[body.decision])))
    return area.water ? WhyNoWater(plan, body) : "";
  if (share > kDecidingShare && body.decision >= 0)
    return "another after it decides on the same hole: " + areas[body.decision].label;
  if (share > kDecidingShare) {
    return "it does not decide on " + HoleAt(plan, body.holes.front()) +
           ", as most of it lies in another; draw one over that hole alone";
  }
  return "it covers " + Number(100 * share) + " % of " + NameOf(plan, body) + "; to decide on " +
         (body.holes.size() > 1 ? "them, draw it over more than half of their area, or give each of them the same "
                                  "decision"
                                : "it, draw it over more than half");
}

// Whether a decision is about this body alone (DecideHoles).
bool MostLiesIn(const WaterArea& area, const Body& body) {
  return CoverLines(SegmentsOf(area)).ShareIn(body.boundary) > kDecidingShare;
}

void AddDoubt(const std::string& more, WaterAnswer& answer) {
  if (!more.empty()) answer.doubt += (answer.doubt.empty() ? "" : "; ") + more;
}

// A hole is water as a whole: it may reach from a lake over a tile that is missing into a river.
std::string DoubtOfExtent(ReviewDecision decision, double taken, double under) {
  const bool is_water = decision == ReviewDecision::kNone || decision == ReviewDecision::kWater;
  return (is_water ? "it makes " + Number(taken) + " m2 water" : "it decides on " + Number(taken) + " m2") + ", and " +
         Number(taken - under) + " m2 of that lie outside it, as the hole goes on there";
}

// Where the surface that told the level scatters by more than what was taken out above it.
std::string DoubtOfSurface(const WaterArea& area) {
  if (!area.clear || !area.level_sigma || *area.level_sigma <= area.clear_height) return "";
  return "the surface in it is not level: it lies " + Decimals(*area.level_sigma) + " m off the level; is water there?";
}

// What an area says of a body that it covers some of.
struct BodyAnswer {
  const Body* body = nullptr;
  double share = 0;    // of the body
  double fit = 0;      // how likely the area was drawn for it
  std::string reason;  // why the area is not taken for it; "" if it is
};

// The reason of the body that fits best. Those of the other bodies are doubts of a decision, unless it is taken and
// about the best body alone.
void AddReasons(const WaterArea& area, const std::vector<BodyAnswer>& answers, WaterAnswer& answer) {
  const auto best = std::ranges::max_element(answers, {}, &BodyAnswer::fit);  // the first of equals
  if (best == answers.end()) return;
  answer.reason = best->reason;
  if (answer.decision == ReviewDecision::kNone) return;
  std::vector<const std::string*> others;
  for (const BodyAnswer& other : answers) {
    if (&other != &*best && other.share >= kNoticed && !other.reason.empty()) others.push_back(&other.reason);
  }
  if (others.empty() || (answer.reason.empty() && MostLiesIn(area, *best->body))) return;
  for (const std::string* other : others) AddDoubt(*other, answer);
}

class Answers {
 public:
  Answers(const std::vector<WaterArea>& areas, const std::optional<PlaneBounds>& scene, Plan& plan,
          const IsCancelled& is_cancelled)
      : areas_(areas), index_(areas, is_cancelled), scene_(scene), plan_(plan), bodies_(BodiesOf(plan)) {
    shares_.resize(areas.size());
    for (size_t b = 0; b < bodies_.size() && !index_.cancelled(); ++b) {
      Body& body = bodies_[b];
      const CoverLines region(body.boundary);
      std::vector<AreaShare> shares = index_.SharesOf(region, [](const WaterArea&) { return true; });
      for (const auto& [a, share] : shares) shares_[a].emplace_back(b, share);
      const auto deciding = DeciderOf(region, std::move(shares), body);
      if (!deciding) continue;
      body.decided_by = static_cast<int32_t>(deciding->area);
      body.together = deciding->together;
      body.share = deciding->share;
    }
  }

  void Run() {
    for (size_t a = 0; a < areas_.size(); ++a) {
      if (index_.cancelled()) return;
      WaterAnswer answer;
      answer.label = areas_[a].label;
      answer.water = areas_[a].water;
      answer.decision = areas_[a].decision;
      if (areas_[a].clear) answer.clear_height = areas_[a].clear_height;
      answer.has_cleared = !areas_[a].cleared_cells.empty();
      double taken = 0, under = 0;  // m2
      std::vector<BodyAnswer> answers;
      for (const auto& [b, share] : shares_[a]) {
        const Body& body = bodies_[b];
        const double covered = share * body.area;
        const bool is_decision = answer.decision != ReviewDecision::kNone;
        answers.push_back(
            {&body, share, is_decision ? covered * share : covered, WhyNot(static_cast<int32_t>(a), body, share)});
        if (!answers.back().reason.empty()) continue;
        answer.holes.insert(answer.holes.end(), body.holes.begin(), body.holes.end());
        const bool decides = body.decided_by == static_cast<int32_t>(a);
        taken += decides ? body.area : covered;
        under += body.together && decides ? body.share * body.area : covered;
      }
      answer.taken = !answer.holes.empty();
      AddReasons(areas_[a], answers, answer);
      answer.is_over_hole = !shares_[a].empty();
      if (!answer.taken) CompleteReason(a, answer);
      AddDoubts(a, taken, under, answer);
      plan_.water_answers.push_back(std::move(answer));
    }
  }

 private:
  // `taken`: m2 of the bodies that are filled as it says; `under`: what of them lies under the area.
  void AddDoubts(size_t a, double taken, double under, WaterAnswer& answer) const {
    if (answer.taken && answer.water) {
      AddDoubt(areas_[a].level ? DoubtOfLevel(areas_[a], answer) : DoubtOfShore(areas_[a], answer), answer);
      if (areas_[a].is_mostly_open) AddDoubt(kMostlyOpen, answer);
      AddDoubt(DoubtOfSurface(areas_[a]), answer);
    }
    if (!answer.water && areas_[a].level)
      AddDoubt("its level_m has no effect where it says that there is no water", answer);
    if (answer.taken && answer.water) AddDoubt(DoubtOfKind(areas_[a], answer), answer);
    if (answer.taken && areas_[a].centreline.size() > 1) AddDoubt(DoubtOfCentreline(a, answer), answer);
    const bool is_decision = answer.decision != ReviewDecision::kNone;
    if ((answer.water || is_decision) && under < kCovers * taken)
      AddDoubt(DoubtOfExtent(answer.decision, taken, under), answer);
  }

  // Who decides on a body of which areas cover `shares`; sets its decision. Who accepts what was filled leaves it to
  // the areas of --water.
  std::optional<DecidingArea> DeciderOf(const CoverLines& region, std::vector<AreaShare> shares, Body& body) const {
    const auto decided = plan_.decisions.find(body.holes.front());
    if (decided != plan_.decisions.end()) body.decision = decided->second;
    if (body.decision >= 0 && areas_[body.decision].decision != ReviewDecision::kAccept) {
      std::erase_if(shares, [&](const AreaShare& s) { return !SayTheSame(areas_[s.area], areas_[body.decision]); });
      const auto own = std::ranges::find(shares, static_cast<size_t>(body.decision), &AreaShare::area);
      if (own != shares.end() && own->share > kDecidingShare) return DecidingArea{own->area, own->share, false};
    } else {
      std::erase_if(shares, [&](const AreaShare& s) { return areas_[s.area].decision != ReviewDecision::kNone; });
    }
    return index_.DeciderOf(region, shares);
  }

  // Of an area that is not taken.
  void CompleteReason(size_t a, WaterAnswer& answer) const {
    const WaterArea& area = areas_[a];
    const bool is_outside = scene_ && !Meets(area.polygon, *scene_);
    if (shares_[a].empty()) answer.reason = is_outside ? kOutside : "no hole lies under it";
    const bool may_clear = answer.water && !area.clear && !is_outside && answer.decision == ReviewDecision::kNone;
    if (may_clear && CoversNoWaterHole(a)) answer.reason += kMaybeSurface;
    if (!area.cleared_cells.empty()) answer.reason += kTakenOut;
  }

  // Whether nothing under an area can be water, so that the water may be there as surface.
  bool CoversNoWaterHole(size_t a) const {
    return std::ranges::none_of(shares_[a], [&](const auto& share) {
      return plan_.holes[bodies_[share.first].holes.front()].kind != HoleKind::kClosed;
    });
  }

  std::string DoubtOfLevel(const WaterArea& area, const WaterAnswer& answer) const {
    const std::string level = area.clear && area.level_sigma ? "the level of the surface in it" : "its level_m";
    std::string doubt;
    double most = 0;
    for (const int32_t h : answer.holes) {
      if (plan_.holes[h].water < 0) continue;
      const WaterBody& body = plan_.water[plan_.holes[h].water];
      const double off = body.level - body.shore_level;
      // What is around cleared surface is the outline of the polygon, which tells a level less surely than a shore.
      const double allowed = kLevelOff + (area.level_sigma ? kSigmas * body.sigma : 0);
      if (std::abs(off) <= std::max(allowed, most)) continue;
      most = std::abs(off);
      doubt = level + " puts the water of " + HoleAt(plan_, h) + " " + Decimals(most) + " m " +
              (off > 0 ? "above" : "below") + " its shore";
    }
    return doubt;
  }

  // A shore that tells no one level: the water may fall, as over a weir, or more than the water lies in the area.
  std::string DoubtOfShore(const WaterArea& area, const WaterAnswer& answer) const {
    double sigma = kSureLevel;
    for (const int32_t h : answer.holes) {
      if (plan_.holes[h].water >= 0 && !IsRiver(h)) sigma = std::max(sigma, plan_.water[plan_.holes[h].water].sigma);
    }
    if (sigma <= kSureLevel) return "";
    const bool may_fall = area.decision == ReviewDecision::kNone && !area.clear;  // such areas have no `kind`
    return "its shore tells the level to " + Decimals(sigma) + " m only; level_m sets it" +
           (may_fall ? ", and \"kind\": \"river\" lets it fall" : "");
  }

  bool IsRiver(int32_t h) const {
    return plan_.holes[h].water >= 0 && !plan_.water[plan_.holes[h].water].river.stations.empty();
  }

  // Water of which the user did not say that it falls.
  std::string DoubtOfKind(const WaterArea& area, const WaterAnswer& answer) const {
    if (area.kind == WaterKind::kLake || area.centreline.size() > 1) return "";
    const auto river = std::ranges::find_if(answer.holes, [&](int32_t h) { return IsRiver(h); });
    if (area.kind == WaterKind::kRiver) {
      return river == answer.holes.end() ? "its shore tells of no fall, so the water is level" : "";
    }
    if (river == answer.holes.end()) return "";
    const std::vector<Point3>& stations = plan_.water[plan_.holes[*river].water].river.stations;
    const bool has_kind = area.decision == ReviewDecision::kNone;
    return "its water falls by " + Decimals(stations.front().z() - stations.back().z()) + " m; " +
           (has_kind ? "\"kind\": \"lake\"" : "level_m") + " makes it level";
  }

  // The length of the rivers among the bodies that are filled as the answer of area `a` says.
  double LengthOfWater(size_t a, const WaterAnswer& answer) const {
    double length = 0;
    for (const auto& [b, share] : shares_[a]) {
      const Body& body = bodies_[b];
      if (std::ranges::find(answer.holes, body.holes.front()) == answer.holes.end()) continue;
      if (!IsRiver(body.holes.front())) continue;
      for (const Centreline& line : FindCentrelines(body.boundary, kReach)) {
        if (line.length > kReach) length += line.length;
      }
    }
    return length;
  }

  // Lakes beside the river of a centreline: large ones the line may have missed.
  std::string OtherWater(const WaterAnswer& answer) const {
    double lakes = 0, all = 0;  // m2
    int32_t largest = answer.holes.front();
    for (const int32_t h : answer.holes) {
      all += plan_.holes[h].area;
      if (IsRiver(h)) continue;
      lakes += plan_.holes[h].area;
      if (IsRiver(largest) || plan_.holes[h].area > plan_.holes[largest].area) largest = h;
    }
    if (lakes <= (1 - kCovers) * all) return "";
    return "its centreline does not run through " + Number(lakes) +
           " m2 of its water, which have a level of their own, at " + Place(plan_.holes[largest].centre);
  }

  std::string DoubtOfCentreline(size_t a, const WaterAnswer& answer) const {
    const WaterArea& area = areas_[a];
    if (std::ranges::none_of(answer.holes, [&](int32_t h) { return IsRiver(h); }))
      return "no level of the shore is known along its centreline, so the water is level";
    if (const auto place = WhereItTurnsBack(area.centreline)) return "its centreline turns back at " + Place(*place);
    std::string other = OtherWater(answer);
    if (!other.empty()) return other;
    const double water = LengthOfWater(a, answer), line = LengthInside(area);
    if (line >= kAlong * water) return "";
    return "its centreline runs along " + Number(line) + " m of " + Number(water) +
           " m of water; it is to run from end to end";
  }

  // Why area `a` does not decide on a body; "" if it does.
  std::string WhyNot(int32_t a, const Body& body, double share) const {
    if (areas_[a].decision != ReviewDecision::kNone) return WhyNoDecision(plan_, areas_, a, body, share);
    const bool is_one_of_them = body.together && SayTheSame(areas_[a], areas_[body.decided_by]);
    if (is_one_of_them) return areas_[a].water ? WhyNoWater(plan_, body) : "";
    if (share <= kDecidingShare) {
      return "it covers " + Number(100 * share) + " % of " + HoleAt(plan_, body.holes.front()) +
             ", which is filled as one; to decide on it, draw it over more than half";
    }
    if (body.decided_by != a) return "another after it decides on the same hole: " + areas_[body.decided_by].label;
    return areas_[a].water ? WhyNoWater(plan_, body) : "";
  }

  const std::vector<WaterArea>& areas_;
  const AreaIndex index_;  // of them
  const std::optional<PlaneBounds>& scene_;
  Plan& plan_;
  std::vector<Body> bodies_;
  std::vector<std::vector<std::pair<size_t, double>>> shares_;  // by area: bodies that it covers some of
};

}  // namespace

std::optional<PlaneBounds> BoundsOfCells(const PlanInput& input) {
  if (!input.has_grid || input.cells.empty()) return std::nullopt;
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  PlaneBounds bounds{Point2::Constant(kInfinity), Point2::Constant(-kInfinity)};
  for (const auto& [cell, record] : input.cells) {
    const Point2 low = input.grid.corner + input.grid.cell_size.cwiseProduct(Point2(cell.col, cell.row));
    bounds.low = bounds.low.cwiseMin(low);
    bounds.high = bounds.high.cwiseMax(low + input.grid.cell_size);
  }
  return bounds;
}

void AnswerWaterAreas(const WaterOptions& options, Plan& plan, const std::optional<PlaneBounds>& scene,
                      const std::function<bool()>& is_cancelled) {
  if (!options.areas.empty()) Answers(options.areas, scene, plan, is_cancelled).Run();
}

}  // namespace tilemend
