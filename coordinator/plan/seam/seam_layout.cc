#include "coordinator/plan/seam/seam_layout.h"

#include <algorithm>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <utility>

#include "absl/strings/str_format.h"
#include "coordinator/plan/seam/junctions.h"
#include "coordinator/plan/seam/projected_places.h"
#include "coordinator/plan/seam/seam_path.h"
#include "coordinator/plan/seam/seam_vertices.h"

namespace tilemend {
namespace {

constexpr double kCornerSnap = 0.25;  // of the rim's edge length: a grid corner this near a rim point is that point
// New vertices on all seams: some 100 MB and more for very many cells, whatever the scene says of itself.
constexpr int64_t kMostVertices = 1'000'000;
constexpr int64_t kMostVerticesOfCell = 1'000;
constexpr double kProjectedBend = 0.2;  // of the rim's mean edge: as far as edges between spaced places bend there
constexpr double kCornerOnRim = 1e-3;   // metres: the same at the rim of the area, where a seam must keep to the line

// One end of a stretch.
struct End {
  int32_t vertex;
  bool start;  // the hole lies towards larger coordinates
};

// A stretch of a border's line through a hole.
struct Stretch {
  Border border;
  int32_t from, to;
};

bool IsInner(const SeamSite& site, const Border& border) {
  return site.area.contains(border.first) && site.area.contains(border.second);
}

bool TakesProjections(const SeamSite& site, const Border& border) {
  return site.options.seam_points == SeamPoints::kProjected && IsInner(site, border);
}

// How far a seam may leave its line without need, metres. At the rim of the area what it cedes stays unfilled.
double LargestBend(const SeamSite& site, const Border& border) {
  if (!IsInner(site, border)) return kSamePlace;
  // Edges between projections may be as long as the stretch: they do not reach for rim points far off.
  return TakesProjections(site, border) ? kProjectedBend * site.index.mean_size()
                                        : std::numeric_limits<double>::infinity();
}

class SeamLayer {
 public:
  SeamLayer(const SeamSite& site, SeamsOverRim over_rim)
      : site_(site), over_rim_(over_rim), rim_points_(static_cast<int32_t>(site.rim.points.size())) {}

  SeamLayout Run(const ClosingCells& closing) {
    Junctions junctions = FindJunctions(site_, closing);
    result_.failures = std::move(junctions.failures);
    const std::set<Corner> in_hole = FindCornersInHoles(site_, closing, junctions);
    for (const Corner corner : in_hole) {
      for (const Border& border : BordersAt(corner)) {
        if (IsOfArea(border, site_.area)) junctions.along[border];  // a border without junctions may lie in a hole
      }
    }
    for (const auto& [border, of_border] : junctions.along) {
      if (site_.options.cancelled()) break;
      if (!site_.lines.left_open.contains(border)) LayBorder(border, of_border, in_hole);
    }
    LayProjected();
    return std::move(result_);
  }

 private:
  void LayBorder(const Border& border, const std::vector<Junction>& junctions, const std::set<Corner>& in_hole) {
    std::vector<End> ends;
    if (in_hole.contains(LowCorner(border))) ends.push_back({CornerVertex(LowCorner(border)), true});
    for (const Junction& j : junctions) ends.push_back({j.point, j.start});
    if (in_hole.contains(HighCorner(border))) ends.push_back({CornerVertex(HighCorner(border)), false});
    bool fits = ends.size() % 2 == 0;
    for (size_t i = 0; i < ends.size(); ++i) fits &= ends[i].start == (i % 2 == 0);
    if (!fits) {
      for (const Junction& j : junctions) result_.trouble.push_back(PositionOf(j.point));
      Fail(border, "its boundary crosses itself at the grid line, so that it has no inside there");
      return;
    }
    for (size_t i = 0; i + 1 < ends.size(); i += 2) {
      const Stretch stretch{border, ends[i].vertex, ends[i + 1].vertex};
      if (stretch.from == stretch.to) continue;
      if (TakesProjections(site_, border)) {
        projected_.push_back(stretch);
      } else {
        LayCompleted(stretch, {});
      }
    }
  }

  // First the stretches that have rim points opposite them, then those opposite these, and so on inward (Wang 2021,
  // 3.3: the second layer does as the first). What has nothing opposite it is spaced.
  void LayProjected() {
    bool from_rim = true;
    while (!projected_.empty() && !site_.options.cancelled()) {
      std::vector<std::pair<Stretch, std::vector<SeamPlace>>> found;
      std::vector<Stretch> rest;
      for (const Stretch& s : projected_) {
        const auto boundary = from_rim ? RimPlacesBeside(site_, s.border) : SeamPlacesBeside(s.border);
        auto places = ProjectedPlaces(site_, s.border, PositionOf(s.from), PositionOf(s.to), boundary);
        if (places.empty()) {
          rest.push_back(s);
        } else {
          found.emplace_back(s, std::move(places));
        }
      }
      projected_ = std::move(rest);
      for (const auto& [stretch, places] : found) {
        if (site_.lines.joined) {
          LayCompleted(stretch, places);
        } else {
          Lay(stretch, places);
        }
      }
      if (found.empty() && !from_rim) break;
      from_rim = false;
    }
    for (const Stretch& s : projected_) LayCompleted(s, {});
  }

  // The vertices of the seams across the two cells of a border.
  std::vector<BoundaryPlace> SeamPlacesBeside(const Border& border) const {
    std::vector<BoundaryPlace> places;
    const int dx = border.second.col - border.first.col, dy = border.second.row - border.first.row;
    for (const Border& beyond : {Border{{border.first.col - dx, border.first.row - dy}, border.first},
                                 Border{border.second, {border.second.col + dx, border.second.row + dy}}}) {
      const auto it = laid_.find(beyond);
      if (it == laid_.end()) continue;
      for (const int32_t v : it->second) places.push_back({PositionOf(v), -1, site_.index.mean_size()});
    }
    return places;
  }

  // With spaced places between given ones, where these are further apart than the triangles there will be large. Tiles
  // that overlap so have one surface in the strip that both fill, up to the last vertex before the rim (SeamSizeAt).
  void LayCompleted(const Stretch& stretch, const std::vector<SeamPlace>& given) {
    std::vector<SeamPlace> places;
    for (size_t i = 0; i <= given.size(); ++i) {
      const Point2 from = i == 0 ? PositionOf(stretch.from) : given[i - 1].position;
      const Point2 to = i == given.size() ? PositionOf(stretch.to) : given[i].position;
      const auto spaced = PlaceSeamVertices(site_, stretch.border, from, to, EdgesLeft() - std::ssize(places));
      if (!spaced) {
        return Fail(stretch.border,
                    absl::StrFormat("the mesh is too fine for cells of this size: more than %d edges on one grid line, "
                                    "or %d in the scene",
                                    kMostSeamEdges, most_vertices_));
      }
      places.insert(places.end(), spaced->begin(), spaced->end());
      if (i < given.size()) places.push_back(given[i]);
    }
    Lay(stretch, places);
  }

  void Lay(const Stretch& stretch, const std::vector<SeamPlace>& places) {
    const auto& [border, from, to] = stretch;
    std::vector<int32_t> way = {from};
    for (const SeamPlace& place : places) {
      way.push_back(NewVertex(place.position, IsVertical(border) ? 1 : 2, place.beside));
      laid_[border].push_back(way.back());
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
      path = BendToRim(*path, site_.rim, site_.index, position, LargestBend(site_, border));
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

  const SeamSite& site_;
  const SeamsOverRim over_rim_;
  const int32_t rim_points_;
  const int64_t most_vertices_ = kMostVertices + kMostVerticesOfCell * std::ssize(site_.area);
  std::map<Corner, int32_t> corner_vertex_;
  std::vector<Stretch> projected_;               // yet to be laid
  std::map<Border, std::vector<int32_t>> laid_;  // the new vertices along each border
  SeamLayout result_;
};

}  // namespace

SeamLayout LaySeams(const SeamSite& site, const ClosingCells& closing, SeamsOverRim over_rim) {
  return SeamLayer(site, over_rim).Run(closing);
}

}  // namespace tilemend
