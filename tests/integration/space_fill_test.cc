// Holes that lie over no plane, from the survey to the patch: whatever is filled is sound, and nearly all are filled.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
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
#include "worker/survey/survey.h"

namespace tilemend {
namespace {

using ::testing::Each;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

struct FilledMesh {
  TriMesh mesh;      // welded
  size_t originals;  // of its triangles
  std::vector<std::string> failures;
  int64_t detached = 0;  // outlines that are taken for those of pieces
};

FilledMesh Fill(const TriMesh& mesh, Surface surface = Surface::kThinPlate) {
  const SurveyRecord record = SurveyTile(mesh, false);
  PlanInput input;
  input.has_grid = input.area_known = false;
  const Point2 extent = (record.hi - record.lo).head<2>();
  input.grid.corner = record.lo.head<2>() - extent;
  input.grid.cell_size = 3 * extent;
  input.cells[CellId{0, 0}] = &record;
  PlanOptions plan_options;
  plan_options.water.find = false;
  const Plan plan = MakePlan(input, plan_options);
  std::vector<int32_t> holes;
  for (size_t h = 0; h < plan.holes.size(); ++h) holes.push_back(static_cast<int32_t>(h));
  FilledMesh filled{mesh, mesh.triangles.size(), {}, plan.outer_rims};
  if (holes.empty()) return filled;
  const CellHoles work = MakeCellHoles(plan, input, {}, holes, true);
  const SurfaceIndex index(mesh);
  FillOptions options;
  options.surface = surface;
  const auto near = [&](const Point3& lo, const Point3& hi) {
    std::vector<SpaceTriangle> found;
    index.AppendNear(lo, hi, found);
    return found;
  };
  for (const HolePatch& patch : FillHoles(work, options, near)) {
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
bool Passes(const Point3& p, const Point3& q, const Point3& a, const Point3& b, const Point3& c) {
  const auto volume = [](const Point3& o, const Point3& u, const Point3& v, const Point3& w) {
    const double six_times = (u - o).cross(v - o).dot(w - o);
    return std::abs(six_times) < 1e-12 ? 0 : six_times;
  };
  const double s = volume(a, b, c, p), t = volume(a, b, c, q);
  if (s * t >= 0) return false;
  const double u = volume(p, q, a, b), v = volume(p, q, b, c), w = volume(p, q, c, a);
  return (u > 0 && v > 0 && w > 0) || (u < 0 && v < 0 && w < 0);
}

// No edge with more than two triangles, or two of one direction, and none at which a new triangle folds back; no new
// triangle that passes through another one. Returns the number of open edges.
int ExpectSound(const FilledMesh& filled) {
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
    const auto across = [&](size_t t) {
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

// An island at the corner of a box, in the hole around it: on one face, on the edge, over the corner.
TEST(SpaceFillTest, FillsAroundAnIslandAtTheCornerOfABox) {
  const Point3 places[] = {{0, 1.7, 1.3}, {0, 0, 1.5}, {0, 0, 0}, {0, 0.3, 0.3}};
  for (int way = 0; way < 7; ++way) {
    for (const Point3& place : places) {
      for (const double noise : {0.0, 0.08}) {
        SCOPED_TRACE(testing::Message() << "turned " << way << " island at " << place.transpose() << " noise "
                                        << noise);
        const TriMesh holed =
            WithoutHole(BoxMesh(7), [&](const Point3& p) { return p.norm() < 3.3 && (p - place).norm() > 0.9; });
        const FilledMesh filled = Fill(Turned(Shaken(holed, noise, 1), way));
        EXPECT_THAT(filled.failures, IsEmpty());
        EXPECT_EQ(filled.detached, 0);
        EXPECT_EQ(ExpectSound(filled), 0);
      }
    }
  }
}

// Holes about the corners and edges of noisy boxes. Where the noise makes the rim touch the surface none can be filled.
TEST(SpaceFillTest, FillsHolesInNoisyBoxesSoundly) {
  for (const Surface surface : {Surface::kThinPlate, Surface::kWang}) {
    int holes = 0, closed = 0;
    for (uint32_t seed = 0; seed < 48; ++seed) {
      SCOPED_TRACE(testing::Message() << "seed " << seed);
      const double radius = 1.5 + 0.4 * (seed % 6), noise = 0.05 + 0.06 * (seed % 5);
      const Point3 middle(0, seed % 4 < 2 ? 0 : 2.5, seed % 4 == 0 ? 0 : 2.5);
      const TriMesh holed = WithoutHole(BoxMesh(6), [&](const Point3& p) { return (p - middle).norm() < radius; });
      const FilledMesh filled = Fill(Turned(Shaken(holed, noise, seed), static_cast<int>(seed % 7)), surface);
      const int open = ExpectSound(filled);
      EXPECT_EQ(open == 0, filled.failures.empty());
      EXPECT_THAT(filled.failures, Each(HasSubstr("passes through")));
      ++holes;
      closed += open == 0;
    }
    EXPECT_GE(closed, holes * 0.95);
  }
}

// Of a closed body in the hole there is nothing on the rim: it is known from the surface alone.
TEST(SpaceFillTest, FillsAroundABodyInTheHole) {
  int closed = 0;
  for (int way = 0; way < 7; ++way) {
    SCOPED_TRACE(testing::Message() << "turned " << way);
    TriMesh mesh = WithoutHole(BoxMesh(6), [](const Point3& p) { return p.norm() < 2.5; });
    AddMesh(Tetrahedron(Point3(0.4, 0.4, 0.4), 0.15), mesh);
    const FilledMesh filled = Fill(Turned(mesh, way));
    const int open = ExpectSound(filled);
    EXPECT_EQ(open == 0, filled.failures.empty());
    closed += open == 0;
  }
  EXPECT_EQ(closed, 7);
}

TEST(SpaceFillTest, LeavesAHoleOpenThatEveryPatchOfCrossesTheSurface) {
  TriMesh mesh = WithoutHole(BoxMesh(6), [](const Point3& p) { return p.norm() < 2.5; });
  AddMesh(Needle(Point3(0.5, 0.5, 0.5)), mesh);
  const FilledMesh filled = Fill(mesh);
  EXPECT_THAT(filled.failures, testing::ElementsAre(HasSubstr("passes through itself or the surface around it")));
  EXPECT_EQ(filled.mesh.triangles.size(), filled.originals);
}

// Where the mesh crosses itself already, a patch may do so too.
TEST(SpaceFillTest, FillsAHoleThatTheSurfacePassesThroughTheRimOf) {
  TriMesh mesh = WithoutHole(BoxMesh(6), [](const Point3& p) { return p.norm() < 2.5; });
  AddMesh(Tetrahedron(Point3(2.5, 0.5, 0), 0.7), mesh);
  const FilledMesh filled = Fill(mesh);
  EXPECT_THAT(filled.failures, testing::IsEmpty());
  EXPECT_GT(filled.mesh.triangles.size(), filled.originals);
}

// Two holes on both sides of a thin plate, and between them nothing: the second patch may not meet the first.
TEST(SpaceFillTest, KeepsPatchesOfTwoHolesApart) {
  TriMesh plate = BoxMesh(10);
  for (Point3& p : plate.points) p.z() *= 0.03;
  const TriMesh mesh = WithoutHole(
      plate, [](const Point3& p) { return (p - Point3(5, 5, p.z())).norm() < 3.2 && std::abs(p.z() - 0.15) > 0.1; });
  for (int way = 0; way < 7; ++way) {
    SCOPED_TRACE(testing::Message() << "turned " << way);
    const FilledMesh filled = Fill(Turned(Shaken(mesh, 0.05, 3), way));
    EXPECT_EQ(ExpectSound(filled) == 0, filled.failures.empty());
  }
}

}  // namespace
}  // namespace tilemend
