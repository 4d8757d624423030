// The columns of tables of holes, for scenes and for single meshes.
#ifndef TILEMEND_CLIENT_HOLE_COLUMNS_H_
#define TILEMEND_CLIENT_HOLE_COLUMNS_H_

#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace tilemend {

// A scene is in metres. A mesh has no cells and may be small: a column has the decimals that give its largest value
// four digits.
class HoleColumns {
 public:
  // Of a report, or of the plan of `inspect`.
  explicit HoleColumns(const nlohmann::ordered_json& report);

  // Of a row with area_m2 or perimeter_m, as of per_hole.
  std::string Area(const nlohmann::ordered_json& hole) const;
  std::string Rim(const nlohmann::ordered_json& hole) const;

  // Of an area in square metres.
  std::string Area(double area) const;

  // TableWithTexts, for a mesh without the column "cell".
  std::string TableOf(std::vector<std::string> headings, std::vector<std::vector<std::string>> rows,
                      size_t terminal_columns = 0) const;

 private:
  bool is_mesh_ = false;
  int area_decimals_ = 1;
  int rim_decimals_ = 1;  // of a mesh
};

}  // namespace tilemend

#endif  // TILEMEND_CLIENT_HOLE_COLUMNS_H_
