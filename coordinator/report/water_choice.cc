#include "coordinator/report/water_choice.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <utility>

#include "absl/strings/str_cat.h"
#include "absl/strings/str_format.h"
#include "common/gis/area_file.h"
#include "common/mesh/box_tree.h"
#include "common/mesh/polygon_index.h"
#include "common/mesh/segment_distance.h"
#include "common/store/digest.h"
#include "common/util/status_macros.h"
#include "coordinator/plan/types/meet_tolerance.h"
#include "coordinator/report/scene_member.h"

namespace tilemend {
namespace {

// Twice the area of a triangle; positive if it turns left.
double Turn(const Point2& a, const Point2& b, const Point2& c) {
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

enum class Side { kInside, kOutside, kAcross };

using Edge = std::pair<Point2, Point2>;

Eigen::AlignedBox3d BoxOf(const Edge& edge, double margin) {
  const Eigen::Vector3d by(margin, margin, 0);
  const Point2 lo = edge.first.cwiseMin(edge.second), hi = edge.first.cwiseMax(edge.second);
  return {Eigen::Vector3d(lo.x(), lo.y(), 0) - by, Eigen::Vector3d(hi.x(), hi.y(), 0) + by};
}

// Where rings lie of an area.
class AreaSides {
 public:
  // Cost O(n sqrt(n)) for n points.
  explicit AreaSides(const PlanePolygon& area) : index_(area) {
    std::vector<Eigen::AlignedBox3d> boxes;
    for (const std::vector<Point2>& ring : area.rings) {
      for (size_t i = 0; i < ring.size(); ++i) {
        edges_.emplace_back(ring[i], ring[(i + 1) % ring.size()]);
        boxes.push_back(BoxOf(edges_.back(), 0));
      }
    }
    tree_ = BoxTree(boxes);
  }

  // Across is also a ring that touches the edge: triangles are taken out whole, so it would take some out beyond. Cost
  // O(log n) for each point and each edge near it.
  Side SideOf(const std::vector<Point2>& ring) const {
    for (size_t i = 0; i < ring.size(); ++i) {
      const Edge edge(ring[i], ring[(i + 1) % ring.size()]);
      const auto meets = [&](int32_t other) { return Meets(edge, edges_[other]); };
      if (tree_.AnyMeeting(BoxOf(edge, 2 * kMeetTolerance), meets)) return Side::kAcross;
    }
    return index_.Contains(ring[0]) ? Side::kInside : Side::kOutside;
  }

 private:
  static bool Meets(const Edge& edge, const Edge& other) {
    const auto& [p, q] = edge;
    const auto& [r, s] = other;
    if (DistanceToSegment(p, r, s) <= kMeetTolerance) return true;
    return Turn(p, q, r) * Turn(p, q, s) < 0 && Turn(r, s, p) * Turn(r, s, q) < 0;
  }

  PolygonIndex index_;
  std::vector<Edge> edges_;
  BoxTree tree_;
};

// Takes the rings out of a polygon that lie outside the area; false if one lies across its edge. `sides` are those of
// the area.
bool KeepRingsInside(const PlanePolygon& area, const AreaSides& sides, PlanePolygon& polygon) {
  std::vector<std::vector<Point2>> kept;
  const PolygonIndex index(polygon);
  for (const std::vector<Point2>& edge : area.rings) {
    if (index.Contains(edge[0])) return false;
  }
  for (std::vector<Point2>& ring : polygon.rings) {
    const Side side = sides.SideOf(ring);
    if (side == Side::kAcross) return false;
    if (side == Side::kInside) kept.push_back(std::move(ring));
  }
  polygon.rings = std::move(kept);
  return true;
}

}  // namespace

absl::StatusOr<WaterChoice> ReadWaterChoice(const std::string& value, const SceneFrame& frame,
                                            const std::stop_token& stop) {
  WaterChoice choice;
  choice.options.find = value != kNoWater;
  if (value == kFindWater || value == kNoWater) return choice;
  TILEMEND_ASSIGN_OR_RETURN(const VectorBytes bytes, ReadAreaFile(value));
  TILEMEND_ASSIGN_OR_RETURN(WaterFile file, ParseWaterFile(bytes, value, frame, stop));
  choice.options.areas = std::move(file.areas);
  choice.coordinates = std::move(file.coordinates);
  choice.warnings = std::move(file.warnings);
  choice.digest = Sha256Hex(ContentOf(bytes));
  return choice;
}

absl::Status AddClearFile(const std::string& value, const SceneFrame& frame, WaterChoice& choice,
                          const std::stop_token& stop) {
  if (value.empty()) return absl::OkStatus();
  TILEMEND_ASSIGN_OR_RETURN(const VectorBytes bytes, ReadAreaFile(value));
  TILEMEND_ASSIGN_OR_RETURN(WaterFile file, ParseWaterFile(bytes, value, frame, stop, ClearChoice::kAll));
  for (WaterArea& area : file.areas) {
    area.label += " of --clear";
    choice.options.areas.push_back(std::move(area));
  }
  for (std::string& warning : file.warnings) choice.warnings.push_back(std::move(warning));
  choice.clear_digest = Sha256Hex(ContentOf(bytes));
  return absl::OkStatus();
}

absl::Status AddDecisions(const std::string& value, const Scene& scene, WaterChoice& choice,
                          const std::stop_token& stop) {
  if (value.empty()) return absl::OkStatus();
  TILEMEND_ASSIGN_OR_RETURN(const VectorBytes bytes, ReadAreaFile(value));
  TILEMEND_ASSIGN_OR_RETURN(std::string warning, CheckSceneMember(bytes.bytes, value, scene));
  if (!warning.empty()) choice.warnings.push_back(std::move(warning));
  TILEMEND_ASSIGN_OR_RETURN(WaterFile file, ParseDecisionFile(bytes, value, FrameOf(scene), stop));
  std::ranges::move(file.areas, std::back_inserter(choice.options.areas));
  std::ranges::move(file.warnings, std::back_inserter(choice.warnings));
  choice.decisions_digest = Sha256Hex(ContentOf(bytes));
  return absl::OkStatus();
}

absl::Status CheckLevels(const std::vector<WaterArea>& areas, const std::map<CellId, StoredRecord>& records) {
  double lowest = std::numeric_limits<double>::infinity(), highest = -lowest;
  for (const auto& [cell, record] : records) {
    if (record == nullptr || record->lo.x() > record->hi.x()) continue;
    lowest = std::min(lowest, record->lo.z());
    highest = std::max(highest, record->hi.z());
  }
  for (const WaterArea& area : areas) {
    if (!area.water || !area.level || lowest > highest) continue;
    const double above = *area.level - highest, below = lowest - *area.level;
    if (std::max(above, below) <= kMostLevelOff) continue;
    return absl::InvalidArgumentError(absl::StrFormat(
        "%s: its level_m is %.1f m %s of the scene, and at most %.0f m are allowed; give metres in the scene's CRS, or "
        "above its origin if the file has the scene's coordinates",
        area.label, std::max(above, below), above > below ? "above all surface" : "below all surface", kMostLevelOff));
  }
  return absl::OkStatus();
}

absl::Status KeepClearInside(const PlanePolygon& area, WaterChoice& choice) {
  if (area.empty()) return absl::OkStatus();
  const AreaSides sides(area);
  std::vector<WaterArea> kept;
  for (WaterArea& water : choice.options.areas) {
    const size_t rings = water.polygon.rings.size();
    if (water.clear && !KeepRingsInside(area, sides, water.polygon)) {
      return absl::InvalidArgumentError(absl::StrCat(water.label,
                                                     ": lies across the edge of the area, or touches it; what "
                                                     "it takes out beyond would stay open: draw it inside"));
    }
    if (water.polygon.rings.size() < rings) {
      choice.warnings.push_back(absl::StrCat(water.label, water.polygon.empty() ? ": lies" : ": a part of it lies",
                                             " outside the area, so nothing is taken out and nothing filled there"));
    }
    if (!water.clear || !water.polygon.empty()) kept.push_back(std::move(water));
  }
  choice.options.areas = std::move(kept);
  return absl::OkStatus();
}

}  // namespace tilemend
