// Where a made scene has no surface.
#ifndef TILEMEND_TESTS_SUPPORT_MADE_HOLES_H_
#define TILEMEND_TESTS_SUPPORT_MADE_HOLES_H_

#include <functional>
#include <map>
#include <optional>
#include <set>
#include <vector>

#include "common/grid/scene.h"
#include "tests/support/scene_maker.h"

namespace tilemend {

// Of hills, lakes and river.
double FeatureSize(const SceneMakerOptions& options);

class MadeHoles {
 public:
  // Precondition: as MakeScene.
  explicit MadeHoles(const SceneMakerOptions& options);

  bool Contains(double x, double y) const;

 private:
  // One of the shapes that options list, in metres.
  struct Shape {
    std::function<bool(const Point2&)> contains;
    std::optional<CellId> only_cell;
  };

  void AddShapes();
  void AddSmall();
  void AddClosed();
  // Files the shape under every cell that the box may reach: looking through all small holes of a scene would take too
  // long.
  void File(const Shape& shape, const Point2& lo, const Point2& hi);
  void AddEllipse(const EllipseHole& ellipse);
  bool IsClear(const EllipseHole& ellipse) const;
  CellId CellAt(const Point2& p) const;
  double Field(uint64_t purpose, double x, double y) const;
  double Level(uint64_t purpose, double share) const;
  bool InLake(double x, double y) const;
  bool InRiver(double x, double y) const;
  bool InShape(const Point2& p) const;
  Point2 Bent(const Point2& p) const;

  SceneMakerOptions o_;
  double width_ = 0, height_ = 0, lake_level_ = 0, island_level_ = 0;
  std::map<CellId, std::vector<Shape>> shapes_;
  std::set<CellId> empty_;
};

}  // namespace tilemend

#endif  // TILEMEND_TESTS_SUPPORT_MADE_HOLES_H_
