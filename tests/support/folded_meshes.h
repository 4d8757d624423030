// Sheets folded into buildings, for tests of sharp edges.
#ifndef TILEMEND_TESTS_SUPPORT_FOLDED_MESHES_H_
#define TILEMEND_TESTS_SUPPORT_FOLDED_MESHES_H_

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <random>
#include <string>
#include <vector>

#include "tests/support/mesh_builders.h"
#include "tests/support/patch_checks.h"
#include "worker/fill/hole/fill_options.h"
#include "worker/papers/published_ways.h"

namespace tilemend {

inline FillOptions With(Surface surface) {
  FillOptions options;
  options.published = AllPublishedWays();
  options.surface = surface;
  return options;
}

inline constexpr double kWallHeight = 10;

// Vertices a few millimetres off, where edges are 1 m: like surveyed buildings with edges of 0.25 m.
inline constexpr double kNoise = 0.01;

// Folds a sheet (u, v, 0): ground for v < 0, a wall of kWallHeight that faces -y, then a roof.
inline Point3 FoldToBuilding(const Point3& p) {
  const double v = p.y();
  return {p.x(), v < 0 ? v : std::max(0.0, v - kWallHeight), std::clamp(v, 0.0, kWallHeight)};
}

// Distance from the ground, wall or roof of FoldToBuilding, whichever is nearest.
inline double DistanceToBuilding(const Point3& p) {
  const double ground = std::hypot(p.z(), std::max(0.0, p.y()));
  const double wall = std::hypot(p.y(), std::max({0.0, p.z() - kWallHeight, -p.z()}));
  const double roof = std::hypot(p.z() - kWallHeight, std::max(0.0, -p.y()));
  return std::min({ground, wall, roof});
}

// Unit squares of a sheet of [-15, 15] x [-10, 20] without those whose middle is in the hole. After `shape`, each
// vertex is moved by up to `noise` in all directions.
inline TriMesh HoledSheet(const std::function<bool(double u, double v)>& hole,
                          const std::function<Point3(const Point3&)>& shape, double noise) {
  const auto keep = [&](int32_t i, int32_t j) { return !hole(i + 0.5, j + 0.5); };
  std::mt19937 random(1);
  const auto off = [&] { return noise * (static_cast<double>(random()) / 0x1p31 - 1); };
  return Moved(SquaresMesh(-15, 15, -10, 20, keep), [&](const Point3& p) {
    const Point3 q = shape(p);
    const double x = off(), y = off();
    return Point3(q + Point3(x, y, off()));
  });
}

// The hole of a HoledSheet: the boundary edges off the sheet's outline, told by where they lie in the sheet.
inline CellHoles WorkOfSheet(const std::function<bool(double u, double v)>& hole,
                             const std::function<Point3(const Point3&)>& shape, double noise) {
  const TriMesh flat = HoledSheet(
                    hole, [](const Point3&p) { return p; }, 0),
                mesh = HoledSheet(hole, shape, noise);
  std::vector<Point3> outline;
  for (size_t i = 0; i < flat.points.size(); ++i) {
    const Point3& p = flat.points[i];
    if (std::abs(p.x()) == 15 || p.y() == -10 || p.y() == 20) outline.push_back(mesh.points[i]);
  }
  const auto inside = [&](const Point3& p) { return std::find(outline.begin(), outline.end(), p) == outline.end(); };
  return WorkOf(mesh, false, [&](const Point3& a, const Point3& b) { return inside(a) || inside(b); });
}

// Gives the first hole an edge inside, between two new vertices that lie on a seam.
inline void AddInnerEdge(const Point3& a, const Point3& b, CellHoles& work) {
  const auto before = static_cast<int32_t>(work.vertices.size());
  for (const Point3& p : {a, b}) {
    RimVertex v;
    v.position = p;
    v.size = 1;
    work.band.points.insert(work.band.points.begin() + std::ssize(work.vertices), p);
    work.vertices.push_back(v);
  }
  for (Triangle& t : work.band.triangles) {
    for (int32_t& v : t) v += v < before ? 0 : 2;
  }
  work.holes[0].inner_edges.push_back({before, before + 1, true});
}

// How many triangles of a patch have the edge between two vertices.
inline int64_t TrianglesAt(int32_t a, int32_t b, const std::vector<Triangle>& triangles) {
  return std::count_if(triangles.begin(), triangles.end(), [&](const Triangle& t) {
    return std::count(t.begin(), t.end(), a) == 1 && std::count(t.begin(), t.end(), b) == 1;
  });
}

// Rolls a sheet (u, v, 0) round a tank along x, from its top at v = `top`.
inline std::function<Point3(const Point3&)> RollRoundTank(double radius, double top = 5) {
  return [=](const Point3& p) {
    const double angle = (p.y() - top) / radius;
    return Point3(p.x(), radius * std::sin(angle), radius * std::cos(angle));
  };
}

// A hole three quarters of the way round a tank of radius 5 with its top at v = 5.
inline bool IsInTankSlit(double u, double v) { return std::abs(u) < 3 && std::abs(v - 5) < 11; }

inline std::function<bool(double, double)> Disc(double u0, double v0, double radius) {
  return [=](double u, double v) { return std::hypot(u - u0, v - v0) < radius; };
}

// A box without its top corner, which is the origin. It has faces x = 0, y = 0 and z = 0 of side 12, and the hole of
// that radius about the corner.
inline CellHoles WorkOfBoxCorner(double radius, double noise) {
  TriMesh box;
  std::mt19937 random(1);
  const auto off = [&] { return noise * (static_cast<double>(random()) / 0x1p31 - 1); };
  const auto add_face = [&](const std::function<Point3(const Point3&)>& place) {
    const TriMesh face =
        SquaresMesh(0, 12, 0, 12, [&](int32_t i, int32_t j) { return std::hypot(i + 0.5, j + 0.5) > radius; });
    std::vector<int32_t> number;
    for (const Point3& p : face.points) {
      const auto it = std::find(box.points.begin(), box.points.end(), place(p));
      number.push_back(static_cast<int32_t>(it - box.points.begin()));
      if (it == box.points.end()) box.points.push_back(place(p));
    }
    for (const Triangle& t : face.triangles) box.triangles.push_back({number[t[0]], number[t[1]], number[t[2]]});
  };
  add_face([](const Point3& p) { return Point3(-p.x(), -p.y(), 0); });
  add_face([](const Point3& p) { return Point3(0, -p.x(), -p.y()); });
  add_face([](const Point3& p) { return Point3(-p.y(), 0, -p.x()); });
  const TriMesh mesh = Moved(std::move(box), [&](const Point3& p) {
    const double x = off(), y = off();
    return Point3(p + Point3(x, y, off()));
  });
  const auto inner = [](const Point3& a, const Point3& b) { return a.minCoeff() > -11.5 || b.minCoeff() > -11.5; };
  return WorkOf(mesh, false, inner);
}

// Least and mean 2 * inradius / circumradius of a patch's triangles.
struct PatchQuality {
  double least = 1, mean = 0;
};

inline PatchQuality QualityOf(const CellHoles& work, const HolePatch& patch) {
  PatchQuality quality;
  for (const Triangle& t : patch.triangles) {
    const Point3 a = CornerOf(work, patch, t[0]), b = CornerOf(work, patch, t[1]), c = CornerOf(work, patch, t[2]);
    const double x = (b - c).norm(), y = (c - a).norm(), z = (a - b).norm();
    const double area2 = AreaVector2(work, patch, t).norm();
    const double q = 4 * area2 * area2 / ((x + y + z) * x * y * z);
    quality.least = std::min(quality.least, q);
    quality.mean += q / static_cast<double>(patch.triangles.size());
  }
  return quality;
}

}  // namespace tilemend

#endif  // TILEMEND_TESTS_SUPPORT_FOLDED_MESHES_H_
