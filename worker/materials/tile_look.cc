#include "worker/materials/tile_look.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "absl/strings/ascii.h"
#include "absl/strings/str_cat.h"
#include "absl/strings/str_split.h"
#include "common/codec/mtl.h"
#include "common/codec/ply_colours.h"
#include "common/store/digest.h"
#include "common/util/files.h"
#include "common/util/object_store.h"
#include "common/util/status_macros.h"
#include "common/util/text.h"
#include "worker/materials/scene_file.h"

namespace tilemend {
namespace {

class LookReader {
 public:
  LookReader(const std::string& root, const std::string& tile) : root_(root), tile_(tile) {}

  // `names`: one name, which may hold blanks, or several.
  void AddLibraries(const std::string& names) {
    if (const SceneFile whole = Find(FolderOf(tile_), names); !whole.path.empty()) return AddLibrary(whole.path);
    const std::vector<std::string> words = absl::StrSplit(names, absl::ByAnyChar(" \t"), absl::SkipEmpty());
    std::vector<SceneFile> files;
    for (const std::string& word : words) {
      SceneFile file = Find(FolderOf(tile_), word);
      if (file.path.empty() && word.starts_with('#')) break;  // a comment
      files.push_back(std::move(file));
    }
    const auto found = [](const SceneFile& file) { return !file.path.empty(); };
    if (std::none_of(files.begin(), files.end(), found)) {
      return Warn(tile_, names, Find(FolderOf(tile_), names).problem);
    }
    for (size_t i = 0; i < files.size(); ++i) {
      if (found(files[i])) {
        AddLibrary(files[i].path);
      } else {
        Warn(tile_, words[i], files[i].problem);
      }
    }
  }

  // The path of an image that `from` names (in this line; 0: it has none), beside it or beside the tile; empty if it
  // cannot be had.
  std::string AddImage(const std::string& from, int64_t line, const std::string& name) {
    SceneFile file = FindBeside(from, name);
    if (const size_t comment = name.find(" #"); file.path.empty() && comment != std::string::npos) {
      const std::string before(absl::StripAsciiWhitespace(name.substr(0, comment)));
      if (SceneFile found = FindBeside(from, before); !found.path.empty()) file = std::move(found);
    }
    if (file.path.empty()) {
      Warn(line > 0 ? absl::StrCat(from, ": line ", line) : from, name, file.problem);
    } else if (std::find(look_.files.images.begin(), look_.files.images.end(), file.path) == look_.files.images.end()) {
      look_.files.images.push_back(file.path);
    }
    return file.path;
  }

  absl::StatusOr<TileLook> Finish() {
    TILEMEND_RETURN_IF_ERROR(status_);
    return std::move(look_);
  }

 private:
  SceneFile Find(const std::string& folder, const std::string& name) {
    auto file = FindSceneFile(root_, folder, name);
    status_.Update(file.status());
    if (!file.ok()) return {"", "cannot be looked for"};
    look_.witness.lookups.push_back({folder, name, file->path, file->problem});
    return *std::move(file);
  }

  // Beside the file that names it, or beside the tile.
  SceneFile FindBeside(const std::string& from, const std::string& name) {
    SceneFile file = Find(FolderOf(from), name);
    if (file.path.empty() && FolderOf(from) != FolderOf(tile_)) {
      if (SceneFile beside_tile = Find(FolderOf(tile_), name); !beside_tile.path.empty()) return beside_tile;
    }
    return file;
  }

  void AddLibrary(const std::string& path) {
    if (std::find(look_.files.libraries.begin(), look_.files.libraries.end(), path) != look_.files.libraries.end())
      return;
    const auto text = ReadFile(absl::StrCat(root_, "/", path));
    look_.witness.reads.push_back({path, text.ok() ? FileDigest(*text) : ""});
    if (IsStoreError(root_, text.status())) status_.Update(text.status());
    if (!text.ok()) return Warn(tile_, path, "cannot be read");
    look_.files.libraries.push_back(path);
    const MtlFile file = ParseMtl(*text);
    if (file.materials.empty()) {
      look_.files.warnings.push_back(
          absl::StrCat(Printable(path), ": no material in it that can be read: fills get no colour from it"));
    }
    std::map<std::string, std::string> paths;  // by name
    for (size_t i = 0; i < file.images.size(); ++i) {
      paths[file.images[i]] = AddImage(path, file.image_lines[i], file.images[i]);
    }
    for (const MtlMaterial& m : file.materials) {
      const std::string& image = m.image.empty() ? m.image : paths[m.image];
      look_.materials.try_emplace(m.name, image.empty() ? TileMaterial{m.diffuse, ""} : TileMaterial{{}, image});
    }
  }

  void Warn(const std::string& from, const std::string& name, const std::string& problem) {
    look_.files.warnings.push_back(
        absl::StrCat(Printable(from), ": ", Printable(name), " ", problem, ": it is not carried to the output"));
  }

  const std::string& root_;
  const std::string& tile_;
  TileLook look_;
  absl::Status status_;  // the first error of an object store
};

}  // namespace

absl::StatusOr<TileLook> ReadObjLook(const std::string& root, const std::string& path, const ObjTextures& textures) {
  LookReader reader(root, path);
  for (const std::string& names : textures.libraries) reader.AddLibraries(names);
  return reader.Finish();
}

absl::StatusOr<TileLook> ReadPlyLook(const std::string& root, const std::string& path, std::string_view bytes) {
  LookReader reader(root, path);
  for (const std::string& name : PlyTextureNames(bytes)) reader.AddImage(path, 0, name);
  return reader.Finish();
}

}  // namespace tilemend
