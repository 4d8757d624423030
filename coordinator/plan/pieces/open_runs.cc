#include "coordinator/plan/pieces/open_runs.h"

#include <algorithm>
#include <tuple>
#include <utility>

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

// The run after each run along its hole, and that before it; -1: none.
struct Order {
  std::vector<int32_t> next, before;
};

Order Choose(const std::vector<Link>& links, size_t runs) {
  Order order{std::vector<int32_t>(runs, -1), std::vector<int32_t>(runs, -1)};
  for (const Link& link : links) {
    if (order.next[link.from] >= 0 || order.before[link.to] >= 0) continue;
    order.next[link.from] = static_cast<int32_t>(link.to);
    order.before[link.to] = static_cast<int32_t>(link.from);
  }
  return order;
}

// The runs of the path or cycle through `start`: a path from its beginning, a cycle from the run after `start`.
std::vector<int32_t> Trace(const Order& order, int32_t start) {
  int32_t first = start;
  while (order.before[first] >= 0 && order.before[first] != start) first = order.before[first];
  std::vector<int32_t> traced = {first};
  for (int32_t r = order.next[first]; r >= 0 && r != first; r = order.next[r]) traced.push_back(r);
  return traced;
}

// The runs of a cycle, one after the other, with straight segments between their ends.
std::vector<RimSegment> Join(const std::vector<int32_t>& cycle, const Order& order, const Runs& runs, const Rim& rim) {
  std::vector<RimSegment> loop;
  for (const int32_t k : cycle) {
    const std::vector<RimSegment> run = Reversed(rim, runs[k]);
    loop.insert(loop.end(), run.begin(), run.end());
    const int32_t to = rim.edges[runs[order.next[k]].back()].to;
    if (loop.back().to != to) loop.push_back({loop.back().to, to, true});
  }
  return loop;
}

}  // namespace

LinkedRuns LinkRuns(const Runs& runs, const Rim& rim, const GridLines& lines) {
  LinkedRuns result;
  if (runs.empty()) return result;
  const CellId tile = rim.edges[runs[0][0]].owner;
  const Order order = Choose(FindLinks(runs, rim, lines), runs.size());
  int64_t left = 0, chords = 0;
  std::vector<bool> seen(runs.size(), false);
  for (size_t start = 0; start < runs.size(); ++start) {
    if (seen[start]) continue;
    const std::vector<int32_t> traced = Trace(order, static_cast<int32_t>(start));
    for (const int32_t r : traced) seen[r] = true;
    if (order.next[traced.back()] >= 0) {
      chords += std::ssize(traced);
      result.loops.push_back(Join(traced, order, runs, rim));
    } else {
      for (const int32_t r : traced) left += std::ssize(runs[r]);
    }
  }
  if (left > 0) {
    result.left.push_back({tile,
                           "its boundary runs from one side of the tile's outline to another, and where the surface "
                           "between them ends is not known",
                           -1, left});
  }
  if (chords > 0) {
    result.left.push_back(
        {tile, "where a hole was filled up to the outline of a piece of the tile: the new outline", -1, chords});
  }
  return result;
}

}  // namespace tilemend
