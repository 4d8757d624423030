#include "worker/fill/crease/crease_ends.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <tuple>
#include <utility>

#include "worker/fill/crease/crease_measures.h"

namespace tilemend {
namespace {

using Eigen::Vector3d;
using internal::AngleBetween;
using internal::kDegree;
using internal::kOnCrease;
using internal::Wrap;

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
// Of that angle: how much of it is between two neighbouring edges of the rim, where it must be at one edge.
constexpr double kLeastStep = 0.5;
// How well a place parts the normals of the two: 1 if they change there once for all, less where the rim weaves about
// the crease, 0 if they are mixed alike on both sides.
constexpr double kLeastSharpness = 0.4;
// Places closer together than this show one crease.
constexpr int32_t kApart = 3;

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
  EndFinder(const RimLoop& loop, int32_t number, Bends bends)
      : loop_(loop), number_(number), n_(loop.size()), bends_(bends) {}

  std::vector<CreaseEnd> Run() {
    std::vector<Bend> bends = SharpBends();
    std::vector<CreaseEnd> ends;
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

  // The largest angle between neighbours of the edges [begin, end).
  double LargestStep(int32_t begin, int32_t end) const {
    double largest = 0;
    for (int32_t e = begin; e + 1 < end; ++e) largest = std::max(largest, AngleBetween(Normal(e), Normal(e + 1)));
    return largest;
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
    if (bends_ == Bends::kAtOneEdge && LargestStep(place - reach, place + reach) < kLeastStep * bend.angle) return bend;
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
  void AddEnds(const Bend& bend, int32_t back, int32_t on, std::vector<CreaseEnd>& ends) const {
    back = std::min(back, bend.reach);
    on = std::min(on, bend.reach);
    const std::optional<Crease> crease = CreaseOf(bend, back, on);
    if (!crease) return;
    const std::vector<int> sides = Sides(*crease);
    std::vector<CreaseEnd> crossings;
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
  CreaseEnd EndAt(const Crease& c, int32_t place, int side) const {
    place = Wrap(place, n_);
    if (side > 0) return {number_, place, 0, c.before, c.after, c.tangent};
    return {number_, place, 0, c.after, c.before, -c.tangent};
  }

  const RimLoop& loop_;
  const int32_t number_, n_;
  const Bends bends_;
};

}  // namespace

std::vector<CreaseEnd> FindCreaseEnds(std::span<const RimLoop> loops, Bends bends) {
  std::vector<CreaseEnd> ends;
  for (size_t l = 0; l < loops.size(); ++l) {
    const std::vector<CreaseEnd> found = EndFinder(loops[l], static_cast<int32_t>(l), bends).Run();
    ends.insert(ends.end(), found.begin(), found.end());
  }
  return ends;
}

}  // namespace tilemend
