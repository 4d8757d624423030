#include "common/codec/osgb/osgb_tile.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <utility>

#include "absl/status/status.h"
#include "absl/strings/match.h"
#include "absl/strings/str_cat.h"
#include "common/util/status_macros.h"
#include "common/util/text.h"

namespace tilemend {
namespace {

// A file of the pack in messages: beside the tile's own file, which is `name`.
std::string NameOf(const PackedFile& file, const std::string& name) {
  return absl::StrCat(name.substr(0, name.rfind('/') + 1), file.name);
}

// A viewer of OSGB shows the finer file where the sphere of the node is larger than the range, in pixels: there a pixel
// is 2 * radius / range metres. Viewers of 3D Tiles refine where the error is larger than 16 pixels, their default.
double GeometricErrorOf(const OsgbPagedLod& lod) {
  constexpr double kPixels = 16;
  for (const OsgbChild& child : lod.children) {
    if (child.file.empty() || !lod.has_center || !(lod.radius > 0)) continue;
    if (lod.range_is_pixels && child.range_lo > 0) return kPixels * 2 * lod.radius / child.range_lo;
    if (!lod.range_is_pixels && child.range_hi > 0) {
      constexpr double kPixelsAtOneMetre = 935;  // 1080 rows that show 60 degrees
      return kPixels * child.range_hi / kPixelsAtOneMetre;
    }
  }
  return lod.has_center && lod.radius > 0 ? lod.radius / kPixels : 1;
}

// Reads files level by level, as they name each other.
class TreeReader {
 public:
  TreeReader(OsgbTile& tile, const std::string& name) : tile_(tile), name_(name) {
    for (size_t f = 0; f < tile.packed.size(); ++f) file_at_.emplace(tile.packed[f].name, static_cast<int32_t>(f));
    tile.files.resize(tile.packed.size());
    is_named_.assign(tile.packed.size(), false);
    is_named_[0] = true;
  }

  absl::Status Run() {
    std::vector<int32_t> level = {0};
    named_by_.assign(tile_.packed.size(), -1);
    for (; !level.empty(); ++tile_.levels) {
      std::vector<int32_t> finer;
      for (const int32_t f : level) TILEMEND_RETURN_IF_ERROR(Read(f, finer));
      level = std::move(finer);
    }
    return absl::OkStatus();
  }

 private:
  // The file of the pack that a child names, -1 if there is none. Programs write ".\\X" and "../TILE/X" for X as well,
  // and names whose case is another than on disk, where file systems do not tell.
  int32_t FileOf(const OsgbChild& child) const {
    std::string path = child.file;
    std::replace(path.begin(), path.end(), '\\', '/');
    path = std::filesystem::path(path).lexically_normal().string();
    const std::string folder = std::filesystem::path(name_).parent_path().filename().string();
    const std::string above = absl::StrCat("../", folder, "/");
    if (absl::StartsWith(path, above)) path = path.substr(above.size());
    if (const auto at = file_at_.find(path); at != file_at_.end()) return at->second;
    const auto at = std::find_if(file_at_.begin(), file_at_.end(),
                                 [&](const auto& file) { return absl::EqualsIgnoreCase(file.first, path); });
    return at == file_at_.end() ? -1 : at->second;
  }

  absl::Status Read(int32_t f, std::vector<int32_t>& finer) {
    const PackedFile& packed = tile_.packed[f];
    TILEMEND_ASSIGN_OR_RETURN(tile_.files[f], ReadOsgb(packed.bytes, NameOf(packed, name_)));
    const OsgbFile& file = tile_.files[f];
    std::vector<bool> has_finer;
    std::vector<std::vector<int32_t>> finer_of(file.paged_lods.size());
    for (const OsgbPagedLod& lod : file.paged_lods) {
      bool found = false;
      for (const OsgbChild& child : lod.children) {
        const int32_t at = FileOf(child);
        if (at < 0 && !child.file.empty()) tile_.missing.push_back(child.file);
        if (at < 0) continue;
        if (is_named_[at]) {
          return absl::InvalidArgumentError(absl::StrCat(NameOf(packed, name_), ": the finer file \"",
                                                         Printable(child.file), "\" is named for the second time"));
        }
        is_named_[at] = true;
        finer.push_back(at);
        finer_of[has_finer.size()].push_back(at);
        found = true;
      }
      has_finer.push_back(found);
    }
    for (int32_t g = 0; g < std::ssize(file.geodes); ++g) {
      const int32_t lod = file.geodes[g].paged_lod;
      const bool is_finest = lod < 0 || !has_finer[lod];
      const double error = is_finest ? 0 : GeometricErrorOf(file.paged_lods[lod]);
      if (!is_finest) {
        for (const int32_t f_finer : finer_of[lod]) named_by_[f_finer] = static_cast<int32_t>(tile_.pieces.size());
      }
      tile_.pieces.push_back({f, g, tile_.levels, is_finest, named_by_[f], error});
    }
    return absl::OkStatus();
  }

  OsgbTile& tile_;
  const std::string& name_;
  std::map<std::string, int32_t, std::less<>> file_at_;
  std::vector<bool> is_named_;
  std::vector<int32_t> named_by_;  // of each file: the piece that it takes the place of
};

}  // namespace

absl::StatusOr<OsgbTile> ReadOsgbTile(std::string_view pack, const std::string& name) {
  OsgbTile tile;
  TILEMEND_ASSIGN_OR_RETURN(tile.packed, UnpackFiles(pack, name));
  TILEMEND_RETURN_IF_ERROR(TreeReader(tile, name).Run());
  for (const OsgbFile& file : tile.files) {
    if (!file.points.empty()) return tile;
  }
  return absl::InvalidArgumentError(absl::StrCat(name, ": no vertices"));
}

absl::StatusOr<std::string> ChangeOsgbTile(const std::vector<PackedFile>& packed, const std::vector<OsgbEdit>& edits,
                                           const std::string& name) {
  std::vector<std::string> changed(packed.size());
  std::vector<PackedFile> files = packed;
  for (size_t f = 0; f < files.size(); ++f) {
    const std::string file_name = NameOf(files[f], name);
    if (!edits[f].drop.empty()) {
      TILEMEND_ASSIGN_OR_RETURN(changed[f], DropOsgbTriangles(files[f].bytes, edits[f].drop, file_name));
      files[f].bytes = changed[f];
    }
    if (edits[f].patches.empty()) continue;
    TILEMEND_ASSIGN_OR_RETURN(changed[f], AppendOsgb(files[f].bytes, edits[f].patches, file_name));
    files[f].bytes = changed[f];
  }
  return PackFiles(files);
}

}  // namespace tilemend
