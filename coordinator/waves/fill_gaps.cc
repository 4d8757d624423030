#include "coordinator/waves/fill_gaps.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "coordinator/plan/rim/surface_gap.h"
#include "coordinator/plan/types/meet_tolerance.h"

namespace tilemend {
namespace {

constexpr int kPlaces = 256;                                           // on each line
constexpr std::array<double, 3> kLines = {1.0 / 6, 1.0 / 2, 5.0 / 6};  // of the strip
constexpr double kAround = 1;                                          // metres: triangles so near to the strip count
constexpr double kSame = 1e-3;  // metres: heights that differ by less are near in space as well
constexpr double kNone = std::numeric_limits<double>::infinity();

// Where a line across an axis cuts a triangle: places along it and heights, the lower place first.
struct Cut {
  double from = 0, to = 0;
  double from_height = 0, to_height = 0;
};

bool CutAt(const std::array<Point3, 3>& t, int axis, double line, Cut& cut) {
  int found = 0;
  for (int k = 0; k < 3 && found < 2; ++k) {
    const Point3 &a = t[k], &b = t[(k + 1) % 3];
    if ((a[axis] < line) == (b[axis] < line)) continue;
    const Point3 p = a + (line - a[axis]) / (b[axis] - a[axis]) * (b - a);
    (found == 0 ? cut.from : cut.to) = p[1 - axis];
    (found == 0 ? cut.from_height : cut.to_height) = p.z();
    ++found;
  }
  if (found == 2 && cut.from > cut.to) {
    std::swap(cut.from, cut.to);
    std::swap(cut.from_height, cut.to_height);
  }
  return found == 2 && cut.to > cut.from;
}

bool MeetsOriginals(const Triangle& t, std::span<const RimVertex> vertices) {
  return std::any_of(t.begin(), t.end(), [&](int32_t v) { return v >= 0 && vertices[v].index >= 0; });
}

// Lowers the heights at places between `begin` and `end` that lie within the cut to those of the cut.
void Lower(const Cut& cut, double begin, double end, std::span<double> heights) {
  const double step = (end - begin) / kPlaces;
  const auto place = [&](double t) { return std::clamp((t - begin) / step - 0.5, -1.0, 1.0 * kPlaces); };
  const auto last = std::min(kPlaces - 1, static_cast<int>(std::floor(place(cut.to))));
  for (auto i = std::max(0, static_cast<int>(std::ceil(place(cut.from)))); i <= last; ++i) {
    const double share = (begin + (i + 0.5) * step - cut.from) / (cut.to - cut.from);
    const double height = cut.from_height + share * (cut.to_height - cut.from_height);
    heights[i] = std::min(heights[i], height);
  }
}

}  // namespace

FillGaps::FillGaps(const Grid& grid, const std::vector<BorderAudit>& borders) {
  for (const BorderAudit& border : borders) {
    if (border.kind != BorderKind::kOverlap || border.offset < kMeetTolerance) continue;
    const int axis = border.a.row == border.b.row ? 0 : 1;
    const int32_t across = axis == 0 ? border.b.col : border.b.row, along = axis == 0 ? border.b.row : border.b.col;
    const double line = grid.corner[axis] + across * grid.cell_size[axis];
    Strip strip{axis, line - border.margins[1], line + border.margins[0]};
    strip.begin = grid.corner[1 - axis] + along * grid.cell_size[1 - axis];
    strip.end = strip.begin + grid.cell_size[1 - axis];
    strips_[{border.a, border.b}] = strip;
    for (const CellId cell : {border.a, border.b}) borders_of_[cell].push_back({border.a, border.b});
  }
}

void FillGaps::Take(CellId cell, std::span<const RimVertex> vertices, std::span<const HolePatch> patches) {
  const auto borders = borders_of_.find(cell);
  if (borders == borders_of_.end()) return;
  for (const Border& border : borders->second) {
    const Strip& strip = strips_.at(border);
    Part part = PartOn(strip, vertices, patches);
    const auto other = waiting_.find(border);
    if (other == waiting_.end()) {
      waiting_[border] = std::move(part);
      continue;
    }
    const SurfaceGap gap = Compare(strip, part, other->second);
    if (gap.places > 0) gaps_[border] = gap;
    waiting_.erase(other);
  }
}

FillGaps::Part FillGaps::PartOn(const Strip& strip, std::span<const RimVertex> vertices,
                                std::span<const HolePatch> patches) {
  Part part;
  part.heights.assign(kLines.size() * kPlaces, kNone);
  for (const HolePatch& patch : patches) {
    for (const Triangle& triangle : patch.triangles) {
      std::array<Point3, 3> t;
      for (int k = 0; k < 3; ++k)
        t[k] = triangle[k] >= 0 ? vertices[triangle[k]].position : patch.new_points[-1 - triangle[k]];
      const auto [lo, hi] = std::minmax({t[0][strip.axis], t[1][strip.axis], t[2][strip.axis]});
      if (hi < strip.lo - kAround || lo > strip.hi + kAround) continue;
      const auto base = static_cast<int32_t>(part.mesh.points.size());
      part.mesh.points.insert(part.mesh.points.end(), t.begin(), t.end());
      part.mesh.triangles.push_back({base, base + 1, base + 2});
      if (MeetsOriginals(triangle, vertices)) continue;
      for (size_t l = 0; l < kLines.size(); ++l) {
        Cut cut;
        if (!CutAt(t, strip.axis, LineOf(strip, l), cut)) continue;
        Lower(cut, strip.begin, strip.end, std::span(part.heights).subspan(l * kPlaces, kPlaces));
      }
    }
  }
  return part;
}

SurfaceGap FillGaps::Compare(const Strip& strip, const Part& a, const Part& b) {
  const StripSurface of_a(a.mesh, strip.axis, strip.lo - kAround, strip.hi + kAround);
  const StripSurface of_b(b.mesh, strip.axis, strip.lo - kAround, strip.hi + kAround);
  std::vector<double> apart;
  for (size_t i = 0; i < a.heights.size(); ++i) {
    if (a.heights[i] == kNone || b.heights[i] == kNone) continue;
    double distance = std::abs(a.heights[i] - b.heights[i]);
    if (distance > kSame) {
      Point3 p;
      p[strip.axis] = LineOf(strip, i / kPlaces);
      p[1 - strip.axis] = strip.begin + (static_cast<double>(i % kPlaces) + 0.5) * (strip.end - strip.begin) / kPlaces;
      const auto to = [&](const StripSurface& surface, double z) {
        return surface.Distance({p.x(), p.y(), z}).value_or(distance);
      };
      distance = std::max(to(of_b, a.heights[i]), to(of_a, b.heights[i]));
    }
    apart.push_back(distance);
  }
  return SummaryOf(std::move(apart));
}

double FillGaps::LineOf(const Strip& strip, size_t line) { return strip.lo + kLines[line] * (strip.hi - strip.lo); }

}  // namespace tilemend
