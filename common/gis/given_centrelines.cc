#include "common/gis/given_centrelines.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>

#include "absl/status/statusor.h"
#include "absl/strings/str_cat.h"
#include "common/mesh/polygon_tree.h"
#include "common/util/status_macros.h"

namespace tilemend {
namespace {

ptrdiff_t PointsInside(const PolygonIndex& polygon, const std::vector<Point2>& points) {
  return std::ranges::count_if(points, [&](const Point2& p) { return polygon.Contains(p); });
}

class LineGiver {
 public:
  LineGiver(const std::string& name, WaterFile& file)
      : name_(name),
        areas_(file.areas),
        tree_(areas_.size(), [&](size_t a) -> const PlanePolygon& { return areas_[a].polygon; }) {}

  // False: no area of water has most of the line.
  absl::StatusOr<bool> Give(VectorFeature line) {
    WaterArea* best = nullptr;
    ptrdiff_t most = 0;
    Point2 lo = line.line.front(), hi = lo;
    for (const Point2& p : line.line) {
      lo = lo.cwiseMin(p);
      hi = hi.cwiseMax(p);
    }
    for (const int32_t a : tree_.Meeting(lo, hi)) {
      if (!areas_[a].water) continue;
      const ptrdiff_t inside = PointsInside(IndexOf(a), line.line);
      if (inside <= most) continue;
      most = inside;
      best = &areas_[a];
    }
    if (2 * most <= std::ssize(line.line)) return false;
    if (!best->centreline.empty()) {
      return absl::InvalidArgumentError(
          absl::StrCat(name_, ": ", line.label, ": a second centreline of ", best->label));
    }
    best->centreline = std::move(line.line);
    return true;
  }

 private:
  const PolygonIndex& IndexOf(int32_t a) { return indices_.try_emplace(a, areas_[a].polygon).first->second; }

  const std::string& name_;
  std::vector<WaterArea>& areas_;
  PolygonTree tree_;
  std::map<int32_t, PolygonIndex> indices_;  // of areas near a line
};

}  // namespace

bool MostLiesIn(const PolygonIndex& polygon, const std::vector<Point2>& points) {
  return 2 * PointsInside(polygon, points) > std::ssize(points);
}

absl::Status GiveCentrelines(std::vector<VectorFeature> features, const std::string& name, const std::stop_token& stop,
                             WaterFile& file) {
  std::string first;
  int64_t stray = 0;
  LineGiver giver(name, file);
  for (VectorFeature& f : features) {
    if (stop.stop_requested()) return absl::CancelledError(absl::StrCat(name, ": reading it was stopped"));
    if (f.line.empty()) continue;
    const std::string label = f.label;
    TILEMEND_ASSIGN_OR_RETURN(const bool given, giver.Give(std::move(f)));
    if (!given && ++stray == 1) first = label;
  }
  if (stray == 0) return absl::OkStatus();
  const std::string more = stray > 1 ? absl::StrCat(" and ", stray - 1, " more") : "";
  file.warnings.push_back(
      absl::StrCat(name, ": ", first, more,
                   ": a line that lies in no polygon of water, so it has no effect; draw water as a polygon"));
  return absl::OkStatus();
}

}  // namespace tilemend
