#include "worker/fill/hole/local_patch.h"

#include <utility>

namespace tilemend {

void AddPart(const HolePart& part, const LocalPatch& of_part, const LocalHole& hole, LocalPatch& patch) {
  patch.loop_cuts += of_part.loop_cuts;
  const auto first = hole.size() + static_cast<int32_t>(patch.new_points.size());
  patch.new_points.insert(patch.new_points.end(), of_part.new_points.begin(), of_part.new_points.end());
  for (Triangle t : of_part.triangles) {
    for (int32_t& v : t) v = v < part.hole.size() ? part.vertices[v] : first + v - part.hole.size();
    patch.triangles.push_back(t);
  }
}

void DropUnusedPoints(const LocalHole& hole, LocalPatch& patch) {
  std::vector<int32_t> number(patch.new_points.size(), -1);
  const auto for_each_new = [&](const auto& use) {
    for (Triangle& t : patch.triangles) {
      for (int32_t& v : t) {
        if (v >= hole.size()) use(v);
      }
    }
  };
  for_each_new([&](int32_t v) { number[v - hole.size()] = 0; });
  std::vector<Point3> points;
  for (size_t k = 0; k < number.size(); ++k) {
    if (number[k] < 0) continue;
    number[k] = hole.size() + static_cast<int32_t>(points.size());
    points.push_back(patch.new_points[k]);
  }
  for_each_new([&](int32_t& v) { v = number[v - hole.size()]; });
  patch.new_points = std::move(points);
}

HolePatch ToHolePatch(const LocalHole& hole, LocalPatch patch) {
  HolePatch out;
  out.new_points = std::move(patch.new_points);
  out.triangles = std::move(patch.triangles);
  out.hold_out = patch.hold_out;
  out.loop_cuts = patch.loop_cuts;
  for (Triangle& t : out.triangles) {
    for (int32_t& v : t) v = v < hole.size() ? hole.vertices[v] : hole.size() - 1 - v;
  }
  return out;
}

}  // namespace tilemend
