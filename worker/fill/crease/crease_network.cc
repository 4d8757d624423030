#include "worker/fill/crease/crease_network.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "worker/fill/crease/crease_measures.h"
#include "worker/fill/crease/rim_touches.h"

namespace tilemend {
namespace {

using Eigen::Vector3d;
using internal::AngleBetween;
using internal::kDegree;
using internal::Wrap;

// How far the normals of one smooth part may differ between two ends.
constexpr double kSamePart = 20 * kDegree;
// How far a crease may turn on its way, from each end to the chord, and the difference between the two.
constexpr double kMostTurn = 45 * kDegree;
// Creases that turn less are joined before corners are looked for, others after: at a corner each three of them might
// turn into one another.
constexpr double kGentleTurn = 15 * kDegree;
constexpr double kUnevenTurn = 15 * kDegree;
// Turns below this are noise of the normals: the crease is straight.
constexpr double kStraight = 6 * kDegree;
// Planes at a corner: as many rim vertices as this at each of their two ends; they are flat if their vertices lie this
// close to them, in edge lengths, and meet in a point if the volume that their normals span is at least this.
constexpr int32_t kPlaneReach = 24;
constexpr double kFlat = 0.15;
constexpr double kLeastCornerVolume = 0.15;
// Creases that meet in one point.
constexpr int32_t kMostAtACorner = 8;
// Creases of a rim, at most. One that bends more often is a coil, or rough: each pair of its ends would be looked at.
constexpr int32_t kMostEnds = 1000;
constexpr double kCornerAim = 20 * kDegree;

struct Plane {
  Vector3d normal;
  double offset = 0;  // normal . x
  double edge = 0;    // mean length of the rim's edges along it
};

// The point that three planes have in common, or more as nearly as they are flat; none if they do not meet in a clear
// one.
std::optional<Point3> Meet(std::span<const Plane> planes) {
  Eigen::MatrixX3d normals(std::ssize(planes), 3);
  Eigen::VectorXd offsets(std::ssize(planes));
  for (size_t k = 0; k < planes.size(); ++k) {
    normals.row(static_cast<Eigen::Index>(k)) = planes[k].normal.transpose();
    offsets[static_cast<Eigen::Index>(k)] = planes[k].offset;
  }
  // The squared volume; of more than three planes the sum over all three of them (Cauchy and Binet).
  const double squared = (normals.transpose() * normals).determinant();
  if (!(squared >= kLeastCornerVolume * kLeastCornerVolume)) return std::nullopt;
  const Point3 point = normals.colPivHouseholderQr().solve(offsets);
  const bool common = std::ranges::all_of(
      planes, [&](const Plane& p) { return std::abs(p.normal.dot(point) - p.offset) <= kFlat * p.edge; });
  return planes.size() == 3 || common ? std::optional(point) : std::nullopt;
}

// Whether place p lies on the way along a loop of n places from a to b, ends excluded.
bool Between(int32_t p, int32_t a, int32_t b, int32_t n) { return p != a && p != b && Wrap(p - a, n) < Wrap(b - a, n); }

class NetworkBuilder {
 public:
  NetworkBuilder(std::span<const RimLoop> loops, Bends bends) : loops_(loops) {
    network_.ends = FindCreaseEnds(loops, bends);
    used_.assign(network_.ends.size(), false);
  }

  CreaseNetwork Run() {
    if (Count() > kMostEnds) return {};
    JoinPairs(kGentleTurn);
    for (int32_t number = 3; number <= kMostAtACorner; ++number) JoinMeetings(number, 1);
    JoinMeetings(4, 2);
    JoinPairs(kMostTurn);
    SplitAtTouches();
    LeaveOutRimEdges();
    return std::move(network_);
  }

 private:
  const Point3& At(const CreaseEnd& end) const { return loops_[end.loop].positions[end.place]; }
  int32_t Count() const { return static_cast<int32_t>(network_.ends.size()); }

  std::optional<CreaseCurve> CurveBetween(int32_t from, int32_t to, double most_turn) const {
    const CreaseEnd &a = network_.ends[from], &b = network_.ends[to];
    const Vector3d chord = At(b) - At(a);
    const double turn_a = AngleBetween(a.tangent, chord), turn_b = AngleBetween(b.tangent, -chord);
    if (std::max(turn_a, turn_b) > most_turn || std::abs(turn_a - turn_b) > kUnevenTurn) return std::nullopt;
    const auto turn = Eigen::Quaterniond::FromTwoVectors(a.tangent, -b.tangent);
    if (AngleBetween(turn * a.after, b.before) > kSamePart || AngleBetween(turn * a.before, b.after) > kSamePart) {
      return std::nullopt;
    }
    CreaseCurve curve{from, to, At(a), At(b), chord, chord};
    if (std::max(turn_a, turn_b) > kStraight) {  // slopes of the cubic nearest to a circular arc
      curve.start_slope = 2 * chord.norm() / (1 + std::cos(turn_a)) * a.tangent;
      curve.finish_slope = -2 * chord.norm() / (1 + std::cos(turn_b)) * b.tangent;
    }
    return curve;
  }

  // The end that the rim comes to along the right side of curve c, which starts at an end: the curve's other end, or
  // the one that is reached by the next curve of its corner.
  int32_t PartnerOf(int32_t c) const {
    int32_t at = network_.curves[c].to;
    while (at < 0) {
      const auto& around = network_.corners[-1 - at].curves;
      c = around[(std::find(around.begin(), around.end(), c) - around.begin() + 1) % around.size()];
      at = network_.curves[c].to == at ? network_.curves[c].from : network_.curves[c].to;
    }
    return at;
  }

  // Whether a curve between two ends would cross one that has all its ends on the same loop.
  bool Crosses(int32_t from, int32_t to) const {
    const CreaseEnd &a = network_.ends[from], &b = network_.ends[to];
    if (a.loop != b.loop) return false;
    const int32_t n = loops_[a.loop].size();
    for (int32_t k = 0; k < static_cast<int32_t>(network_.curves.size()); ++k) {
      if (network_.curves[k].from < 0) continue;
      const CreaseEnd &c = network_.ends[network_.curves[k].from], &d = network_.ends[PartnerOf(k)];
      if (c.loop != a.loop || d.loop != a.loop) continue;
      if (Between(c.place, a.place, b.place, n) != Between(d.place, a.place, b.place, n)) return true;
    }
    return false;
  }

  void JoinPairs(double most_turn) {
    std::vector<std::pair<double, CreaseCurve>> candidates;
    for (int32_t a = 0; a < Count(); ++a) {
      for (int32_t b = a + 1; b < Count(); ++b) {
        const std::optional<CreaseCurve> curve = CurveBetween(a, b, most_turn);
        if (curve) candidates.emplace_back((curve->finish - curve->start).norm(), *curve);
      }
    }
    std::stable_sort(candidates.begin(), candidates.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    for (const auto& [length, curve] : candidates) {
      if (used_[curve.from] || used_[curve.to] || Crosses(curve.from, curve.to)) continue;
      used_[curve.from] = used_[curve.to] = true;
      network_.curves.push_back(curve);
    }
  }

  // The plane of the flat part that the rim borders on from one end to another. None if it is not flat.
  std::optional<Plane> PlaneBetween(const CreaseEnd& a, const CreaseEnd& b) const {
    if (AngleBetween(a.after, b.before) > kSamePart) return std::nullopt;
    const RimLoop& loop = loops_[a.loop];
    const int32_t n = loop.size(), length = Wrap(b.place - a.place, n), reach = std::min(kPlaneReach, length);
    const Vector3d facing = (a.after + b.before).normalized();
    std::vector<Point3> points;
    for (int32_t k = 0; k <= length; ++k) {
      const int32_t place = Wrap(a.place + k, n);
      const bool fits = AngleBetween(loop.outside[place], facing) < kSamePart ||
                        AngleBetween(loop.outside[Wrap(place - 1, n)], facing) < kSamePart;
      if (fits && (k <= reach || k >= length - reach)) points.push_back(loop.positions[place]);
    }
    if (points.empty()) return std::nullopt;
    Point3 middle = Point3::Zero();
    double edge = 0;
    for (const Point3& p : points) middle += p / static_cast<double>(points.size());
    Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
    for (const Point3& p : points) spread += (p - middle) * (p - middle).transpose();
    for (int32_t k = 0; k < length; ++k) {
      edge += (loop.positions[Wrap(a.place + k + 1, n)] - loop.positions[Wrap(a.place + k, n)]).norm() / length;
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(spread);  // eigenvalues ascending
    Vector3d normal = axes.eigenvectors().col(0);
    if (normal.dot(facing) < 0) normal = -normal;
    const auto count = static_cast<double>(points.size());
    const bool on_a_line = axes.eigenvalues()[1] <= count * std::pow(kFlat * edge, 2);
    if (on_a_line || AngleBetween(normal, facing) > kSamePart) normal = facing;
    const double off = std::sqrt(std::max(0.0, normal.dot(spread * normal)) / count);  // rounding goes below zero
    if (!(off <= kFlat * edge)) return std::nullopt;
    return Plane{normal, normal.dot(middle), edge};
  }

  // The angle by which an end aims past a corner.
  double MissOf(int32_t end, const Point3& corner) const {
    return AngleBetween(network_.ends[end].tangent, corner - At(network_.ends[end]));
  }

  // Neighbouring ends along a loop that meet inside the hole: in one corner; or four in two, the first two of them in
  // the first corner.
  struct Meeting {
    std::vector<int32_t> ends;
    std::vector<Point3> corners;
    double miss = 0;  // the largest
  };

  std::optional<Meeting> MeetingOf(const std::vector<int32_t>& ends, size_t corners) const {
    const size_t n = ends.size();
    std::vector<Plane> planes;  // after each end
    for (size_t k = 0; k < n; ++k) {
      const CreaseEnd &a = network_.ends[ends[k]], &b = network_.ends[ends[(k + 1) % n]];
      if (a.loop != b.loop || Crosses(ends[k], ends[(k + 1) % n])) return std::nullopt;
      const std::optional<Plane> plane = PlaneBetween(a, b);
      if (!plane) return std::nullopt;
      planes.push_back(*plane);
    }
    Meeting meeting{ends, {}, 0};
    for (size_t k = 0; k < corners; ++k) {  // planes around the ends 2k and 2k + 1, or around all
      const Plane around[] = {planes[(2 * k + n - 1) % n], planes[2 * k], planes[2 * k + 1]};
      const auto corner = corners == 1 ? Meet(planes) : Meet(around);
      if (!corner) return std::nullopt;
      meeting.corners.push_back(*corner);
    }
    for (size_t k = 0; k < n; ++k) {
      meeting.miss = std::max(meeting.miss, MissOf(ends[k], meeting.corners[corners == 1 ? 0 : k / 2]));
    }
    if (meeting.miss > kCornerAim) return std::nullopt;
    return meeting;
  }

  void JoinMeetings(int32_t number, size_t corners) {
    while (JoinMeeting(number, corners)) {
    }
  }

  // Joins that number of ends, neighbours among those left on their loop, that aim best at common corners, if any do.
  bool JoinMeeting(int32_t number, size_t corners) {
    std::vector<int32_t> left;
    for (int32_t e = 0; e < Count(); ++e) {
      if (!used_[e]) left.push_back(e);
    }
    const auto count = static_cast<int32_t>(left.size());
    std::optional<Meeting> best;
    for (int32_t k = 0; k < count && count >= number; ++k) {
      std::vector<int32_t> ends;
      for (int32_t i = 0; i < number; ++i) ends.push_back(left[(k + i) % count]);
      const std::optional<Meeting> meeting = MeetingOf(ends, corners);
      if (meeting && (!best || meeting->miss < best->miss)) best = meeting;
    }
    if (best) Join(*best);
    return best.has_value();
  }

  void Join(const Meeting& meeting) {
    const auto first = static_cast<int32_t>(network_.corners.size());
    for (const Point3& p : meeting.corners) network_.corners.push_back({p, {}});
    const bool two = meeting.corners.size() == 2;
    for (size_t k = 0; k < meeting.ends.size(); ++k) {
      const int32_t e = meeting.ends[k], corner = first + (two ? static_cast<int32_t>(k / 2) : 0);
      const Point3 start = At(network_.ends[e]), finish = network_.corners[corner].position;
      network_.corners[corner].curves.push_back(static_cast<int32_t>(network_.curves.size()));
      network_.curves.push_back({e, -1 - corner, start, finish, finish - start, finish - start});
      used_[e] = true;
    }
    if (!two) return;
    const Vector3d way = meeting.corners[1] - meeting.corners[0];
    for (const int32_t k : {0, 1}) {
      network_.corners[first + k].curves.push_back(static_cast<int32_t>(network_.curves.size()));
    }
    network_.curves.push_back({-1 - first, -2 - first, meeting.corners[0], meeting.corners[1], way, way});
  }

  bool HasEnd(const RimTouch& touch) const {
    return std::any_of(network_.ends.begin(), network_.ends.end(),
                       [&](const CreaseEnd& e) { return e.loop == touch.loop && e.place == touch.place; });
  }

  // Whether the rim at a touch of curve c lies to the right of it. The curve starts at an end.
  bool IsRight(const RimTouch& touch, int32_t c) const {
    const CreaseCurve& curve = network_.curves[c];
    const CreaseEnd& from = network_.ends[curve.from];
    const RimLoop& loop = loops_[touch.loop];
    const int32_t n = loop.size(), i = touch.place, to = PartnerOf(c);
    if (from.loop == touch.loop && network_.ends[to].loop == touch.loop) {
      return Between(i, from.place, network_.ends[to].place, n);
    }
    const Vector3d around = loop.positions[Wrap(i - 1, n)] + loop.positions[Wrap(i + 1, n)] - 2 * loop.positions[i];
    return around.dot((curve.finish - curve.start).cross(loop.outside[i])) > 0;
  }

  // Makes a vertex of the rim that lies on a curve a point of it: the curve becomes two that end there, one on either
  // side of the surface that touches it.
  void SplitAtTouches() {
    if (network_.curves.empty()) return;
    const RimTouches touches(loops_);
    for (size_t c = 0; c < network_.curves.size(); ++c) {
      while (network_.curves[c].from >= 0) {
        const auto touch = touches.FirstOn(network_.curves[c], [&](const RimTouch& t) { return HasEnd(t); });
        if (!touch) break;
        const CreaseCurve curve = network_.curves[c];
        const bool right = IsRight(*touch, static_cast<int32_t>(c));
        const Point3& p = loops_[touch->loop].positions[touch->place];
        const CreaseEnd& from = network_.ends[curve.from];
        const double t = touch->at;
        const Vector3d slope = curve.SlopeAt(t), way = slope.normalized();
        const CreaseEnd near{touch->loop, touch->place, right ? 0 : 1, from.after, from.before, -way};
        const CreaseEnd far{touch->loop, touch->place, right ? 1 : 0, from.before, from.after, way};
        network_.ends.push_back(near);
        network_.ends.push_back(far);
        network_.curves[c] = {curve.from, Count() - 2, curve.start, p, t * curve.start_slope, t * slope};
        network_.curves.push_back(
            {Count() - 1, curve.to, p, curve.finish, (1 - t) * slope, (1 - t) * curve.finish_slope});
        if (curve.to >= 0) continue;
        for (int32_t& k : network_.corners[-1 - curve.to].curves) {
          if (k == static_cast<int32_t>(c)) k = static_cast<int32_t>(network_.curves.size()) - 1;
        }
      }
    }
  }

  bool IsRimEdge(const CreaseCurve& curve) const {
    if (curve.from < 0 || curve.to < 0) return false;
    const CreaseEnd &a = network_.ends[curve.from], &b = network_.ends[curve.to];
    const int32_t way = Wrap(a.place - b.place, loops_[a.loop].size());
    return a.loop == b.loop && (way == 1 || way == loops_[a.loop].size() - 1);
  }

  // A curve along a single edge of the rim parts nothing.
  void LeaveOutRimEdges() {
    std::vector<CreaseCurve> kept;
    std::vector<int32_t> number;
    for (const CreaseCurve& curve : network_.curves) {
      number.push_back(static_cast<int32_t>(kept.size()));
      if (!IsRimEdge(curve)) kept.push_back(curve);
    }
    network_.curves = std::move(kept);
    for (CreaseCorner& corner : network_.corners) {
      for (int32_t& c : corner.curves) c = number[c];
    }
  }

  std::span<const RimLoop> loops_;
  CreaseNetwork network_;
  std::vector<bool> used_;  // per end
};

}  // namespace

Point3 CreaseCurve::At(double t) const {
  const double s = 1 - t;
  return s * s * (1 + 2 * t) * start + s * s * t * start_slope + t * t * (1 + 2 * s) * finish -
         t * t * s * finish_slope;
}

Vector3d CreaseCurve::SlopeAt(double t) const {
  const double s = 1 - t;
  return 6 * s * t * (finish - start) + s * (s - 2 * t) * start_slope + t * (t - 2 * s) * finish_slope;
}

CreaseNetwork FindCreases(std::span<const RimLoop> loops, Bends bends) { return NetworkBuilder(loops, bends).Run(); }

}  // namespace tilemend
