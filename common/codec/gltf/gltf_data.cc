#include "common/codec/gltf/gltf_data.h"

#include <meshoptimizer.h>

#include <algorithm>
#include <cstring>
#include <utility>

#include "absl/strings/str_cat.h"
#include "common/util/status_macros.h"

namespace tilemend {
namespace {

constexpr int64_t kMaxBytes = INT64_C(1) << 40;  // of offsets and counts: sums do not overflow
constexpr size_t kMaxDecodedBytes = size_t{1} << 30;

template <typename T>
T Load(const char* p) {
  T value;
  std::memcpy(&value, p, sizeof(value));
  return value;
}

// (value / largest), but not below -1.
template <typename T>
double Normalized(T value) {
  return std::max(-1.0, static_cast<double>(value) / static_cast<double>(std::numeric_limits<T>::max()));
}

template <typename T>
double LoadNumber(const char* p, bool normalized) {
  const T value = Load<T>(p);
  return normalized ? Normalized(value) : static_cast<double>(value);
}

enum class MeshoptMode { kAttributes, kTriangles, kIndices };

struct MeshoptView {
  MeshoptMode mode = MeshoptMode::kAttributes;
  std::string filter;
  size_t count = 0;
  size_t stride = 0;
};

// What the decoders demand of their caller, which they check with assert() alone.
absl::Status CheckMeshopt(const MeshoptView& view, size_t compressed_bytes, const JsonView& at) {
  const bool is_attributes = view.mode == MeshoptMode::kAttributes;
  if (is_attributes ? view.stride % 4 != 0 || view.stride > 256 : view.stride != 2 && view.stride != 4) {
    return at.Error(absl::StrCat("a stride of ", view.stride, " bytes is not allowed"));
  }
  if (view.mode == MeshoptMode::kTriangles && view.count % 3 != 0) return at.Error("the count is no multiple of 3");
  const bool filter_ok = view.filter == "NONE" || (is_attributes && view.filter == "EXPONENTIAL") ||
                         (is_attributes && view.filter == "OCTAHEDRAL" && (view.stride == 4 || view.stride == 8)) ||
                         (is_attributes && view.filter == "QUATERNION" && view.stride == 8);
  if (!filter_ok) return at.Error("the filter does not fit the mode and the stride");
  // Attributes take at least a byte for 64; indices one for a triangle.
  if (view.count > kMaxDecodedBytes / view.stride || view.count * view.stride > 4096 + 256 * compressed_bytes) {
    return at.Error(absl::StrCat(view.count, " elements are too many for ", compressed_bytes, " bytes"));
  }
  return absl::OkStatus();
}

absl::StatusOr<MeshoptView> ParseMeshopt(const JsonView& extension) {
  MeshoptView view;
  TILEMEND_ASSIGN_OR_RETURN(const int64_t count, extension.Integer("count", 1, kMaxBytes));
  TILEMEND_ASSIGN_OR_RETURN(const int64_t stride, extension.Integer("byteStride", 2, 256));
  TILEMEND_ASSIGN_OR_RETURN(const std::string mode, extension.TextOr("mode", ""));
  TILEMEND_ASSIGN_OR_RETURN(view.filter, extension.TextOr("filter", "NONE"));
  if (mode != "ATTRIBUTES" && mode != "TRIANGLES" && mode != "INDICES") return extension.Error("unknown mode");
  view.mode = mode == "ATTRIBUTES"  ? MeshoptMode::kAttributes
              : mode == "TRIANGLES" ? MeshoptMode::kTriangles
                                    : MeshoptMode::kIndices;
  view.count = static_cast<size_t>(count);
  view.stride = static_cast<size_t>(stride);
  return view;
}

// Returns whether the bytes were in order. Precondition: CheckMeshopt.
bool DecodeMeshopt(const MeshoptView& view, std::string_view compressed, std::string& out) {
  const auto* bytes = reinterpret_cast<const unsigned char*>(compressed.data());
  if (view.mode == MeshoptMode::kTriangles) {
    return meshopt_decodeIndexBuffer(out.data(), view.count, view.stride, bytes, compressed.size()) == 0;
  }
  if (view.mode == MeshoptMode::kIndices) {
    return meshopt_decodeIndexSequence(out.data(), view.count, view.stride, bytes, compressed.size()) == 0;
  }
  if (meshopt_decodeVertexBuffer(out.data(), view.count, view.stride, bytes, compressed.size()) != 0) return false;
  if (view.filter == "OCTAHEDRAL") meshopt_decodeFilterOct(out.data(), view.count, view.stride);
  if (view.filter == "QUATERNION") meshopt_decodeFilterQuat(out.data(), view.count, view.stride);
  if (view.filter == "EXPONENTIAL") meshopt_decodeFilterExp(out.data(), view.count, view.stride);
  return true;
}

}  // namespace

size_t GltfComponents(const std::string& type) {
  constexpr std::pair<const char*, size_t> kTypes[] = {{"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4}};
  for (const auto& [name, components] : kTypes) {
    if (type == name) return components;
  }
  return 0;
}

size_t GltfComponentBytes(int64_t component_type) {
  switch (component_type) {
    case 5120:
    case 5121:
      return 1;
    case 5122:
    case 5123:
      return 2;
    case 5125:
    case 5126:
      return 4;
    default:
      return 0;
  }
}

double GltfValues::At(size_t element, size_t component) const {
  const char* const p = bytes.data() + element * stride + component * GltfComponentBytes(component_type);
  switch (component_type) {
    case 5120:
      return LoadNumber<int8_t>(p, normalized);
    case 5121:
      return LoadNumber<uint8_t>(p, normalized);
    case 5122:
      return LoadNumber<int16_t>(p, normalized);
    case 5123:
      return LoadNumber<uint16_t>(p, normalized);
    case 5125:
      return LoadNumber<uint32_t>(p, false);
    default:
      return Load<float>(p);
  }
}

uint32_t GltfValues::IndexAt(size_t element) const {
  const char* const p = bytes.data() + element * stride;
  if (component_type == 5121) return Load<uint8_t>(p);
  return component_type == 5123 ? Load<uint16_t>(p) : Load<uint32_t>(p);
}

absl::StatusOr<GltfBytes> GltfData::PlainView(const JsonView& view) const {
  TILEMEND_ASSIGN_OR_RETURN(const JsonView buffers, root_.Get("buffers"));
  TILEMEND_ASSIGN_OR_RETURN(const int64_t buffer_index, view.Integer("buffer", 0, kMaxBytes));
  TILEMEND_ASSIGN_OR_RETURN(const JsonView buffer, buffers.At(buffer_index));
  if (buffer.Find("uri") || buffer_index != 0 || !container_.has_bin) {
    return buffer.Error("the data is not in the binary chunk; files and data URIs are not read");
  }
  TILEMEND_ASSIGN_OR_RETURN(const int64_t size, buffer.Integer("byteLength", 1, kMaxBytes));
  if (size > static_cast<int64_t>(container_.bin.size())) {
    return buffer.Error(absl::StrCat(size, " bytes, but the binary chunk has ", container_.bin.size()));
  }
  TILEMEND_ASSIGN_OR_RETURN(const int64_t offset, view.IntegerOr("byteOffset", 0, size, 0));
  TILEMEND_ASSIGN_OR_RETURN(const int64_t length, view.Integer("byteLength", 1, kMaxBytes));
  if (length > size - offset) {
    return view.Error(absl::StrCat("byte ", container_.bin_offset + static_cast<size_t>(offset), ": ", length,
                                   " bytes, but the buffer has ", size - offset, " left"));
  }
  return GltfBytes{container_.bin.substr(static_cast<size_t>(offset), static_cast<size_t>(length)),
                   container_.bin_offset + static_cast<size_t>(offset), 0, false};
}

absl::StatusOr<std::string> GltfData::DecodedView(const JsonView& extension) const {
  TILEMEND_ASSIGN_OR_RETURN(const GltfBytes compressed, PlainView(extension));
  TILEMEND_ASSIGN_OR_RETURN(const MeshoptView view, ParseMeshopt(extension));
  TILEMEND_RETURN_IF_ERROR(CheckMeshopt(view, compressed.bytes.size(), extension));
  std::string out(view.count * view.stride, '\0');
  if (!DecodeMeshopt(view, compressed.bytes, out)) {
    return extension.Error(absl::StrCat("byte ", compressed.offset, ": the meshoptimizer stream is damaged"));
  }
  return out;
}

absl::StatusOr<GltfBytes> GltfData::View(int64_t index) {
  TILEMEND_ASSIGN_OR_RETURN(const JsonView views, root_.Get("bufferViews"));
  TILEMEND_ASSIGN_OR_RETURN(const JsonView view, views.At(index));
  const std::optional<JsonView> meshopt = view.Extension("EXT_meshopt_compression");
  if (!meshopt) {
    TILEMEND_ASSIGN_OR_RETURN(GltfBytes bytes, PlainView(view));
    TILEMEND_ASSIGN_OR_RETURN(const int64_t stride, view.IntegerOr("byteStride", 1, 252, 0));
    bytes.stride = static_cast<size_t>(stride);
    return bytes;
  }
  if (!decoded_.contains(index)) {
    TILEMEND_ASSIGN_OR_RETURN(std::string decoded, DecodedView(*meshopt));
    decoded_.emplace(index, std::move(decoded));
  }
  TILEMEND_ASSIGN_OR_RETURN(const GltfBytes compressed, PlainView(*meshopt));
  TILEMEND_ASSIGN_OR_RETURN(const int64_t stride, meshopt->Integer("byteStride", 2, 256));
  return GltfBytes{decoded_.at(index), compressed.offset, static_cast<size_t>(stride), true};
}

absl::StatusOr<GltfValues> GltfData::Accessor(int64_t index) {
  TILEMEND_ASSIGN_OR_RETURN(const JsonView accessors, root_.Get("accessors"));
  TILEMEND_ASSIGN_OR_RETURN(const JsonView accessor, accessors.At(index));
  if (accessor.Find("sparse")) return accessor.Error("sparse accessors are not read");
  GltfValues values;
  TILEMEND_ASSIGN_OR_RETURN(values.component_type, accessor.Integer("componentType", 5120, 5126));
  TILEMEND_ASSIGN_OR_RETURN(values.normalized, accessor.BoolOr("normalized", false));
  TILEMEND_ASSIGN_OR_RETURN(const std::string type, accessor.TextOr("type", ""));
  values.components = GltfComponents(type);
  const size_t size = values.components * GltfComponentBytes(values.component_type);
  if (size == 0) return accessor.Error("numbers of this type are not read");
  TILEMEND_ASSIGN_OR_RETURN(const int64_t count, accessor.Integer("count", 1, kMaxBytes));
  TILEMEND_ASSIGN_OR_RETURN(const int64_t view_index, accessor.Integer("bufferView", 0, kMaxBytes));
  TILEMEND_ASSIGN_OR_RETURN(const GltfBytes view, View(view_index));
  TILEMEND_ASSIGN_OR_RETURN(const int64_t offset, accessor.IntegerOr("byteOffset", 0, kMaxBytes, 0));
  values.stride = view.stride > 0 ? view.stride : size;
  values.count = static_cast<size_t>(count);
  if (values.stride < size || static_cast<size_t>(offset) > view.bytes.size() ||
      view.bytes.size() - static_cast<size_t>(offset) < size ||
      (view.bytes.size() - static_cast<size_t>(offset) - size) / values.stride < values.count - 1) {
    return accessor.Error(absl::StrCat("byte ", view.offset, ": ", count, " elements of ", size,
                                       " bytes do not fit into a view of ", view.bytes.size(), " bytes"));
  }
  values.bytes = view.bytes.substr(static_cast<size_t>(offset));
  return values;
}

absl::StatusOr<const GltfDracoMesh*> GltfData::Draco(int64_t view) {
  const auto known = draco_.find(view);
  if (known != draco_.end()) return &known->second;
  TILEMEND_ASSIGN_OR_RETURN(const GltfBytes stream, View(view));
  absl::StatusOr<GltfDracoMesh> mesh = DecodeGltfDraco(stream.bytes);
  if (!mesh.ok()) {
    const absl::Status error = root_.Error(absl::StrCat("byte ", stream.offset, ": ", mesh.status().message()));
    return absl::Status(mesh.status().code(), error.message());
  }
  return &draco_.emplace(view, *std::move(mesh)).first->second;
}

}  // namespace tilemend
