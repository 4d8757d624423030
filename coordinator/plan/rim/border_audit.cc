#include "coordinator/plan/rim/border_audit.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "common/mesh/position_index.h"
#include "coordinator/plan/rim/buffered_cut.h"
#include "coordinator/plan/rim/surface_gap.h"
#include "coordinator/plan/types/meet_tolerance.h"

namespace tilemend {
namespace {

constexpr double kMostInside = 0.05;     // of a cell: a tile that ends farther inside its side ends at a shore, no cut
constexpr double kStraightShare = 0.05;  // of a side's length must run along the outline for it to count

std::optional<double> OutlineOffset(const SurveyRecord& record, const Grid& grid, CellId cell, Side side) {
  const int axis = AxisOf(side);
  const double extreme = side % 2 == 0 ? record.lo[axis] : record.hi[axis];
  const double offset = (extreme - NominalLine(grid, cell, side)) * OutwardOf(side);
  if (offset < -kMostInside * grid.cell_size[axis]) return std::nullopt;
  double along = 0;
  for (const BoundaryEdge& e : record.edges) {
    const Point3& a = record.vertices[e.from].position;
    const Point3& b = record.vertices[e.to].position;
    if (std::abs(a[axis] - extreme) > kMeetTolerance || std::abs(b[axis] - extreme) > kMeetTolerance) continue;
    along += std::abs(a[1 - axis] - b[1 - axis]);
  }
  if (along < kStraightShare * grid.cell_size[1 - axis]) return std::nullopt;
  return offset;
}

OutlineOffsets FindOffsets(const PlanInput& input) {
  OutlineOffsets offsets;
  for (const auto& [cell, record] : input.cells) {
    if (record == nullptr) continue;
    const auto outline = record.Outline();
    if (outline->vertices.empty()) continue;
    for (const Side side : kSides) {
      if (const auto offset = OutlineOffset(*outline, input.grid, cell, side)) offsets[{cell, side}] = *offset;
    }
  }
  return offsets;
}

// Whether most tiles end straight towards their neighbours. Those that were cut from one mesh with a buffer do not;
// then what lies beyond the lines is shores.
bool MostEndStraight(const PlanInput& input, const OutlineOffsets& offsets) {
  int64_t straight = 0, all = 0;
  for (const auto& [cell, record] : input.cells) {
    for (const Side side : kSides) {
      const auto other = input.cells.find(Across(cell, side));
      if (record == nullptr || other == input.cells.end() || other->second == nullptr) continue;
      ++all;
      straight += offsets.contains({cell, side});
    }
  }
  return 2 * straight > all;
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
  bool no_buffers = false;       // it has none, whatever lies beyond a line
  SharedVertices shared;         // of tiles that do not overlap
  std::vector<double> offsets;   // of outlines towards a neighbour
  int64_t exact = 0, apart = 0;  // borders whose tiles share vertices; that overlap or part
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

// The kind of a border where both tiles have surface, with what belongs to it.
//   buffers  null: there are none
void Classify(const SurveyRecord& record, const SurveyRecord& other, const Grid& grid, Side side,
              const OutlineOffsets& offsets, OutlineOffsets* buffers, BorderAudit& audit) {
  const auto mine = offsets.find({audit.a, side}), theirs = offsets.find({audit.b, Opposite(side)});
  const bool straight = mine != offsets.end() && theirs != offsets.end();
  if (straight) {
    audit.margins = {mine->second, theirs->second};
  } else if (const auto found = buffers ? FindBuffers(record, other, grid, audit.a, side) : std::nullopt) {
    const auto& [of_a, of_b] = *found;
    if (of_a) (*buffers)[{audit.a, side}] = *of_a;
    if (of_b) (*buffers)[{audit.b, Opposite(side)}] = *of_b;
    audit.margins = {of_a.value_or(0), of_b.value_or(0)};
    audit.kind = BorderKind::kOverlap;
  }
  audit.offset = audit.margins[0] + audit.margins[1];
  if (audit.shared_vertices >= 2 && audit.kind != BorderKind::kOverlap && audit.offset <= kMeetTolerance) {
    audit.kind = BorderKind::kExact;
    audit.margins = {};
    audit.offset = 0;
  } else if (straight) {
    audit.kind = KindOf(audit.offset);
  }
}

//   own  the outline of the cell; null: no surface
BorderAudit AuditBorder(const PlanInput& input, CellId cell, const SurveyRecord* own, Side side, BorderFindings& found,
                        CutEvidence& evidence) {
  const CellId other = Across(cell, side);
  BorderAudit audit;
  audit.a = cell, audit.b = other;
  for (const auto outline : {found.offsets.find({cell, side}), found.offsets.find({other, Opposite(side)})}) {
    if (outline != found.offsets.end()) evidence.offsets.push_back(outline->second);
  }
  const StoredRecord& neighbour = input.cells.at(other);
  if (own == nullptr || neighbour == nullptr) return audit;
  const auto other_record = neighbour.Outline();
  const auto shared = CountShared(*own, *other_record, AxisOf(side), NominalLine(input.grid, cell, side));
  audit.shared_vertices = shared.count;
  Classify(*own, *other_record, input.grid, side, found.offsets, evidence.no_buffers ? nullptr : &found.buffers, audit);
  evidence.exact += audit.kind == BorderKind::kExact;
  evidence.apart += audit.kind == BorderKind::kOverlap || std::abs(audit.offset) > kMeetTolerance;
  if (audit.kind == BorderKind::kOverlap) {
    audit.apart = CompareOver(*input.cells.at(cell).WithBand(), *neighbour.WithBand(), audit, input.grid, side);
  } else {
    evidence.shared.count += shared.count;
    evidence.shared.on_line += shared.on_line;
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
  found.borders.reserve(2 * input.cells.size());  // each cell has two of its own: growth would take as much again
  CutEvidence evidence;
  evidence.no_buffers = MostEndStraight(input, found.offsets);
  for (const auto& [cell, record] : input.cells) {
    const auto own = record == nullptr ? nullptr : record.Outline();
    for (const Side side : {kEast, kNorth}) {
      if (!input.cells.contains(Across(cell, side))) continue;
      found.borders.push_back(AuditBorder(input, cell, own.get(), side, found, evidence));
    }
  }
  bool straight_on_line = false;
  std::vector<double> all;
  all.reserve(found.offsets.size() + found.buffers.size());
  for (const auto& [side, offset] : found.offsets) {
    all.push_back(offset);
    straight_on_line |= std::abs(offset) <= kOnLine;
  }
  for (const auto& [side, offset] : found.buffers) all.push_back(offset);
  if (!all.empty()) found.usual_offset = Median(all);
  const auto& [shared, on_line] = evidence.shared;
  const std::vector<double>& telling = evidence.offsets.empty() ? all : evidence.offsets;
  found.independent = shared == 0 && !telling.empty() && std::abs(Median(telling)) > kMeetTolerance;
  found.independent |= evidence.apart > evidence.exact;
  found.clipped = shared > 0 ? on_line >= shared - on_line : straight_on_line;
  return found;
}

}  // namespace tilemend
