#include "worker/fill/region/fold_cutting.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <set>
#include <unordered_map>
#include <utility>

namespace tilemend {
namespace {

using Kind = RegionConflict::Kind;

// Every round cuts at least one run, so this bounds the folds that a hole may have.
constexpr int kMostRounds = 400;

struct Place {
  size_t loop;
  size_t at;  // into the loop
};

struct Loop {
  std::vector<int32_t> points;    // points[k] -> points[k + 1] is a segment
  std::vector<int32_t> original;  // of that segment; -1: a chord
};

class FoldCutter {
 public:
  FoldCutter(std::span<const LatticePoint> points, std::span<const RegionSegment> segments,
             const std::function<bool(int32_t, int32_t)>& allowed)
      : points_(points), allowed_(allowed) {
    Link(segments);
  }

  CutBoundary Run() {
    for (int round = 0; round < kMostRounds; ++round) {
      StoreSegments();
      const RegionTriangulation region = TriangulateRegion(points_, result_.segments);
      result_.simple = region.conflicts.empty();
      if (result_.simple || !CutAny(region.conflicts)) break;
    }
    return std::move(result_);
  }

 private:
  // Links the segments to loops. Where several leave a point, the one that keeps the hole between it and the arriving
  // one whole.
  void Link(std::span<const RegionSegment> segments) {
    std::unordered_map<int32_t, std::vector<int32_t>> leaving;
    for (size_t s = 0; s < segments.size(); ++s) leaving[segments[s].from].push_back(static_cast<int32_t>(s));
    std::vector<bool> used(segments.size(), false);
    for (size_t start = 0; start < segments.size(); ++start) {
      if (used[start]) continue;
      Loop loop;
      auto s = static_cast<int32_t>(start);
      while (s >= 0 && !used[s]) {
        used[s] = true;
        loop.points.push_back(segments[s].from);
        loop.original.push_back(s);
        s = NextOf(segments, s, leaving[segments[s].to], used, static_cast<int32_t>(start));
      }
      loops_.push_back(std::move(loop));
    }
  }

  int32_t NextOf(std::span<const RegionSegment> segments, int32_t s, const std::vector<int32_t>& candidates,
                 const std::vector<bool>& used, int32_t start) const {
    const auto angle = [&](int32_t from, int32_t to) {
      return std::atan2(static_cast<double>(points_[to].y - points_[from].y),
                        static_cast<double>(points_[to].x - points_[from].x));
    };
    const double back = angle(segments[s].to, segments[s].from);
    double least = 0;
    int32_t best = -1;
    for (const int32_t c : candidates) {
      if (used[c] && c != start) continue;
      double turn = back - angle(segments[c].from, segments[c].to);
      if (turn <= 0) turn += 2 * std::numbers::pi;
      if (best >= 0 && turn >= least) continue;
      least = turn;
      best = c;
    }
    return best;
  }

  void StoreSegments() {
    result_.segments.clear();
    result_.original.clear();
    places_.clear();
    for (size_t l = 0; l < loops_.size(); ++l) {
      const Loop& loop = loops_[l];
      for (size_t k = 0; k < loop.points.size(); ++k) {
        result_.segments.push_back({loop.points[k], loop.points[(k + 1) % loop.points.size()]});
        result_.original.push_back(loop.original[k]);
        places_.push_back({l, k});
      }
    }
  }

  // Cuts at the first conflict where that can be done.
  bool CutAny(const std::vector<RegionConflict>& conflicts) {
    return std::any_of(conflicts.begin(), conflicts.end(), [&](const RegionConflict& c) { return CutAt(c); });
  }

  // A place along a loop that a cut has to take off: a segment, or a point strictly inside the run.
  struct Part {
    Place place;
    bool segment;
  };

  std::vector<Part> PartsOf(const RegionConflict& c) const {
    std::vector<Part> parts;
    const auto add_point = [&](int32_t point) {
      for (size_t s = 0; s < result_.segments.size(); ++s) {
        if (result_.segments[s].from == point) parts.push_back({places_[s], false});
      }
    };
    switch (c.kind) {
      case Kind::kCoincidentPoints:
        add_point(c.first);
        add_point(c.second);
        break;
      case Kind::kPointOnSegment:
        parts.push_back({places_[c.first], true});
        add_point(c.second);
        break;
      case Kind::kCrossing:
      case Kind::kDegenerate:
        parts.push_back({places_[c.first], true});
        if (c.second != c.first) parts.push_back({places_[c.second], true});
        break;
      case Kind::kInsideOut:  // a small loop that faces down
        if (loops_.size() > 1) parts.push_back({places_[c.first], true});
        break;
    }
    return parts;
  }

  struct Cut {
    size_t loop, begin, edges;
  };

  // Takes off the shortest run with a clean chord that has one of the parts in it; of several the one with the largest
  // area, seen with the hole on the left: the others lie over the surface.
  bool CutAt(const RegionConflict& c) {
    const std::vector<Part> parts = PartsOf(c);
    for (int32_t edges = 2; edges <= kLongestFold && c.kind != Kind::kInsideOut; ++edges) {
      std::optional<Cut> best;
      double best_area = 0;
      for (const Part& part : parts) {
        const auto n = static_cast<int32_t>(loops_[part.place.loop].points.size());
        if (edges > n - 2) continue;
        for (int32_t before = part.segment ? 0 : 1; before < edges; ++before) {
          const auto begin = static_cast<size_t>((static_cast<int32_t>(part.place.at) + n - before) % n);
          const Cut cut{part.place.loop, begin, static_cast<size_t>(edges)};
          const double area = AreaOf(cut);
          if ((best && area <= best_area) || !MayCut(cut)) continue;
          best = cut;
          best_area = area;
        }
      }
      if (!best) continue;
      Apply(*best);
      return true;
    }
    for (const Part& part : parts) {
      if (loops_[part.place.loop].points.size() > kLongestFold) continue;
      CutWhole(part.place.loop);
      return true;
    }
    return false;
  }

  int32_t PointOf(const Cut& cut, size_t k) const {
    const Loop& loop = loops_[cut.loop];
    return loop.points[(cut.begin + k) % loop.points.size()];
  }

  double AreaOf(const Cut& cut) const {
    const LatticePoint o = points_[PointOf(cut, 0)];
    double sum = 0;
    for (size_t k = 1; k < cut.edges; ++k) {
      const LatticePoint a = points_[PointOf(cut, k)], b = points_[PointOf(cut, k + 1)];
      sum += static_cast<double>(a.x - o.x) * static_cast<double>(b.y - o.y) -
             static_cast<double>(a.y - o.y) * static_cast<double>(b.x - o.x);
    }
    return sum;
  }

  bool IsClosed(const Cut& cut) const { return PointOf(cut, 0) == PointOf(cut, cut.edges); }

  bool MayCut(const Cut& cut) const {
    if (IsClosed(cut)) return cut.edges >= 3;
    const int32_t from = PointOf(cut, 0), to = PointOf(cut, cut.edges);
    return points_[from] != points_[to] && !chords_.contains(std::minmax(from, to)) && allowed_(from, to) &&
           IsClean(cut.loop, cut.begin, cut.edges);
  }

  // A small loop that has no clean chord is filled in space as a whole.
  void CutWhole(size_t l) {
    result_.runs.push_back(loops_[l].points);
    loops_.erase(loops_.begin() + static_cast<ptrdiff_t>(l));
  }

  void Apply(const Cut& cut) {
    const bool closed = IsClosed(cut);
    Loop& loop = loops_[cut.loop];
    const size_t n = loop.points.size();
    std::vector<int32_t> run;
    for (size_t k = 0; k < cut.edges + !closed; ++k) run.push_back(PointOf(cut, k));
    Loop rest;
    if (!closed) {
      chords_.insert(std::minmax(run.front(), run.back()));
      rest.points.push_back(run.front());
      rest.original.push_back(-1);
    }
    for (size_t k = cut.edges; k < n; ++k) {
      rest.points.push_back(PointOf(cut, k));
      rest.original.push_back(loop.original[(cut.begin + k) % n]);
    }
    result_.runs.push_back(std::move(run));
    loop = std::move(rest);
  }

  // Whether the chord of a run meets no segment outside the run, except at its ends.
  bool IsClean(size_t l, size_t begin, size_t edges) const {
    const size_t n = loops_[l].points.size();
    const int32_t from = loops_[l].points[begin], to = loops_[l].points[(begin + edges) % n];
    for (size_t s = 0; s < result_.segments.size(); ++s) {
      if (places_[s].loop == l && (places_[s].at + n - begin) % n < edges) continue;
      if (Meets(from, to, result_.segments[s].from, result_.segments[s].to)) return false;
    }
    return true;
  }

  bool Meets(int32_t p, int32_t q, int32_t a, int32_t b) const {
    const LatticePoint P = points_[p], Q = points_[q], A = points_[a], B = points_[b];
    if (std::max(A.x, B.x) < std::min(P.x, Q.x) || std::min(A.x, B.x) > std::max(P.x, Q.x) ||
        std::max(A.y, B.y) < std::min(P.y, Q.y) || std::min(A.y, B.y) > std::max(P.y, Q.y)) {
      return false;
    }
    const auto on = [&](LatticePoint x, LatticePoint u, LatticePoint v) {  // inside segment uv
      return x != u && x != v && Orientation(u, v, x) == 0 && std::min(u.x, v.x) <= x.x && x.x <= std::max(u.x, v.x) &&
             std::min(u.y, v.y) <= x.y && x.y <= std::max(u.y, v.y);
    };
    if ((P == A && Q == B) || (P == B && Q == A)) return true;
    if (on(A, P, Q) || on(B, P, Q) || on(P, A, B) || on(Q, A, B)) return true;
    return Orientation(P, Q, A) * Orientation(P, Q, B) < 0 && Orientation(A, B, P) * Orientation(A, B, Q) < 0;
  }

  std::span<const LatticePoint> points_;
  const std::function<bool(int32_t, int32_t)>& allowed_;
  std::set<std::pair<int32_t, int32_t>> chords_;
  std::vector<Loop> loops_;
  std::vector<Place> places_;  // of each segment
  CutBoundary result_;
};

}  // namespace

CutBoundary CutFolds(std::span<const LatticePoint> points, std::span<const RegionSegment> segments,
                     const std::function<bool(int32_t, int32_t)>& allowed) {
  return FoldCutter(points, segments, allowed).Run();
}

}  // namespace tilemend
