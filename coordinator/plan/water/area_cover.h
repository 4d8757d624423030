// How much of a hole an area of the user covers.
#ifndef TILEMEND_COORDINATOR_PLAN_WATER_AREA_COVER_H_
#define TILEMEND_COORDINATOR_PLAN_WATER_AREA_COVER_H_

#include <cstddef>
#include <functional>
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

// What of a region an area covers, 0 to 1.
struct AreaShare {
  size_t area = 0;  // its number among all
  double share = 0;
};

struct DecidingArea {
  size_t area = 0;
  double share = 0;       // that it covers, or that all of them cover together
  bool together = false;  // with the others that say the same
};

using PlaneSegment = std::pair<Point2, Point2>;

// The rings of the area's polygon.
std::vector<PlaneSegment> SegmentsOf(const WaterArea& area);

// Asked in loops whose length a file of the user's decides. Once true, results are not to be used. None: never.
using IsCancelled = std::function<bool()>;

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
  // The same of all areas together. `is_cancelled` is asked at each line. Cost O(128 * positions of the areas).
  double ShareIn(std::span<const WaterArea* const> areas, const IsCancelled& is_cancelled = {}) const;

  // Bounds of the boundary; lo > hi without segments.
  const Point2& lo() const { return lo_; }
  const Point2& hi() const { return hi_; }

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

// Who decides on a region of which areas cover `shares`: those that count and cover some of it, in rising order. The
// last that covers more than kDecidingShare. Where none does, areas that say the same may cover so much together, as
// the parts of a canal that is drawn in parts; then that of them which covers most, of equal ones the first.
//
// SayTheSame is no equivalence: levels may differ a little. Those with one level, or none, are measured together once.
// Levels that run on are halved until each half is settled by what it covers at most. Cost for n shares: O(n log n),
// and that of ShareIn for each such run, as a rule log n times. It is O(n) times where each of them covers nearly half.
std::optional<DecidingArea> FindDecidingArea(const CoverLines& region, std::span<const AreaShare> shares,
                                             std::span<const WaterArea> areas, const IsCancelled& is_cancelled = {});

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_WATER_AREA_COVER_H_
