// glTF 2.0 in its binary form (.glb), alone or inside a Batched 3D Model (.b3dm): the contents of 3D Tiles.
//
// Guarantees
//  - Reads plain, quantized (KHR_mesh_quantization), Draco (KHR_draco_mesh_compression) and meshoptimizer
//    (EXT_meshopt_compression) geometry.
//  - Writing splices: the binary chunk is a prefix of the new one. Accessors, images and compressed geometry of the
//    original are not encoded again; the batch table, extras and unknown extensions stay.
//  - What the reader does not know, it refuses by name: a required extension, a primitive mode, a sparse accessor,
//    skins and morph targets, data in other files.
//  - Malformed input is an error that names file and byte offset or JSON path. Memory is limited by GltfLimits. No path
//    or URI that a file names is ever opened.
//
// Sources: glTF 2.0 specification; 3D Tiles 1.0, "Batched 3D Model"; the specifications of the extensions.
#ifndef TILEMEND_COMMON_CODEC_GLTF_GLTF_FILE_H_
#define TILEMEND_COMMON_CODEC_GLTF_GLTF_FILE_H_

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"
#include "common/mesh/tri_mesh.h"
#include "common/util/colour.h"

namespace tilemend {

// Which axis of the file points up. glTF says y; asset.gltfUpAxis of a tileset 1.0 may say otherwise.
enum class GltfUpAxis { kX, kY, kZ };

// One primitive of one node. A mesh that two nodes use is there twice. Vertices and triangles are contiguous in
// GltfFile.
struct GltfPrimitive {
  int32_t first_vertex = 0;
  int32_t vertex_count = 0;
  int32_t first_triangle = 0;
  int32_t triangle_count = 0;
  int32_t material = -1;                             // index into the file's materials; -1: the default material
  int32_t texture = -1;                              // index into GltfFile::images, of the base colour; -1: none
  int32_t node = 0;                                  // index into GltfFile::nodes
  int32_t mesh = 0;                                  // index into the file's meshes
  int32_t primitive = 0;                             // of that mesh
  bool is_draco = false;                             // compressed as a whole
  std::array<double, 4> base_colour = {1, 1, 1, 1};  // linear red, green, blue, alpha
  bool has_base_colour = false;                      // the file says it
};

struct GltfImage {
  std::string mime_type;  // image/jpeg, image/png, image/webp or image/ktx2; empty if the file does not say
  std::string name;       // as the file names it, or its URI; not a path to open
  size_t offset = 0;      // of the encoded image's bytes in the file
  size_t size = 0;        // 0: the image is another file or a data URI
};

// A node with a mesh.
struct GltfNode {
  std::string name;
  Eigen::Matrix4d matrix;  // from the coordinates in its accessors to GltfFile::points
  int64_t number = 0;      // in the file: new nodes come after those that were there
};

struct GltfFile {
  bool is_b3dm = false;
  Point3 origin = Point3::Zero();        // RTC_CENTER or CESIUM_RTC: a point lies at origin + point in the tile's frame
  std::vector<Point3> points;            // metres, z up in the tile's frame; matrices of the nodes are applied
  std::vector<std::array<float, 2>> uv;  // of the base colour's texture, one per point, v up; (0, 0) without
  std::vector<Triangle> triangles;       // indices into points; counter-clockwise seen from outside
  std::vector<GltfPrimitive> primitives;  // node by node, in the order of the scene
  std::vector<GltfImage> images;          // as many as in the file, in its order
  std::vector<GltfNode> nodes;            // in the order of the scene
};

// What a reader accepts. Sums over the file, instances counted as often as they are drawn.
struct GltfLimits {
  int64_t max_points = 20'000'000;
  int64_t max_triangles = 40'000'000;
};

// A new mesh of one primitive with a material and at most one texture.
struct GltfPatch {
  std::vector<Point3> points;            // frame of GltfFile::points; written as float32 in the frame of `node`
  std::vector<std::array<float, 2>> uv;  // one per point if there is an image, else empty; v up
  std::vector<Triangle> triangles;       // indices into points
  std::string image;                     // encoded JPEG or PNG; empty: the material has `colour`
  std::string image_name;
  Rgb colour;
  int32_t node = 0;  // index into GltfFile::nodes: equal coordinates give equal bits in its frame
};

// Reads `bytes`, a glb or a b3dm; `name` stands in messages. Returns kInvalidArgument for malformed input and for what
// is refused, and kResourceExhausted beyond `limits` or the memory. Linear in the file and in what it draws.
absl::StatusOr<GltfFile> ReadGltf(std::string_view bytes, GltfUpAxis up, const std::string& name,
                                  const GltfLimits& limits = {});

// What is done to a file. Indices are those of the GltfFile that was read.
struct GltfEdit {
  std::vector<bool> drop;  // of its triangles; empty: none
  std::vector<GltfPatch> patches;
};

// `bytes` without the triangles that `edit` drops and with a new mesh and node for each patch, in this order.
//  - A primitive that loses triangles gets a new accessor of indices; its vertices and images stay. A Draco primitive
//  is
//    written again without compression. A node whose mesh loses all triangles has no mesh afterwards.
//  - A new node is a sibling of the patch's node and has the same transform. Its material is unlit and double-sided if
//    that of the node's first primitive is.
// kInvalidArgument as ReadGltf, or if sizes or indices do not fit the file, or if a matrix cannot be inverted. The same
// if two nodes share a mesh but do not drop the same triangles of it. Linear.
absl::StatusOr<std::string> ChangeGltf(std::string_view bytes, GltfUpAxis up, const GltfEdit& edit,
                                       const std::string& name);

}  // namespace tilemend

#endif  // TILEMEND_COMMON_CODEC_GLTF_GLTF_FILE_H_
