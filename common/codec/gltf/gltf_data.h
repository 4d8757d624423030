// Accessors and buffer views of a glTF document, with their compression undone.
#ifndef TILEMEND_COMMON_CODEC_GLTF_GLTF_DATA_H_
#define TILEMEND_COMMON_CODEC_GLTF_GLTF_DATA_H_

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>

#include "absl/status/statusor.h"
#include "common/codec/gltf/gltf_container.h"
#include "common/codec/gltf/gltf_draco.h"
#include "common/codec/gltf/json_view.h"

namespace tilemend {

// The elements of an accessor. Every element lies in `bytes`.
struct GltfValues {
  std::string_view bytes;  // from the first element on
  size_t stride = 0;
  int64_t component_type = 0;  // of glTF: 5120 int8, 5121 uint8, 5122 int16, 5123 uint16, 5125 uint32, 5126 float32
  bool normalized = false;
  size_t components = 0;
  size_t count = 0;

  // A component as a number; integers that are normalized are mapped to [0, 1] or [-1, 1].
  double At(size_t element, size_t component) const;
  // Precondition: one unsigned component.
  uint32_t IndexAt(size_t element) const;
};

struct GltfBytes {
  std::string_view bytes;
  size_t offset = 0;  // in the file; of a compressed view: of its compressed bytes
  size_t stride = 0;  // 0: the elements are packed
  bool is_compressed = false;
};

// The bytes of a component, 0 if glTF has no such type.
size_t GltfComponentBytes(int64_t component_type);

// The number of components of an accessor's type, 0 for matrices and unknown types.
size_t GltfComponents(const std::string& type);

// Decodes each compressed view once, and keeps it.
class GltfData {
 public:
  // Both must outlive this, and `root` is the document of `container`.
  GltfData(const GltfContainer& container, const JsonView& root) : container_(container), root_(root) {}

  const JsonView& root() const { return root_; }

  // What lies in a buffer view; of one with EXT_meshopt_compression: what it means. All errors are those of JsonView.
  absl::StatusOr<GltfBytes> View(int64_t index);

  // An accessor of float32 or integers. Sparse ones and those without a view are refused.
  absl::StatusOr<GltfValues> Accessor(int64_t index);

  // The mesh in a buffer view. Also kResourceExhausted of DecodeGltfDraco.
  absl::StatusOr<const GltfDracoMesh*> Draco(int64_t view);

 private:
  absl::StatusOr<GltfBytes> PlainView(const JsonView& view) const;
  absl::StatusOr<std::string> DecodedView(const JsonView& extension) const;

  const GltfContainer& container_;
  JsonView root_;
  std::map<int64_t, std::string> decoded_;
  std::map<int64_t, GltfDracoMesh> draco_;
};

}  // namespace tilemend

#endif  // TILEMEND_COMMON_CODEC_GLTF_GLTF_DATA_H_
