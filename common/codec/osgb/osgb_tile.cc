#include "common/codec/osgb/osgb_tile.h"

#include <map>
#include <utility>

#include "absl/status/status.h"
#include "absl/strings/str_cat.h"
#include "common/util/status_macros.h"
#include "common/util/text.h"

namespace tilemend {
namespace {

// A file of the pack in messages: beside the tile's own file, which is `name`.
std::string NameOf(const PackedFile& file, const std::string& name) {
  return absl::StrCat(name.substr(0, name.rfind('/') + 1), file.name);
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
    for (; !level.empty(); ++tile_.levels) {
      std::vector<int32_t> finer;
      for (const int32_t f : level) TILEMEND_RETURN_IF_ERROR(Read(f, finer));
      level = std::move(finer);
    }
    return absl::OkStatus();
  }

 private:
  absl::Status Read(int32_t f, std::vector<int32_t>& finer) {
    const PackedFile& packed = tile_.packed[f];
    TILEMEND_ASSIGN_OR_RETURN(tile_.files[f], ReadOsgb(packed.bytes, NameOf(packed, name_)));
    const OsgbFile& file = tile_.files[f];
    std::vector<bool> has_finer;
    for (const OsgbPagedLod& lod : file.paged_lods) {
      bool found = false;
      for (const OsgbChild& child : lod.children) {
        const auto at = file_at_.find(child.file);
        if (child.file.empty() || at == file_at_.end()) continue;
        if (is_named_[at->second]) {
          return absl::InvalidArgumentError(absl::StrCat(NameOf(packed, name_), ": the finer file \"",
                                                         Printable(child.file), "\" is named for the second time"));
        }
        is_named_[at->second] = true;
        finer.push_back(at->second);
        found = true;
      }
      has_finer.push_back(found);
    }
    for (int32_t g = 0; g < std::ssize(file.geodes); ++g) {
      const int32_t lod = file.geodes[g].paged_lod;
      tile_.pieces.push_back({f, g, tile_.levels, lod < 0 || !has_finer[lod]});
    }
    return absl::OkStatus();
  }

  OsgbTile& tile_;
  const std::string& name_;
  std::map<std::string, int32_t, std::less<>> file_at_;
  std::vector<bool> is_named_;
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
