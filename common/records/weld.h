// What welding a mesh did to it.
#ifndef TILEMEND_COMMON_RECORDS_WELD_H_
#define TILEMEND_COMMON_RECORDS_WELD_H_

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace tilemend {

// All vertices are numbers in the file, from 0; of several at one position the lowest. Distances are in its units.
struct WeldedVertex {
  int32_t vertex = 0;  // faces name the other one in its place
  int32_t into = 0;
  double distance = 0;
};

// A vertex that lay beside an edge. The face of that edge is two faces now, which meet at the vertex.
struct SplitEdge {
  int32_t vertex = 0;
  std::array<int32_t, 2> edge = {0, 0};
  double distance = 0;
};

// What lies within the tolerance and was left as it was. Vertices: two; or one, and the two of an edge.
struct RefusedWeld {
  std::vector<int32_t> vertices;
  double distance = 0;
  std::string reason;
};

struct WeldRecord {
  std::vector<WeldedVertex> welded;  // by vertex
  std::vector<SplitEdge> split;      // in the order in which they were split
  std::vector<RefusedWeld> refused;  // the nearest first
};

}  // namespace tilemend

#endif  // TILEMEND_COMMON_RECORDS_WELD_H_
