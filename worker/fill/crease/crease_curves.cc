#include "worker/fill/crease/crease_curves.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <tuple>

namespace tilemend {
namespace {

using Eigen::Vector3d;

constexpr double kDegree = std::numbers::pi / 180;
// Vertex noise of 1 % of the edge length turns normals by a few degrees; edges of buildings mostly have 90.
constexpr double kLeastCreaseAngle = 30 * kDegree;
// Numbers of rim edges that are looked at on either side: the short one for small parts, the long one outvotes bites
// of a triangle or two along a crease.
constexpr std::array<int32_t, 2> kReaches = {4, 8};
// Of half that angle: no two normals that are nearer than this to a third make a crease.
constexpr double kSmoothCosine = 0.966;
// At a crease all normals are near one of two. Their mean angle to the nearer of the two, as a share of the angle
// between the two: 0 between planes, 1/4 where the bend is spread evenly (a round wall).
constexpr double kMostSpread = 0.125;
// How well a place parts the normals of the two: 1 if they change there once for all, less where the rim weaves about
// the crease, 0 if they are mixed alike on both sides.
constexpr double kLeastSharpness = 0.4;
// Places closer together than this show one crease.
constexpr int32_t kApart = 3;
// A vertex is on a crease if it is this close to both planes, in edge lengths.
constexpr double kOnCrease = 0.25;
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
// Pieces of a curve when distances from it are measured.
constexpr int kCurvePieces = 64;
constexpr double kCornerAim = 20 * kDegree;

double AngleBetween(const Vector3d& a, const Vector3d& b) { return std::atan2(a.cross(b).norm(), a.dot(b)); }

// The members of a cyclic sequence by any index.
int32_t Wrap(int32_t i, int32_t n) { return ((i % n) + n) % n; }

// A bend of the surface at a place of the rim, seen over `reach` edges on either side.
struct Bend {
  int32_t place = 0;
  int32_t reach = 0;
  double angle = 0;
  double sharpness = 0;
  Vector3d before, after;
};

class EndFinder {
 public:
  EndFinder(const RimLoop& loop, int32_t number) : loop_(loop), number_(number), n_(loop.size()) {}

  std::vector<FeatureEnd> Run() {
    std::vector<Bend> bends = SharpBends();
    std::vector<FeatureEnd> ends;
    for (size_t k = 0; k < bends.size(); ++k) {
      const int32_t back = Wrap(bends[k].place - bends[Wrap(static_cast<int32_t>(k) - 1, Count(bends))].place, n_);
      const int32_t on = Wrap(bends[Wrap(static_cast<int32_t>(k) + 1, Count(bends))].place - bends[k].place, n_);
      AddEnds(bends[k], back > 0 ? back : n_ / 2, on > 0 ? on : n_ / 2, ends);
    }
    std::sort(ends.begin(), ends.end(), [](const auto& a, const auto& b) { return a.place < b.place; });
    const auto same = [](const auto& a, const auto& b) { return a.place == b.place; };
    ends.erase(std::unique(ends.begin(), ends.end(), same), ends.end());
    return ends;
  }

 private:
  static int32_t Count(const std::vector<Bend>& bends) { return static_cast<int32_t>(bends.size()); }
  const Vector3d& Normal(int32_t edge) const { return loop_.outside[Wrap(edge, n_)]; }
  const Point3& At(int32_t place) const { return loop_.positions[Wrap(place, n_)]; }
  double Length(int32_t edge) const { return (At(edge + 1) - At(edge)).norm(); }

  // The normal among edges [begin, end) with the least sum of angles to the others, and that sum.
  std::pair<Vector3d, double> Middle(int32_t begin, int32_t end) const {
    std::pair<Vector3d, double> best{Vector3d::Zero(), INFINITY};
    for (int32_t m = begin; m < end; ++m) {
      double sum = 0;
      for (int32_t e = begin; e < end; ++e) sum += AngleBetween(Normal(m), Normal(e));
      if (sum < best.second) best = {Normal(m), sum};
    }
    return best;
  }

  // Most places are on smooth surface: all normals near that of the place itself.
  bool IsSmooth(int32_t place, int32_t reach) const {
    for (int32_t e = place - reach; e < place + reach; ++e) {
      if (Normal(e).dot(Normal(place)) < kSmoothCosine) return false;
    }
    return true;
  }

  Bend BendAt(int32_t place, int32_t reach) const {
    const auto before = Middle(place - reach, place), after = Middle(place, place + reach);
    Bend bend{place, reach, AngleBetween(before.first, after.first), 0, before.first, after.first};
    if (bend.angle < kLeastCreaseAngle) return bend;
    double off = 0;
    for (int32_t e = place - reach; e < place + reach; ++e) {
      off += std::min(AngleBetween(Normal(e), bend.before), AngleBetween(Normal(e), bend.after));
    }
    if (off > kMostSpread * 2 * reach * bend.angle) return bend;
    const double together = Middle(place - reach, place + reach).second;
    bend.sharpness = (together - before.second - after.second) / (reach * bend.angle);
    return bend;
  }

  // Sharp bends in order of place, the sharpest of those that lie close together.
  std::vector<Bend> SharpBends() const {
    std::vector<Bend> sharp;
    for (int32_t i = 0; i < n_; ++i) {
      std::optional<Bend> best;
      for (const int32_t reach : kReaches) {
        if (2 * reach > n_ || IsSmooth(i, reach)) continue;
        const Bend bend = BendAt(i, reach);
        if (bend.sharpness >= kLeastSharpness && (!best || bend.sharpness > best->sharpness)) best = bend;
      }
      if (best) sharp.push_back(*best);
    }
    std::stable_sort(sharp.begin(), sharp.end(),
                     [](const Bend& a, const Bend& b) { return a.sharpness * a.angle > b.sharpness * b.angle; });
    std::vector<Bend> chosen;
    for (const Bend& b : sharp) {
      const bool apart = std::all_of(chosen.begin(), chosen.end(), [&](const Bend& c) {
        return std::min(Wrap(b.place - c.place, n_), Wrap(c.place - b.place, n_)) >= kApart;
      });
      if (apart) chosen.push_back(b);
    }
    std::sort(chosen.begin(), chosen.end(), [](const Bend& a, const Bend& b) { return a.place < b.place; });
    return chosen;
  }

  // The planes of a crease near the rim and the line where they meet.
  struct Crease {
    Vector3d before, after;      // unit normals
    Point3 on_before, on_after;  // points of the planes
    Vector3d tangent;            // into the hole
    double edge = 0;             // mean length
  };

  // Mean normal and position of the edges of [begin, end) that face like `like`.
  std::pair<Vector3d, Point3> PlaneOf(int32_t begin, int32_t end, const Vector3d& like, double tolerance) const {
    Vector3d normal = Vector3d::Zero();
    Point3 sum = Point3::Zero();
    double weight = 0;
    for (int32_t e = begin; e < end; ++e) {
      if (AngleBetween(Normal(e), like) > tolerance) continue;
      const double length = Length(e);
      normal += length * Normal(e);
      sum += length / 2 * (At(e) + At(e + 1));
      weight += length;
    }
    return {normal.normalized(), sum / weight};
  }

  // None if the rim does not cross the crease from one plane to the other, or the two disagree on which side the hole
  // is.
  std::optional<Crease> CreaseOf(const Bend& bend, int32_t back, int32_t on) const {
    Crease c;
    std::tie(c.before, c.on_before) = PlaneOf(bend.place - back, bend.place, bend.before, bend.angle / 2);
    std::tie(c.after, c.on_after) = PlaneOf(bend.place, bend.place + on, bend.after, bend.angle / 2);
    const Vector3d line = c.before.cross(c.after).normalized();
    if (!line.allFinite() || !c.on_before.allFinite() || !c.on_after.allFinite()) return std::nullopt;
    const Point3& p = At(bend.place);
    for (int32_t e = bend.place - back; e < bend.place + on; ++e) c.edge += Length(e) / (back + on);
    // The hole is to the left of the way across the crease. One of the two is about zero where the rim runs along it.
    const double from = c.before.cross(p - c.on_before).dot(line), to = c.after.cross(c.on_after - p).dot(line);
    c.tangent = from + to > 0 ? line : Vector3d(-line);
    const double contrary = from + to > 0 ? -std::min(from, to) : std::max(from, to);
    if (contrary > kOnCrease * c.edge) return std::nullopt;
    return c;
  }

  bool IsOn(const Crease& c, int32_t place) const {
    return std::abs(c.before.dot(At(place) - c.on_before)) <= kOnCrease * c.edge &&
           std::abs(c.after.dot(At(place) - c.on_after)) <= kOnCrease * c.edge;
  }

  // On which side of the crease the hole is at each edge: 1 after, -1 before; unknown sides are those of the edge
  // before. It is the side of the surface beside the edge, except on the way along the crease from one side to the
  // other: there the crease goes on into the hole at the far end.
  std::vector<int> Sides(const Crease& c) const {
    std::vector<int> sides;
    for (int32_t e = 0; e < n_; ++e) {
      const double before = AngleBetween(Normal(e), c.before), after = AngleBetween(Normal(e), c.after);
      const bool known = std::min(before, after) <= AngleBetween(c.before, c.after) / 2;
      sides.push_back(known ? (after < before ? 1 : -1) : 0);
    }
    for (int32_t e = 1; e < 2 * n_; ++e) {
      if (sides[Wrap(e, n_)] == 0) sides[Wrap(e, n_)] = sides[Wrap(e - 1, n_)];
    }
    const std::vector<int> beside = sides;
    const auto along = [&](int32_t e) { return IsOn(c, e) && IsOn(c, e + 1); };
    for (int32_t e = 0; e < n_; ++e) {
      if (!along(e) || along(e - 1)) continue;
      int32_t end = e;
      while (end < e + n_ && along(end)) ++end;
      if (beside[Wrap(e - 1, n_)] == beside[Wrap(end, n_)]) continue;
      for (int32_t k = e; k < end; ++k) sides[Wrap(k, n_)] = -beside[Wrap(k, n_)];
    }
    return sides;
  }

  // One end where the rim crosses the crease once; where it weaves about the crease, one for each time that it crosses.
  //   back, on  edges to the neighbouring bends
  void AddEnds(const Bend& bend, int32_t back, int32_t on, std::vector<FeatureEnd>& ends) const {
    back = std::min(back, bend.reach);
    on = std::min(on, bend.reach);
    const std::optional<Crease> crease = CreaseOf(bend, back, on);
    if (!crease) return;
    const std::vector<int> sides = Sides(*crease);
    std::vector<FeatureEnd> crossings;
    for (int32_t e = 0; e < n_; ++e) {
      const int side = sides[e];
      if (side == sides[Wrap(e - 1, n_)]) continue;
      if (IsOn(*crease, e)) {
        crossings.push_back(EndAt(*crease, e, side));
      } else if (Wrap(e - bend.place + back, n_) < back + on) {  // no vertex of the rim is on the crease
        ends.push_back(EndAt(*crease, bend.place, 1));
        return;
      }
    }
    ends.insert(ends.end(), crossings.begin(), crossings.end());
  }

  // The end at a place where the rim crosses a crease to the side given.
  FeatureEnd EndAt(const Crease& c, int32_t place, int side) const {
    place = Wrap(place, n_);
    if (side > 0) return {number_, place, 0, c.before, c.after, c.tangent};
    return {number_, place, 0, c.after, c.before, -c.tangent};
  }

  const RimLoop& loop_;
  const int32_t number_, n_;
};

class NetworkBuilder {
 public:
  explicit NetworkBuilder(std::span<const RimLoop> loops) : loops_(loops) {
    network_.ends = FindFeatureEnds(loops);
    used_.assign(network_.ends.size(), false);
  }

  FeatureNetwork Run() {
    JoinPairs(kGentleTurn);
    for (const int32_t number : {3, 4}) {
      while (JoinMeeting(number)) {
      }
    }
    JoinPairs(kMostTurn);
    SplitAtTouches();
    LeaveOutRimEdges();
    return std::move(network_);
  }

 private:
  const Point3& At(const FeatureEnd& end) const { return loops_[end.loop].positions[end.place]; }
  int32_t Count() const { return static_cast<int32_t>(network_.ends.size()); }

  std::optional<FeatureCurve> CurveBetween(int32_t from, int32_t to, double most_turn) const {
    const FeatureEnd &a = network_.ends[from], &b = network_.ends[to];
    const Vector3d chord = At(b) - At(a);
    const double turn_a = AngleBetween(a.tangent, chord), turn_b = AngleBetween(b.tangent, -chord);
    if (std::max(turn_a, turn_b) > most_turn || std::abs(turn_a - turn_b) > kUnevenTurn) return std::nullopt;
    const auto turn = Eigen::Quaterniond::FromTwoVectors(a.tangent, -b.tangent);
    if (AngleBetween(turn * a.after, b.before) > kSamePart || AngleBetween(turn * a.before, b.after) > kSamePart) {
      return std::nullopt;
    }
    FeatureCurve curve{from, to, At(a), At(b), chord, chord};
    if (std::max(turn_a, turn_b) > kStraight) {  // slopes of the cubic nearest to a circular arc
      curve.start_slope = 2 * chord.norm() / (1 + std::cos(turn_a)) * a.tangent;
      curve.finish_slope = -2 * chord.norm() / (1 + std::cos(turn_b)) * b.tangent;
    }
    return curve;
  }

  // Whether place p lies on the way along a loop of n places from a to b, ends excluded.
  static bool Between(int32_t p, int32_t a, int32_t b, int32_t n) {
    return p != a && p != b && Wrap(p - a, n) < Wrap(b - a, n);
  }

  // The end that the rim comes to along the right side of curve c, which starts at an end: the curve's other end, or
  // the one that is reached by the next curve of its corner.
  int32_t PartnerOf(int32_t c) const {
    int32_t at = network_.curves[c].to;
    while (at < 0) {
      const auto& around = network_.corners[-1 - at].curves;
      c = around[(std::find(around.begin(), around.end(), c) - around.begin() + 1) % 3];
      at = network_.curves[c].to == at ? network_.curves[c].from : network_.curves[c].to;
    }
    return at;
  }

  // Whether a curve between two ends would cross one that has all its ends on the same loop.
  bool Crosses(int32_t from, int32_t to) const {
    const FeatureEnd &a = network_.ends[from], &b = network_.ends[to];
    if (a.loop != b.loop) return false;
    const int32_t n = loops_[a.loop].size();
    for (int32_t k = 0; k < static_cast<int32_t>(network_.curves.size()); ++k) {
      if (network_.curves[k].from < 0) continue;
      const FeatureEnd &c = network_.ends[network_.curves[k].from], &d = network_.ends[PartnerOf(k)];
      if (c.loop != a.loop || d.loop != a.loop) continue;
      if (Between(c.place, a.place, b.place, n) != Between(d.place, a.place, b.place, n)) return true;
    }
    return false;
  }

  void JoinPairs(double most_turn) {
    std::vector<std::pair<double, FeatureCurve>> candidates;
    for (int32_t a = 0; a < Count(); ++a) {
      for (int32_t b = a + 1; b < Count(); ++b) {
        const std::optional<FeatureCurve> curve = CurveBetween(a, b, most_turn);
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

  struct Plane {
    Vector3d normal;
    double offset = 0;  // normal . x
  };

  // The plane of the flat part that the rim borders on from one end to another. None if it is not flat.
  std::optional<Plane> PlaneBetween(const FeatureEnd& a, const FeatureEnd& b) const {
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
    if (AngleBetween(normal, facing) > kSamePart) normal = facing;  // the vertices lie on a line
    const double off = std::sqrt(normal.dot(spread * normal) / static_cast<double>(points.size()));
    if (!(off <= kFlat * edge)) return std::nullopt;
    return Plane{normal, normal.dot(middle)};
  }

  // The point that three planes have in common; none if they do not meet in a clear one.
  static std::optional<Point3> Meet(const Plane& a, const Plane& b, const Plane& c) {
    Eigen::Matrix3d normals;
    normals << a.normal.transpose(), b.normal.transpose(), c.normal.transpose();
    if (std::abs(normals.determinant()) < kLeastCornerVolume) return std::nullopt;
    return Point3(normals.partialPivLu().solve(Vector3d(a.offset, b.offset, c.offset)));
  }

  // The angle by which an end aims past a corner.
  double MissOf(int32_t end, const Point3& corner) const {
    return AngleBetween(network_.ends[end].tangent, corner - At(network_.ends[end]));
  }

  // Neighbouring ends along a loop that meet inside the hole: three in one corner; four in two, the first two of them
  // in the first corner.
  struct Meeting {
    std::vector<int32_t> ends;
    std::vector<Point3> corners;
    double miss = 0;  // the largest
  };

  std::optional<Meeting> MeetingOf(const std::vector<int32_t>& ends) const {
    const size_t n = ends.size();
    std::vector<Plane> planes;  // after each end
    for (size_t k = 0; k < n; ++k) {
      const FeatureEnd &a = network_.ends[ends[k]], &b = network_.ends[ends[(k + 1) % n]];
      if (a.loop != b.loop || Crosses(ends[k], ends[(k + 1) % n])) return std::nullopt;
      const std::optional<Plane> plane = PlaneBetween(a, b);
      if (!plane) return std::nullopt;
      planes.push_back(*plane);
    }
    Meeting meeting{ends, {}, 0};
    for (size_t k = 0; k + 2 < n; ++k) {  // planes around the ends 2k and 2k + 1, or around all three
      const auto corner = Meet(planes[(2 * k + n - 1) % n], planes[2 * k], planes[2 * k + 1]);
      if (!corner) return std::nullopt;
      meeting.corners.push_back(*corner);
    }
    for (size_t k = 0; k < n; ++k) {
      meeting.miss = std::max(meeting.miss, MissOf(ends[k], meeting.corners[n == 3 ? 0 : k / 2]));
    }
    if (meeting.miss > kCornerAim) return std::nullopt;
    return meeting;
  }

  // Joins that number of ends, neighbours among those left on their loop, that aim best at common corners, if any do.
  bool JoinMeeting(int32_t number) {
    std::vector<int32_t> left;
    for (int32_t e = 0; e < Count(); ++e) {
      if (!used_[e]) left.push_back(e);
    }
    const auto count = static_cast<int32_t>(left.size());
    std::optional<Meeting> best;
    for (int32_t k = 0; k < count && count >= number; ++k) {
      std::vector<int32_t> ends;
      for (int32_t i = 0; i < number; ++i) ends.push_back(left[(k + i) % count]);
      const std::optional<Meeting> meeting = MeetingOf(ends);
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
      network_.corners[corner].curves[two ? k % 2 : k] = static_cast<int32_t>(network_.curves.size());
      network_.curves.push_back({e, -1 - corner, start, finish, finish - start, finish - start});
      used_[e] = true;
    }
    if (!two) return;
    const Vector3d way = meeting.corners[1] - meeting.corners[0];
    for (const int32_t k : {0, 1}) {
      network_.corners[first + k].curves[2] = static_cast<int32_t>(network_.curves.size());
    }
    network_.curves.push_back({-1 - first, -2 - first, meeting.corners[0], meeting.corners[1], way, way});
  }

  // A place where the rim touches a curve without crossing it.
  struct Touch {
    int32_t loop = 0, place = 0;
    double at = 0;  // of the curve's [0, 1]
  };

  bool HasEnd(const Touch& touch) const {
    return std::any_of(network_.ends.begin(), network_.ends.end(),
                       [&](const FeatureEnd& e) { return e.loop == touch.loop && e.place == touch.place; });
  }

  // The first place of the rim that lies on a curve and is no end.
  std::optional<Touch> TouchOf(const FeatureCurve& curve) const {
    std::vector<Point3> line;
    for (int k = 0; k <= kCurvePieces; ++k) line.push_back(curve.At(static_cast<double>(k) / kCurvePieces));
    for (size_t l = 0; l < loops_.size(); ++l) {
      const int32_t n = loops_[l].size();
      for (int32_t i = 0; i < n; ++i) {
        const Point3& p = loops_[l].positions[i];
        const double edges =
            (loops_[l].positions[Wrap(i + 1, n)] - p).norm() + (loops_[l].positions[Wrap(i - 1, n)] - p).norm();
        const auto [at, distance] = Nearest(line, p);
        const Touch touch{static_cast<int32_t>(l), i, at};
        if (distance <= kOnCrease * edges / 2 && !HasEnd(touch)) return touch;
      }
    }
    return std::nullopt;
  }

  // Where a curve, given by points at even parameters, comes nearest to p, and how near.
  static std::pair<double, double> Nearest(const std::vector<Point3>& line, const Point3& p) {
    std::pair<double, double> nearest{0, INFINITY};
    for (size_t k = 0; k + 1 < line.size(); ++k) {
      const Vector3d way = line[k + 1] - line[k];
      const double t = std::clamp((p - line[k]).dot(way) / way.squaredNorm(), 0.0, 1.0);
      const double distance = (p - line[k] - t * way).norm();
      if (distance < nearest.second) nearest = {(static_cast<double>(k) + t) / kCurvePieces, distance};
    }
    return nearest;
  }

  // Whether the rim at a touch of curve c lies to the right of it. The curve starts at an end.
  bool IsRight(const Touch& touch, int32_t c) const {
    const FeatureCurve& curve = network_.curves[c];
    const FeatureEnd& from = network_.ends[curve.from];
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
    for (size_t c = 0; c < network_.curves.size(); ++c) {
      while (network_.curves[c].from >= 0) {
        const std::optional<Touch> touch = TouchOf(network_.curves[c]);
        if (!touch) break;
        const FeatureCurve curve = network_.curves[c];
        const bool right = IsRight(*touch, static_cast<int32_t>(c));
        const Point3& p = loops_[touch->loop].positions[touch->place];
        const FeatureEnd& from = network_.ends[curve.from];
        const double t = touch->at;
        const Vector3d slope = curve.SlopeAt(t), way = slope.normalized();
        const FeatureEnd near{touch->loop, touch->place, right ? 0 : 1, from.after, from.before, -way};
        const FeatureEnd far{touch->loop, touch->place, right ? 1 : 0, from.before, from.after, way};
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

  bool IsRimEdge(const FeatureCurve& curve) const {
    if (curve.from < 0 || curve.to < 0) return false;
    const FeatureEnd &a = network_.ends[curve.from], &b = network_.ends[curve.to];
    const int32_t way = Wrap(a.place - b.place, loops_[a.loop].size());
    return a.loop == b.loop && (way == 1 || way == loops_[a.loop].size() - 1);
  }

  // A curve along a single edge of the rim parts nothing.
  void LeaveOutRimEdges() {
    std::vector<FeatureCurve> kept;
    std::vector<int32_t> number;
    for (const FeatureCurve& curve : network_.curves) {
      number.push_back(static_cast<int32_t>(kept.size()));
      if (!IsRimEdge(curve)) kept.push_back(curve);
    }
    network_.curves = std::move(kept);
    for (FeatureCorner& corner : network_.corners) {
      for (int32_t& c : corner.curves) c = number[c];
    }
  }

  std::span<const RimLoop> loops_;
  FeatureNetwork network_;
  std::vector<bool> used_;  // per end
};

}  // namespace

Point3 FeatureCurve::At(double t) const {
  const double s = 1 - t;
  return s * s * (1 + 2 * t) * start + s * s * t * start_slope + t * t * (1 + 2 * s) * finish -
         t * t * s * finish_slope;
}

Vector3d FeatureCurve::SlopeAt(double t) const {
  const double s = 1 - t;
  return 6 * s * t * (finish - start) + s * (s - 2 * t) * start_slope + t * (t - 2 * s) * finish_slope;
}

std::vector<FeatureEnd> FindFeatureEnds(std::span<const RimLoop> loops) {
  std::vector<FeatureEnd> ends;
  for (size_t l = 0; l < loops.size(); ++l) {
    const std::vector<FeatureEnd> found = EndFinder(loops[l], static_cast<int32_t>(l)).Run();
    ends.insert(ends.end(), found.begin(), found.end());
  }
  return ends;
}

FeatureNetwork FindFeatures(std::span<const RimLoop> loops) { return NetworkBuilder(loops).Run(); }

}  // namespace tilemend
