#include "worker/papers/wang/grid_stretches.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

namespace tilemend {
namespace {

constexpr double kOnGridLine = 1e-3;  // metres
constexpr uint8_t kVerticalLine = 1, kHorizontalLine = 2;

Point2 PlaceOf(const LocalHole& hole, int32_t v) { return hole.positions[v].head<2>(); }

// Of a new vertex on a grid line which one it is, as RimVertex::lines; of any other, those at corners included, 0.
uint8_t LineAt(const LocalHole& hole, int32_t v) {
  const int32_t k = hole.vertices[v];
  if (k < 0 || hole.cell->vertices[k].index >= 0) return 0;
  const uint8_t lines = hole.cell->vertices[k].lines;
  return lines == kVerticalLine || lines == kHorizontalLine ? lines : 0;
}

// The stretches around one loop.
class LoopWalk {
 public:
  LoopWalk(const LocalHole& hole, const std::vector<int32_t>& loop)
      : hole_(hole), loop_(loop), n_(static_cast<int>(loop.size())) {}

  void AddTo(std::vector<GridStretch>& stretches) const {
    int start = 0;
    while (start < n_ && LineFrom(start) == LineFrom(start - 1)) ++start;
    for (int i = start; start < n_ && i < start + n_;) {
      const uint8_t line = LineFrom(i);
      int end = i + 1;
      while (end < start + n_ && LineFrom(end) == line) ++end;
      if (line != 0) stretches.push_back(StretchAlong(i, end));
      i = end;
    }
  }

 private:
  int32_t At(int i) const { return loop_[(i % n_ + n_) % n_]; }
  // Of the segment from place i on.
  uint8_t LineFrom(int i) const { return std::max(LineAt(hole_, At(i)), LineAt(hole_, At(i + 1))); }

  GridStretch StretchAlong(int begin, int end) const {
    GridStretch s;
    for (int i = begin; i <= end; ++i) s.vertices.push_back(At(i));
    for (int i = begin - 1; i > begin - n_ && (s.before.empty() || LineFrom(i) == 0); --i) s.before.push_back(At(i));
    for (int i = end + 1; i < end + n_ && (s.after.empty() || LineFrom(i - 1) == 0); ++i) s.after.push_back(At(i));
    const auto on_line =
        *std::find_if(s.vertices.begin(), s.vertices.end(), [&](int32_t v) { return LineAt(hole_, v) != 0; });
    s.axis = LineAt(hole_, on_line) == kVerticalLine ? 0 : 1;
    s.line = PlaceOf(hole_, on_line)[s.axis];
    const int along = 1 - s.axis;
    s.way = PlaceOf(hole_, s.vertices.back())[along] > PlaceOf(hole_, s.vertices.front())[along] ? 1 : -1;
    s.own = (s.way > 0) == (s.axis == 0) ? -1 : 1;
    return s;
  }

  const LocalHole& hole_;
  const std::vector<int32_t>& loop_;
  const int n_;
};

// Neighbours' outlines within a hole.
class InnerLines {
 public:
  explicit InnerLines(const LocalHole& hole) : hole_(hole) {
    for (const RegionSegment& e : hole.inner_edges) {
      const Point2 a = PlaceOf(hole, e.from), b = PlaceOf(hole, e.to);
      for (const int axis : {0, 1}) {
        if (std::abs(a[axis] - b[axis]) < kOnGridLine) along_[axis][a[axis]].emplace(a[1 - axis], e.from);
      }
    }
  }

  // Where the neighbour's outline beside that stretch runs: the nearest one.
  std::optional<double> Beside(const GridStretch& s) const {
    std::optional<double> nearest;
    for (const auto& [line, vertices] : along_[s.axis]) {
      const double off = s.own * (line - s.line);
      if (off > kOnGridLine && (!nearest || off < s.own * (*nearest - s.line))) nearest = line;
    }
    return nearest;
  }

  // Its vertices.
  std::vector<int32_t> On(int axis, double line) const {
    std::vector<int32_t> vertices;
    for (auto it = along_[axis].lower_bound(line - kOnGridLine);
         it != along_[axis].end() && it->first < line + kOnGridLine; ++it) {
      for (const auto& [t, v] : it->second) vertices.push_back(v);
    }
    return vertices;
  }

  GridStretch Moved(const GridStretch& own, double line) const {
    GridStretch moved = own;
    moved.line = line;
    std::map<double, int32_t> at;
    for (const int32_t v : On(own.axis, line)) at.emplace(PlaceOf(hole_, v)[1 - own.axis], v);
    moved.vertices = {own.vertices.front()};
    for (size_t i = 1; i + 1 < own.vertices.size(); ++i) {
      const double t = PlaceOf(hole_, own.vertices[i])[1 - own.axis];
      const auto across = at.lower_bound(t - kOnGridLine);
      if (across != at.end() && across->first < t + kOnGridLine) moved.vertices.push_back(across->second);
    }
    moved.vertices.push_back(own.vertices.back());
    for (std::vector<int32_t>* beside : {&moved.before, &moved.after}) {
      const auto beyond = std::find_if(beside->begin(), beside->end(),
                                       [&](int32_t v) { return moved.OffLine(PlaceOf(hole_, v)) > kOnGridLine; });
      beside->erase(beside->begin(), beyond);
    }
    return moved;
  }

 private:
  const LocalHole& hole_;
  std::map<double, std::map<double, int32_t>> along_[2];  // by axis, line and place along it
};

}  // namespace

std::vector<GridStretch> StretchesAround(const LocalHole& hole) {
  std::vector<GridStretch> stretches;
  for (const std::vector<int32_t>& loop : LoopsOf(hole.segments)) LoopWalk(hole, loop).AddTo(stretches);
  return stretches;
}

void MoveToNeighbours(const LocalHole& hole, std::vector<GridStretch>& stretches) {
  if (hole.inner_edges.empty()) return;
  const InnerLines inner(hole);
  for (GridStretch& s : stretches) {
    if (const std::optional<double> line = inner.Beside(s)) s = inner.Moved(s, *line);
  }
}

std::vector<uint8_t> StripsBeside(const LocalHole& hole) {
  std::vector<uint8_t> strips(hole.size(), 0);
  if (hole.inner_edges.empty()) return strips;
  const InnerLines inner(hole);
  for (const GridStretch& s : StretchesAround(hole)) {
    const std::optional<double> line = inner.Beside(s);
    if (!line) continue;
    const auto side = static_cast<uint8_t>(1U << (2 * s.axis + (s.own > 0 ? 1 : 0)));
    for (const int32_t v : s.vertices) {
      if (std::abs(s.OffLine(PlaceOf(hole, v))) < kOnGridLine) strips[v] |= side;
    }
    for (const int32_t v : inner.On(s.axis, *line)) strips[v] |= side;
  }
  return strips;
}

}  // namespace tilemend
