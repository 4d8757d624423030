#include "coordinator/plan/seam/seam_layout.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <utility>

#include "absl/strings/str_format.h"
#include "coordinator/plan/seam/seam_path.h"

namespace tilemend {
namespace {

constexpr double kRimTolerance = 1e-3;  // metres: a grid corner this near the rim lies on it
// Metres: places this near one another are one. A few steps of float32 at a few hundred metres.
constexpr double kSamePlace = 2e-5;
constexpr double kCornerSnap = 0.25;  // of the rim's edge length: a grid corner this near a rim point is that point
constexpr double kRimClearance =
    0.4;  // of the wanted edge length: seam vertices nearer than this to the rim are not made

// A border between two cells, at least one of them in the area; b is east or north of a.
using Border = std::pair<CellId, CellId>;
// The grid corner at the south-west of a cell.
using Corner = CellId;

struct Junction {
  double t;       // along the line
  int32_t point;  // of the rim
  bool start;     // the hole lies towards larger t
};

bool IsVertical(const Border& b) { return b.first.row == b.second.row; }
Corner LowCorner(const Border& b) { return b.second; }
Corner HighCorner(const Border& b) {
  return IsVertical(b) ? Corner{b.second.col, b.second.row + 1} : Corner{b.second.col + 1, b.second.row};
}

class Layout {
 public:
  Layout(const std::set<CellId>& area, const CutLines& lines, const Rim& rim, const RimIndex& index,
         const PlanOptions& options, double lattice_step)
      : area_(area), lines_(lines), rim_(rim), index_(index), options_(options), step_(lattice_step) {}

  SeamLayout Run() {
    ListBorders();
    FindJunctions();
    for (auto& [border, junctions] : junctions_) SortJunctions(border, junctions);
    DecideCorners();
    for (const auto& [border, junctions] : junctions_) LayBorder(border, junctions);
    return std::move(result_);
  }

 private:
  void ListBorders() {
    for (const CellId cell : area_) {
      for (const Side side : kSides) {
        const CellId across = Across(cell, side);
        junctions_[side % 2 == 0 ? Border{across, cell} : Border{cell, across}];
      }
    }
  }

  // The line's coordinate on its constant axis.
  double LineOf(const Border& b) const {
    const bool vertical = IsVertical(b);
    if (area_.contains(b.first)) return lines_.At(b.first, vertical ? kEast : kNorth);
    return lines_.At(b.second, vertical ? kWest : kSouth);
  }

  void FindJunctions() {
    for (const std::vector<int32_t>& loop : rim_.loops) {
      for (size_t k = 0; k < loop.size(); ++k) {
        const RimEdge& in = rim_.edges[loop[k]];
        Step(in.label, rim_.edges[loop[(k + 1) % loop.size()]].label, in.to);
      }
    }
  }

  // The rim passes from cell a to cell b at `point`, with the hole on the right.
  void Step(CellId a, CellId b, int32_t point) {
    if (a == b) return;
    const int32_t dc = b.col - a.col, dr = b.row - a.row;
    if (std::abs(dc) + std::abs(dr) == 1) {
      AddJunction(a, b, point);
    } else if (std::abs(dc) == 1 && std::abs(dr) == 1) {
      const CellId right = dc * dr > 0 ? CellId{a.col + dc, a.row} : CellId{a.col, a.row + dr};
      AddJunction(a, right, point);
      AddJunction(right, b, point);
    } else if (area_.contains(a) || area_.contains(b)) {
      result_.failures.push_back({area_.contains(a) ? a : b,
                                  absl::StrFormat("at (%.3f, %.3f) one edge of the surface reaches over a whole cell",
                                                  rim_.points[point].position.x(), rim_.points[point].position.y())});
    }
  }

  void AddJunction(CellId a, CellId b, int32_t point) {
    const bool forward = a < b;
    const Border border = forward ? Border{a, b} : Border{b, a};
    const auto it = junctions_.find(border);
    if (it == junctions_.end()) return;  // neither cell is in the area
    const bool vertical = IsVertical(border);
    // Going east over a vertical line the hole is to the south; going north over a horizontal line it is to the east.
    const bool start = vertical ? !forward : forward;
    it->second.push_back({rim_.points[point].position[vertical ? 1 : 0], point, start});
  }

  // Orders the junctions along a border. Junctions nearer than the tolerance (a tile's own sliver along the line, a
  // hairline between tiles) have no order of their own: there, starts and ends take turns.
  void SortJunctions(const Border& border, std::vector<Junction>& junctions) const {
    std::sort(junctions.begin(), junctions.end(), [](const Junction& a, const Junction& b) {
      if (a.t != b.t) return a.t < b.t;
      if (a.start != b.start) return !a.start;  // one hole ends before the next begins
      return a.point < b.point;
    });
    bool inside = false;
    for (size_t begin = 0; begin < junctions.size();) {
      size_t end = begin + 1;
      while (end < junctions.size() && junctions[end].t - junctions[end - 1].t <= lines_.tolerance) ++end;
      if (begin == 0)
        inside = StartsInside(border, {junctions.begin(), junctions.begin() + static_cast<ptrdiff_t>(end)});
      for (; begin < end; ++begin) {
        size_t next = begin;
        while (next < end && junctions[next].start == inside) ++next;
        if (next < end)
          std::rotate(junctions.begin() + static_cast<ptrdiff_t>(begin),
                      junctions.begin() + static_cast<ptrdiff_t>(next),
                      junctions.begin() + static_cast<ptrdiff_t>(next) + 1);
        inside = junctions[begin].start;
      }
    }
  }

  // Whether the border begins in a hole, by its first junctions.
  bool StartsInside(const Border& border, const std::vector<Junction>& first) const {
    const auto starts = std::count_if(first.begin(), first.end(), [](const Junction& j) { return j.start; });
    const auto ends = static_cast<ptrdiff_t>(first.size()) - starts;
    if (starts != ends) return ends > starts;
    return !index_.InSurface(CornerPosition(LowCorner(border)), kRimTolerance);
  }

  // Which corners lie in a hole: the outermost junctions of the four borders there tell; without any, the winding
  // number does.
  void DecideCorners() {
    std::map<Corner, std::pair<int, int>> votes;  // in a hole, on the surface
    for (const auto& [border, junctions] : junctions_) {
      auto& low = votes[LowCorner(border)];
      auto& high = votes[HighCorner(border)];
      if (junctions.empty()) continue;
      ++(junctions.front().start ? low.second : low.first);
      ++(junctions.back().start ? high.first : high.second);
    }
    for (const auto& [corner, vote] : votes) {
      in_hole_[corner] = vote.first != vote.second ? vote.first > vote.second
                                                   : !index_.InSurface(CornerPosition(corner), kRimTolerance);
    }
  }

  Point2 CornerPosition(Corner c) const {
    const Border vertical[2] = {{{c.col - 1, c.row}, c}, {{c.col - 1, c.row - 1}, {c.col, c.row - 1}}};
    const Border horizontal[2] = {{{c.col, c.row - 1}, c}, {{c.col - 1, c.row - 1}, {c.col - 1, c.row}}};
    const auto line = [&](const Border(&pair)[2]) { return LineOf(junctions_.contains(pair[0]) ? pair[0] : pair[1]); };
    return {line(vertical), line(horizontal)};
  }

  // The plan vertex at a corner in a hole: a rim point if one is very near, else a new vertex.
  int32_t CornerVertex(Corner c) {
    const auto [it, fresh] = corner_vertex_.try_emplace(c, -1);
    if (!fresh) return it->second;
    const Point2 p = CornerPosition(c);
    const double reach = TouchesOutside(c) ? kRimTolerance : kCornerSnap * index_.mean_size();
    const int32_t near = index_.NearestPoint(p, reach);
    it->second = near >= 0 ? near : NewVertex(p, 3);
    return it->second;
  }

  // Whether a cell around the corner lies outside the area: what a bent seam would cede to it stayed unfilled.
  bool TouchesOutside(Corner c) const {
    return !area_.contains(c) || !area_.contains({c.col - 1, c.row}) || !area_.contains({c.col, c.row - 1}) ||
           !area_.contains({c.col - 1, c.row - 1});
  }

  int32_t NewVertex(const Point2& p, uint8_t on_lines, int32_t beside = -1) {
    result_.vertices.push_back(p);
    result_.sizes.push_back(SizeAt(p));
    result_.lines.push_back(on_lines);
    result_.beside.push_back(beside);
    return static_cast<int32_t>(rim_.points.size() + result_.vertices.size()) - 1;
  }

  double SizeAt(const Point2& p) const {
    // In uniform mode sizes go from those of the rim near by to its mean, slowly: a lone outlier is not followed.
    constexpr double kUniformGrowth = 0.02;
    if (options_.uniform) return index_.SizeAt(p, kUniformGrowth, index_.mean_size());
    return index_.SizeAt(p, options_.gradation - 1, options_.size_limit * index_.mean_size());
  }

  Point2 PositionOf(int32_t vertex) const {
    const auto points = static_cast<int32_t>(rim_.points.size());
    return vertex < points ? Point2(rim_.points[vertex].position.head<2>())
                           : result_.vertices[static_cast<size_t>(vertex - points)];
  }

  struct End {
    int32_t vertex;
    bool start;
  };

  void LayBorder(const Border& border, const std::vector<Junction>& junctions) {
    if (lines_.left_open.contains(border)) return;
    std::vector<End> ends;
    if (in_hole_.at(LowCorner(border))) ends.push_back({CornerVertex(LowCorner(border)), true});
    for (const Junction& j : junctions) ends.push_back({j.point, j.start});
    if (in_hole_.at(HighCorner(border))) ends.push_back({CornerVertex(HighCorner(border)), false});
    bool fits = ends.size() % 2 == 0;
    for (size_t i = 0; i < ends.size(); ++i) fits &= ends[i].start == (i % 2 == 0);
    if (!fits) {
      for (const Junction& j : junctions) result_.trouble.emplace_back(rim_.points[j.point].position.head<2>());
      Fail(border, "the rim folds over itself at the grid line, so that inside and outside cannot be told apart");
      return;
    }
    for (size_t i = 0; i + 1 < ends.size(); i += 2) LayStretch(border, ends[i].vertex, ends[i + 1].vertex);
  }

  void Fail(const Border& border, const std::string& reason) {
    for (const CellId cell : {border.first, border.second}) {
      if (area_.contains(cell)) result_.failures.push_back({cell, reason});
    }
  }

  void LayStretch(const Border& border, int32_t from, int32_t to) {
    if (from == to) return;
    std::vector<int32_t> way = {from};
    for (const auto& [p, beside] : WayPoints(border, from, to)) {
      way.push_back(NewVertex(p, IsVertical(border) ? 1 : 2, beside));
    }
    way.push_back(to);
    const auto position = [this](int32_t v) { return PositionOf(v); };
    auto path = FindSeamPath(way, rim_, index_, position);
    // A tile's own outline runs straight on under and over its facades, which need not be gone around: the filler cuts
    // off what crosses.
    if (lines_.independent && (!path || Bends(*path))) path = way;
    if (!path) {
      const Point2 p = PositionOf(from);
      result_.trouble.insert(result_.trouble.end(), {p, PositionOf(to)});
      Fail(border, absl::StrFormat("no way along the grid line through the hole at (%.3f, %.3f)", p.x(), p.y()));
      return;
    }
    if (options_.seams_over_rim && !lines_.independent) {
      path = BendToRim(*path, rim_, index_, position, LargestBend(border));
    }
    result_.seams.push_back({border.first, border.second, *path});
  }

  // How far a seam may leave its line without need, metres. At the rim of the area what it cedes stays unfilled.
  double LargestBend(const Border& border) const {
    return IsInner(border) ? std::numeric_limits<double>::infinity() : kSamePlace;
  }

  bool IsInner(const Border& border) const { return area_.contains(border.first) && area_.contains(border.second); }

  // Whether a path goes over rim points between its ends.
  bool Bends(const std::vector<int32_t>& path) const {
    const auto points = static_cast<int32_t>(rim_.points.size());
    return std::any_of(path.begin() + 1, path.end() - 1, [&](int32_t v) { return v < points; });
  }

  using WayPoint = std::pair<Point2, int32_t>;  // a place on the line and the rim point a hair beside it, or -1

  // The new vertices between two ends, in order along the line.
  std::vector<WayPoint> WayPoints(const Border& border, int32_t from, int32_t to) const {
    std::vector<WayPoint> points;
    for (const Point2& p : SpacedPoints(border, from, to)) points.emplace_back(p, -1);
    if (lines_.independent || IsInner(border)) return points;
    const int along = IsVertical(border) ? 1 : 0;
    const auto beside = PointsBesideRim(border, from, to);
    points.insert(points.end(), beside.begin(), beside.end());
    std::sort(points.begin(), points.end(),
              [&](const WayPoint& a, const WayPoint& b) { return a.first[along] < b.first[along]; });
    return points;
  }

  // Points on the line strictly between two ends, each opposite a rim point that lies a hair off the line.
  std::vector<WayPoint> PointsBesideRim(const Border& border, int32_t from, int32_t to) const {
    const int along = IsVertical(border) ? 1 : 0;
    const double line = LineOf(border);
    const double t0 = PositionOf(from)[along], t1 = PositionOf(to)[along];
    Point2 lo, hi;
    lo[along] = t0, hi[along] = t1;
    lo[1 - along] = line - kOnLine, hi[1 - along] = line + kOnLine;
    std::map<double, int32_t> near;  // by place along the line
    for (const int32_t e : index_.EdgesIn(lo, hi)) {
      const int32_t v = rim_.edges[e].from;
      const Point2 p = PositionOf(v);
      if (std::abs(p[1 - along] - line) <= kOnLine) near.emplace(p[along], v);
    }
    std::vector<WayPoint> points;
    double last = t0;
    for (const auto& [t, v] : near) {
      if (t <= last + kOnLine || t >= t1 - kOnLine) continue;
      last = t;
      Point2 p = PositionOf(v);
      if (std::abs(p[1 - along] - line) <= kSamePlace) continue;
      p[1 - along] = line;
      points.emplace_back(p, v);
    }
    return points;
  }

  // Points on the line strictly between two ends, spaced by the wanted size, clear of the rim.
  std::vector<Point2> SpacedPoints(const Border& border, int32_t from, int32_t to) const {
    const int along = IsVertical(border) ? 1 : 0;
    const double line = LineOf(border);
    const double t0 = PositionOf(from)[along], t1 = PositionOf(to)[along];
    const auto at = [&](double t) {
      Point2 p;
      p[along] = t;
      p[1 - along] = line;
      return p;
    };
    // Integrates 1 / size to find how many edges fit, then places the vertices at equal shares of it.
    std::vector<std::pair<double, double>> steps = {{t0, 0.0}};
    double sum = 0;
    for (double t = t0; t < t1;) {
      const double size = SizeAt(at(t));
      const double next = std::min(t1, t + size / 8);
      sum += (next - t) / size;
      t = next;
      steps.emplace_back(t, sum);
    }
    const auto edges = std::max<int64_t>(1, std::llround(sum));
    std::vector<Point2> points;
    size_t k = 0;
    for (int64_t i = 1; i < edges; ++i) {
      const double share = sum * static_cast<double>(i) / static_cast<double>(edges);
      while (k + 1 < steps.size() && steps[k + 1].second < share) ++k;
      const double f = (share - steps[k].second) / (steps[k + 1].second - steps[k].second);
      const double t = steps[k].first + f * (steps[k + 1].first - steps[k].first);
      const Point2 p = at(std::round(t / step_) * step_);
      const double size = SizeAt(p);
      if (p[along] <= t0 || p[along] >= t1 || index_.Distance(p, size) < kRimClearance * size) continue;
      if (!points.empty() && p == points.back()) continue;
      points.push_back(p);
    }
    return points;
  }

  const std::set<CellId>& area_;
  const CutLines& lines_;
  const Rim& rim_;
  const RimIndex& index_;
  const PlanOptions& options_;
  const double step_;
  std::map<Border, std::vector<Junction>> junctions_;
  std::map<Corner, bool> in_hole_;
  std::map<Corner, int32_t> corner_vertex_;
  SeamLayout result_;
};

}  // namespace

SeamLayout LaySeams(const std::set<CellId>& area, const CutLines& lines, const Rim& rim, const RimIndex& index,
                    const PlanOptions& options, double lattice_step) {
  return Layout(area, lines, rim, index, options, lattice_step).Run();
}

}  // namespace tilemend
