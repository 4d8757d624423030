// How much of a hole an area of the user covers.
#ifndef TILEMEND_COORDINATOR_PLAN_WATER_AREA_COVER_H_
#define TILEMEND_COORDINATOR_PLAN_WATER_AREA_COVER_H_

#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "common/grid/water_areas.h"

namespace tilemend {

// An area decides on a hole, a cluster or a body of water if it covers more than this share: most of it.
inline constexpr double kDecidingShare = 0.5;

// Whether two areas say the same of what they cover: water or none, the same decision, its kind and what is cleared,
// without centrelines, and one level. Levels that were measured in them may differ by as much as the surface scatters.
bool SayTheSame(const WaterArea& a, const WaterArea& b);

struct DecidingArea {
  size_t area = 0;
  double share = 0;       // that it covers, or that all of them cover together
  bool together = false;  // with the others that say the same
};

using PlaneSegment = std::pair<Point2, Point2>;

// A region that segments bound (even-odd rule, any order), on 128 lines across it. Segments that occur twice, such as
// seams inside a cluster, bound nothing. Cost O(128 * segments).
class CoverLines {
 public:
  explicit CoverLines(std::span<const PlaneSegment> boundary);

  // The share, 0 to 1, of the region that lies in the area. Cost O(positions of the area), where the bounding boxes
  // meet that and the segments of the lines, at most 128 times.
  double ShareIn(const WaterArea& area) const;
  // The same of the region that segments bound.
  double ShareIn(std::span<const PlaneSegment> outline) const;
  // The same of all areas together.
  double ShareIn(std::span<const WaterArea* const> areas) const;

 private:
  struct Line {
    double y;
    std::vector<double> inside;  // where intervals begin and end, ascending
  };

  bool Meets(const Point2& lo, const Point2& hi) const;

  Point2 lo_, hi_;
  std::vector<Line> lines_;
  double length_ = 0;  // of all intervals
};

// Who decides on a region of which area a covers shares[a]; 0 for areas that do not count. The last that covers more
// than kDecidingShare. Where none does, areas that say the same may cover so much together, as the parts of a canal
// that is drawn in parts; then that of them which covers most. Cost O(areas^2), and that of ShareIn.
std::optional<DecidingArea> FindDecidingArea(const CoverLines& region, std::span<const double> shares,
                                             std::span<const WaterArea> areas);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_WATER_AREA_COVER_H_
