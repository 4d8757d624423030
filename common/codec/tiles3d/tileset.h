// tileset.json of 3D Tiles 1.0 and 1.1: a tree of tiles over one or more files.
//
// Guarantees
//  - A file is opened only if it lies below the tileset's folder: URIs with a scheme, an authority, a root or "..", and
//    links that lead out, are refused.
//  - Writing changes bounding volumes that must grow and nothing else: extras, metadata and unknown fields stay.
//  - Refused by name: refinement ADD with content below it, implicit tiling, several contents in a tile, other
//  versions.
//  - Malformed input is an error that names file and JSON path. Size, depth and number of tiles are limited, and a
//    tileset that refers to itself is an error.
//
// Source: 3D Tiles specification 1.0 and 1.1 (OGC 18-053r2 and 22-025r4).
#ifndef TILEMEND_COMMON_CODEC_TILES3D_TILESET_H_
#define TILEMEND_COMMON_CODEC_TILES3D_TILESET_H_

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "absl/status/statusor.h"
#include "common/codec/gltf/gltf_file.h"
#include "common/codec/tiles3d/bounding_volume.h"
#include "common/mesh/tri_mesh.h"

namespace tilemend {

struct TilesetTile {
  int32_t document = 0;  // index into Tileset::documents: the file that holds this tile
  std::string path;      // JSON pointer in that file, such as /root/children/0
  int32_t parent = -1;   // index into Tileset::tiles, across files; -1: the root
  int32_t level = 0;     // number of tiles above it that have a model
  std::vector<int32_t> children;
  std::string external;        // path of an external tileset, as that of a model; empty: none
  std::string content;         // path of a model relative to the tileset's folder, with "/"; empty: none
  double geometric_error = 0;  // metres
  BoundingVolume volume;
  std::optional<BoundingVolume> content_volume;           // of the model alone
  Eigen::Matrix4d to_root = Eigen::Matrix4d::Identity();  // from the tile's frame to that of the root's parent
  Eigen::Matrix4d in_root = Eigen::Matrix4d::Identity();  // from the tile's frame to that of the root
};

struct TilesetDocument {
  std::string file;  // relative to the tileset's folder, with "/"
  std::string text;  // as it was read
  GltfUpAxis up = GltfUpAxis::kY;
};

struct Tileset {
  std::vector<TilesetDocument> documents;  // the entry first; external ones in the order of their tiles
  std::vector<TilesetTile> tiles;          // parents before children; the root first
};

struct TilesetLimits {
  int64_t max_tiles = 1'000'000;
  int64_t max_documents = 100'000;
  int64_t max_document_bytes = int64_t{64} << 20;
  int32_t max_depth = 100;  // of tiles, across files
  bool follows = true;      // false: external tilesets are named, not read
};

// Gives the text of a file by its path relative to the tileset's folder, with "/"; kNotFound and other errors as
// ReadFile.
class TilesetSource {
 public:
  virtual ~TilesetSource() = default;
  virtual absl::StatusOr<std::string> Read(const std::string& file) const = 0;
};

// The files below a folder. A link that leads out of the folder is kOutOfRange.
class FolderSource : public TilesetSource {
 public:
  explicit FolderSource(std::string folder) : folder_(std::move(folder)) {}
  absl::StatusOr<std::string> Read(const std::string& file) const override;

 private:
  std::string folder_;
};

// Reads the tileset `entry`, a path relative to the source, with all external tilesets. Returns kInvalidArgument for
// malformed input and for what is refused. Returns kResourceExhausted beyond `limits`. Errors of the source for files
// that are missing. Linear in the bytes.
absl::StatusOr<Tileset> ReadTileset(const TilesetSource& source, const std::string& entry,
                                    const TilesetLimits& limits = {});

// Grows the bounding volumes of a tile, of its model and of all tiles above it, so that they hold `points`. These are
// in metres in the tile's frame; for a b3dm they include its RTC_CENTER. Volumes that hold the points already stay as
// they are. For a region, the root's parent is the Earth-centred frame of WGS 84. O(points * depth).
void GrowVolumes(Tileset& tileset, int32_t tile, const std::vector<Point3>& points);

// The text of a document with the bounding volumes of `tileset`; nothing else changes. The same bytes as `text` if no
// volume changed. Precondition: `tileset` came from ReadTileset.
std::string WriteTilesetDocument(const Tileset& tileset, int32_t document);

}  // namespace tilemend

#endif  // TILEMEND_COMMON_CODEC_TILES3D_TILESET_H_
