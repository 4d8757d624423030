#include "common/mesh/height_tallies.h"

#include <cmath>
#include <cstddef>
#include <cstdint>

#include "common/mesh/polygon_index.h"
#include "common/mesh/polygon_tree.h"

namespace tilemend {

std::vector<HeightTally> TallyHeightsIn(const MeshView& mesh, std::span<const PlanePolygon> polygons) {
  const PolygonTree tree(polygons.size(), [&](size_t i) -> const PlanePolygon& { return polygons[i]; });
  const std::vector<PolygonIndex> indices(polygons.begin(), polygons.end());
  std::vector<HeightTally> tallies(polygons.size());
  for (const Triangle& t : mesh.triangles) {
    const Point3 a = mesh.points[t[0]], b = mesh.points[t[1]], c = mesh.points[t[2]];
    const Point3 centroid = (a + b + c) / 3;
    const Point2 at = centroid.head<2>();
    tree.ForMeeting(at, at, [&](int32_t i) {
      if (!indices[i].Contains(at)) return;
      const Point3 u = b - a, v = c - a;
      const double area = std::abs(u.x() * v.y() - u.y() * v.x()) / 2;
      const auto units = static_cast<int64_t>(std::llround(area / kAreaUnit));
      if (units > 0) tallies[i].area_of_bin[HeightBinOf(centroid.z())] += units;
    });
  }
  return tallies;
}

}  // namespace tilemend
