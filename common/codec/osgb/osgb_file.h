// OSGB files: OpenSceneGraph's binary scene files, as photogrammetry programs export them.
//
// Guarantees
//  - Reads versions 80 (OpenSceneGraph 3.0) to 161 (3.6), with and without binary brackets, little-endian.
//  - Writing splices: every byte of the original stays, but for the counts and bracket sizes around an insertion.
//    Images are never decoded or encoded.
//  - What the reader does not know, it refuses by name: a compressor, a class, schema data, a primitive set.
//  - Malformed input is an error that names file and byte offset. Memory is in proportion to the file, the depth of
//    recursion is limited, and no path that a file names is ever opened.
//
// Source of the format: src/osgDB and src/osgWrappers/serializers/osg of OpenSceneGraph 3.6.5.
#ifndef TILEMEND_COMMON_CODEC_OSGB_OSGB_FILE_H_
#define TILEMEND_COMMON_CODEC_OSGB_OSGB_FILE_H_

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"
#include "common/mesh/tri_mesh.h"
#include "common/util/colour.h"

namespace tilemend {

// One osg::Geometry of a file. Its vertices and triangles are contiguous in OsgbFile.
struct OsgbGeometry {
  int32_t first_vertex = 0;
  int32_t vertex_count = 0;
  int32_t first_triangle = 0;
  int32_t triangle_count = 0;
  int32_t texture = -1;            // index into OsgbFile::images; -1: no image at texture unit 0
  std::optional<Rgb> colour = {};  // diffuse, of its material
  int32_t geode = 0;               // index into OsgbFile::geodes
};

// One osg::Image. Several geometries may share it.
struct OsgbImage {
  enum class Storage {
    kEncoded,   // a JPEG or PNG lies in the file
    kPixels,    // raw pixels lie in the file
    kExternal,  // the file has a name only
  };
  Storage storage = Storage::kEncoded;
  std::string name;   // as the file names it; not a path to open
  size_t offset = 0;  // of the image's bytes in the file
  size_t size = 0;    // of the image's bytes; 0 for kExternal
};

// One child of an osg::PagedLOD. Its range is in the units of the PagedLOD: metres of distance, or pixels on the
// screen.
struct OsgbChild {
  std::string file;  // as the file names it; empty: the child lies in this file
  float range_lo = 0;
  float range_hi = 0;
};

struct OsgbPagedLod {
  bool range_is_pixels = false;    // PIXEL_SIZE_ON_SCREEN, else DISTANCE_FROM_EYE_POINT
  bool has_center = false;         // the file gives center and radius
  Point3 center = Point3::Zero();  // scene frame, metres
  double radius = -1;              // metres
  std::vector<OsgbChild> children;
};

// One osg::Geode, the leaf that holds geometries.
struct OsgbGeode {
  int32_t paged_lod = -1;               // index into OsgbFile::paged_lods of the nearest PagedLOD above it; -1: none
  Point3 translation = Point3::Zero();  // from the coordinates in the file to those of OsgbFile::points
};

struct OsgbFile {
  uint32_t version = 0;
  bool has_brackets = false;
  std::vector<Point3> points;            // of all geometries, in the order of the file; float32 values, exactly
  std::vector<std::array<float, 2>> uv;  // of texture unit 0, one per point; (0, 0) where a geometry has none
  std::vector<Triangle> triangles;       // indices into points
  std::vector<OsgbGeometry> geometries;  // in the order of the file
  std::vector<OsgbImage> images;
  std::vector<OsgbGeode> geodes;
  std::vector<OsgbPagedLod> paged_lods;
};

// A new osg::Geometry with a material and at most one texture.
struct OsgbPatch {
  std::vector<Point3> points;            // frame of OsgbFile::points; written as float32
  std::vector<std::array<float, 2>> uv;  // one per point if there is an image, else empty; v points up
  std::vector<Triangle> triangles;       // indices into points
  std::string image;                     // encoded JPEG or PNG; empty: the material has `colour`
  std::string image_name;                // with the extension that tells readers the image's format (.jpg, .png)
  Rgb colour;
  int32_t geode = 0;  // index into OsgbFile::geodes: the geometry goes to its end
};

// Reads `bytes`; `name` stands in messages. kInvalidArgument for malformed input and for what is refused. A
// MatrixTransform above geometry is applied if it only translates, else it is refused. Linear in the file.
absl::StatusOr<OsgbFile> ReadOsgb(std::string_view bytes, const std::string& name);

// `bytes` with the geometries `patches` at the ends of their geodes. Every other byte stays, but for the counts and the
// sizes of brackets. New objects have ids above those of the file. kInvalidArgument as ReadOsgb, and if the file has no
// such geode or a patch is inconsistent. Linear.
absl::StatusOr<std::string> AppendOsgb(std::string_view bytes, std::span<const OsgbPatch> patches,
                                       const std::string& name);

// `bytes` without the triangles in `drop` (one entry per triangle of OsgbFile::triangles). Vertices and images stay; a
// geometry may have no triangle then. kInvalidArgument as ReadOsgb, or if `drop` has another size. The same if it takes
// a part of a primitive set that is no list of triangles by index. Linear.
absl::StatusOr<std::string> DropOsgbTriangles(std::string_view bytes, const std::vector<bool>& drop,
                                              const std::string& name);

}  // namespace tilemend

#endif  // TILEMEND_COMMON_CODEC_OSGB_OSGB_FILE_H_
