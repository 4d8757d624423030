// Encoding of a new osg::Geometry as bytes to insert into an OSGB file.
#ifndef TILEMEND_COMMON_CODEC_OSGB_OSGB_ENCODE_H_
#define TILEMEND_COMMON_CODEC_OSGB_OSGB_ENCODE_H_

#include <cstddef>
#include <cstdint>
#include <string>

#include "common/codec/osgb/osgb_file.h"

namespace tilemend {

struct OsgbEncoding {
  uint32_t version = 0;
  size_t bracket_bytes = 0;  // 0: no binary brackets
  uint32_t next_object_id = 1;
  uint32_t next_array_id = 1;
};

// The most ids of either kind that one geometry takes.
inline constexpr uint32_t kOsgbIdsOfGeometry = 8;

// The osg::Geometry of `patch` with its state set, material, texture and image. `translation` leads from the
// coordinates in the file to those of the patch. Raises the ids of `encoding` beyond those that it used.
// Preconditions: CheckOsgbPatch (osgb_patch_check.h) is OK, the ids have room for kOsgbIdsOfGeometry more. Linear.
std::string EncodeOsgbGeometry(const OsgbPatch& patch, const Point3& translation, OsgbEncoding& encoding);

}  // namespace tilemend

#endif  // TILEMEND_COMMON_CODEC_OSGB_OSGB_ENCODE_H_
