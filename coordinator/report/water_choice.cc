#include "coordinator/report/water_choice.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <utility>

#include "absl/strings/str_cat.h"
#include "absl/strings/str_format.h"
#include "common/gis/area_file.h"
#include "common/mesh/segment_distance.h"
#include "common/store/digest.h"
#include "common/util/status_macros.h"
#include "coordinator/plan/types/meet_tolerance.h"

namespace tilemend {
namespace {

// Twice the area of a triangle; positive if it turns left.
double Turn(const Point2& a, const Point2& b, const Point2& c) {
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

enum class Side { kInside, kOutside, kAcross };

// Where a ring lies of a polygon. Across is also one that touches its edge: triangles are taken out whole, so it would
// take some out beyond. Cost O(points * points).
Side SideOf(const std::vector<Point2>& ring, const PlanePolygon& polygon) {
  const Side side = Contains(polygon, ring[0]) ? Side::kInside : Side::kOutside;
  for (const std::vector<Point2>& edge : polygon.rings) {
    for (size_t k = 0; k < edge.size(); ++k) {
      const Point2 &r = edge[k], &s = edge[(k + 1) % edge.size()];
      for (size_t i = 0; i < ring.size(); ++i) {
        const Point2 &p = ring[i], &q = ring[(i + 1) % ring.size()];
        if (DistanceToSegment(p, r, s) <= kMeetTolerance) return Side::kAcross;
        if (Turn(p, q, r) * Turn(p, q, s) < 0 && Turn(r, s, p) * Turn(r, s, q) < 0) return Side::kAcross;
      }
    }
  }
  return side;
}

// Takes the rings out of a polygon that lie outside the area; false if one lies across its edge.
bool KeepRingsInside(const PlanePolygon& area, PlanePolygon& polygon) {
  std::vector<std::vector<Point2>> kept;
  for (const std::vector<Point2>& edge : area.rings) {
    if (Contains(polygon, edge[0])) return false;
  }
  for (std::vector<Point2>& ring : polygon.rings) {
    const Side side = SideOf(ring, area);
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
  TILEMEND_ASSIGN_OR_RETURN(WaterFile file, ParseWaterFile(bytes, value, frame, stop));
  for (WaterArea& area : file.areas) {
    if (!area.clear) TILEMEND_RETURN_IF_ERROR(CheckClear(value, area, file.warnings));
    area.clear = true;
    area.label += " of --clear";
    choice.options.areas.push_back(std::move(area));
  }
  for (std::string& warning : file.warnings) choice.warnings.push_back(std::move(warning));
  choice.clear_digest = Sha256Hex(ContentOf(bytes));
  return absl::OkStatus();
}

absl::Status AddDecisions(const std::string& value, const SceneFrame& frame, WaterChoice& choice,
                          const std::stop_token& stop) {
  if (value.empty()) return absl::OkStatus();
  TILEMEND_ASSIGN_OR_RETURN(const VectorBytes bytes, ReadAreaFile(value));
  TILEMEND_ASSIGN_OR_RETURN(WaterFile file, ParseDecisionFile(bytes, value, frame, stop));
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
  std::vector<WaterArea> kept;
  for (WaterArea& water : choice.options.areas) {
    const size_t rings = water.polygon.rings.size();
    if (water.clear && !KeepRingsInside(area, water.polygon)) {
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
