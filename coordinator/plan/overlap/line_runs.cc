#include "coordinator/plan/overlap/line_runs.h"

#include <iterator>
#include <utility>

namespace tilemend {
namespace {

// Which of two tiles has something on a place of the line where the other has nothing.
struct LineOwner {
  int tile = -1;         // -1: both or none
  bool outside = false;  // as LineRun

  bool HasSurface() const { return tile >= 0 && !outside; }
  bool operator==(const LineOwner&) const = default;
};

int StepAt(const std::map<double, int>& steps, double t) {
  const auto it = steps.find(t);
  return it == steps.end() ? 0 : it->second;
}

double NearestHeight(const std::map<double, double>& heights, double t) {
  const auto above = heights.lower_bound(t);
  if (heights.empty()) return 0;
  if (above == heights.begin()) return above->second;
  const auto below = std::prev(above);
  return above == heights.end() || t - below->first < above->first - t ? below->second : above->second;
}

bool HasVertex(const LineCover& cover, double t) {
  return cover.height.contains(t) || cover.crossing.contains(t) || cover.outside.contains(t);
}

class RunFinder {
 public:
  RunFinder(const std::array<LineCover, 2>& of, const std::map<double, LineVertex>& fixed) : of_(of), fixed_(fixed) {}

  std::vector<LineRun> Run() {
    for (const double t : Places()) {
      const LineOwner before = owner_;
      owner_ = OwnerFrom(t);
      const bool on_surface = before.HasSurface() || owner_.HasSurface();
      if (before.tile >= 0 && (owner_ != before || HasVertex(of_[before.tile], t))) {
        runs_.back().vertices.push_back(VertexAt(before.tile, t, on_surface));
      }
      if (owner_ == before || owner_.tile < 0) continue;
      runs_.push_back({owner_.tile, owner_.outside, {VertexAt(owner_.tile, t, on_surface)}});
    }
    return std::move(runs_);
  }

 private:
  std::set<double> Places() const {
    std::set<double> places;
    for (const LineCover& cover : of_) {
      places.insert(cover.outside.begin(), cover.outside.end());
      for (const auto* steps : {&cover.step, &cover.of_tile}) {
        for (const auto& [t, step] : *steps) places.insert(t);
      }
      for (const auto* heights : {&cover.height, &cover.crossing}) {
        for (const auto& [t, height] : *heights) places.insert(t);
      }
    }
    return places;
  }

  // By how often each tile covers what follows, with or without what is outside the area.
  LineOwner OwnerFrom(double t) {
    for (const int k : {0, 1}) {
      covered_[k] += StepAt(of_[k].step, t);
      of_tile_[k] += StepAt(of_[k].of_tile, t);
    }
    if ((covered_[0] > 0) == (covered_[1] > 0)) return {};
    const int tile = covered_[0] > 0 ? 0 : 1;
    return {tile, of_tile_[tile] <= 0 && of_[1 - tile].in_scene};
  }

  // on_surface: whether there is surface before or behind along the line.
  LineVertex VertexAt(int tile, double t, bool on_surface) const {
    if (const auto it = fixed_.find(t); it != fixed_.end()) return it->second;
    for (const auto heights : {&LineCover::crossing, &LineCover::height}) {
      for (const int k : {tile, 1 - tile}) {
        if (const auto it = (of_[k].*heights).find(t); it != (of_[k].*heights).end()) return {t, it->second};
      }
    }
    if (!on_surface) return {t, 0, false};
    return {t, NearestHeight(of_[tile].height, t)};
  }

  const std::array<LineCover, 2>& of_;
  const std::map<double, LineVertex>& fixed_;
  std::array<int, 2> covered_{}, of_tile_{};
  LineOwner owner_;
  std::vector<LineRun> runs_;
};

}  // namespace

std::vector<LineRun> FindLineRuns(const std::array<LineCover, 2>& of, const std::map<double, LineVertex>& fixed) {
  return RunFinder(of, fixed).Run();
}

}  // namespace tilemend
