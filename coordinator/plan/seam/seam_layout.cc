#include "coordinator/plan/seam/seam_layout.h"

#include <algorithm>
#include <limits>
#include <map>
#include <string>
#include <utility>

#include "absl/strings/str_format.h"
#include "coordinator/plan/seam/junctions.h"
#include "coordinator/plan/seam/seam_path.h"
#include "coordinator/plan/seam/seam_vertices.h"

namespace tilemend {
namespace {

constexpr double kCornerSnap = 0.25;  // of the rim's edge length: a grid corner this near a rim point is that point
// New vertices on all seams: some 100 MB and more for very many cells, whatever the scene says of itself.
constexpr int64_t kMostVertices = 1'000'000;
constexpr int64_t kMostVerticesOfCell = 1'000;
constexpr double kCornerOnRim = 1e-3;  // metres: the same at the rim of the area, where a seam must keep to the line

// One end of a stretch.
struct End {
  int32_t vertex;
  bool start;  // the hole lies towards larger coordinates
};

class SeamLayer {
 public:
  SeamLayer(const SeamSite& site, SeamsOverRim over_rim)
      : site_(site), over_rim_(over_rim), rim_points_(static_cast<int32_t>(site.rim.points.size())) {}

  SeamLayout Run(const ClosingCells& closing) {
    Junctions junctions = FindJunctions(site_, closing);
    result_.failures = std::move(junctions.failures);
    const std::map<Corner, bool> in_hole = FindCornersInHoles(site_, closing, junctions);
    for (const auto& [border, of_border] : junctions.along) {
      if (site_.options.cancelled()) break;
      if (!site_.lines.left_open.contains(border)) LayBorder(border, of_border, in_hole);
    }
    return std::move(result_);
  }

 private:
  void LayBorder(const Border& border, const std::vector<Junction>& junctions, const std::map<Corner, bool>& in_hole) {
    std::vector<End> ends;
    if (in_hole.at(LowCorner(border))) ends.push_back({CornerVertex(LowCorner(border)), true});
    for (const Junction& j : junctions) ends.push_back({j.point, j.start});
    if (in_hole.at(HighCorner(border))) ends.push_back({CornerVertex(HighCorner(border)), false});
    bool fits = ends.size() % 2 == 0;
    for (size_t i = 0; i < ends.size(); ++i) fits &= ends[i].start == (i % 2 == 0);
    if (!fits) {
      for (const Junction& j : junctions) result_.trouble.push_back(PositionOf(j.point));
      Fail(border, "its boundary crosses itself at the grid line, so that it has no inside there");
      return;
    }
    for (size_t i = 0; i + 1 < ends.size(); i += 2) LayStretch(border, ends[i].vertex, ends[i + 1].vertex);
  }

  void LayStretch(const Border& border, int32_t from, int32_t to) {
    if (from == to) return;
    std::vector<int32_t> way = {from};
    const auto places = PlaceSeamVertices(site_, border, PositionOf(from), PositionOf(to), EdgesLeft());
    if (!places) {
      Fail(border, absl::StrFormat("the mesh is too fine for cells of this size: more than %d edges on one grid line, "
                                   "or %d in the scene",
                                   kMostSeamEdges, most_vertices_));
      return;
    }
    for (const SeamPlace& place : *places) {
      way.push_back(NewVertex(place.position, IsVertical(border) ? 1 : 2, place.beside));
    }
    way.push_back(to);
    const auto position = [this](int32_t v) { return PositionOf(v); };
    auto path = FindSeamPath(way, site_.rim, site_.index, position);
    if (!path) {
      const Point2 p = PositionOf(from);
      result_.trouble.insert(result_.trouble.end(), {p, PositionOf(to)});
      Fail(border, absl::StrFormat("no seam can be laid along the grid line at (%.3f, %.3f)", p.x(), p.y()));
      return;
    }
    if (over_rim_ == SeamsOverRim::kYes && !site_.lines.joined) {
      path = BendToRim(*path, site_.rim, site_.index, position, LargestBend(border));
    }
    result_.seams.push_back({border.first, border.second, *std::move(path)});
  }

  int64_t EdgesLeft() const {
    return std::clamp<int64_t>(most_vertices_ - std::ssize(result_.vertices), 0, kMostSeamEdges);
  }

  void Fail(const Border& border, const std::string& reason) {
    for (const CellId cell : {border.first, border.second}) {
      if (site_.area.contains(cell)) result_.failures.push_back({cell, reason});
    }
  }

  // The vertex at a corner in a hole: a rim point if one is very near, or if the surface of a neighbour that was given
  // an edge back covers the corner, else a new vertex. What a bent seam would cede to a cell outside the area stayed
  // unfilled.
  int32_t CornerVertex(Corner c) {
    const auto [it, fresh] = corner_vertex_.try_emplace(c, -1);
    if (!fresh) return it->second;
    const Point2 p = CornerPosition(c, site_.area, site_.lines);
    const bool keeps = TouchesOutside(c, site_.area) || site_.lines.joined;
    const double near_by = keeps ? kCornerOnRim : kCornerSnap * site_.index.mean_size();
    const double reach = site_.index.InSurface(p, kCornerOnRim) ? site_.index.mean_size() : near_by;
    const int32_t near = site_.index.NearestPoint(p, reach);
    it->second = near >= 0 ? near : NewVertex(p, 3, -1);
    return it->second;
  }

  int32_t NewVertex(const Point2& p, uint8_t lines, int32_t beside) {
    result_.vertices.push_back({p, SeamSizeAt(site_, p), lines, beside});
    return rim_points_ + static_cast<int32_t>(result_.vertices.size()) - 1;
  }

  Point2 PositionOf(int32_t vertex) const {
    if (vertex >= rim_points_) return result_.vertices[static_cast<size_t>(vertex - rim_points_)].position;
    return site_.rim.points[vertex].position.head<2>();
  }

  // How far a seam may leave its line without need, metres. At the rim of the area what it cedes stays unfilled.
  double LargestBend(const Border& border) const {
    const bool inner = site_.area.contains(border.first) && site_.area.contains(border.second);
    return inner ? std::numeric_limits<double>::infinity() : kSamePlace;
  }

  const SeamSite& site_;
  const SeamsOverRim over_rim_;
  const int32_t rim_points_;
  const int64_t most_vertices_ = kMostVertices + kMostVerticesOfCell * std::ssize(site_.area);
  std::map<Corner, int32_t> corner_vertex_;
  SeamLayout result_;
};

}  // namespace

SeamLayout LaySeams(const SeamSite& site, const ClosingCells& closing, SeamsOverRim over_rim) {
  return SeamLayer(site, over_rim).Run(closing);
}

}  // namespace tilemend
