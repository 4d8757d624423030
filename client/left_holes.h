// An index of the holes that an output left open.
#ifndef TILEMEND_CLIENT_LEFT_HOLES_H_
#define TILEMEND_CLIENT_LEFT_HOLES_H_

#include <cstdint>
#include <span>
#include <vector>

#include "client/reported_output.h"
#include "common/mesh/box_tree.h"

namespace tilemend {

class LeftHoles {
 public:
  // O(n log n) in the points of the boundaries.
  LeftHoles(const Grid& grid, std::span<const ReportedOutput::Left> left);

  // Whether an edge at p may be open because a hole was left: p lies at its boundary, or, where that is not known,
  // around it. Also if p lies where the hole goes on beyond its cell and was filled. That is at the sides that the
  // hole reaches, and on sides near its boundary: `beside` has the cells whose sides p is on. O(log n + boundaries near
  // p).
  bool AreAt(const Point2& p, std::span<const CellId> beside) const;

 private:
  // One segment of a boundary, or a circle if a and b are one point.
  struct Part {
    Point2 a, b;
    double reach;  // metres around it
  };
  // The box of a hole that goes on beyond its cell, or of a part of its cell's sides that it reaches.
  struct Beyond {
    CellId cell;
    Eigen::AlignedBox2d box;
    bool is_side;
  };

  void AddSides(const Grid& grid, const ReportedOutput::Left& hole);

  std::vector<Part> parts_;
  std::vector<Beyond> beyond_;
  BoxTree part_tree_, beyond_tree_;  // from above
};

}  // namespace tilemend

#endif  // TILEMEND_CLIENT_LEFT_HOLES_H_
