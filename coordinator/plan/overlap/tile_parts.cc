#include "coordinator/plan/overlap/tile_parts.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace tilemend {
namespace {

constexpr double kStraight = 2e-3;     // metres: an outline whose vertices agree to this is straight
constexpr double kLeastLength = 0.05;  // of a cell: of a tile's outlines along a line
constexpr double kSameLine = 0.05;     // metres: lines in two cells this near are one

// Lengths of straight outline by coordinate.
using Lengths = std::map<int64_t, double>;

struct PieceLine {
  double place = 0;    // from the cell's west or south side
  double overlap = 0;  // of the pieces there
};

class LineFinder {
 public:
  // Pieces overlap by less than `reach`.
  LineFinder(const PlanInput& input, int axis, double reach) : input_(input), axis_(axis), reach_(reach) {}

  // In rising order.
  std::vector<PieceLine> Run() {
    for (const auto& [cell, record] : input_.cells) {
      if (record != nullptr) FindIn(cell, *record);
    }
    std::sort(found_.begin(), found_.end(), [](const PieceLine& a, const PieceLine& b) { return a.place < b.place; });
    std::vector<PieceLine> lines;
    for (size_t i = 0; i < found_.size();) {
      PieceLine sum;
      size_t k = i;
      for (; k < found_.size() && found_[k].place - found_[i].place <= kSameLine; ++k) {
        sum.place += found_[k].place;
        sum.overlap = std::max(sum.overlap, found_[k].overlap);
      }
      sum.place /= static_cast<double>(k - i);
      if (!IsCrossed(sum.place)) lines.push_back(sum);
      i = k;
    }
    return lines;
  }

 private:
  // Whether a piece of any cell goes on across a line.
  bool IsCrossed(double place) const {
    for (const auto& [cell, record] : input_.cells) {
      if (record == nullptr) continue;
      const double low = NominalLine(input_.grid, cell, axis_ == 0 ? kWest : kSouth);
      std::map<int32_t, std::pair<bool, bool>> sides;  // of each piece: whether it is on either
      for (const BoundaryVertex& v : record->vertices) {
        auto& [below, above] = sides[v.piece];
        below |= v.position[axis_] - low < place - reach_;
        above |= v.position[axis_] - low > place + reach_;
        if (below && above) return true;
      }
    }
    return false;
  }

  void FindIn(CellId cell, const SurveyRecord& record) {
    const double size = input_.grid.cell_size[axis_];
    const double low = input_.grid.corner[axis_] + (axis_ == 0 ? cell.col : cell.row) * size;
    Lengths ends, begins;  // of surface, going up along the axis
    for (const BoundaryEdge& e : record.edges) {
      const Point3 &a = record.vertices[e.from].position, &b = record.vertices[e.to].position;
      const double place = a[axis_] - low;
      if (std::abs(a[axis_] - b[axis_]) > kStraight || place < reach_ || place > size - reach_) {
        continue;
      }
      const double along = b[1 - axis_] - a[1 - axis_];
      const bool surface_below = (along > 0) == (axis_ == 0);
      (surface_below ? ends : begins)[std::llround(place / kStraight)] += std::abs(along);
    }
    DropShort(ends), DropShort(begins);
    for (const auto& [begin, length] : begins) {
      const auto end = ends.lower_bound(begin + 1);
      if (end == ends.end() || static_cast<double>(end->first - begin) * kStraight > reach_) continue;
      found_.push_back({static_cast<double>(begin + end->first) / 2 * kStraight,
                        static_cast<double>(end->first - begin) * kStraight});
    }
  }

  void DropShort(Lengths& lengths) const {
    const double least = kLeastLength * input_.grid.cell_size[1 - axis_];
    std::erase_if(lengths, [&](const auto& l) { return l.second < least; });
  }

  const PlanInput& input_;
  const int axis_;
  const double reach_;
  std::vector<PieceLine> found_;
};

class Splitter {
 public:
  Splitter(const PlanInput& input, const GridLines& own, double step, TileParts& parts)
      : input_(input), own_(own), step_(step), parts_(parts) {}

  void Run() {
    for (const int axis : {0, 1}) lines_[axis] = LineFinder(input_, axis, own_.piece_reach).Run();
    parts_.columns = static_cast<int32_t>(lines_[0].size()) + 1;
    parts_.rows = static_cast<int32_t>(lines_[1].size()) + 1;
    parts_.input = input_;
    parts_.own = own_;
    if (!parts_.whole()) {
      parts_.input.cells.clear();
      parts_.own.coordinate.clear();
      parts_.own.left_open.clear();
      for (const auto& [cell, record] : input_.cells) Split(cell, record);
      for (auto& [part, record] : parts_.records) parts_.input.cells[part] = &record;
    }
    for (const auto& [part, record] : parts_.input.cells) {
      for (const Side s : kSides) parts_.line[{part, s}] = LineAt(part, s);
    }
    if (parts_.whole()) return;
    for (const auto& [part, record] : parts_.input.cells) {
      for (const Side s : kSides) SetOutline(part, s);
    }
  }

 private:
  int32_t Number(int axis) const { return axis == 0 ? parts_.columns : parts_.rows; }
  static int32_t IndexOf(CellId cell, int axis) { return axis == 0 ? cell.col : cell.row; }

  // The number within its cell of the line on a side of a part; 0 and Number(axis): the cell's own sides.
  int32_t LineNumber(CellId part, Side side) const {
    const int axis = AxisOf(side);
    return IndexOf(part, axis) - IndexOf(parts_.TileOf(part), axis) * Number(axis) + side % 2;
  }

  double LineAt(CellId part, Side side) const {
    const int axis = AxisOf(side);
    const int32_t n = LineNumber(part, side), cell = IndexOf(parts_.TileOf(part), axis);
    const double size = input_.grid.cell_size[axis], low = input_.grid.corner[axis];
    const double place = n == 0              ? low + cell * size
                         : n == Number(axis) ? low + (cell + 1) * size
                                             : low + cell * size + lines_[axis][n - 1].place;
    return std::round(place / step_) * step_;
  }

  void Split(CellId cell, const SurveyRecord* record) {
    std::map<CellId, std::set<int32_t>> pieces;
    for (int32_t r = 0; r < parts_.rows; ++r) {
      for (int32_t c = 0; c < parts_.columns; ++c) {
        const CellId part{cell.col * parts_.columns + c, cell.row * parts_.rows + r};
        parts_.input.cells[part] = nullptr;
        pieces[part];
      }
    }
    if (record == nullptr) return;
    std::map<int32_t, std::pair<Point3, Point3>> extent;
    for (const BoundaryVertex& v : record->vertices) {
      auto& [lo, hi] = extent.try_emplace(v.piece, v.position, v.position).first->second;
      lo = lo.cwiseMin(v.position);
      hi = hi.cwiseMax(v.position);
    }
    for (const auto& [piece, box] : extent) {
      const auto [c0, c1] = Range(cell, 0, box.first.x(), box.second.x());
      const auto [r0, r1] = Range(cell, 1, box.first.y(), box.second.y());
      for (int32_t r = r0; r <= r1; ++r) {
        for (int32_t c = c0; c <= c1; ++c) {
          pieces[{cell.col * parts_.columns + c, cell.row * parts_.rows + r}].insert(piece);
        }
      }
    }
    for (const auto& [part, of_part] : pieces) {
      if (!of_part.empty()) MakeRecord(part, *record, of_part);
    }
  }

  // The parts that [lo, hi] reaches into by more than an overlap.
  std::pair<int32_t, int32_t> Range(CellId cell, int axis, double lo, double hi) const {
    const double low = input_.grid.corner[axis] + IndexOf(cell, axis) * input_.grid.cell_size[axis];
    const auto part_of = [&](double x, double slack) {
      int32_t n = 0;
      for (const PieceLine& line : lines_[axis]) n += x - low > line.place + slack * line.overlap;
      return n;
    };
    const int32_t first = part_of(lo, -1), last = part_of(hi, 1);
    if (first <= last) return {first, last};
    const int32_t middle = part_of((lo + hi) / 2, 0);
    return {middle, middle};
  }

  void MakeRecord(CellId part, const SurveyRecord& tile, const std::set<int32_t>& pieces) {
    SurveyRecord& record = parts_.records[part];
    std::vector<int32_t>& vertex_of = parts_.vertex_of[part];
    record.vertex_count = tile.vertex_count;
    record.triangle_count = tile.triangle_count;
    record.float32 = tile.float32;
    std::vector<int32_t> number(tile.vertices.size(), -1);
    record.lo = Point3::Constant(INFINITY), record.hi = -record.lo;
    for (size_t v = 0; v < number.size(); ++v) {
      if (!pieces.contains(tile.vertices[v].piece)) continue;
      number[v] = static_cast<int32_t>(record.vertices.size());
      record.vertices.push_back(tile.vertices[v]);
      vertex_of.push_back(static_cast<int32_t>(v));
      record.lo = record.lo.cwiseMin(tile.vertices[v].position);
      record.hi = record.hi.cwiseMax(tile.vertices[v].position);
    }
    for (const BoundaryEdge& e : tile.edges) {
      if (number[e.from] >= 0 && number[e.to] >= 0) record.edges.push_back({number[e.from], number[e.to]});
    }
  }

  // A part ends at the tile's outline or at its own, which lies half an overlap behind the line.
  void SetOutline(CellId part, Side side) {
    const int axis = AxisOf(side);
    const int32_t n = LineNumber(part, side);
    const CellId tile = parts_.TileOf(part);
    double& outline = parts_.own.coordinate[{part, side}];
    if (n == 0 || n == Number(axis)) {
      outline = own_.At(tile, side);
      const CellId across = Across(tile, side);
      if (own_.left_open.contains(std::minmax(tile, across))) {
        parts_.own.left_open.insert(std::minmax(part, Across(part, side)));
      }
      return;
    }
    const double line = parts_.line.at({part, side}), overlap = lines_[axis][n - 1].overlap;
    outline = std::round((line + OutwardOf(side) * overlap / 2) / step_) * step_;
    const auto record = parts_.records.find(part);
    if (record == parts_.records.end()) return;
    const double extreme = side % 2 == 0 ? record->second.lo[axis] : record->second.hi[axis];
    if (std::abs(extreme - outline) < overlap / 2) outline = extreme;
  }

  const PlanInput& input_;
  const GridLines& own_;
  const double step_;
  TileParts& parts_;
  std::vector<PieceLine> lines_[2];
};

int32_t FloorDivided(int32_t a, int32_t b) { return a >= 0 ? a / b : -((b - 1 - a) / b); }

}  // namespace

CellId TileParts::TileOf(CellId part) const { return {FloorDivided(part.col, columns), FloorDivided(part.row, rows)}; }

TileParts SplitTiles(const PlanInput& input, const GridLines& own, double lattice_step) {
  TileParts parts;
  Splitter(input, own, lattice_step, parts).Run();
  return parts;
}

}  // namespace tilemend
