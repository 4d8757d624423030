#include "coordinator/plan/outline_chains.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "absl/strings/str_format.h"

namespace tilemend {
namespace {

constexpr double kPlane = 2e-3;      // metres: an edge whose ends agree to this lies in a plane across that axis
constexpr double kSamePlane = 2e-2;  // metres: ends of a chain that agree to this lie in one plane
constexpr double kOtherWay = -0.3;   // cosine between edges that run along each other, one this way, one that

double SegmentDistance(const Point3& p, const Point3& a, const Point3& b) {
  const Eigen::Vector3d d = b - a;
  const double t = std::clamp((p - a).dot(d) / std::max(d.squaredNorm(), 1e-300), 0.0, 1.0);
  return (p - a - t * d).norm();
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
    result_.open_edges = open_edges_;
    if (open_edges_ > 0) {
      Leave(
          "its boundary runs from one side of the tile's outline to another, and where the surface between them ends "
          "is not known",
          open_edges_);
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

  // Which of the four sides a point lies near, as bits.
  int SidesOf(const Point3& p) const {
    int sides = 0;
    for (const Side side : kSides) {
      if (std::abs(p[AxisOf(side)] - lines_.At(cell_, side)) <= lines_.tolerance) sides |= 1 << side;
    }
    return sides;
  }

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
    const bool one_side = (SidesOf(p) & SidesOf(q)) != 0;
    if (!one_side && (p - q).cwiseAbs().minCoeff() > kSamePlane) {
      open_edges_ += static_cast<int64_t>(chain.size());
      return;
    }
    if (!one_side) ++border_edges_;  // the closing segment
    loop.push_back({first, last, true});
    result_.loops.push_back(std::move(loop));
  }

  const std::vector<int32_t>& loop_;
  const Rim& rim_;
  const CutLines& lines_;
  const std::vector<double>& piece_border_;
  const CellId cell_;
  OutlineChains result_;
  int64_t border_edges_ = 0, measured_ = 0, open_edges_ = 0, short_edges_ = 0;
  double border_sum_ = 0;
};

}  // namespace

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
