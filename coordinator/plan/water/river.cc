#include "coordinator/plan/water/river.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <tuple>
#include <utility>

#include "coordinator/plan/water/centreline.h"
#include "coordinator/plan/water/rim_level.h"
#include "coordinator/plan/water/shore.h"

namespace tilemend {
namespace {

constexpr double kStation = 25;           // metres
constexpr int64_t kLeastAtStation = 8;    // heights
constexpr int64_t kLeastAtSide = 4;       // heights
constexpr double kLeastReach = 1;         // times as long as wide: a reach
constexpr double kLeastRiver = 3;         // likewise: a river
constexpr double kSteep = 0.005;          // metre a metre
constexpr double kSteepest = 0.02;        // likewise
constexpr int64_t kLeastWhereSteep = 8;   // stations
constexpr size_t kStationsAtEnd = 3;      // that tell where a reach runs at its end
constexpr double kWidestBridge = 40;      // metres
constexpr double kOpposite = 0.5;         // cosine of the angle between the ends of two reaches
constexpr double kBentEnd = 0.75;         // widths from its end: there a centreline bends into a corner
constexpr double kMostAside = 1.5;        // widths: one end of the line through the other
constexpr size_t kOddStations = 8;        // one in so many may be other than the rest
constexpr size_t kAgreeing = 3;           // one in so many has the level at both shores; along the rest one is a quay
constexpr size_t kBankStations = 3;       // one in so many may lie between quays on both sides
constexpr double kSure = 3;               // standard errors
constexpr double kErrorOfLevel = 1.2533;  // of normal noise, times its deviation over the root of the count
constexpr double kErrorOfRise = 1.4472;   // of the difference to the mean of three, likewise

// An end of a centreline.
struct End {
  size_t line;
  bool last;  // of the centreline's points
  double width;
  Point2 at, outward;
};

End EndOf(const Centreline& line, size_t number, bool last) {
  const std::vector<Point2>& p = line.points;
  const size_t back = std::min<size_t>(kStationsAtEnd, p.size() - 1);
  const Point2 at = last ? p.back() : p.front(), before = last ? p[p.size() - 1 - back] : p[back];
  return {number, last, line.width, at, (at - before).normalized()};
}

bool Faces(const End& a, const End& b) {
  const Point2 gap = b.at - a.at;
  const double far = gap.norm(), width = (a.width + b.width) / 2, turn = a.outward.dot(b.outward);
  // Nearer than that the last bits of two centrelines, which may end in corners, tell nothing.
  if (far < width && turn < kOpposite) return true;
  if (turn > -kOpposite) return false;
  // A centreline may end anywhere across the water, in a corner too, and the river may bend under the bridge.
  const double ahead = (a.outward - b.outward).normalized().dot(gap), across = kMostAside * width;
  return std::abs(ahead) <= kWidestBridge && far * far - ahead * ahead <= across * across;
}

bool HasGivenLine(const Reach& reach) { return reach.centreline.size() > 1; }

// A centreline of a reach, which has several where it is in parts.
struct ReachLine {
  size_t reach;
  Centreline line;
};

// Lines in order along a river; reversed: from the last of its points to the first.
using Chain = std::vector<std::pair<size_t, bool>>;

std::vector<Chain> LinkLines(const std::vector<ReachLine>& lines, const std::vector<bool>& is_free) {
  std::vector<End> ends;
  for (size_t i = 0; i < lines.size(); ++i) {
    if (!is_free[i]) continue;
    for (const bool last : {false, true}) ends.push_back(EndOf(lines[i].line, i, last));
  }
  std::vector<std::tuple<double, size_t, size_t>> gaps;
  for (size_t i = 0; i < ends.size(); ++i) {
    for (size_t k = i + 1; k < ends.size(); ++k) {
      if (ends[i].line != ends[k].line && Faces(ends[i], ends[k])) {
        gaps.emplace_back((ends[i].at - ends[k].at).norm(), i, k);
      }
    }
  }
  std::sort(gaps.begin(), gaps.end());
  constexpr size_t kNone = std::numeric_limits<size_t>::max();
  std::vector<size_t> linked(ends.size(), kNone);
  for (const auto& [gap, i, k] : gaps) {
    if (linked[i] == kNone && linked[k] == kNone) linked[i] = k, linked[k] = i;
  }
  std::vector<Chain> chains;
  std::vector<bool> used(lines.size(), false);
  const auto follow = [&](size_t end) {  // in through this end, out through the other
    Chain chain;
    while (end != kNone && !used[ends[end].line]) {
      used[ends[end].line] = true;
      chain.emplace_back(ends[end].line, ends[end].last);
      end = linked[end ^ 1];
    }
    if (!chain.empty()) chains.push_back(std::move(chain));
  };
  for (size_t e = 0; e < ends.size(); ++e) {
    if (linked[e] == kNone) follow(e);
  }
  for (size_t e = 0; e < ends.size(); ++e) follow(e);  // rings
  return chains;
}

// A chain put together as one river, before it is known to be one.
struct Course {
  std::vector<Point2> line;
  std::vector<Point3> shore;
  std::vector<double> bank;
  double noise = 0, length = 0, area = 0;
  bool forced = false, given = false;

  double width() const { return length > 0 ? area / length : 0; }
};

// Ascending.
std::vector<size_t> ReachesOf(const Chain& chain, const std::vector<ReachLine>& lines) {
  std::vector<size_t> reaches;
  for (const auto& [i, reversed] : chain) reaches.push_back(lines[i].reach);
  std::ranges::sort(reaches);
  reaches.erase(std::unique(reaches.begin(), reaches.end()), reaches.end());
  return reaches;
}

// Takes off the bend at the last end of a line.
void TakeOffBend(double bend, std::vector<Point2>& points) {
  double off = 0;
  while (points.size() > 2 && off < bend) {
    const Point2 last = points.back();
    points.pop_back();
    off += (last - points.back()).norm();
  }
}

Course CourseOf(const Chain& chain, std::span<const Reach> reaches, const std::vector<ReachLine>& lines) {
  Course course;
  for (const auto& [i, reversed] : chain) {
    const Centreline& line = lines[i].line;
    std::vector<Point2> points = line.points;
    if (!reversed) std::reverse(points.begin(), points.end());
    if (i != chain.front().first) TakeOffBend(kBentEnd * line.width, points);
    std::reverse(points.begin(), points.end());
    if (i != chain.back().first) TakeOffBend(kBentEnd * line.width, points);
    course.line.insert(course.line.end(), points.begin(), points.end());
    course.length += line.length;
    course.area += line.length * line.width;
  }
  std::vector<double> noises;
  for (const size_t r : ReachesOf(chain, lines)) {
    course.shore.insert(course.shore.end(), reaches[r].shore.begin(), reaches[r].shore.end());
    course.bank.insert(course.bank.end(), reaches[r].bank.begin(), reaches[r].bank.end());
    noises.push_back(reaches[r].noise);
  }
  const Reach& first = reaches[lines[chain[0].first].reach];
  course.forced = noises.size() == 1 && first.forced;
  if (HasGivenLine(first)) {
    course.given = true;
    course.line = first.centreline;
  }
  course.noise = Quantile(noises, 0.5);
  return course;
}

class RiverTest {
 public:
  RiverTest(const Course& course, const RiverProfile& profile, double tolerance)
      : course_(course), profile_(profile), tolerance_(tolerance) {
    for (const Point3& p : course.shore) {
      above_.push_back(p.z() - LevelAt(profile.water, p.head<2>(), kAnyStep));
    }
  }

  bool Falls() const { return profile_.fall > tolerance_ + Noise(kErrorOfLevel, kLeastAtStation); }

  bool Holds() const {
    if (course_.given) return true;
    if (profile_.fall > kSteepest * course_.length) return false;
    if (course_.forced) return Falls();
    return StationsAgree() && SidesAgree() && (profile_.fall <= kSteep * course_.length || IsSurelySteep()) &&
           FitLowLevel(above_, course_.noise).spread <= tolerance_ + 2 * course_.noise && BanksRise();
  }

 private:
  static constexpr double kAnyStep = 0x1p-20;  // metres

  double Noise(double factor, int64_t count) const {
    return std::min(tolerance_, kSure * factor * course_.noise / std::sqrt(static_cast<double>(count)));
  }

  // Ground may fall like that by chance, but seldom far, and evenly.
  bool IsSurelySteep() const {
    const auto known = std::ranges::count_if(
        profile_.stations, [](const RiverStation& s) { return !s.on_banks && s.count >= kLeastAtStation; });
    return profile_.straight && known >= kLeastWhereSteep;
  }

  bool StationsAgree() const {
    size_t count = 0, odd = 0, on_banks = 0;
    for (size_t k = 0; k < profile_.stations.size(); ++k) {
      const RiverStation& s = profile_.stations[k];
      if (s.on_banks) ++on_banks;
      if (s.on_banks || s.count < kLeastAtStation) continue;
      ++count;
      odd += std::abs(s.level - profile_.water.stations[k].z()) > tolerance_ + Noise(kErrorOfLevel, s.count);
    }
    return odd <= count / kOddStations && on_banks <= profile_.stations.size() / kBankStations;
  }

  // Where a quay runs along one shore, the other one has the level.
  bool SidesAgree() const {
    size_t same = 0, quays = 0, others = 0;
    for (const RiverStation& s : profile_.stations) {
      const int64_t least = std::min(s.left_count, s.right_count);
      if (s.on_banks || least < kLeastAtSide) continue;
      const double apart = std::abs(s.left - s.right);
      const bool agree = apart <= tolerance_ + std::sqrt(2) * Noise(kErrorOfLevel, least);
      ++(agree ? same : apart > kLeastQuay ? quays : others);
    }
    const size_t count = same + quays + others;
    return count >= 2 && same >= others && kAgreeing * same >= count;
  }

  bool BanksRise() const {
    std::vector<double> rises, above;
    std::vector<std::vector<double>> at(profile_.stations.size());
    for (size_t i = 0; i < above_.size(); ++i) {
      if (std::isnan(course_.bank[i])) continue;
      rises.push_back(course_.bank[i] - course_.shore[i].z());
      above.push_back(rises.back() + above_[i]);
      const PlaceOnLine place = NearestOnLine(profile_.water.stations, course_.shore[i].head<2>());
      at[place.piece + (place.along > 0.5 ? 1 : 0)].push_back(above.back());
    }
    if (rises.empty()) return false;
    size_t count = 0, odd = 0;
    for (const std::vector<double>& station : at) {
      if (std::ssize(station) < kLeastAtStation) continue;
      ++count;
      odd += Quantile(station, 0.5) < -std::min(tolerance_, tolerance_ / 2 + Noise(kErrorOfLevel, std::ssize(station)));
    }
    const double noise = Noise(kErrorOfRise, std::ssize(rises));
    return odd <= count / kOddStations && Quantile(rises, 0.5) > (rises.size() < kLongShore ? noise : -noise);
  }

  const Course& course_;
  const RiverProfile& profile_;
  const double tolerance_;
  std::vector<double> above_;  // of each shore point, over the profile
};

// A line that is given is one whatever the shape of the water.
Centreline GivenLine(const std::vector<Point2>& points) {
  Centreline line{points, 0, 0};
  for (size_t i = 1; i < points.size(); ++i) line.length += (points[i] - points[i - 1]).norm();
  return line;
}

std::vector<Centreline> LinesOf(const Reach& reach, double least_width) {
  if (HasGivenLine(reach)) return {GivenLine(reach.centreline)};
  if (reach.shore.size() < kLeastShore) return {};
  Eigen::AlignedBox2d box;
  for (const auto& [a, b] : reach.boundary) box.extend(a).extend(b);
  if (box.diagonal().norm() < kStation) return {};
  std::vector<Centreline> lines = FindCentrelines(reach.boundary, kStation);
  std::erase_if(lines, [&](const Centreline& line) {
    return (line.width < least_width && !reach.forced) || line.length < kLeastReach * line.width;
  });
  return lines;
}

// Reaches along one line that was given are one river, whatever lies between them; others are linked by their ends.
std::vector<Chain> ChainsOf(std::span<const Reach> reaches, const std::vector<ReachLine>& lines) {
  std::vector<Chain> given;
  std::vector<bool> is_free(lines.size(), true);
  for (size_t i = 0; i < lines.size(); ++i) {
    const Reach& reach = reaches[lines[i].reach];
    if (!HasGivenLine(reach)) continue;
    is_free[i] = false;
    const auto same = std::find_if(given.begin(), given.end(), [&](const Chain& chain) {
      return reaches[lines[chain[0].first].reach].centreline == reach.centreline;
    });
    Chain& chain = same == given.end() ? given.emplace_back() : *same;
    chain.emplace_back(i, false);
  }
  std::vector<Chain> chains = LinkLines(lines, is_free);
  chains.insert(chains.end(), given.begin(), given.end());
  return chains;
}

std::optional<River> RiverAlong(const Chain& chain, std::span<const Reach> reaches, const std::vector<ReachLine>& lines,
                                double tolerance) {
  const Course course = CourseOf(chain, reaches, lines);
  if (course.length < kLeastRiver * course.width()) return std::nullopt;
  River river;
  river.profile = FitRiver(course.line, course.shore, course.noise, {kStation, kLeastAtStation, tolerance});
  river.width = course.width();
  if (river.profile.stations.empty()) return std::nullopt;
  const RiverTest test(course, river.profile, tolerance);
  if (!test.Holds()) return std::nullopt;
  river.given = course.given;
  river.falls = chain.size() > 1 || test.Falls();
  river.reaches = ReachesOf(chain, lines);
  return river;
}

}  // namespace

std::vector<River> FindRivers(std::span<const Reach> reaches, double tolerance, double least_width) {
  std::vector<ReachLine> lines;
  for (size_t r = 0; r < reaches.size(); ++r) {
    for (Centreline& line : LinesOf(reaches[r], least_width)) lines.push_back({r, std::move(line)});
  }
  std::vector<River> rivers;
  std::vector<bool> taken(reaches.size(), false);
  const auto add = [&](const Chain& chain) {
    const std::vector<size_t> own = ReachesOf(chain, lines);
    if (std::ranges::any_of(own, [&](size_t r) { return taken[r]; })) return false;
    std::optional<River> river = RiverAlong(chain, reaches, lines, tolerance);
    if (!river) return false;
    for (const size_t r : own) taken[r] = true;
    rivers.push_back(*std::move(river));
    return true;
  };
  for (const Chain& chain : ChainsOf(reaches, lines)) {
    if (add(chain) || chain.size() == 1) continue;
    for (const auto& link : chain) add({link});
  }
  return rivers;
}

}  // namespace tilemend
