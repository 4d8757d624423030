#include "client/page_pictures.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "absl/strings/str_cat.h"
#include "client/crop_bytes.h"
#include "client/hole_crop.h"
#include "client/picture_tile.h"
#include "common/grid/delivery_paths.h"
#include "common/store/gzip.h"
#include "common/util/status_macros.h"
#include "coordinator/report/json_access.h"
#include "coordinator/report/page_holes.h"

namespace tilemend {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kLeastArea = 0.5;  // m2: fills that are smaller show nothing
constexpr size_t kMostOfCluster = 3;

struct Wanted {
  size_t rank = 0;
  int64_t hole = 0;
  Point2 centre{0, 0};
  double area = 0;
};

// Filled holes with a place, the largest first. A picture shows one tile: of a cluster the largest hole in each cell,
// but no more than kMostOfCluster, so that a river does not take all pictures.
std::map<CellId, std::vector<Wanted>> WantedByCell(const Json& report) {
  std::vector<const Json*> rows;
  const Json& holes = Member(report, "per_hole");
  if (!holes.is_array()) return {};
  for (const Json& hole : holes) {
    const Json &cell = Member(hole, "cell"), &centre = Member(hole, "centre");
    const bool placed = cell.is_array() && cell.size() == 2 && cell[0].is_number_integer() &&
                        cell[1].is_number_integer() && centre.is_array() && centre.size() >= 2 &&
                        centre[0].is_number() && centre[1].is_number();
    if (placed && Member(hole, "outcome") == "filled") rows.push_back(&hole);
  }
  std::stable_sort(rows.begin(), rows.end(), [](const Json* a, const Json* b) {
    return std::abs(Number(Member(*a, "area_m2"))) > std::abs(Number(Member(*b, "area_m2")));
  });
  std::map<CellId, std::vector<Wanted>> wanted;
  std::map<int64_t, std::set<CellId>> cells_of_cluster;
  size_t rank = 0;
  for (const Json* row : rows) {
    if (rank == kMostPictures || std::abs(Number(Member(*row, "area_m2"))) < kLeastArea) break;
    const Json &column_row = Member(*row, "cell"), &centre = Member(*row, "centre");
    const CellId cell{column_row[0].get<int32_t>(), column_row[1].get<int32_t>()};
    if (const int64_t cluster = ClusterOf(*row); cluster >= 0) {
      std::set<CellId>& cells = cells_of_cluster[cluster];
      if (cells.size() == kMostOfCluster || !cells.insert(cell).second) continue;
    }
    wanted[cell].push_back({rank++,
                            static_cast<int64_t>(Number(Member(*row, "id"))),
                            {centre[0].get<double>(), centre[1].get<double>()},
                            std::abs(Number(Member(*row, "area_m2")))});
  }
  return wanted;
}

absl::StatusOr<TilePair> ReadPair(const Scene& scene, const SceneTile& tile, const std::string& out) {
  TilePair pair;
  if (!tile.path.empty()) {
    TILEMEND_ASSIGN_OR_RETURN(pair.before, ReadPictureTile(scene.root, tile.path, tile.frame));
  }
  const TileFrame frame = OutputFrame(tile);
  TILEMEND_ASSIGN_OR_RETURN(pair.after, ReadPictureTile(out, OutputPath(tile), frame));
  pair.change = CompareTiles(pair.before.faces, pair.after.faces);
  return pair;
}

using Ranked = std::map<size_t, PagePicture>;

absl::Status AddPictures(const Scene& scene, const SceneTile& tile, const std::string& out,
                         const std::vector<Wanted>& wanted, Ranked& pictures) {
  TILEMEND_ASSIGN_OR_RETURN(const TilePair pair, ReadPair(scene, tile, out));
  const auto pieces = AddedPieces(pair.after.faces.mesh, pair.change.added);
  for (const Wanted& hole : wanted) {
    const Eigen::AlignedBox3d fill = PieceAt(pieces, hole.centre, hole.area);
    if (fill.isEmpty()) continue;
    const HoleCrop crop = CropAround(pair, fill);
    if (crop.faces.empty()) continue;
    PagePicture picture{hole.hole, std::ssize(crop.faces), std::ssize(crop.faces) < crop.faces_there, {}};
    TILEMEND_ASSIGN_OR_RETURN(picture.bytes, Gzip(CropBytes(crop, pair, scene.root, out)));
    pictures.emplace(hole.rank, std::move(picture));
  }
  return absl::OkStatus();
}

}  // namespace

PagePictures MakePagePictures(const Json& report, const Scene& scene, const std::string& out) {
  const std::map<CellId, std::vector<Wanted>> wanted = WantedByCell(report);
  PagePictures result;
  Ranked ranked;
  for (const SceneTile& tile : scene.tiles) {
    const auto holes = wanted.find(tile.cell);
    if (holes == wanted.end()) continue;
    const absl::Status status = AddPictures(scene, tile, out, holes->second, ranked);
    if (!status.ok()) result.problems.emplace_back(status.message());
  }
  for (auto& [rank, picture] : ranked) result.pictures.push_back(std::move(picture));
  return result;
}

}  // namespace tilemend
