#include "coordinator/report/water_choice.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "absl/strings/str_cat.h"
#include "common/gis/area_file.h"
#include "common/store/digest.h"
#include "common/util/status_macros.h"

namespace tilemend {
namespace {

// Twice the area of a triangle; positive if it turns left.
double Turn(const Point2& a, const Point2& b, const Point2& c) {
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

// Whether the outlines of two polygons cross each other. Cost O(points * points).
bool CrossesEdge(const PlanePolygon& a, const PlanePolygon& b) {
  const auto crosses_any = [&](const Point2& p, const Point2& q) {
    for (const std::vector<Point2>& ring : b.rings) {
      for (size_t k = 0; k < ring.size(); ++k) {
        const Point2 &r = ring[k], &s = ring[(k + 1) % ring.size()];
        if (Turn(p, q, r) * Turn(p, q, s) < 0 && Turn(r, s, p) * Turn(r, s, q) < 0) return true;
      }
    }
    return false;
  };
  for (const std::vector<Point2>& ring : a.rings) {
    for (size_t k = 0; k < ring.size(); ++k) {
      if (crosses_any(ring[k], ring[(k + 1) % ring.size()])) return true;
    }
  }
  return false;
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

absl::Status KeepClearInside(const PlanePolygon& area, WaterChoice& choice) {
  if (area.empty()) return absl::OkStatus();
  std::vector<WaterArea> kept;
  for (WaterArea& water : choice.options.areas) {
    const bool goes_beyond = CrossesEdge(water.polygon, area) || Contains(water.polygon, area.rings[0][0]);
    if (water.clear && goes_beyond) {
      return absl::InvalidArgumentError(absl::StrCat(
          water.label, ": lies across the edge of the area; what it takes out beyond would stay open: draw it inside"));
    }
    if (!water.clear || Contains(area, water.polygon.rings[0][0])) {
      kept.push_back(std::move(water));
    } else {
      choice.warnings.push_back(
          absl::StrCat(water.label, ": lies outside the area, so nothing is taken out and nothing filled there"));
    }
  }
  choice.options.areas = std::move(kept);
  return absl::OkStatus();
}

}  // namespace tilemend
