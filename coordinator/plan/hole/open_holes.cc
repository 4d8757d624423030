#include "coordinator/plan/hole/open_holes.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>
#include <utility>

#include "common/mesh/disjoint_sets.h"
#include "coordinator/plan/hole/hole_types.h"
#include "coordinator/plan/hole/measure_hole.h"
#include "coordinator/plan/types/doubled_segments.h"
#include "coordinator/plan/types/left_reasons.h"

namespace tilemend {
namespace {

constexpr char kFolds[] = "its boundary crosses itself seen from above";
constexpr char kDoesNotClose[] = "its boundary does not close along the grid lines, so that it has no inside";

using Segments = std::vector<BoundarySegment>;

// Connected groups of segments, by shared vertices, in order of their first segment.
std::vector<Segments> GroupsOf(const Segments& open) {
  DisjointSets sets(static_cast<int32_t>(open.size()));
  std::unordered_map<int32_t, int32_t> first_at;
  for (int32_t i = 0; i < std::ssize(open); ++i) {
    for (const int32_t v : {open[i].segment.from, open[i].segment.to}) {
      sets.Join(i, first_at.try_emplace(v, i).first->second);
    }
  }
  const std::vector<int32_t> group_of = sets.Groups();
  std::vector<Segments> groups;
  for (size_t i = 0; i < open.size(); ++i) {
    if (group_of[i] == std::ssize(groups)) groups.emplace_back();
    groups[group_of[i]].push_back(open[i]);
  }
  return groups;
}

// Whether as many segments end at every vertex as begin there, so that they form loops.
bool IsBalanced(const Segments& open) {
  std::unordered_map<int32_t, int32_t> balance;
  for (const BoundarySegment& s : open) {
    ++balance[s.segment.from];
    --balance[s.segment.to];
  }
  return std::all_of(balance.begin(), balance.end(), [](const auto& b) { return b.second == 0; });
}

std::vector<RimSegment> RimSegmentsOf(const Segments& open) {
  std::vector<RimSegment> segments;
  for (const BoundarySegment& s : open) segments.push_back(s.segment);
  return segments;
}

class OpenHoleFinder {
 public:
  OpenHoleFinder(const HoleSite& site, const CellBoundary& boundary) : site_(site), boundary_(boundary) {}

  OpenHoles Run() {
    Segments open = boundary_.open;
    DropDoubled(open, &BoundarySegment::segment);  // the cells beyond close on each other
    if (open.empty() || AddRegions(open)) return std::move(found_);
    const std::vector<Segments> groups = GroupsOf(open);
    for (const Segments& group : groups) {
      if (groups.size() == 1 || !AddRegions(group)) AddWithoutRegion(group);
    }
    return std::move(found_);
  }

 private:
  // Adds the holes that the segments bound; nothing if they bound none.
  bool AddRegions(const Segments& open) {
    PlanarRegions regions = FindPlanarRegions(RimSegmentsOf(open), site_.position, site_.is_cancelled);
    const RegionTriangulation& triangulation = regions.triangulation;
    crosses_ = std::any_of(triangulation.conflicts.begin(), triangulation.conflicts.end(),
                           [](const RegionConflict& c) { return c.kind != RegionConflict::Kind::kInsideOut; });
    if (!triangulation.conflicts.empty()) return false;
    std::vector<Segments> parts(regions.area.size());
    for (size_t i = 0; i < open.size(); ++i) {
      parts[triangulation.component[triangulation.segment_triangle[i]]].push_back(open[i]);
    }
    for (size_t c = 0; c < parts.size(); ++c) {
      found_.places.push_back({found_.regions.size(), static_cast<int32_t>(c), found_.holes.size()});
      found_.holes.push_back(NewHole(parts[c]));
      found_.holes.back().area = regions.area[c];
    }
    found_.regions.push_back(std::move(regions));
    return true;
  }

  // Adds a hole whose boundary crosses itself seen from above, for the filler to cut the folds off, or one that fails.
  void AddWithoutRegion(const Segments& group) {
    PlannedHole hole = NewHole(group);
    hole.projects = false;
    if (crosses_ && boundary_.seam_failure.empty() && IsBalanced(group)) {
      hole.area = std::abs(VectorArea(hole.segments, site_.position).z());
    } else if (crosses_) {
      hole.failure = kFolds;
    } else {
      const char* why = site_.lines.left_open.empty() ? kDoesNotClose : kReachesUnknownRim;
      hole.failure = boundary_.seam_failure.empty() ? why : boundary_.seam_failure;
    }
    found_.holes.push_back(std::move(hole));
  }

  PlannedHole NewHole(const Segments& part) const {
    PlannedHole hole = MeasureHole(boundary_.cell, RimSegmentsOf(part), site_.position);
    const bool external = std::any_of(part.begin(), part.end(), [&](const BoundarySegment& s) {
      return s.area_edge || (s.side >= 0 && !site_.area.contains(s.across));
    });
    hole.kind = external ? HoleKind::kOpenII : HoleKind::kOpenI;
    hole.type = ClassifyOpen(part, boundary_.cell, boundary_.has_surface, site_.lines, site_.position);
    return hole;
  }

  const HoleSite& site_;
  const CellBoundary& boundary_;
  bool crosses_ = false;  // the segments that were tried last cross seen from above
  OpenHoles found_;
};

}  // namespace

OpenHoles FindOpenHoles(const HoleSite& site, const CellBoundary& boundary) {
  return OpenHoleFinder(site, boundary).Run();
}

}  // namespace tilemend
