#include "coordinator/plan/pieces/open_runs.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include "common/mesh/edge_loops.h"
#include "coordinator/plan/pieces/outline_sides.h"

namespace tilemend {
namespace {

using Runs = std::vector<std::vector<int32_t>>;

// The hole goes on from the start of run `from` to the end of run `to`.
struct Link {
  bool loose;  // in one plane with kLoosePlane alone
  double length;
  size_t from, to;
};

std::vector<Link> FindLinks(const Runs& runs, const Rim& rim, const GridLines& lines) {
  const CellId tile = rim.edges[runs[0][0]].owner;
  std::vector<Link> links;
  for (size_t i = 0; i < runs.size(); ++i) {
    const Point3& p = rim.points[rim.edges[runs[i].front()].from].position;
    for (size_t j = 0; j < runs.size(); ++j) {
      const Point3& q = rim.points[rim.edges[runs[j].back()].to].position;
      if (!FaceEachOther(p, q, tile, lines, kLoosePlane)) continue;
      links.push_back({!FaceEachOther(p, q, tile, lines, kSamePlane), (p - q).norm(), i, j});
    }
  }
  std::sort(links.begin(), links.end(), [](const Link& a, const Link& b) {
    return std::tie(a.loose, a.length, a.from, a.to) < std::tie(b.loose, b.length, b.from, b.to);
  });
  return links;
}

// The run after each run along its hole; -1: none.
std::vector<int32_t> ChooseNext(const std::vector<Link>& links, size_t runs) {
  std::vector<int32_t> next(runs, -1);
  std::vector<bool> led_to(runs, false);
  for (const Link& link : links) {
    if (next[link.from] >= 0 || led_to[link.to]) continue;
    next[link.from] = static_cast<int32_t>(link.to);
    led_to[link.to] = true;
  }
  return next;
}

// The runs of a cycle, one after the other, with straight segments between their ends.
std::vector<RimSegment> Join(const std::vector<int32_t>& cycle, const std::vector<int32_t>& next, const Runs& runs,
                             const Rim& rim) {
  std::vector<RimSegment> loop;
  for (const int32_t before : cycle) {
    const int32_t k = next[before];
    const std::vector<RimSegment> run = Reversed(rim, runs[k]);
    loop.insert(loop.end(), run.begin(), run.end());
    const int32_t to = rim.edges[runs[next[k]].back()].to;
    if (loop.back().to != to) loop.push_back({loop.back().to, to, true});
  }
  return loop;
}

}  // namespace

LinkedRuns LinkRuns(const Runs& runs, const Rim& rim, const GridLines& lines) {
  LinkedRuns result;
  if (runs.empty()) return result;
  const CellId tile = rim.edges[runs[0][0]].owner;
  const std::vector<int32_t> next = ChooseNext(FindLinks(runs, rim, lines), runs.size());
  int64_t left = 0, chords = 0;
  for (const EdgeWalk& walk : FollowEdges(next)) {
    if (walk.closed) {
      chords += std::ssize(walk.edges);
      result.loops.push_back(Join(walk.edges, next, runs, rim));
    } else {
      for (const int32_t r : walk.edges) left += std::ssize(runs[r]);
    }
  }
  if (left > 0) {
    result.left.push_back({tile,
                           "its boundary runs from one side of the tile's outline to another, and it is not known "
                           "where the surface between them ends",
                           -1, left});
  }
  if (chords > 0) {
    result.left.push_back({tile, "outline of a tile up to which a hole was filled", -1, chords, false});
  }
  return result;
}

}  // namespace tilemend
