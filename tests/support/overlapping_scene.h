// Scenes in memory whose tiles overlap, as photogrammetry delivers them.
#ifndef TILEMEND_TESTS_SUPPORT_OVERLAPPING_SCENE_H_
#define TILEMEND_TESTS_SUPPORT_OVERLAPPING_SCENE_H_

#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "common/mesh/rounding.h"
#include "tests/support/mesh_builders.h"
#include "tests/support/surveyed_scene.h"

namespace tilemend {

// The mesh stretched from [lo, hi] to the same grown by `margin` on every side, in float32.
inline TriMesh Grown(TriMesh mesh, const Point2& lo, const Point2& hi, double margin, const HeightFunction& height) {
  return Moved(std::move(mesh), [&](const Point3& p) {
    Point3 q = p;
    for (const int k : {0, 1}) q[k] = lo[k] - margin + (p[k] - lo[k]) * (hi[k] - lo[k] + 2 * margin) / (hi[k] - lo[k]);
    q.z() = height(q.x(), q.y());
    return RoundedTo(NumberType::kFloat32, q);
  });
}

// The scene of a picture (PictureScene) with every tile, or every one of its `pieces` x `pieces` pieces, stretched by
// `margin` beyond its outline. Neighbours overlap by twice that and share no vertex. Negative: they part.
inline SurveyedScene OverlappingScene(const std::vector<std::string>& picture, int32_t squares, double margin,
                                      int32_t pieces = 1, const HeightFunction& height = Flat) {
  const SurveyedScene clipped = PictureScene(picture, squares / pieces);  // pieces as cells
  std::map<CellId, TriMesh> tiles;
  const double size = static_cast<double>(squares) / pieces;
  for (const auto& [part, mesh] : clipped.tiles) {
    TriMesh& tile = tiles[{part.col / pieces, part.row / pieces}];
    const Point2 lo(part.col * size, part.row * size), hi = lo + Point2::Constant(size);
    const TriMesh grown = Grown(mesh, lo, hi, margin, height);
    const auto base = static_cast<int32_t>(tile.points.size());
    tile.points.insert(tile.points.end(), grown.points.begin(), grown.points.end());
    for (const Triangle& t : grown.triangles) tile.triangles.push_back({t[0] + base, t[1] + base, t[2] + base});
  }
  Grid grid;
  grid.cell_size = Point2(squares, squares);
  return SurveyScene(grid, std::move(tiles));
}

// A scene of one cell of 50 m: nine pieces of 10 m that overlap by twice `margin`, cut along axes that are turned by
// `angle`. A pond of 8 m by 4 m lies over four of them, one of 2 m by 2 m in one. What lies around is not the area.
inline SurveyedScene TurnedPiecesScene(double margin, double angle) {
  std::vector<std::string> picture(30, std::string(30, '#'));
  for (size_t row = 18; row < 22; ++row) picture[row].replace(6, 8, "........");
  for (size_t row = 3; row < 5; ++row) picture[row].replace(24, 2, "..");
  const SurveyedScene straight = OverlappingScene(picture, 30, margin, 3);
  const Point2 x(std::cos(angle), std::sin(angle)), y(-std::sin(angle), std::cos(angle));
  TriMesh tile = Moved(straight.tiles.begin()->second, [&](const Point3& p) {
    const Point2 turned = Point2(25, 25) + (p.x() - 15) * x + (p.y() - 15) * y;
    return RoundedTo(NumberType::kFloat32, Point3(turned.x(), turned.y(), p.z()));
  });
  Grid grid;
  grid.cell_size = Point2(50, 50);
  SurveyedScene scene = SurveyScene(grid, {{{0, 0}, std::move(tile)}});
  scene.area_known = false;
  return scene;
}

// A lake over four cells, one that leaves the area, one in a cell, and a river over two cells.
inline const std::vector<std::string> kWaters = {
    "##########|######..##",  //
    "#..#######|######..##",  //
    "#..#######|##########",  //
    "##########|##########",  //
    "##########|##########",  //
    "##########|##########",  //
    "##########|##########",  //
    "#######...|..########",  //
    "#######...|..########",  //
    "#######...|..########",  //
    "----------+----------",  //
    "#######...|..########",  //
    "#######...|..########",  //
    "##########|##########",  //
    "##########|##########",  //
    "..........|..........",  //
    "..........|..........",  //
    "##########|##########",  //
    "##########|##########",  //
    "##########|##########",  //
    "##########|##########",  //
};

}  // namespace tilemend

#endif  // TILEMEND_TESTS_SUPPORT_OVERLAPPING_SCENE_H_
