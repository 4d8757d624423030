#include "worker/check/tile_joins.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include "common/mesh/segment_distance.h"
#include "common/mesh/triangle_shape.h"

namespace tilemend {
namespace {

constexpr double kSteepReach = 0.05;                   // metres: a wall has no surface above or below a point beside it
constexpr double kSteep = 0.05;                        // upward part of the normal, below which a triangle is a wall
constexpr double kSteeperThan45 = 0.7071067811865476;  // the same, of 45 degrees
constexpr double kBeside = 0.002;  // metres, to either side of an edge: coordinates of text files are rounded

Eigen::AlignedBox3d FlatBoxOf(const SpaceTriangle& t) {
  Eigen::AlignedBox3d box;
  for (const Point3& p : t) box.extend(Point3(p.x(), p.y(), 0));
  return box;
}

bool IsSteep(const Eigen::Vector3d& normal) { return std::abs(normal.z()) <= kSteep * normal.norm(); }

// The height of the triangle's plane above p, where p lies in it seen from above; infinity elsewhere.
double HeightAbove(const SpaceTriangle& t, const Point3& p) {
  const Eigen::Vector3d normal = TwiceVectorArea(t);
  if (IsSteep(normal)) {
    Eigen::AlignedBox3d box(t[0]);
    box.extend(t[1]);
    box.extend(t[2]);
    const bool beside = (p.head<2>().array() >= box.min().head<2>().array() - kSteepReach).all() &&
                        (p.head<2>().array() <= box.max().head<2>().array() + kSteepReach).all();
    return beside ? std::clamp(p.z(), box.min().z(), box.max().z()) - p.z() : INFINITY;
  }
  for (int k = 0; k < 3; ++k) {
    const Point3 &a = t[k], &b = t[(k + 1) % 3];
    const double side = (b.x() - a.x()) * (p.y() - a.y()) - (b.y() - a.y()) * (p.x() - a.x());
    const double slack = 1e-6 * (b - a).norm();  // a micrometre beside the edge is on it
    if (side * (normal.z() > 0 ? 1 : -1) < -slack) return INFINITY;
  }
  return normal.dot(t[0] - p) / normal.z();
}

double DistanceToTriangle(const Point3& p, const SpaceTriangle& t) {
  const Eigen::Vector3d normal = TwiceVectorArea(t).normalized();
  double nearest = INFINITY;
  bool is_beside = true;
  for (int k = 0; k < 3; ++k) {
    const Point3 &a = t[k], &b = t[(k + 1) % 3];
    nearest = std::min(nearest, DistanceToSegment(p, a, b));
    is_beside = is_beside && (b - a).cross(p - a).dot(normal) >= 0;
  }
  return is_beside ? std::min(nearest, std::abs(normal.dot(p - t[0]))) : nearest;
}

}  // namespace

BorderStrip::BorderStrip(std::vector<SpaceTriangle> triangles, std::vector<bool> inner)
    : triangles_(std::move(triangles)), inner_(std::move(inner)) {
  std::vector<Eigen::AlignedBox3d> boxes;
  for (const SpaceTriangle& t : triangles_) boxes.push_back(FlatBoxOf(t));
  tree_ = BoxTree(boxes);
}

BorderStrip::Nearest BorderStrip::NearestBeside(const Point3& p, const Point3& a, const Point3& b) const {
  Nearest nearest;
  double best = INFINITY;
  const Point3 flat(p.x(), p.y(), 0), reach(kSteepReach, kSteepReach, 0);
  tree_.AnyMeeting({flat - reach, flat + reach}, [&](int32_t t) {
    const auto ends = std::count_if(triangles_[t].begin(), triangles_[t].end(),
                                    [&](const Point3& corner) { return corner == a || corner == b; });
    if (a != b && (ends > 1 || (ends > 0 && IsSteep(TwiceVectorArea(triangles_[t]))))) return false;
    const double height = HeightAbove(triangles_[t], p);
    if (std::abs(height) < best) {
      best = std::abs(height);
      nearest = {true, inner_[t], height};
    }
    return false;
  });
  return nearest;
}

bool BorderStrip::EndsAt(const Point3& p) const {
  const Point3 flat(p.x(), p.y(), 0), reach(kCoverReach, kCoverReach, 0);
  return tree_.AnyMeeting({flat - reach, flat + reach}, [&](int32_t t) {
    const Eigen::Vector3d normal = TwiceVectorArea(triangles_[t]);
    const bool is_upright = std::abs(normal.z()) < kSteeperThan45 * normal.norm();
    const double away = is_upright ? DistanceToTriangle(p, triangles_[t]) : HeightAbove(triangles_[t], p);
    return std::abs(away) <= kCoverReach;
  });
}

bool BorderStrip::GoesOnAcross(const Point3& a, const Point3& b) const {
  const Point3 along = Point3(b.x() - a.x(), b.y() - a.y(), 0).normalized();
  const Point3 aside = kBeside * Point3(-along.y(), along.x(), 0);
  return std::ranges::all_of(std::array{aside, Point3(-aside)}, [&](const Point3& offset) {
    const Nearest nearest = NearestBeside((a + b) / 2 + offset, a, b);
    return nearest.is_covered && std::abs(nearest.height) <= kCoverReach;
  });
}

void CoverOpenEdges(const TriMesh& mesh, const std::function<bool(const OpenEdge&)>& is_asked,
                    std::vector<OpenEdge>& edges) {
  if (std::none_of(edges.begin(), edges.end(), is_asked)) return;
  std::vector<SpaceTriangle> triangles;
  for (const Triangle& t : mesh.triangles) {
    triangles.push_back({mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]]});
  }
  const BorderStrip surface(std::move(triangles), std::vector<bool>(mesh.triangles.size(), false));
  for (OpenEdge& e : edges) {
    if (is_asked(e)) e.is_covered = surface.GoesOnAcross(e.from, e.to);
  }
}

void JoinedEdges::Add(int32_t tile, int32_t row, const std::vector<OpenEdge>& edges) {
  for (const OpenEdge& e : edges) {
    Sum& sum = sums_[{e.from.x(), e.from.y(), e.from.z(), e.to.x(), e.to.y(), e.to.z()}];
    sum.before += e.before;
    sum.after += e.after;
    sum.forward += e.forward;
    sum.single += e.after == 1 ? 1 : 0;
    sum.row = row;
    if (e.after > 0) sum.tile = tile;
    sum.is_added = sum.is_added || e.is_added;
    sum.is_inner = sum.is_inner || e.is_inner;
    sum.is_covered = sum.is_covered || e.is_covered;
    if (e.hole >= 0 && e.after > 0) sum.hole = e.hole;
  }
}

JoinedEdges::Released JoinedEdges::ReleaseBelow(int32_t row) {
  Released released;
  for (auto it = sums_.begin(); it != sums_.end();) {
    const auto& [key, sum] = *it;
    if (sum.row >= row) {
      ++it;
      continue;
    }
    NewOpenEdge edge{{{key[0], key[1], key[2]},
                      {key[3], key[4], key[5]},
                      sum.before,
                      sum.after,
                      sum.is_added,
                      sum.is_inner,
                      sum.is_covered},
                     sum.tile};
    edge.edge.hole = sum.hole;
    if (sum.after == 1 && sum.before != 1) released.open.push_back(edge);
    if (sum.single == 2 && sum.after == 2 && sum.forward != 1 && sum.is_added) released.turned.push_back(edge);
    if (sum.before == 1 && sum.after > 0) released.rims.push_back(edge);
    if (sum.after > 2 && sum.before <= 2 && sum.is_added) released.crowded.push_back(edge);
    it = sums_.erase(it);
  }
  return released;
}

}  // namespace tilemend
