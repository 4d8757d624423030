#include "client/acceptance.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "absl/strings/str_cat.h"
#include "absl/strings/str_format.h"
#include "client/acceptance_input.h"
#include "client/acceptance_kinds.h"
#include "client/area_rim.h"
#include "client/carried_files.h"
#include "client/coarser_levels.h"
#include "client/compared_tile.h"
#include "client/fill_area.h"
#include "client/fill_owners.h"
#include "client/fill_textures.h"
#include "client/hole_numbers.h"
#include "client/left_holes.h"
#include "client/lost_fills.h"
#include "client/original_rims.h"
#include "client/output_tiles.h"
#include "client/report_agreement.h"
#include "client/tile_placement.h"
#include "client/water_seams.h"
#include "common/util/status_macros.h"
#include "common/util/tile_files.h"
#include "worker/check/added_faults.h"
#include "worker/check/tile_joins.h"

namespace tilemend {
namespace {

constexpr double kMostApart = 0.02;   // metres between fills of overlapping tiles,
constexpr double kShareApart = 0.01;  // but for this share of the places of a border

// Of the strip of one tile along the sides of its cell, while its neighbours are looked at.
struct KeptTile {
  CellId cell;
  BorderStrip strip;
};

// Places of a border where fills of both tiles lie over each other.
struct BorderTally {
  int64_t places = 0;
  std::vector<AcceptancePlace> apart;
};

// What of the surface may close an edge of a neighbour's tile, or lie over its fill: within kCoverReach of where that
// tile ends, and beyond.
BorderStrip StripOf(const Grid& grid, CellId cell, double overlap, const TriMesh& mesh,
                    const std::vector<bool>& inside_fill) {
  const Point2 inner = Point2::Constant(std::max(2 * overlap + 0.1, overlap + kCoverReach));
  const Point2 corner = grid.corner + grid.cell_size.cwiseProduct(Point2(cell.col, cell.row));
  const Point2 lo = corner + inner, hi = corner + grid.cell_size - inner;
  std::vector<SpaceTriangle> triangles;
  std::vector<bool> is_inner;
  for (size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Triangle& corners = mesh.triangles[t];
    const SpaceTriangle triangle = {mesh.points[corners[0]], mesh.points[corners[1]], mesh.points[corners[2]]};
    const bool inside = std::all_of(triangle.begin(), triangle.end(), [&](const Point3& p) {
      return (p.head<2>().array() > lo.array()).all() && (p.head<2>().array() < hi.array()).all();
    });
    if (inside) continue;
    triangles.push_back(triangle);
    is_inner.push_back(inside_fill[t]);
  }
  return {std::move(triangles), std::move(is_inner)};
}

constexpr std::pair<AddedFault, AcceptanceKind> kFaults[] = {
    {AddedFault::kCrossedFill, kCrossedFill}, {AddedFault::kCrossedSurface, kCrossedSurface},
    {AddedFault::kCrossedRim, kCrossedRim},   {AddedFault::kNonManifoldEdge, kNonManifoldEdge},
    {AddedFault::kTurnedEdge, kTurnedEdge},   {AddedFault::kFlatTriangle, kFlatTriangle}};

std::vector<bool> NoneOf(const TriMesh& mesh) { return std::vector<bool>(mesh.triangles.size(), false); }

Point3 MiddleOf(const TriMesh& mesh, int32_t t) {
  const Triangle& corners = mesh.triangles[t];
  return (mesh.points[corners[0]] + mesh.points[corners[1]] + mesh.points[corners[2]]) / 3;
}

bool IsBeside(const ComparedTile& tile, const std::string& path) {
  return std::ranges::any_of(tile.beside, [&](const DeliveryFile& file) { return file.name == path; });
}

class AcceptanceCheck {
 public:
  explicit AcceptanceCheck(AcceptanceInput input)
      : input_(std::move(input)),
        reported_(ReportedOf(input_)),
        rim_(input_.scene, reported_.overlap),
        left_(input_.scene.grid, reported_.left),
        lost_(reported_.filled_rims),
        numbers_(reported_),
        levels_(reported_.levels),
        files_(input_.scene.root, input_.out) {
    for (const AcceptanceKindText& text : kAcceptanceKinds)
      result_.findings.push_back({text.name, text.one, text.many, text.is_fault, 0, {}});
  }

  absl::StatusOr<Acceptance> Run(const StepWatcher& watcher) {
    for (size_t t = 0; t < input_.scene.tiles.size(); ++t) {
      if (const int32_t row = input_.scene.tiles[t].cell.row; row != row_) Resolve(row - 1);
      row_ = input_.scene.tiles[t].cell.row;
      if (watcher) watcher("compare the tiles", t, input_.scene.tiles.size(), "cell");
      TILEMEND_RETURN_IF_ERROR(CheckTile(static_cast<int32_t>(t)));
    }
    Resolve(row_ + 2);
    AddLostFills();
    AddBorders();
    for (const CoarserLevels::Fault& f : levels_.Unfilled()) Add(kUnfilledLevel, f.cell, std::nullopt, f.note);
    for (const CoarserLevels::Fault& f : levels_.Cleared()) Add(kClearedFaces, f.cell, std::nullopt, f.note);
    AddFiles();
    AddReported();
    return std::move(result_);
  }

 private:
  // `hole`: its number; if it is not given, that of the hole around `at` for faults of fills.
  void Add(AcceptanceKind kind, CellId cell, std::optional<Point3> at, std::string note = "",
           std::optional<int64_t> hole = std::nullopt) {
    AcceptanceFinding& finding = result_.findings[kind];
    ++finding.count;
    if (finding.places.size() >= kMostAcceptancePlaces) return;
    if (!hole && at && kAcceptanceKinds[kind].is_of_fill) hole = numbers_.At(cell, *at);
    finding.places.push_back({cell, std::move(at), std::move(note), hole});
  }

  absl::Status CheckTile(int32_t t) {
    const SceneTile& tile = input_.scene.tiles[t];
    TILEMEND_ASSIGN_OR_RETURN(const ComparedTile pair, ReadComparedTile(input_.scene, tile, input_.out));
    const bool has_output = pair.after || !pair.damage.empty();
    if (tile.path.empty() && !has_output) return absl::OkStatus();
    const TriMesh& original = pair.before.faces.mesh;
    const bool is_chosen = input_.chosen.empty() || input_.chosen.contains(tile.cell);
    if (has_output || is_chosen) {
      ++result_.tiles;
      result_.original_faces += std::ssize(original.triangles);
    } else {
      ++result_.cells_left_out;
    }
    if (!pair.damage.empty()) Add(kDamagedTile, tile.cell, std::nullopt, pair.damage);
    if (pair.after) {
      CheckPair(t, pair);
    } else {
      // A cell that the job was not to write, else a tile that is missing: to its neighbours it is what it was.
      CheckFaces(t, original, original, TileChange{{}, NoneOf(original), 0});
    }
    return absl::OkStatus();
  }

  void CheckPair(int32_t t, const ComparedTile& pair) {
    const SceneTile& tile = input_.scene.tiles[t];
    const CheckedTile &before = pair.before, &after = *pair.after;
    const TileChange change = CompareTiles(before.faces, after.faces);
    CheckOriginals(tile.cell, before.faces.mesh, change);
    CheckFaces(t, before.faces.mesh, after.faces.mesh, change);
    CheckArea(tile.cell, after.faces.mesh, change.added);
    CheckWater(tile.cell, after.faces.mesh, change.added);
    CheckLevels(tile.cell, before, after, change);
    CheckNames(tile, pair, change.added);
  }

  // The material files and images. Fills add one at most; in a converted tile any number, one for each of their
  // colours.
  void CheckNames(const SceneTile& tile, const ComparedTile& pair, const std::vector<bool>& added) {
    const CheckedTile &before = pair.before, &after = *pair.after;
    const std::string output = OutputPath(tile);
    const bool is_same = NamesTheSame(before, after, tile.delivered.empty() ? 1 : after.named.size());
    if (!is_same) Add(kChangedFile, tile.cell, std::nullopt, output + ": names other files");
    for (const DeliveryFile& file : pair.beside) files_.Compare(file.name, file.bytes, file.name.ends_with(".mtl"));
    if (!reported_.has_textures && tile.delivered.empty()) return;
    files_.Compare(before.files);
    for (const std::string& name : NewMissingNames(before, after)) {
      if (IsBeside(pair, FileBesideTile(output, name))) continue;  // it was compared
      Add(kMissingFile, tile.cell, std::nullopt, absl::StrCat(name, " of ", output));
    }
    for (const std::string& fault : FillTextureFaults(input_.out, output, pair, added)) {
      Add(kFillTexture, tile.cell, std::nullopt, fault);
    }
  }

  // The levels of detail: originals are there, but for what clearing takes out of each level.
  void CheckLevels(CellId cell, const CheckedTile& before, const CheckedTile& after, const TileChange& finest) {
    if (before.coarser.size() != after.coarser.size()) {
      Add(kMissingFace, cell, std::nullopt,
          absl::StrCat(before.coarser.size() + 1, " levels of detail, ", after.coarser.size() + 1, " in the output"));
      return;
    }
    const bool is_cleared = reported_.cleared.contains(cell);
    std::vector<TileChange> levels;
    for (size_t l = 0; l < before.coarser.size(); ++l) {
      const TileChange& change = levels.emplace_back(CompareTiles(before.coarser[l], after.coarser[l]));
      if (is_cleared) continue;
      for (const int32_t t : change.missing) Add(kMissingFace, cell, MiddleOf(before.coarser[l].mesh, t));
    }
    levels.push_back(finest);
    levels_.Add(cell, levels, is_cleared);
  }

  void CheckOriginals(CellId cell, const TriMesh& before, const TileChange& change) {
    result_.added_faces += change.added_count;
    const auto cleared = reported_.cleared.find(cell);
    const int64_t expected = cleared == reported_.cleared.end() ? 0 : cleared->second;
    const int64_t missing = std::ssize(change.missing);
    // The fill may have put some of what was taken out there again, to the bit.
    if (missing <= expected) {
      result_.cleared_faces += missing;
      return;
    }
    if (expected > 0) {
      Add(kClearedFaces, cell, std::nullopt, absl::StrCat(missing, " taken out, ", expected, " reported"));
      return;
    }
    for (const int32_t t : change.missing) Add(kMissingFace, cell, MiddleOf(before, t));
  }

  void CheckFaces(int32_t t, const TriMesh& before, const TriMesh& after, const TileChange& change) {
    const CellId cell = input_.scene.tiles[t].cell;
    AddedFindings found = FindAddedFaults(before, after, change);
    FillOwners owners(numbers_, cell, after, change.added);
    // Also of holes' boundaries: what looks like one may be where a piece ends and the next goes on.
    const auto may_be_fault = [this](const OpenEdge& e) {
      return e.after == 1 && (e.before != 1 || lost_.IsAtRim(e.from, e.to));
    };
    if (reported_.overlap > 0) CoverOpenEdges(after, may_be_fault, found.open);
    for (const auto& [fault, kind] : kFaults) {
      const auto places = found.faults.find(fault);
      if (places == found.faults.end()) continue;
      for (const AddedFaultPlace& p : places->second)
        Add(kind, cell, p.at, owners.CrossedText(p), owners.Of(p.triangle));
    }
    for (const int32_t folded : owners.FoldedTriangles(reported_.height_fields)) {
      Add(kFoldedFill, cell, MiddleOf(after, folded), "", owners.Of(folded));
    }
    for (OpenEdge& e : found.open) e.hole = owners.Of(e.triangle).value_or(-1);
    edges_.Add(t, cell.row, found.open);
    originals_.Add(cell.row, found.open);
    if (reported_.overlap > 0)
      strips_[t] = {cell, StripOf(input_.scene.grid, cell, reported_.overlap, after, found.inner)};
  }

  void CheckArea(CellId cell, const TriMesh& after, const std::vector<bool>& added) {
    const auto reported = reported_.filled.find(cell);
    const double holes = reported == reported_.filled.end() ? 0 : reported->second;
    const auto fault = FillAreaFault(input_.scene.grid, cell, holes, reported_.overlap > 0, after, added);
    if (fault) Add(kFillArea, cell, std::nullopt, *fault);
  }

  void CheckWater(CellId cell, const TriMesh& after, const std::vector<bool>& added) {
    const auto waters = reported_.water.find(cell);
    if (waters == reported_.water.end()) return;
    std::vector<WaterHole> holes;
    for (const ReportedOutput::Water& water : waters->second) holes.push_back(water.fill);
    const std::vector<WaterFinding> findings = CheckWaterFills(after, added, holes);
    for (size_t h = 0; h < holes.size(); ++h) {
      ++result_.water_fills;
      const Point3 centre(holes[h].centre.x(), holes[h].centre.y(), holes[h].lowest);
      if (!findings[h].is_found) Add(kWaterWithoutFill, cell, centre, "", waters->second[h].hole);
      seams_.Add(cell, findings[h].off_at_seam);
      for (const Point3& p : findings[h].off) {
        const double off = p.z() < holes[h].lowest ? p.z() - holes[h].lowest : p.z() - holes[h].highest;
        Add(kWaterOffLevel, cell, p, absl::StrFormat("%+.3f m", off), waters->second[h].hole);
      }
    }
  }

  // Judges the edges of tiles in rows below `row`, all of whose neighbours were read.
  void Resolve(int32_t row) {
    const JoinedEdges::Released released = edges_.ReleaseBelow(row);
    // The same edge in two layers that lie on each other is no seam: the tiles may be cut from one mesh, with a buffer.
    if (reported_.overlap <= 0) {
      for (const NewOpenEdge& e : released.crowded) {
        AddEdge(kNonManifoldEdge, e, "between tiles");
      }
      for (const NewOpenEdge& e : released.turned) {
        AddEdge(kTurnedEdge, e, "between tiles");
      }
    }
    for (const NewOpenEdge& e : released.open) {
      if (!MayBeOpen(e)) AddEdge(kOpenEdge, e);
    }
    for (const NewOpenEdge& e : released.rims) {
      const bool is_at_rim = lost_.IsAtRim(e.edge.from, e.edge.to);
      if (is_at_rim && (e.edge.after != 1 || !MayBeOpen(e))) lost_.Add(e);
    }
    for (const WaterSeams::Place& place : seams_.ReleaseBelow(row, originals_)) {
      Add(kWaterOffLevel, place.cell, place.at, "between tiles");
    }
    originals_.ForgetBelow(row - 1);
    std::erase_if(strips_, [&](const auto& kept) { return kept.second.cell.row < row - 1; });
  }

  // An edge without a new triangle may be one of a hole's boundary.
  void AddEdge(AcceptanceKind kind, const NewOpenEdge& e, std::string note = "") {
    const CellId cell = input_.scene.tiles[e.tile].cell;
    std::optional<int64_t> hole = numbers_.OfRim(cell, {{e.edge.from, e.edge.to}});
    if (e.edge.hole >= 0) hole = e.edge.hole;
    Add(kind, cell, (e.edge.from + e.edge.to) / 2, std::move(note), hole);
  }

  bool MayBeOpen(const NewOpenEdge& open) {
    const CellId cell = input_.scene.tiles[open.tile].cell;
    const Point3 middle = (open.edge.from + open.edge.to) / 2;
    return IsCovered(cell, middle, open.edge) || open.edge.is_covered ||
           rim_.HasEdge(cell, open.edge.from, open.edge.to, originals_.EndsOf(open.edge)) ||
           left_.AreAt(middle.head<2>(), rim_.NeighboursAt(cell, middle));
  }

  void AddLostFills() {
    for (const NewOpenEdge& open : lost_.Lost()) AddEdge(kOpenEdge, open);
  }

  // Whether the tile of a neighbour lies over or under p. Where both have fills there, off their rims, counts
  // how far they are apart: at the rims they are as far apart as the originals.
  bool IsCovered(CellId cell, const Point3& p, const OpenEdge& edge) {
    if (reported_.overlap <= 0) return false;
    bool covered = false;
    for (const CellId other : rim_.NeighboursAt(cell, p)) {
      const auto kept =
          std::find_if(strips_.begin(), strips_.end(), [&](const auto& s) { return s.second.cell == other; });
      if (kept == strips_.end()) continue;
      const BorderStrip::Nearest nearest = kept->second.strip.NearestTo(p);
      covered = covered || kept->second.strip.EndsAt(p);
      if (!nearest.is_covered || !nearest.is_inner || !edge.is_inner) continue;
      BorderTally& tally = borders_[std::minmax(cell, other)];
      ++tally.places;
      if (std::abs(nearest.height) > kMostApart) {
        const std::optional<int64_t> hole = edge.hole >= 0 ? std::optional(edge.hole) : std::nullopt;
        tally.apart.push_back({cell, p, absl::StrFormat("%.3f m", std::abs(nearest.height)), hole});
      }
    }
    return covered;
  }

  void AddBorders() {
    for (const auto& [cells, tally] : borders_) {
      result_.overlap_places += tally.places;
      const double allowed = std::max(1.0, kShareApart * static_cast<double>(tally.places));
      if (static_cast<double>(tally.apart.size()) <= allowed) continue;
      for (const AcceptancePlace& place : tally.apart) {
        Add(kFillsApart, place.cell, place.at, place.note, place.hole);
      }
    }
  }

  void AddFiles() {
    result_.files = static_cast<int64_t>(files_.compared());
    for (const std::string& path : files_.missing()) Add(kMissingFile, {}, std::nullopt, path);
    for (const std::string& path : files_.changed()) Add(kChangedFile, {}, std::nullopt, path);
    for (const std::string& note : ChangedPlacement(input_.scene, input_.out, input_.has_area)) {
      Add(kPlacement, {}, std::nullopt, note);
    }
  }

  void AddReported() {
    for (const std::string& note : ReportContradictions(input_.report)) Add(kReport, {}, std::nullopt, note);
    const OutputTiles tiles = LookForTiles(input_.out, input_.report, input_.scene, input_.chosen);
    std::map<std::string, CellId> cells;
    for (const SceneTile& tile : input_.scene.tiles) cells[OutputPath(tile)] = tile.cell;
    for (const std::string& path : tiles.missing) Add(kMissingTile, cells[path], std::nullopt, path);
    for (const std::string& path : tiles.others) Add(kOtherMesh, {}, std::nullopt, path);
    for (const ReportedOutput::Left& left : reported_.left)
      Add(kLeftHole, left.cell, left.at, left.reason, left.hole >= 0 ? std::optional(left.hole) : std::nullopt);
  }

  const AcceptanceInput input_;
  const ReportedOutput reported_;
  const AreaRim rim_;
  const LeftHoles left_;
  LostFills lost_;
  const HoleNumbers numbers_;
  CoarserLevels levels_;
  CarriedFiles files_;
  JoinedEdges edges_;
  OriginalRims originals_;
  WaterSeams seams_;
  std::map<int32_t, KeptTile> strips_;  // by tile
  std::map<std::pair<CellId, CellId>, BorderTally> borders_;
  int32_t row_ = 0;
  Acceptance result_;
};

}  // namespace

bool Acceptance::IsAccepted() const {
  return std::none_of(findings.begin(), findings.end(),
                      [](const AcceptanceFinding& f) { return f.is_fault && f.count > 0; });
}

absl::StatusOr<Acceptance> CheckAcceptance(const std::string& in, const std::string& out, const StepWatcher& watcher) {
  std::vector<std::string> warnings;
  TILEMEND_ASSIGN_OR_RETURN(AcceptanceInput input, ReadAcceptanceInput(in, out, warnings));
  TILEMEND_ASSIGN_OR_RETURN(Acceptance result, AcceptanceCheck(std::move(input)).Run(watcher));
  result.warnings = std::move(warnings);
  return result;
}

}  // namespace tilemend
