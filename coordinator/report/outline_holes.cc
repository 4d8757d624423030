#include "coordinator/report/outline_holes.h"

#include "absl/strings/str_cat.h"

namespace tilemend {
namespace {

// Share of the mesh's size. Of two tiles of 100 m of a real export one ended exactly where its outline did, the other
// 0.5 mm beyond it.
constexpr double kAsFar = 1e-3;

}  // namespace

std::vector<int32_t> OutlineHoles(const Plan& plan, const Point3& low, const Point3& high) {
  std::vector<int32_t> outlines;
  for (size_t h = 0; h < plan.holes.size(); ++h) {
    Point3 from = high, to = low;
    for (const RimSegment& s : plan.holes[h].segments) {
      from = from.cwiseMin(plan.vertices[s.from].position);
      to = to.cwiseMax(plan.vertices[s.from].position);
    }
    int as_far = 0;  // axes
    for (int axis = 0; axis < 3; ++axis) {
      // An axis along which the mesh is flat tells nothing.
      const double size = high[axis] - low[axis], off = kAsFar * size;
      as_far += size > 0 && from[axis] <= low[axis] + off && to[axis] >= high[axis] - off ? 1 : 0;
    }
    if (as_far >= 2) outlines.push_back(static_cast<int32_t>(h));
  }
  return outlines;
}

std::string OutlineHolesText(const Plan& plan, const std::vector<int32_t>& holes) {
  std::string text;
  for (const int32_t h : holes) {
    const auto edges = std::ssize(plan.holes[h].segments);
    absl::StrAppend(&text, "hole ", h, " is as large as the whole mesh and probably its outline; `fill --largest-hole ",
                    edges - 1, "` leaves it and larger ones open\n");
  }
  return text.empty() ? "" : absl::StrCat("\n", text);
}

}  // namespace tilemend
