// Tells ground from objects at points over a mesh, for ground_bench.py.
//
//   ground_bench MESH [SLOPE WINDOW] <POINTS >FLAGS
//
// POINTS: lines of x, y, z. FLAGS: a line of 0 (ground) and 1 (object), one for each point.
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <vector>

#include "common/codec/mesh_file.h"
#include "worker/ground/lowest_surface.h"
#include "worker/ground/rim_objects.h"

int main(int argc, char** argv) {
  if (argc != 2 && argc != 4) {
    std::cerr << "ground_bench MESH [SLOPE WINDOW] <POINTS >FLAGS\n";
    return 2;
  }
  const auto file = tilemend::ReadMeshFile(argv[1]);
  if (!file.ok()) {
    std::cerr << file.status() << '\n';
    return 4;
  }
  tilemend::GroundFilterOptions options;
  if (argc == 4) {
    options.slope = std::atof(argv[2]);
    options.window = std::atof(argv[3]);
  }
  std::vector<tilemend::Point3> points;
  for (double x, y, z; std::cin >> x >> y >> z;) points.emplace_back(x, y, z);
  const std::vector<tilemend::GroundRaster> rasters = {tilemend::LowestSurface(file->mesh, 1)};
  for (const bool on_object : tilemend::GroundAtRim(points, rasters, options).on_object) {
    std::putchar(on_object ? '1' : '0');
  }
  std::putchar('\n');
}
