// A mesh from the survey over the plan to its patches, without files.
#ifndef TILEMEND_TESTS_SUPPORT_FILLED_MESH_H_
#define TILEMEND_TESTS_SUPPORT_FILLED_MESH_H_

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "coordinator/plan/make_cell_holes.h"
#include "coordinator/plan/plan.h"
#include "tests/support/space_meshes.h"
#include "worker/fill/fill_holes.h"
#include "worker/fill/space/surface_index.h"
#include "worker/papers/published_ways.h"
#include "worker/survey/survey.h"

namespace tilemend {

struct FilledMesh {
  TriMesh mesh;      // welded
  size_t originals;  // of its triangles
  std::vector<std::string> failures;
  int64_t detached = 0;  // outlines that are taken for those of pieces
  Plan plan;
  std::vector<HolePatch> patches;
};

inline FilledMesh Fill(const TriMesh& mesh, Surface surface = Surface::kThinPlate, const MeshHoleOptions& choice = {}) {
  const SurveyRecord record = SurveyTile(mesh, false);
  PlanInput input;
  input.has_grid = input.area_known = false;
  const Point2 extent = (record.hi - record.lo).head<2>();
  input.grid.corner = record.lo.head<2>() - extent;
  input.grid.cell_size = 3 * extent;
  input.cells[CellId{0, 0}] = &record;
  PlanOptions plan_options;
  plan_options.water.find = false;
  plan_options.mesh = choice;
  const Plan plan = MakePlan(input, plan_options);
  std::vector<int32_t> holes;
  for (size_t h = 0; h < plan.holes.size(); ++h) holes.push_back(static_cast<int32_t>(h));
  FilledMesh filled{mesh, mesh.triangles.size(), {}, plan.outer_rims, plan, {}};
  if (holes.empty()) return filled;
  const CellHoles work = MakeCellHoles(plan, input, {}, holes, true);
  const SurfaceIndex index(mesh);
  FillOptions options;
  options.surface = surface;
  options.published = AllPublishedWays();
  const auto near = [&](const Point3& lo, const Point3& hi) {
    std::vector<SpaceTriangle> found;
    index.AppendNear(lo, hi, found);
    return found;
  };
  filled.patches = FillHoles(work, options, near);
  for (const HolePatch& patch : filled.patches) {
    if (!patch.failure.empty()) filled.failures.push_back(patch.failure);
    const auto first = static_cast<int32_t>(filled.mesh.points.size());
    filled.mesh.points.insert(filled.mesh.points.end(), patch.new_points.begin(), patch.new_points.end());
    for (const Triangle& t : patch.triangles) {
      Triangle& out = filled.mesh.triangles.emplace_back();
      for (int k = 0; k < 3; ++k) out[k] = t[k] >= 0 ? work.vertices[t[k]].index : first - 1 - t[k];
    }
  }
  filled.mesh = Welded(filled.mesh);
  return filled;
}

// Whether segment pq passes through the inside of a triangle, by more than rounding.
inline bool Passes(const Point3& p, const Point3& q, const Point3& a, const Point3& b, const Point3& c) {
  const auto volume = [](const Point3& o, const Point3& u, const Point3& v, const Point3& w) {
    const double six_times = (u - o).cross(v - o).dot(w - o);
    return std::abs(six_times) < 1e-12 ? 0 : six_times;
  };
  const double s = volume(a, b, c, p), t = volume(a, b, c, q);
  if (s * t >= 0) return false;
  const double u = volume(p, q, a, b), v = volume(p, q, b, c), w = volume(p, q, c, a);
  return (u > 0 && v > 0 && w > 0) || (u < 0 && v < 0 && w < 0);
}

// Expects that no edge has more than two triangles, or two of one direction. No new triangle may fold back at an edge
// or pass through another one. Returns the number of open edges.
inline int ExpectSound(const FilledMesh& filled) {
  const auto& p = filled.mesh.points;
  const auto& triangles = filled.mesh.triangles;
  std::map<std::pair<int32_t, int32_t>, std::vector<size_t>> at_edge;
  for (size_t t = 0; t < triangles.size(); ++t) {
    for (int k = 0; k < 3; ++k) at_edge[{triangles[t][k], triangles[t][(k + 1) % 3]}].push_back(t);
  }
  int open = 0;
  for (const auto& [edge, one_way] : at_edge) {
    EXPECT_EQ(one_way.size(), 1u) << "edge " << edge.first << " -> " << edge.second;
    const auto back = at_edge.find({edge.second, edge.first});
    if (back == at_edge.end()) ++open;
    if (back == at_edge.end() || std::max(one_way[0], back->second[0]) < filled.originals) continue;
    const auto across = [&, &edge = edge](size_t t) {
      const Triangle& tri = triangles[t];
      const Eigen::Vector3d along = (p[edge.second] - p[edge.first]).normalized();
      Eigen::Vector3d out = p[tri[0]] + p[tri[1]] + p[tri[2]] - 2 * p[edge.first] - p[edge.second];
      out -= out.dot(along) * along;
      return Eigen::Vector3d(out.normalized());
    };
    EXPECT_LT(across(one_way[0]).dot(across(back->second[0])), 1 - 1e-5) << "folded";
  }
  for (size_t a = filled.originals; a < triangles.size(); ++a) {
    for (size_t b = 0; b < a; ++b) {
      const auto crosses = [&](const Triangle& s, const Triangle& t) {
        for (int k = 0; k < 3; ++k) {
          const int32_t from = s[k], to = s[(k + 1) % 3];
          const auto has = [&](int32_t v) { return t[0] == v || t[1] == v || t[2] == v; };
          if (!has(from) && !has(to) && Passes(p[from], p[to], p[t[0]], p[t[1]], p[t[2]])) return true;
        }
        return false;
      };
      EXPECT_FALSE(crosses(triangles[a], triangles[b]) || crosses(triangles[b], triangles[a])) << a << " and " << b;
    }
  }
  return open;
}

}  // namespace tilemend

#endif  // TILEMEND_TESTS_SUPPORT_FILLED_MESH_H_
