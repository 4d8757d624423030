#include "common/codec/osgb/osgb_new.h"

#include <cstdint>
#include <string_view>

#include "absl/strings/str_cat.h"
#include "common/codec/osgb/osgb_encode.h"
#include "common/codec/osgb/osgb_encoder.h"
#include "common/codec/osgb/osgb_parse.h"
#include "common/codec/osgb/osgb_patch_check.h"
#include "common/util/status_macros.h"

namespace tilemend {
namespace {

class OsgbWriter {
 public:
  std::string Make(std::span<const OsgbNode> nodes) {
    constexpr std::string_view kMagic("\xa1\x0e\x91\x6c\x45\x45\xfb\x1a", 8);
    constexpr uint32_t kScene = 1;
    out_.Raw(kMagic);
    out_.U32(kScene);
    out_.U32(kOsgbMinVersion);
    out_.U32(0);  // no attributes
    out_.String("0");
    if (nodes.size() == 1) {
      Node(nodes[0]);
    } else {
      out_.BeginObject("osg::Group");
      NodeFields();
      Count(nodes.size());
      for (const OsgbNode& node : nodes) Node(node);
      out_.End();
    }
    return out_.Take();
  }

 private:
  // The length of a list that is not empty.
  void Count(size_t count) {
    out_.Flag(true);
    out_.U32(static_cast<uint32_t>(count));
  }

  void NodeFields() {
    out_.Zeros(5);  // no bound, no callbacks
    out_.Flag(true);
    out_.U32(UINT32_MAX);  // the node mask
    out_.Flag(false);      // no state set
  }

  void Node(const OsgbNode& node) {
    if (node.finer.empty()) return Geode(node);
    out_.BeginObject("osg::PagedLOD");
    NodeFields();
    LodFields(node);
    out_.Flag(true);
    out_.Zeros(1 + sizeof(uint32_t) + 1);  // no folder; all children may go; paging is on
    FileNames(node.finer);
    Count(1);
    Geode(node);
    out_.End();
  }

  void LodFields(const OsgbNode& node) {
    constexpr uint32_t kGivenCenter = 1, kPixelsOnScreen = 1;
    constexpr float kNoEnd = 1e30F;
    out_.U32(kGivenCenter);
    out_.Flag(true);
    for (int axis = 0; axis < 3; ++axis) out_.F64(node.center[axis]);
    out_.F64(node.radius);
    out_.U32(kPixelsOnScreen);
    Count(2);
    const auto range = static_cast<float>(node.range);
    for (const float end : {0.0F, range, range, kNoEnd}) out_.F32(end);
  }

  // The first child lies in this file, the second in `finer`.
  void FileNames(const std::string& finer) {
    constexpr uint32_t kChildren = 2;
    Count(kChildren);
    out_.String("");
    out_.String(finer);
    out_.U32(kChildren);
    for (uint32_t child = 0; child < kChildren; ++child) {
      for (const float priority : {0.0F, 1.0F}) out_.F32(priority);
    }
  }

  void Geode(const OsgbNode& node) {
    out_.BeginObject("osg::Geode");
    NodeFields();
    if (node.geometries.empty()) {
      out_.Flag(false);
    } else {
      Count(node.geometries.size());
      for (const OsgbPatch& patch : node.geometries) {
        out_.Raw(EncodeOsgbGeometry(patch, Point3::Zero(), encoding_));
      }
    }
    out_.End();
  }

  OsgbEncoding encoding_{.version = kOsgbMinVersion};
  OsgbEncoder out_{encoding_};
};

}  // namespace

absl::StatusOr<std::string> NewOsgb(std::span<const OsgbNode> nodes, const std::string& name) {
  if (nodes.empty()) return absl::InvalidArgumentError(absl::StrCat(name, ": no geometry"));
  uint64_t bytes = 0;
  size_t geometry = 0;
  for (const OsgbNode& node : nodes) {
    for (const OsgbPatch& patch : node.geometries) {
      TILEMEND_RETURN_IF_ERROR(CheckOsgbPatch(patch, Point3::Zero(), geometry++, name));
      bytes += BytesOfOsgbPatch(patch);
    }
  }
  if (bytes > INT32_MAX) return absl::InvalidArgumentError(absl::StrCat(name, ": the file would be over 2 GiB"));
  return OsgbWriter().Make(nodes);
}

}  // namespace tilemend
