// New OSGB files.
#ifndef TILEMEND_COMMON_CODEC_OSGB_OSGB_NEW_H_
#define TILEMEND_COMMON_CODEC_OSGB_OSGB_NEW_H_

#include <span>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "common/codec/osgb/osgb_file.h"

namespace tilemend {

// Geometry that a viewer shows at once, and the finer file that replaces it on the screen.
struct OsgbNode {
  std::vector<OsgbPatch> geometries;  // in the frame of the file; `geode` is not used
  std::string finer;                  // in the same folder; empty: none
  // Only if `finer` is set: a sphere around all that the finer file shows, and the size on the screen, in pixels, above
  // which it is shown.
  Point3 center = Point3::Zero();
  double radius = 0;
  double range = 0;
};

// A file of version 80, which OpenSceneGraph reads from 3.0 on, as photogrammetry programs write it: an osg::Geode or
// osg::PagedLOD for each node, in an osg::Group if there are several. Images are written as they are. Returns
// kInvalidArgument with `name` if there is no node, a geometry is inconsistent (AppendOsgb), or the file would be over
// 2 GiB. Cost linear in the bytes.
absl::StatusOr<std::string> NewOsgb(std::span<const OsgbNode> nodes, const std::string& name);

}  // namespace tilemend

#endif  // TILEMEND_COMMON_CODEC_OSGB_OSGB_NEW_H_
