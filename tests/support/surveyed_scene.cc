#include "tests/support/surveyed_scene.h"

#include <algorithm>
#include <utility>

#include "absl/strings/str_cat.h"
#include "absl/strings/str_join.h"
#include "worker/ground/lowest_surface.h"
#include "worker/survey/survey.h"

namespace tilemend {

PlanInput SurveyedScene::Input() const {
  PlanInput input;
  input.grid = grid;
  input.area_known = area_known;
  for (const auto& [cell, tile] : tiles) {
    const auto record = records.find(cell);
    input.cells[cell] = record == records.end() ? nullptr : &record->second;
  }
  return input;
}

Scene SurveyedScene::AsScene() const {
  Scene scene;
  scene.grid = grid;
  scene.area_known = area_known;
  for (const auto& [cell, tile] : tiles) {
    scene.tiles.push_back({cell, records.contains(cell) ? ToString(cell) : std::string()});
  }
  return scene;
}

SurveyedScene SurveyScene(const Grid& grid, std::map<CellId, TriMesh> tiles) {
  SurveyedScene scene;
  scene.grid = grid;
  scene.tiles = std::move(tiles);
  for (const auto& [cell, tile] : scene.tiles) {
    if (tile.triangles.empty()) continue;
    SurveyRecord& record = scene.records[cell] = SurveyTile(tile, true);
    record.lowest = LowestSurface(tile, RasterSquareFor(grid.cell_size.x(), grid.cell_size.y()));
  }
  return scene;
}

SurveyedScene SurveyScene(const MadeScene& made) {
  std::map<CellId, TriMesh> tiles;
  for (const MadeTile& tile : made.tiles) tiles[tile.cell] = tile.mesh;
  return SurveyScene(made.grid, std::move(tiles));
}

SurveyedScene PictureScene(const std::vector<std::string>& picture, int32_t squares, const HeightFunction& height) {
  std::vector<std::string> rows;  // from south to north
  for (std::string row : picture) {
    std::erase(row, '|');
    if (row.find_first_not_of("-+") != std::string::npos) rows.insert(rows.begin(), row);
  }
  const auto at = [&](int32_t i, int32_t j) { return rows.at(j).at(i); };
  Grid grid;
  grid.cell_size = Point2(squares, squares);
  std::map<CellId, TriMesh> tiles;
  for (int32_t row = 0; row * squares < static_cast<int32_t>(rows.size()); ++row) {
    for (int32_t col = 0; col * squares < static_cast<int32_t>(rows[0].size()); ++col) {
      const int32_t i0 = col * squares, j0 = row * squares;
      if (at(i0, j0) == ' ') continue;
      tiles[{col, row}] = SquaresMesh(
          i0, i0 + squares, j0, j0 + squares, [&](int32_t i, int32_t j) { return at(i, j) == '#'; }, height);
    }
  }
  return SurveyScene(grid, std::move(tiles));
}

std::string CountsOf(const Plan& plan) {
  std::map<std::string, int> counts;
  for (const PlannedHole& hole : plan.holes) {
    if (!hole.failure.empty()) continue;
    const std::string kind = hole.kind == HoleKind::kClosed ? "closed" : hole.kind == HoleKind::kOpenI ? "I" : "II";
    const std::string type(1, "?ABCD"[static_cast<int>(hole.type)]);
    ++counts[hole.kind == HoleKind::kClosed ? kind : kind + type];
  }
  std::vector<std::string> words;
  for (const std::string name : {"closed", "IA", "IB", "IC", "ID", "IIA", "IIB", "IIC", "IID"}) {
    if (counts.contains(name)) words.push_back(absl::StrCat(counts[name], " ", name));
  }
  return words.empty() ? "none" : absl::StrJoin(words, ", ");
}

}  // namespace tilemend
