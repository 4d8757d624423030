// What every patch of a hole must satisfy, checked by means that share no code with the filler.
#ifndef TILEMEND_TESTS_SUPPORT_PATCH_CHECKS_H_
#define TILEMEND_TESTS_SUPPORT_PATCH_CHECKS_H_

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "common/mesh/edge_loops.h"
#include "common/records/cell_holes.h"
#include "worker/survey/survey.h"

namespace tilemend {

inline Point3 CornerOf(const CellHoles& work, const HolePatch& patch, int32_t corner) {
  return corner >= 0 ? work.vertices[corner].position : patch.new_points[-1 - corner];
}

// Twice the area vector of a patch triangle.
inline Eigen::Vector3d AreaVector2(const CellHoles& work, const HolePatch& patch, const Triangle& t) {
  const Point3 a = CornerOf(work, patch, t[0]);
  return (CornerOf(work, patch, t[1]) - a).cross(CornerOf(work, patch, t[2]) - a);
}

inline double PatchArea(const CellHoles& work, const HolePatch& patch) {
  double area = 0;
  for (const Triangle& t : patch.triangles) area += AreaVector2(work, patch, t).norm() / 2;
  return area;
}

// The patch has each rim segment once, in its direction, and every other edge twice, once each way; no triangle is
// flat. So it closes the hole and is oriented like the surface around it.
inline void ExpectClosesHole(const CellHoles& work, const CellHole& hole, const HolePatch& patch) {
  ASSERT_EQ(patch.failure, "");
  ASSERT_FALSE(patch.triangles.empty());
  std::map<std::pair<int32_t, int32_t>, int> uses;
  for (const Triangle& t : patch.triangles) {
    for (int k = 0; k < 3; ++k) ++uses[{t[k], t[(k + 1) % 3]}];
    EXPECT_GT(AreaVector2(work, patch, t).norm(), 0);
  }
  for (const RimSegment& s : hole.segments) {
    EXPECT_EQ((uses[{s.from, s.to}]), 1) << "rim segment " << s.from << " -> " << s.to;
    EXPECT_EQ(uses.count({s.to, s.from}), 0u) << "rim segment " << s.from << " -> " << s.to;
    uses.erase({s.from, s.to});
  }
  for (const auto& [edge, n] : uses) {
    EXPECT_EQ(n, 1) << "edge " << edge.first << " -> " << edge.second;
    EXPECT_EQ(uses.count({edge.second, edge.first}), 1u) << "edge " << edge.first << " -> " << edge.second;
  }
}

// Loop by loop, as the plan hands them out.
inline std::vector<RimSegment> InOrderOfLoops(const std::vector<RimSegment>& segments) {
  std::vector<DirectedEdge> edges;
  for (const RimSegment& s : segments) edges.push_back({s.from, s.to});
  std::vector<RimSegment> ordered;
  for (const EdgeWalk& walk : LinkEdges(edges)) {
    for (const int32_t edge : walk.edges) ordered.push_back(segments[edge]);
  }
  return ordered;
}

// One hole with those boundary edges of the mesh for which `of_hole(from, to)` holds, as the plan would hand it out.
inline CellHoles WorkOf(const TriMesh& mesh, bool open,
                        const std::function<bool(const Point3&, const Point3&)>& of_hole) {
  const SurveyRecord record = SurveyTile(mesh, true);
  CellHoles work;
  work.lattice_step = 0x1p-10;
  work.band = record.band;
  for (const BoundaryVertex& v : record.vertices) {
    RimVertex out;
    out.index = v.index;
    out.position = v.position;
    out.centroid_height = v.centroid_height;
    work.vertices.push_back(out);
  }
  std::vector<int32_t> count(work.vertices.size(), 0);
  CellHole hole;
  hole.open = open;
  for (const BoundaryEdge& e : record.edges) {
    const double length = (work.vertices[e.to].position - work.vertices[e.from].position).norm();
    for (const int32_t v : {e.from, e.to}) {
      work.vertices[v].size = (work.vertices[v].size * count[v] + length) / (count[v] + 1);
      ++count[v];
    }
    if (of_hole(work.vertices[e.from].position, work.vertices[e.to].position)) {
      hole.segments.push_back({e.to, e.from, false});
    }
  }
  hole.segments = InOrderOfLoops(hole.segments);
  work.holes.push_back(std::move(hole));
  return work;
}

}  // namespace tilemend

#endif  // TILEMEND_TESTS_SUPPORT_PATCH_CHECKS_H_
