#include "coordinator/plan/rim/border_audit.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "common/mesh/position_index.h"
#include "coordinator/plan/rim/surface_gap.h"

namespace tilemend {
namespace {

constexpr double kMostOffset = 0.05;     // of a cell: a tile that ends farther from its side ends at a shore, not a cut
constexpr double kStraightShare = 0.05;  // of a side's length must run along the outline for it to count

std::optional<double> OutlineOffset(const SurveyRecord& record, const Grid& grid, CellId cell, Side side) {
  const int axis = AxisOf(side);
  const double extreme = side % 2 == 0 ? record.lo[axis] : record.hi[axis];
  const double offset = (extreme - NominalLine(grid, cell, side)) * OutwardOf(side);
  if (std::abs(offset) > kMostOffset * grid.cell_size[axis]) return std::nullopt;
  double along = 0;
  for (const BoundaryEdge& e : record.edges) {
    const Point3& a = record.vertices[e.from].position;
    const Point3& b = record.vertices[e.to].position;
    if (std::abs(a[axis] - extreme) > kStraight || std::abs(b[axis] - extreme) > kStraight) continue;
    along += std::abs(a[1 - axis] - b[1 - axis]);
  }
  if (along < kStraightShare * grid.cell_size[1 - axis]) return std::nullopt;
  return offset;
}

OutlineOffsets FindOffsets(const PlanInput& input) {
  OutlineOffsets offsets;
  for (const auto& [cell, record] : input.cells) {
    if (record == nullptr || record->vertices.empty()) continue;
    for (const Side side : kSides) {
      if (const auto offset = OutlineOffset(*record, input.grid, cell, side)) offsets[{cell, side}] = *offset;
    }
  }
  return offsets;
}

struct SharedVertices {
  int64_t count = 0;
  int64_t on_line = 0;
};

SharedVertices CountShared(const SurveyRecord& a, const SurveyRecord& b, int axis, double line) {
  PositionIndex index;
  for (const BoundaryVertex& v : a.vertices) index.Insert(v.position);
  SharedVertices shared;
  for (const BoundaryVertex& v : b.vertices) {
    if (index.Find(v.position) < 0) continue;
    ++shared.count;
    if (std::abs(v.position[axis] - line) <= kOnLine) ++shared.on_line;
  }
  return shared;
}

// What all borders say of the cut.
struct CutEvidence {
  SharedVertices shared;
  std::vector<double> offsets;  // of outlines towards a neighbour
};

BorderKind KindOf(double offset) {
  if (offset > kOnLine) return BorderKind::kOverlap;
  return offset < -kOnLine ? BorderKind::kGap : BorderKind::kNear;
}

SurfaceGap CompareOver(const SurveyRecord& record, const SurveyRecord& other, const BorderAudit& audit,
                       const Grid& grid, Side side) {
  const double line = NominalLine(grid, audit.a, side);
  return MeasureGap({record, line + audit.margins[0]}, {other, line - audit.margins[1]}, AxisOf(side));
}

BorderAudit AuditBorder(const PlanInput& input, const OutlineOffsets& offsets, CellId cell, Side side,
                        CutEvidence& evidence) {
  const CellId other = Across(cell, side);
  BorderAudit audit;
  audit.a = cell, audit.b = other;
  const auto mine = offsets.find({cell, side}), theirs = offsets.find({other, Opposite(side)});
  for (const auto outline : {mine, theirs}) {
    if (outline != offsets.end()) evidence.offsets.push_back(outline->second);
  }
  const SurveyRecord *record = input.cells.at(cell), *other_record = input.cells.at(other);
  if (record == nullptr || other_record == nullptr) return audit;
  const auto shared = CountShared(*record, *other_record, AxisOf(side), NominalLine(input.grid, cell, side));
  evidence.shared.count += shared.count;
  evidence.shared.on_line += shared.on_line;
  audit.shared_vertices = shared.count;
  if (shared.count >= 2) {
    audit.kind = BorderKind::kExact;
  } else if (mine != offsets.end() && theirs != offsets.end()) {
    audit.margins = {mine->second, theirs->second};
    audit.offset = mine->second + theirs->second;
    audit.kind = KindOf(audit.offset);
    if (audit.kind == BorderKind::kOverlap) audit.apart = CompareOver(*record, *other_record, audit, input.grid, side);
  }
  return audit;
}

double Median(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + static_cast<ptrdiff_t>(values.size() / 2), values.end());
  return values[values.size() / 2];
}

}  // namespace

BorderFindings AuditBorders(const PlanInput& input) {
  BorderFindings found;
  if (!input.has_grid) return found;
  found.offsets = FindOffsets(input);
  CutEvidence evidence;
  for (const auto& [cell, record] : input.cells) {
    for (const Side side : {kEast, kNorth}) {
      if (!input.cells.contains(Across(cell, side))) continue;
      found.borders.push_back(AuditBorder(input, found.offsets, cell, side, evidence));
    }
  }
  bool straight_on_line = false;
  std::vector<double> all;
  for (const auto& [side, offset] : found.offsets) {
    all.push_back(offset);
    straight_on_line |= std::abs(offset) <= kOnLine;
  }
  if (!all.empty()) found.usual_offset = Median(all);
  const auto& [shared, on_line] = evidence.shared;
  const std::vector<double>& telling = evidence.offsets.empty() ? all : evidence.offsets;
  found.independent = shared == 0 && !telling.empty() && std::abs(Median(telling)) > kStraight;
  found.clipped = shared > 0 ? on_line >= shared - on_line : straight_on_line;
  return found;
}

}  // namespace tilemend
