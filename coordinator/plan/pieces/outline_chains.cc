#include "coordinator/plan/pieces/outline_chains.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <tuple>

#include "absl/strings/str_format.h"

namespace tilemend {
namespace {

constexpr double kPlane = 2e-3;      // metres: an edge whose ends agree to this lies in a plane across that axis
constexpr double kSamePlane = 2e-2;  // metres: ends of a run that agree to this lie in one plane
constexpr double kLoosePlane = 0.2;  // metres: the same where pieces end raggedly, if nothing fits better
constexpr double kOuterRim = 0.3;    // cosine between a loop's vector area, surface on the left, and its normals
constexpr double kOtherWay = -0.3;   // cosine between edges that run along each other, one this way, one that

double SegmentDistance(const Point3& p, const Point3& a, const Point3& b) {
  const Eigen::Vector3d d = b - a;
  const double t = std::clamp((p - a).dot(d) / std::max(d.squaredNorm(), 1e-300), 0.0, 1.0);
  return (p - a - t * d).norm();
}

// Which of the four sides of its tile a point lies near, as bits.
int SidesOf(const Point3& p, CellId cell, const CutLines& lines) {
  int sides = 0;
  for (const Side side : kSides) {
    if (std::abs(p[AxisOf(side)] - lines.At(cell, side)) <= lines.tolerance) sides |= 1 << side;
  }
  return sides;
}

// Whether two ends of runs lie on one side of the tile's outline or in one plane across an axis.
bool Facing(const Point3& p, const Point3& q, CellId cell, const CutLines& lines, double plane = kSamePlane) {
  return (SidesOf(p, cell, lines) & SidesOf(q, cell, lines)) != 0 || (p - q).cwiseAbs().minCoeff() <= plane;
}

class BorderFinder {
 public:
  BorderFinder(const Rim& rim, const RimIndex& index, double reach)
      : rim_(rim), index_(index), reach_(reach), loop_of_(rim.edges.size(), -1) {
    for (size_t l = 0; l < rim.loops.size(); ++l) {
      for (const int32_t e : rim.loops[l]) loop_of_[e] = static_cast<int32_t>(l);
    }
  }

  double DistanceOf(int32_t edge) const {
    const RimEdge& e = rim_.edges[edge];
    if (e.label != e.owner) return -1;  // the tile's own outline
    double best = -1;
    const Point3 a = At(e.from), b = At(e.to), middle = (a + b) / 2;
    const Point2 r = Point2::Constant(reach_);
    for (const int32_t i : index_.EdgesIn(middle.head<2>() - r, middle.head<2>() + r)) {
      const RimEdge& o = rim_.edges[i];
      if (o.from == e.from || o.from == e.to || o.to == e.from || o.to == e.to) continue;
      const Point3 c = At(o.from), d = At(o.to);
      if ((b - a).dot(d - c) > kOtherWay * (b - a).norm() * (d - c).norm() || !ShareAxis(a, b, c, d)) continue;
      const Eigen::Vector3d left = (rim_.points[e.from].normal + rim_.points[e.to].normal).cross(b - a);
      if (loop_of_[i] == loop_of_[edge] && left.dot((c + d) / 2 - middle) <= 0) continue;
      const double distance = SegmentDistance(middle, c, d);
      if (distance <= reach_ && (best < 0 || distance < best)) best = distance;
    }
    return best;
  }

 private:
  const Point3& At(int32_t p) const { return rim_.points[p].position; }

  static bool ShareAxis(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
    for (int k = 0; k < 3; ++k) {
      if (std::abs(a[k] - b[k]) <= kPlane && std::abs(c[k] - d[k]) <= kPlane) return true;
    }
    return false;
  }

  const Rim& rim_;
  const RimIndex& index_;
  const double reach_;
  std::vector<int32_t> loop_of_;  // per edge
};

class ChainCloser {
 public:
  ChainCloser(const std::vector<int32_t>& loop, const Rim& rim, const CutLines& lines,
              const std::vector<double>& piece_border)
      : loop_(loop), rim_(rim), lines_(lines), piece_border_(piece_border), cell_(rim.edges[loop[0]].owner) {}

  OutlineChains Run() {
    const size_t n = loop_.size();
    size_t start = 0;
    while (start < n && !Bounds(loop_[start])) ++start;
    for (size_t i = start; i < start + n; ++i) {
      const int32_t e = loop_[i % n];
      if (Bounds(e)) {
        CountBorder(e);
        continue;
      }
      std::vector<int32_t> chain;
      for (; i < start + n && !Bounds(loop_[i % n]); ++i) chain.push_back(loop_[i % n]);
      --i;
      Close(chain);
    }
    if (border_edges_ > 0) {
      Leave(absl::StrFormat("the outline of a piece of the tile that ends along another piece %.2f m away, sharing no "
                            "vertices: no hole",
                            border_sum_ / static_cast<double>(std::max<int64_t>(1, measured_))),
            border_edges_);
    }
    if (short_edges_ > 0) Leave("single edges off the tile's outline: they bound no area", short_edges_);
    return std::move(result_);
  }

 private:
  bool Bounds(int32_t e) const { return rim_.edges[e].label != rim_.edges[e].owner || piece_border_[e] >= 0; }

  void CountBorder(int32_t e) {
    if (piece_border_[e] < 0) return;
    ++border_edges_;
    ++measured_;
    border_sum_ += piece_border_[e];
  }

  void Leave(std::string reason, int64_t edges) { result_.left.push_back({cell_, std::move(reason), -1, edges}); }

  void Close(const std::vector<int32_t>& chain) {
    const int32_t first = rim_.edges[chain.front()].from, last = rim_.edges[chain.back()].to;
    std::vector<RimSegment> loop;  // reversed: the hole lies to the right of a rim edge
    for (auto e = chain.rbegin(); e != chain.rend(); ++e) {
      loop.push_back({rim_.edges[*e].to, rim_.edges[*e].from, false});
    }
    if (first == last) {
      result_.loops.push_back(std::move(loop));
      return;
    }
    if (chain.size() == 1) {
      ++short_edges_;
      return;
    }
    const Point3& p = rim_.points[first].position;
    const Point3& q = rim_.points[last].position;
    if (!Facing(p, q, cell_, lines_)) {
      result_.open_runs.push_back(chain);
      return;
    }
    if ((SidesOf(p, cell_, lines_) & SidesOf(q, cell_, lines_)) == 0) ++border_edges_;  // the closing segment
    loop.push_back({first, last, true});
    result_.loops.push_back(std::move(loop));
  }

  const std::vector<int32_t>& loop_;
  const Rim& rim_;
  const CutLines& lines_;
  const std::vector<double>& piece_border_;
  const CellId cell_;
  OutlineChains result_;
  int64_t border_edges_ = 0, measured_ = 0, short_edges_ = 0;
  double border_sum_ = 0;
};

}  // namespace

std::vector<std::vector<int32_t>> OneSidedRuns(const std::vector<int32_t>& loop, const Rim& rim, const CutLines& lines,
                                               size_t longest) {
  const auto at_outline = [&](size_t i) {
    const RimEdge& e = rim.edges[loop[i % loop.size()]];
    return e.label != e.owner;
  };
  std::vector<std::vector<int32_t>> runs;
  const size_t n = loop.size();
  for (size_t i = 0; i < n; ++i) {
    if (!at_outline(i) || at_outline(i + 1)) continue;
    std::vector<int32_t> run;
    size_t k = i + 1;
    for (; !at_outline(k) && run.size() <= longest; ++k) run.push_back(loop[k % n]);
    if (run.size() > longest || rim.edges[loop[i]].label != rim.edges[loop[k % n]].label) continue;
    const RimEdge& first = rim.edges[run.front()];
    const RimEdge& last = rim.edges[run.back()];
    const int sides = SidesOf(rim.points[first.from].position, first.owner, lines) &
                      SidesOf(rim.points[last.to].position, first.owner, lines);
    if (sides != 0 && first.from != last.to) runs.push_back(std::move(run));
  }
  return runs;
}

bool IsDetachedOutline(const std::vector<int32_t>& loop, const Rim& rim, double largest) {
  const Point3 origin = rim.points[rim.edges[loop[0]].from].position;
  Eigen::Vector3d area = Eigen::Vector3d::Zero(), normal = area, lo = area, hi = area;
  for (const int32_t e : loop) {
    const RimPoint& p = rim.points[rim.edges[e].from];
    const Eigen::Vector3d a = p.position - origin, b = rim.points[rim.edges[e].to].position - origin;
    area += a.cross(b);
    normal += p.normal.normalized();
    lo = lo.cwiseMin(a);
    hi = hi.cwiseMax(a);
  }
  return (hi - lo).maxCoeff() <= largest && area.dot(normal) > kOuterRim * area.norm() * normal.norm();
}

OutlineChains LinkRuns(const std::vector<std::vector<int32_t>>& runs, const Rim& rim, const CutLines& lines) {
  struct Link {
    bool loose;
    double length;
    size_t from, to;  // the hole goes on from the start of run `from` to the end of run `to`
  };
  OutlineChains result;
  if (runs.empty()) return result;
  const CellId cell = rim.edges[runs[0][0]].owner;
  std::vector<Link> links;
  for (size_t i = 0; i < runs.size(); ++i) {
    for (size_t j = 0; j < runs.size(); ++j) {
      const Point3& p = rim.points[rim.edges[runs[i].front()].from].position;
      const Point3& q = rim.points[rim.edges[runs[j].back()].to].position;
      if (!Facing(p, q, cell, lines, kLoosePlane)) continue;
      links.push_back({!Facing(p, q, cell, lines), (p - q).norm(), i, j});
    }
  }
  std::sort(links.begin(), links.end(), [](const Link& a, const Link& b) {
    return std::tie(a.loose, a.length, a.from, a.to) < std::tie(b.loose, b.length, b.from, b.to);
  });
  std::vector<int32_t> next(runs.size(), -1), before(runs.size(), -1);
  for (const Link& link : links) {
    if (next[link.from] >= 0 || before[link.to] >= 0) continue;
    next[link.from] = static_cast<int32_t>(link.to);
    before[link.to] = static_cast<int32_t>(link.from);
  }
  int64_t left = 0, chords = 0;
  std::vector<bool> seen(runs.size(), false);
  for (size_t start = 0; start < runs.size(); ++start) {
    if (seen[start]) continue;
    std::vector<size_t> cycle;
    auto r = static_cast<int32_t>(start);
    // From the start of its path, if the runs do not close.
    for (size_t steps = 0; steps < runs.size() && before[r] >= 0 && before[r] != static_cast<int32_t>(start); ++steps) {
      r = before[r];
    }
    const int32_t first = r;
    do {
      seen[r] = true;
      cycle.push_back(static_cast<size_t>(r));
      r = next[r];
    } while (r >= 0 && r != first);
    std::vector<RimSegment> loop;
    for (const size_t k : cycle) {
      if (r < 0) left += static_cast<int64_t>(runs[k].size());
      for (auto e = runs[k].rbegin(); e != runs[k].rend(); ++e) {
        loop.push_back({rim.edges[*e].to, rim.edges[*e].from, false});
      }
      if (r < 0) continue;
      const int32_t to = rim.edges[runs[static_cast<size_t>(next[k])].back()].to;
      if (loop.back().to != to) loop.push_back({loop.back().to, to, true});
      ++chords;
    }
    if (r >= 0) result.loops.push_back(std::move(loop));
  }
  if (left > 0) {
    result.left.push_back({cell,
                           "its boundary runs from one side of the tile's outline to another, and where the surface "
                           "between them ends is not known",
                           -1, left});
  }
  if (chords > 0) {
    result.left.push_back(
        {cell, "where a hole was filled up to the outline of a piece of the tile: the new outline", -1, chords});
  }
  return result;
}

std::vector<double> FindPieceBorders(const Rim& rim, const RimIndex& index, double reach) {
  const BorderFinder finder(rim, index, reach);
  std::vector<double> distance;
  for (size_t e = 0; e < rim.edges.size(); ++e) distance.push_back(finder.DistanceOf(static_cast<int32_t>(e)));
  return distance;
}

OutlineChains CloseChains(const std::vector<int32_t>& loop, const Rim& rim, const CutLines& lines,
                          const std::vector<double>& piece_border) {
  return ChainCloser(loop, rim, lines, piece_border).Run();
}

}  // namespace tilemend
