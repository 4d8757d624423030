// The line between two tiles that were cut there: where one has surface and the other has not.
#ifndef TILEMEND_COORDINATOR_PLAN_OVERLAP_LINE_RUNS_H_
#define TILEMEND_COORDINATOR_PLAN_OVERLAP_LINE_RUNS_H_

#include <array>
#include <map>
#include <set>
#include <vector>

namespace tilemend {

// A vertex on a line between tiles.
struct LineVertex {
  double t = 0, height = 0;  // metres; t: along the line
  bool on_surface = true;    // else only what is outside the area is there, without a height
};

// What one tile has along the line; the keys are places along it.
struct LineCover {
  bool in_scene = true;                 // its cell is
  std::map<double, int> step, of_tile;  // as SideCover
  std::map<double, double> height;      // of its own vertices beyond the line
  std::map<double, double> crossing;    // of the vertices of its clipped boundary on the line
  std::set<double> outside;             // vertices of what is outside the area
};

// A stretch where one tile has surface, or what is outside the area counts as such, and the other has none.
struct LineRun {
  int tile = -1;                     // which of the two has it
  bool outside = false;              // it has nothing but what is outside the area; the other's cell is in the scene
  std::vector<LineVertex> vertices;  // by rising t, two at least
};

//   fixed  places whose vertex is known: ends of the area's edge, corners of the grid
// Elsewhere a vertex has the height of a clipped boundary that crosses there. Without one it has that of the nearest
// vertex of the run's tile along the line. Runs come by rising t. Cost O(n log n).
std::vector<LineRun> FindLineRuns(const std::array<LineCover, 2>& of, const std::map<double, LineVertex>& fixed);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_OVERLAP_LINE_RUNS_H_
