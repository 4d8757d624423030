#include "common/codec/mesh_file.h"

#include "absl/strings/ascii.h"
#include "absl/strings/str_cat.h"
#include "common/codec/obj.h"
#include "common/codec/off.h"
#include "common/codec/ply.h"
#include "common/codec/stl.h"
#include "common/codec/text.h"
#include "common/codec/tree/tile_tree.h"
#include "common/codec/tree_mesh.h"
#include "common/util/status_macros.h"

namespace tilemend {

absl::StatusOr<MeshFormat> MeshFormatOf(std::string_view path) {
  constexpr const char kAccepted[] = "; accepted: .ply, .obj, .off, .stl, .osgb, .json (a tileset)";
  const size_t slash = path.rfind('/');
  const std::string_view file = slash == std::string_view::npos ? path : path.substr(slash + 1);
  const size_t dot = file.rfind('.');
  if (dot == std::string_view::npos || dot == 0) {
    return absl::InvalidArgumentError(absl::StrCat(std::string(path), ": no file extension", kAccepted));
  }
  const std::string extension = absl::AsciiStrToLower(std::string(file.substr(dot)));
  if (extension == ".ply") return MeshFormat::kPly;
  if (extension == ".obj") return MeshFormat::kObj;
  if (extension == ".off") return MeshFormat::kOff;
  if (extension == ".stl") return MeshFormat::kStl;
  if (IsTileTree(file)) return MeshFormat::kTileTree;
  return absl::InvalidArgumentError(absl::StrCat(std::string(path), ": ", extension, " files are not read", kAccepted));
}

namespace {

absl::StatusOr<MeshFile> ParseTileTree(std::string_view pack, const std::string& name, NoFaces no_faces) {
  TILEMEND_ASSIGN_OR_RETURN(const TileTree tile, ReadTileTree(pack, name));
  return FinestMesh(tile, static_cast<int64_t>(pack.size()), name, no_faces);
}

}  // namespace

absl::StatusOr<MeshFile> ReadMeshFile(const std::string& path, const TileFrame& frame) {
  TILEMEND_ASSIGN_OR_RETURN(const MeshFormat format, MeshFormatOf(path));
  TILEMEND_ASSIGN_OR_RETURN(const std::string bytes, ReadTileBytes(path, frame));
  return ParseMesh(format, bytes, path);
}

absl::StatusOr<MeshFile> ParseMesh(MeshFormat format, std::string_view bytes, const std::string& name,
                                   NoFaces no_faces) {
  switch (format) {
    case MeshFormat::kPly:
      return ParsePly(bytes, name);
    case MeshFormat::kObj:
      return ParseObj(bytes, name, {}, no_faces);
    case MeshFormat::kOff:
      return ParseOff(bytes, name);
    case MeshFormat::kStl:
      return ParseStl(bytes, name);
    case MeshFormat::kTileTree:
      return ParseTileTree(bytes, name, no_faces);
  }
  return absl::InternalError(absl::StrCat(name, ": unknown mesh format"));
}

absl::StatusOr<std::string> AppendPatch(MeshFormat format, std::string_view original_bytes, const FilePatch& patch,
                                        const std::string& name) {
  switch (format) {
    case MeshFormat::kPly:
      return AppendToPly(original_bytes, patch, name);
    case MeshFormat::kObj:
      return AppendToObj(original_bytes, patch, name);
    case MeshFormat::kOff:
      return AppendToOff(original_bytes, patch, name);
    case MeshFormat::kStl:
      return AppendToStl(original_bytes, patch, name);
    case MeshFormat::kTileTree:
      return absl::InvalidArgumentError(
          absl::StrCat(name, ": a tile that is a tree of files is filled with all of its levels"));
  }
  return absl::InternalError(absl::StrCat(name, ": unknown mesh format"));
}

}  // namespace tilemend
