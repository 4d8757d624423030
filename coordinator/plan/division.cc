#include "coordinator/plan/division.h"

#include <algorithm>
#include <utility>

#include "coordinator/plan/hole/hole_regions.h"
#include "coordinator/plan/hole/sort_boundary.h"
#include "coordinator/plan/rim/rim_index.h"
#include "coordinator/plan/seam/pieces_beside_seams.h"
#include "coordinator/plan/seam/seams_along_rim.h"

namespace tilemend {
namespace {

// Readings of a ragged cut that are tried.
constexpr int kAttempts = 4;

class Divider {
 public:
  explicit Divider(const Part& part) : part_(part), index_(part.rim) {
    for (const auto& [cell, record] : part.input.cells) area_.insert(cell);
  }

  Division DivideScene(const ClosingCells& closing) const {
    SeamsOverRim over_rim = SeamsOverRim::kYes;
    Division division = Divide(closing, over_rim);
    // Seams that take rim vertices beside them may cede the last of a hole.
    if (CountFailures(division) > 0) {
      Division on_lines = Divide(closing, SeamsOverRim::kNo);
      if (CountFailures(on_lines) < CountFailures(division)) {
        division = std::move(on_lines);
        over_rim = SeamsOverRim::kNo;
      }
    }
    if (part_.lines.clipped) return division;
    return TryOtherReadings(std::move(division), over_rim);
  }

 private:
  SeamSite Site() const { return {area_, part_.lines, part_.rim, index_, part_.options, part_.lattice_step}; }

  Division Divide(ClosingCells closing, SeamsOverRim over_rim) const {
    Division division;
    division.seams = LaySeams(Site(), closing, over_rim);
    if (!part_.lines.clipped) GivePiecesToTheirSide(Site(), division.seams, closing);
    CloseAlongSeams(Site(), division.seams.seams, closing);
    CellBoundaries boundaries;
    for (const auto& loop : part_.rim.loops) AddLoop(part_.input, part_.lines, part_.rim, closing, loop, boundaries);
    FindHolesOfCells(boundaries, division);
    return division;
  }

  // The zigzag of a border can be read in more than one way, and the reading of the closing cells may bound no regions
  // near grid corners. There, edges go back to their owners, ever farther around.
  Division TryOtherReadings(Division first, SeamsOverRim over_rim) const {
    std::vector<Point2> trouble = TroubleOf(first);
    if (trouble.empty()) return first;
    ClosingCells closing = FindClosingCells(part_.input, part_.lines, part_.rim);
    Division best = first, last = std::move(first);
    for (int attempt = 1; attempt <= kAttempts && !trouble.empty(); ++attempt) {
      GiveBackNear(part_.input, part_.rim, trouble, 2 * attempt * index_.mean_size(), closing);
      last = Divide(closing, over_rim);
      trouble = TroubleOf(last);
      if (CountFailures(last) < CountFailures(best)) best = last;
    }
    if (CountFailures(last) == CountFailures(best)) return last;
    return best;
  }

  static size_t CountFailures(const Division& division) {
    size_t count = 0;
    for (const auto& [cell, found] : division.holes) {
      for (const PlannedHole& hole : found.holes) count += !hole.failure.empty();
    }
    return count;
  }

  // Where seams could not be laid, or end on the boundary of a hole that failed.
  std::vector<Point2> TroubleOf(const Division& division) const {
    std::vector<Point2> points = division.seams.trouble;
    for (const auto& [cell, found] : division.holes) {
      for (const PlannedHole& hole : found.holes) {
        if (!hole.failure.empty()) AddEnds(hole, points);
      }
    }
    return points;
  }

  // Its own points where it has no seam: one cell closes on all of a piece that lies over the line.
  void AddEnds(const PlannedHole& hole, std::vector<Point2>& points) const {
    const bool seams = std::any_of(hole.segments.begin(), hole.segments.end(), [](const auto& s) { return s.seam; });
    for (const RimSegment& s : hole.segments) {
      if (s.seam != seams) continue;
      for (const int32_t v : {s.from, s.to}) {
        if (v < std::ssize(part_.rim.points)) points.emplace_back(part_.rim.points[v].position.head<2>());
      }
    }
  }

  void FindHolesOfCells(CellBoundaries& boundaries, Division& division) const {
    for (const Seam& seam : division.seams.seams) AddSeam(part_.input, part_.rim, index_, seam, boundaries);
    std::vector<Point3> position;
    for (const RimPoint& p : part_.rim.points) position.push_back(p.position);
    for (const SeamVertex& v : division.seams.vertices) position.emplace_back(v.position.x(), v.position.y(), 0);
    const HoleSite site{area_, part_.lines, part_.rim, position, part_.options.is_cancelled};
    for (const LeftOpen& failure : division.seams.failures) {
      const auto boundary = boundaries.find(failure.cell);
      if (boundary == boundaries.end()) continue;
      std::string& reason = boundary->second.seam_failure;
      if (reason.empty()) reason = failure.reason;
    }
    for (auto& [cell, boundary] : boundaries) {
      if (part_.options.cancelled()) return;
      boundary.cell = cell;
      const StoredRecord& record = part_.input.cells.at(cell);
      boundary.has_surface = record != nullptr && record->triangle_count > 0;
      const StoredRecord& own = part_.own.cells.at(cell);
      if (own != nullptr) boundary.surface = &own;
      division.holes[cell] = FindHoles(site, boundary);
    }
  }

  const Part& part_;
  const RimIndex index_;
  std::set<CellId> area_;
};

}  // namespace

Division DivideScene(const Part& part, const ClosingCells& closing) { return Divider(part).DivideScene(closing); }

}  // namespace tilemend
