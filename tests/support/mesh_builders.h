// Small meshes for tests, by name.
#ifndef TILEMEND_TESTS_SUPPORT_MESH_BUILDERS_H_
#define TILEMEND_TESTS_SUPPORT_MESH_BUILDERS_H_

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <map>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "common/mesh/tri_mesh.h"

namespace tilemend {

using HeightFunction = std::function<double(double x, double y)>;

inline double Flat(double, double) { return 0; }

// Squares of side 1, each of two triangles facing up, where `keep(i, j)` holds; square (i, j) is [i, i+1) x [j, j+1).
// Only the vertices in use, by row.
inline TriMesh SquaresMesh(int32_t i0, int32_t i1, int32_t j0, int32_t j1,
                           const std::function<bool(int32_t, int32_t)>& keep, const HeightFunction& height = Flat) {
  std::map<std::pair<int32_t, int32_t>, int32_t> number;  // (j, i)
  for (int32_t j = j0; j < j1; ++j) {
    for (int32_t i = i0; i < i1; ++i) {
      if (!keep(i, j)) continue;
      for (const int32_t dj : {0, 1}) {
        for (const int32_t di : {0, 1}) number[{j + dj, i + di}] = 0;
      }
    }
  }
  TriMesh mesh;
  for (auto& [at, n] : number) {
    n = static_cast<int32_t>(mesh.points.size());
    mesh.points.emplace_back(at.second, at.first, height(at.second, at.first));
  }
  for (int32_t j = j0; j < j1; ++j) {
    for (int32_t i = i0; i < i1; ++i) {
      if (!keep(i, j)) continue;
      const int32_t a = number[{j, i}], b = number[{j, i + 1}], c = number[{j + 1, i + 1}], d = number[{j + 1, i}];
      mesh.triangles.push_back({a, b, c});
      mesh.triangles.push_back({a, c, d});
    }
  }
  return mesh;
}

// Squares by a picture, north at the top: '#' is surface, everything else none. The south-west corner is at 0, 0.
inline TriMesh PictureMesh(const std::vector<std::string>& picture, const HeightFunction& height = Flat) {
  const auto rows = static_cast<int32_t>(picture.size());
  const auto cols = static_cast<int32_t>(picture.at(0).size());
  const auto keep = [&](int32_t i, int32_t j) { return picture[rows - 1 - j].at(i) == '#'; };
  return SquaresMesh(0, cols, 0, rows, keep, height);
}

// A disc facing up: a vertex in the middle and `rings` rings of `sectors` vertices, 1 apart. The outermost ring is the
// last one: vertices 1 + (rings - 1) * sectors and on.
inline TriMesh DiscMesh(int32_t rings, int32_t sectors) {
  TriMesh mesh;
  mesh.points.emplace_back(0, 0, 0);
  const auto at = [sectors](int32_t ring, int32_t k) { return 1 + (ring - 1) * sectors + k % sectors; };
  for (int32_t ring = 1; ring <= rings; ++ring) {
    for (int32_t k = 0; k < sectors; ++k) {
      const double angle = 2 * std::numbers::pi * k / sectors;
      mesh.points.emplace_back(ring * std::cos(angle), ring * std::sin(angle), 0);
    }
  }
  for (int32_t k = 0; k < sectors; ++k) {
    mesh.triangles.push_back({0, at(1, k), at(1, k + 1)});
    for (int32_t ring = 1; ring < rings; ++ring) {
      mesh.triangles.push_back({at(ring, k), at(ring + 1, k), at(ring + 1, k + 1)});
      mesh.triangles.push_back({at(ring, k), at(ring + 1, k + 1), at(ring, k + 1)});
    }
  }
  return mesh;
}

// The same surface with three vertices of its own for each triangle, as texture seams double them.
inline TriMesh Unwelded(const TriMesh& mesh) {
  TriMesh out;
  for (const Triangle& t : mesh.triangles) {
    const auto n = static_cast<int32_t>(out.points.size());
    for (const int32_t v : t) out.points.push_back(mesh.points[v]);
    out.triangles.push_back({n, n + 1, n + 2});
  }
  return out;
}

// The mesh with `f` applied to its points.
inline TriMesh Moved(TriMesh mesh, const std::function<Point3(const Point3&)>& f) {
  for (Point3& p : mesh.points) p = f(p);
  return mesh;
}

// Two pieces of one flat surface, two squares of 1 m deep, from x = 0 to 4.5 and from 1.5 to 6. From 2 to 4 they have
// the same triangles. Each outline has 14 edges, of which both have four.
inline TriMesh PiecesOfOneSurface() {
  const auto all = [](int32_t, int32_t) { return true; };
  TriMesh mesh =
      Moved(SquaresMesh(0, 5, 0, 2, all), [](const Point3& p) { return Point3(std::min(p.x(), 4.5), p.y(), 0); });
  const TriMesh other =
      Moved(SquaresMesh(1, 6, 0, 2, all), [](const Point3& p) { return Point3(std::max(p.x(), 1.5), p.y(), 0); });
  const auto base = static_cast<int32_t>(mesh.points.size());
  mesh.points.insert(mesh.points.end(), other.points.begin(), other.points.end());
  for (const Triangle& t : other.triangles) mesh.triangles.push_back({t[0] + base, t[1] + base, t[2] + base});
  return mesh;
}

}  // namespace tilemend

#endif  // TILEMEND_TESTS_SUPPORT_MESH_BUILDERS_H_
