#include "common/records/asked_places.h"

#include <iterator>

namespace tilemend {

std::vector<int32_t> VerticesWithoutSegment(const CellHoles& holes) {
  std::vector<bool> has_segment(holes.vertices.size(), false);
  for (const CellHole& hole : holes.holes) {
    for (const RimSegment& s : hole.segments) has_segment[s.from] = has_segment[s.to] = true;
  }
  std::vector<int32_t> vertices;
  for (int32_t v = 0; v < std::ssize(has_segment); ++v) {
    if (!has_segment[v]) vertices.push_back(v);
  }
  return vertices;
}

}  // namespace tilemend
