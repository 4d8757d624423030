// The loops of an advancing front.
#ifndef TILEMEND_WORKER_PAPERS_FRONT_FRONT_LOOPS_H_
#define TILEMEND_WORKER_PAPERS_FRONT_FRONT_LOOPS_H_

#include <cstdint>
#include <span>
#include <vector>

namespace tilemend {

// Nodes in loops, what is yet to be filled on their left. A vertex has several nodes where the front passes it several
// times. Nodes keep their numbers; all steps are O(1).
class FrontLoops {
 public:
  struct Node {
    int32_t vertex = 0;
    int32_t before = 0, after = 0;  // nodes
    bool alive = true;
  };

  explicit FrontLoops(std::span<const std::vector<int32_t>> loops);

  // A triangle before, node, after: the front passes the node no more.
  void CutOff(int32_t node);
  // A triangle before, node, `vertex`, which is new: the front passes it between the two. Gives its node.
  int32_t Insert(int32_t node, int32_t vertex);
  // A triangle before, node, other. The front then runs from `before` to `other` and on, and comes from before `other`
  // to `other` and on to the node. So one loop becomes two, or two become one. Gives the second node of `other`'s
  // vertex. Precondition: `other` is neither the node nor the one before it.
  int32_t Join(int32_t node, int32_t other);

  const Node& operator[](int32_t node) const { return nodes_[node]; }
  int32_t size() const { return static_cast<int32_t>(nodes_.size()); }  // those that are gone included
  std::span<const int32_t> Alive() const { return alive_; }             // in no order that means anything
  int32_t VertexBefore(int32_t node) const { return nodes_[nodes_[node].before].vertex; }
  int32_t VertexAfter(int32_t node) const { return nodes_[nodes_[node].after].vertex; }

 private:
  void Link(int32_t from, int32_t to);
  void EndIfClosed(int32_t node);
  int32_t Add(const Node& node);
  void End(int32_t node);

  std::vector<Node> nodes_;
  std::vector<int32_t> alive_, place_;  // of each node in `alive_`
};

}  // namespace tilemend

#endif  // TILEMEND_WORKER_PAPERS_FRONT_FRONT_LOOPS_H_
