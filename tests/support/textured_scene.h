// Two OBJ tiles with a hole over their border, their material files, and an image that both name.
#ifndef TILEMEND_TESTS_SUPPORT_TEXTURED_SCENE_H_
#define TILEMEND_TESTS_SUPPORT_TEXTURED_SCENE_H_

#include <cstdint>
#include <string>

#include "absl/strings/str_cat.h"
#include "absl/strings/str_format.h"
#include "tests/support/image_builders.h"
#include "tests/support/mesh_builders.h"
#include "tests/support/temporary_folder.h"

namespace tilemend {

inline constexpr int32_t kSide = 10;  // of a cell, metres
inline constexpr Rgb kGreen = {40, 120, 60};

// Cell `column` without the squares of a lake over the border of both; every vertex has the same texture coordinate.
inline std::string TileText(int32_t column, const std::string& library) {
  const int32_t x = column * kSide;
  const auto keep = [](int32_t i, int32_t j) { return i < 7 || i > 12 || j < 3 || j > 6; };
  const TriMesh mesh = SquaresMesh(x, x + kSide, 0, kSide, keep, [](double u, double v) { return 0.1 * u + 0.05 * v; });
  std::string text = absl::StrCat("mtllib ", library, "\n");
  for (const Point3& p : mesh.points) absl::StrAppendFormat(&text, "v %.6f %.6f %.6f\n", p.x(), p.y(), p.z());
  text += "vt 0.5 0.5\nusemtl ground\n";
  for (const Triangle& t : mesh.triangles) {
    absl::StrAppendFormat(&text, "f %d/1 %d/1 %d/1\n", t[0] + 1, t[1] + 1, t[2] + 1);
  }
  return text;
}

// The same with an image over both cells.
inline std::string ImageTileText(int32_t column, const std::string& library) {
  const int32_t x = column * kSide;
  const auto keep = [](int32_t i, int32_t j) { return i < 7 || i > 12 || j < 3 || j > 6; };
  const TriMesh mesh = SquaresMesh(x, x + kSide, 0, kSide, keep, [](double u, double v) { return 0.1 * u + 0.05 * v; });
  std::string text = absl::StrCat("mtllib ", library, "\n");
  for (const Point3& p : mesh.points) absl::StrAppendFormat(&text, "v %.6f %.6f %.6f\n", p.x(), p.y(), p.z());
  for (const Point3& p : mesh.points) absl::StrAppendFormat(&text, "vt %.6f %.6f\n", p.x() / 20, p.y() / 20);
  text += "usemtl ground\n";
  for (const Triangle& t : mesh.triangles) {
    absl::StrAppendFormat(&text, "f %1$d/%1$d %2$d/%2$d %3$d/%3$d\n", t[0] + 1, t[1] + 1, t[2] + 1);
  }
  return text;
}

// Writes it to the folder `scene`: tiles T0.obj and T1.obj with an image of bright lines along x.
inline void WriteImageScene(const TemporaryFolder& folder) {
  for (const int32_t column : {0, 1}) {
    const std::string name = absl::StrCat("scene/T", column);
    folder.Write(name + ".obj", ImageTileText(column, absl::StrCat("T", column, ".mtl")));
    folder.Write(name + ".mtl", "newmtl ground\nmap_Kd ground.png\n");
  }
  folder.Write("scene/ground.png", PngImage(80, 80, [](int32_t, int32_t row) {
                 const auto grey = static_cast<uint8_t>(row % 8 < 2 ? 180 : 90);
                 return Rgb{grey, grey, grey};
               }));
  folder.Write("scene/scene.json", R"({"cell_size": 10, "cols": 2, "rows": 1, "tiles": [
    {"col": 0, "row": 0, "path": "T0.obj"}, {"col": 1, "row": 0, "path": "T1.obj"}]})");
}

// Writes it to the folder `scene`.
inline void WriteTexturedScene(const TemporaryFolder& folder) {
  for (const int32_t column : {0, 1}) {
    const std::string name = absl::StrFormat("Tile_+%03d_+000", column);
    folder.Write(absl::StrCat("scene/Data/", name, "/", name, ".obj"), TileText(column, name + ".mtl"));
    folder.Write(absl::StrCat("scene/Data/", name, "/", name, ".mtl"),
                 absl::StrCat("newmtl ground\nmap_Kd ..\\..\\shared\\my ground.JPG\nbump lost.png\n"));
  }
  folder.Write("scene/shared/my ground.jpg", PngImage(8, 8, [](int32_t, int32_t) { return kGreen; }));
  folder.Write("scene/metadata.xml",
               "<ModelMetadata><SRS>EPSG:32650</SRS><SRSOrigin>1,2,3</SRSOrigin></ModelMetadata>");
  folder.Write("scene/scene.json", R"({"cell_size": 10, "cols": 2, "rows": 1, "tiles": [
    {"col": 0, "row": 0, "path": "Data/Tile_+000_+000/Tile_+000_+000.obj"},
    {"col": 1, "row": 0, "path": "Data/Tile_+001_+000/Tile_+001_+000.obj"}]})");
}

}  // namespace tilemend

#endif  // TILEMEND_TESTS_SUPPORT_TEXTURED_SCENE_H_
