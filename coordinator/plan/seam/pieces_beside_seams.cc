#include "coordinator/plan/seam/pieces_beside_seams.h"

#include <algorithm>
#include <map>
#include <vector>

namespace tilemend {
namespace {

// Seams around a grid corner may hand a piece on, each once.
constexpr int kSeamsAtCorner = 4;

double Cross(const Point2& a, const Point2& b) { return a.x() * b.y() - a.y() * b.x(); }

// Where the outline of a piece passes over a rim point.
struct Passage {
  int32_t loop, before, after;  // of the rim; the points before and after it along the outline
};

class PieceGiver {
 public:
  PieceGiver(const SeamSite& site, const SeamLayout& layout, ClosingCells& closing)
      : site_(site), layout_(layout), closing_(closing) {
    for (int32_t l = 0; l < std::ssize(site.rim.loops); ++l) {
      if (IsPieceOfOneCell(site.rim.loops[l])) AddPassages(l);
    }
  }

  // Whether the outline of a piece went to another cell.
  bool Run() {
    bool given = false;
    for (const Seam& seam : layout_.seams) {
      for (size_t i = 1; i + 1 < seam.vertices.size(); ++i) {
        const auto [begin, end] = passages_.equal_range(seam.vertices[i]);
        for (auto p = begin; p != end; ++p) given |= Give(seam, i, p->second);
      }
    }
    return given;
  }

 private:
  bool IsPieceOfOneCell(const std::vector<int32_t>& loop) const {
    const CellId cell = closing_[loop[0]];
    if (std::any_of(loop.begin(), loop.end(), [&](int32_t e) { return closing_[e] != cell; })) return false;
    const Point2 origin = PositionOf(site_.rim.edges[loop[0]].from);
    double twice_area = 0;
    for (const int32_t e : loop) {
      const RimEdge& edge = site_.rim.edges[e];
      twice_area += Cross(PositionOf(edge.from) - origin, PositionOf(edge.to) - origin);
    }
    return twice_area > 0;  // the surface is within
  }

  void AddPassages(int32_t l) {
    const std::vector<int32_t>& loop = site_.rim.loops[l];
    for (size_t k = 0; k < loop.size(); ++k) {
      const RimEdge& edge = site_.rim.edges[loop[k]];
      const RimEdge& next = site_.rim.edges[loop[(k + 1) % loop.size()]];
      passages_.insert({edge.to, {l, edge.from, next.to}});
    }
  }

  // Gives the piece away if the seam at its vertex i has it on the other side than that of its cell.
  bool Give(const Seam& seam, size_t i, const Passage& at) {
    const int32_t last = seam.vertices[i - 1], next = seam.vertices[i + 1];
    const auto follows = [&](int32_t point) { return point == last || point == next; };
    if (follows(at.before) && follows(at.after)) return false;
    const int32_t off = follows(at.after) ? at.before : at.after;
    const bool left = LiesLeft(PositionOf(seam.vertices[i]), PositionOf(last), PositionOf(next), PositionOf(off));
    const Border border(seam.a, seam.b);
    const CellId beside = left ? LeftOf(border) : RightOf(border), beyond = left ? RightOf(border) : LeftOf(border);
    const std::vector<int32_t>& loop = site_.rim.loops[at.loop];
    if (closing_[loop[0]] != beyond || !site_.area.contains(beside)) return false;
    for (const int32_t e : loop) closing_[e] = beside;
    return true;
  }

  // Whether `q` is on the left of the way from `last` over `at` to `next`.
  static bool LiesLeft(const Point2& at, const Point2& last, const Point2& next, const Point2& q) {
    const bool left_of_first = Cross(at - last, q - at) > 0, left_of_second = Cross(next - at, q - at) > 0;
    const bool turns_left = Cross(at - last, next - at) > 0;
    return turns_left ? left_of_first && left_of_second : left_of_first || left_of_second;
  }

  Point2 PositionOf(int32_t vertex) const {
    const auto rim_points = static_cast<int32_t>(site_.rim.points.size());
    if (vertex >= rim_points) return layout_.vertices[static_cast<size_t>(vertex - rim_points)].position;
    return site_.rim.points[vertex].position.head<2>();
  }

  const SeamSite& site_;
  const SeamLayout& layout_;
  ClosingCells& closing_;
  std::multimap<int32_t, Passage> passages_;  // by rim point
};

}  // namespace

void GivePiecesToTheirSide(const SeamSite& site, const SeamLayout& layout, ClosingCells& closing) {
  PieceGiver giver(site, layout, closing);
  for (int round = 0; round < kSeamsAtCorner && giver.Run(); ++round) {
  }
}

}  // namespace tilemend
