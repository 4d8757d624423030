// Whether new geometry can be written.
#ifndef TILEMEND_COMMON_CODEC_OSGB_OSGB_PATCH_CHECK_H_
#define TILEMEND_COMMON_CODEC_OSGB_OSGB_PATCH_CHECK_H_

#include <cstddef>
#include <cstdint>
#include <string>

#include "absl/status/status.h"
#include "common/codec/osgb/osgb_file.h"

namespace tilemend {

absl::Status OsgbPatchError(const std::string& name, size_t patch, const std::string& message);

// Whether indices, texture coordinates and coordinates of `patch` can be written; `translation` as EncodeOsgbGeometry
// has it, `index` stands in messages. Linear.
absl::Status CheckOsgbPatch(const OsgbPatch& patch, const Point3& translation, size_t index, const std::string& name);

// What a patch takes in a file, without the small fields.
uint64_t BytesOfOsgbPatch(const OsgbPatch& patch);

}  // namespace tilemend

#endif  // TILEMEND_COMMON_CODEC_OSGB_OSGB_PATCH_CHECK_H_
