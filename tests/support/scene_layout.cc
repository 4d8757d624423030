#include "tests/support/scene_layout.h"

#include <nlohmann/json.hpp>
#include <optional>
#include <utility>
#include <vector>

#include "absl/strings/str_cat.h"

namespace tilemend {
namespace {

using Json = nlohmann::json;

// As a share of a cell. The shared layouts leave room for this much.
constexpr double kBend = 0.012;

Point2 PointOf(const Json& json, double cell) {
  return cell * Point2(json.at(0).get<double>(), json.at(1).get<double>());
}

CellId CellOf(const Json& json) { return {json.at(0).get<int32_t>(), json.at(1).get<int32_t>()}; }

// True if the hole is of a kind that there is.
bool AddHole(const Json& hole, SceneMakerOptions* options) {
  const double cell = options->cell_size;
  const std::string kind = hole.at("kind").get<std::string>();
  std::optional<CellId> only;
  if (hole.contains("only_cell")) only = CellOf(hole.at("only_cell"));
  if (kind == "strip") {
    std::vector<Point2> through;
    for (const Json& point : hole.at("through")) through.push_back(PointOf(point, cell));
    options->strips.push_back({std::move(through), cell * hole.at("half_width").get<double>(), only});
    return !options->strips.back().through.empty();
  }
  const Json& at = hole.at("at");
  const Point2 first = PointOf(at, cell);
  const Point2 second = cell * Point2(at.at(2).get<double>(), at.at(3).get<double>());
  if (kind == "box") options->boxes.push_back({first, second, only});
  if (kind == "disc") options->ellipses.push_back({first, second, only});
  return kind == "box" || kind == "disc";
}

}  // namespace

absl::Status ApplyLayout(const std::string& text, const std::string& name, SceneMakerOptions* options) {
  try {
    const Json layout = Json::parse(text);
    options->cols = layout.at("cols").get<int32_t>();
    options->rows = layout.at("rows").get<int32_t>();
    options->relief = layout.value("relief", options->relief);
    options->closed = layout.value("closed", 0);
    options->bend = kBend;
    for (const Json& cell : layout.value("out_of_area", Json::array())) options->out_of_area.push_back(CellOf(cell));
    for (const Json& hole : layout.at("holes")) {
      if (!AddHole(hole, options)) {
        return absl::InvalidArgumentError(absl::StrCat(name, ": ", hole.dump(), ": expected a box, disc or strip"));
      }
    }
  } catch (const Json::exception& error) {
    return absl::InvalidArgumentError(absl::StrCat(name, ": no layout: ", error.what()));
  }
  return absl::OkStatus();
}

}  // namespace tilemend
