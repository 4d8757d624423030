#include "worker/papers/front/front_loops.h"

namespace tilemend {

FrontLoops::FrontLoops(std::span<const std::vector<int32_t>> loops) {
  for (const std::vector<int32_t>& loop : loops) {
    const int32_t first = size(), count = static_cast<int32_t>(loop.size());
    for (int32_t i = 0; i < count; ++i) {
      Add({loop[i], first + (i + count - 1) % count, first + (i + 1) % count, true});
    }
  }
}

void FrontLoops::CutOff(int32_t node) {
  const int32_t before = nodes_[node].before;
  Link(before, nodes_[node].after);
  End(node);
  EndIfClosed(before);
}

int32_t FrontLoops::Insert(int32_t node, int32_t vertex) {
  const int32_t before = nodes_[node].before, added = Add({vertex, before, node, true});
  Link(before, added);
  Link(added, node);
  return added;
}

int32_t FrontLoops::Join(int32_t node, int32_t other) {
  const int32_t before = nodes_[node].before, after_other = nodes_[other].after;
  const int32_t added = Add({nodes_[other].vertex, before, after_other, true});
  Link(before, added);
  Link(added, after_other);
  Link(other, node);
  EndIfClosed(added);
  EndIfClosed(other);
  return added;
}

void FrontLoops::Link(int32_t from, int32_t to) {
  nodes_[from].after = to;
  nodes_[to].before = from;
}

// Two nodes with an edge to and fro have nothing between them.
void FrontLoops::EndIfClosed(int32_t node) {
  const int32_t other = nodes_[node].after;
  if (!nodes_[node].alive || nodes_[other].after != node) return;
  End(node);
  End(other);
}

int32_t FrontLoops::Add(const Node& node) {
  place_.push_back(static_cast<int32_t>(alive_.size()));
  alive_.push_back(size());
  nodes_.push_back(node);
  return alive_.back();
}

void FrontLoops::End(int32_t node) {
  nodes_[node].alive = false;
  const int32_t last = alive_.back();
  alive_[place_[node]] = last;
  place_[last] = place_[node];
  alive_.pop_back();
}

}  // namespace tilemend
