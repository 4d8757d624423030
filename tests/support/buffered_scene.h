// Scenes in memory whose tiles are cut from one mesh with a buffer.
#ifndef TILEMEND_TESTS_SUPPORT_BUFFERED_SCENE_H_
#define TILEMEND_TESTS_SUPPORT_BUFFERED_SCENE_H_

#include <array>
#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "common/mesh/rounding.h"
#include "tests/support/mesh_builders.h"
#include "tests/support/overlapping_scene.h"

namespace tilemend {

// The scene of a picture (PictureScene) as one mesh, its inner vertices shifted so that no edges lie along grid lines.
// It is cut so that every tile has all triangles whose bounds touch its cell grown by `margin`.
inline SurveyedScene BufferedScene(const std::vector<std::string>& picture, int32_t squares, double margin,
                                   const HeightFunction& height = Flat) {
  const SurveyedScene whole = PictureScene(picture, squares);
  const CellId last = whole.tiles.rbegin()->first;
  const Point2 size = squares * Point2(last.col + 1, last.row + 1);
  std::map<CellId, TriMesh> tiles;
  for (const auto& [cell, unused] : whole.tiles) {
    TriMesh& tile = tiles[cell];
    const Point2 lo(cell.col * squares - margin, cell.row * squares - margin);
    const Point2 hi = lo + Point2::Constant(squares + 2 * margin);
    for (const auto& [from, part] : whole.tiles) {
      for (const Triangle& t : part.triangles) {
        std::array<Point3, 3> corners;
        Point2 low = Point2::Constant(1e9), high = -low;
        for (int k = 0; k < 3; ++k) {
          Point3 p = part.points[t[k]];
          const bool inside = p.x() > 0 && p.y() > 0 && p.x() < size.x() && p.y() < size.y();
          if (inside) p += Point3(0.3 * std::sin(3 * p.y() + p.x()), 0.3 * std::sin(2 * p.x() + 5 * p.y()), 0);
          p.z() = height(p.x(), p.y());
          corners[k] = RoundedTo(NumberType::kFloat32, p);
          low = low.cwiseMin(corners[k].head<2>());
          high = high.cwiseMax(corners[k].head<2>());
        }
        if ((low.array() > hi.array()).any() || (high.array() < lo.array()).any()) continue;
        const auto base = static_cast<int32_t>(tile.points.size());
        tile.points.insert(tile.points.end(), corners.begin(), corners.end());
        tile.triangles.push_back({base, base + 1, base + 2});
      }
    }
  }
  Grid grid;
  grid.cell_size = Point2(squares, squares);
  return SurveyScene(grid, std::move(tiles));
}

}  // namespace tilemend

#endif  // TILEMEND_TESTS_SUPPORT_BUFFERED_SCENE_H_
