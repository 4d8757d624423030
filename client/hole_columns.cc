#include "client/hole_columns.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "client/fitted_table.h"
#include "client/output.h"
#include "coordinator/report/json_access.h"

namespace tilemend {
namespace {

using Json = nlohmann::ordered_json;

int DecimalsFor(double largest) {
  constexpr double kFewest = 1, kMost = 15;
  return largest > 0 ? static_cast<int>(std::clamp(3 - std::floor(std::log10(largest)), kFewest, kMost)) : 1;
}

}  // namespace

HoleColumns::HoleColumns(const Json& report) {
  double area = 0, rim = 0;
  for (const Json& hole : Member(report, "per_hole")) {
    is_mesh_ = is_mesh_ || Member(hole, "centre").size() == 3;  // a place of a scene has two coordinates
    area = std::max(area, std::abs(Number(Member(hole, "area_m2"))));
    rim = std::max(rim, Number(Member(hole, "perimeter_m")));
  }
  area_decimals_ = is_mesh_ ? DecimalsFor(area) : 1;
  rim_decimals_ = DecimalsFor(rim);
}

std::string HoleColumns::Area(const Json& hole) const { return AreaText(Member(hole, "area_m2"), area_decimals_); }

std::string HoleColumns::Area(double area) const { return AreaText(area, area_decimals_); }

std::string HoleColumns::Rim(const Json& hole) const {
  return Decimals(Member(hole, "perimeter_m"), is_mesh_ ? rim_decimals_ : 1);
}

std::string HoleColumns::TableOf(std::vector<std::string> headings, std::vector<std::vector<std::string>> rows,
                                 size_t terminal_columns) const {
  const auto cell = std::ranges::find(headings, "cell");
  if (is_mesh_ && cell != headings.end()) {
    const std::ptrdiff_t at = cell - headings.begin();
    headings.erase(cell);
    for (std::vector<std::string>& row : rows) row.erase(row.begin() + at);
  }
  return TableWithTexts(std::move(headings), std::move(rows), terminal_columns);
}

}  // namespace tilemend
