// Links directed edges, head to tail, to loops.
#ifndef TILEMEND_COMMON_MESH_EDGE_LOOPS_H_
#define TILEMEND_COMMON_MESH_EDGE_LOOPS_H_

#include <cstdint>
#include <functional>
#include <map>
#include <span>
#include <utility>
#include <vector>

namespace tilemend {

struct DirectedEdge {
  int32_t from = 0;
  int32_t to = 0;
};

// Edges by their numbers, each running on into the next.
struct EdgeWalk {
  std::vector<int32_t> edges;
  bool closed = false;  // a loop: the last edge runs on into the first
};

// Of several edges that leave the vertex where `edge` ends: the one that it runs on into. `candidates` are the edges
// not walked yet. The first edge of the walk is one of them too if it leaves there; it closes the walk. They are
// rising, and at least one.
using ChooseEdge = std::function<int32_t(int32_t edge, std::span<const int32_t> candidates)>;

// Walks along all edges, each once. An edge runs on into the one that follows it in the list, if that begins where it
// ends. Else it runs on into the first in the list that begins there and is not walked yet. So a loop that the list has
// in one piece stays one, however often it passes a vertex.
//
// The walks begin with the chains, each at an edge that none leads to, in order of these. Then come the loops, each
// from the lowest edge that is left. If as many edges leave every vertex as arrive at it, all walks are closed. Else a
// walk may also end, open, where all edges that leave are walked already.
//
// Vertices are any numbers. Cost O(n log n), and for each vertex the square of its edges. Deterministic: depends on the
// list alone.
std::vector<EdgeWalk> LinkEdges(std::span<const DirectedEdge> edges);

// The same with `choose` at every vertex: for loops that are to turn in a certain way where they touch.
std::vector<EdgeWalk> LinkEdges(std::span<const DirectedEdge> edges, const ChooseEdge& choose);

// The same where it is known which edge each runs on into; next[e] is -1 if edge e ends a chain. No two edges run on
// into the same one. Cost O(n).
std::vector<EdgeWalk> FollowEdges(std::span<const int32_t> next);

// Cuts a loop that passes corners more than once into loops that do not. A part between two passages that has no other
// such is a loop, and the rest goes on without it. A way there and back is a loop of two. Cost O(n log n). Corner:
// anything in an order.
template <typename Corner>
std::vector<std::vector<Corner>> CutWhereItTouches(std::span<const Corner> loop) {
  std::vector<std::vector<Corner>> loops;
  std::vector<Corner> open;
  std::map<Corner, size_t> place;  // in `open`
  for (const Corner& corner : loop) {
    if (const auto seen = place.find(corner); seen != place.end()) {
      const auto begin = open.begin() + static_cast<ptrdiff_t>(seen->second);
      loops.emplace_back(begin, open.end());
      for (auto c = begin; c != open.end(); ++c) place.erase(*c);
      open.erase(begin, open.end());
    }
    place[corner] = open.size();
    open.push_back(corner);
  }
  if (!open.empty()) loops.push_back(std::move(open));
  return loops;
}

}  // namespace tilemend

#endif  // TILEMEND_COMMON_MESH_EDGE_LOOPS_H_
