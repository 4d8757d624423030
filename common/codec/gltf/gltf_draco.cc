#include "common/codec/gltf/gltf_draco.h"

#include <algorithm>
#include <cstring>
#include <exception>
#include <new>

#include "absl/strings/str_cat.h"
#include "common/util/status_macros.h"
#include "draco/compression/config/decoder_options.h"
#include "draco/compression/mesh/mesh_edgebreaker_decoder.h"
#include "draco/compression/mesh/mesh_sequential_decoder.h"
#include "draco/core/varint_decoding.h"
#include "draco/mesh/mesh.h"

namespace tilemend {
namespace {

constexpr int64_t kMaxPerByte = 64;         // faces or points; real streams have below 4
constexpr int64_t kMinCounts = 1024;        // always allowed
constexpr int64_t kMaxBytesPerPoint = 256;  // of all attributes
constexpr uint8_t kSequential = 0, kEdgebreaker = 1;

absl::Status StreamError(std::string_view what) {
  return absl::InvalidArgumentError(absl::StrCat("Draco stream: ", std::string(what)));
}

struct Header {
  uint8_t method = 0;
  int64_t faces = 0;
  int64_t points = 0;  // an upper bound before the attributes split vertices
};

// "DRACO", version 2.2, mesh, method, flags; then the counts.
absl::StatusOr<Header> ReadHeader(std::string_view stream) {
  constexpr std::string_view kMagic("DRACO\2\2\1", 8);
  constexpr size_t kHeaderBytes = 11;
  if (stream.size() < kHeaderBytes || stream.substr(0, kMagic.size()) != kMagic) {
    return StreamError("expected a mesh of version 2.2");
  }
  Header header;
  header.method = static_cast<uint8_t>(stream[8]);
  if (header.method > kEdgebreaker) return StreamError("unknown method");
  if (stream[9] != 0 || stream[10] != 0) return StreamError("metadata is not read");
  draco::DecoderBuffer buffer;
  buffer.Init(stream.data() + kHeaderBytes, stream.size() - kHeaderBytes);
  uint32_t faces = 0, points = 0, symbols = 0, splits = 0;
  uint8_t traversal = 0, attributes = 0;
  bool ok = false;
  if (header.method == kSequential) {
    ok = draco::DecodeVarint(&faces, &buffer) && draco::DecodeVarint(&points, &buffer);
  } else {
    ok = buffer.Decode(&traversal) && draco::DecodeVarint(&points, &buffer) && draco::DecodeVarint(&faces, &buffer) &&
         buffer.Decode(&attributes) && draco::DecodeVarint(&symbols, &buffer) && draco::DecodeVarint(&splits, &buffer);
    if (attributes > 16) return StreamError("more than 16 attributes");
  }
  if (!ok) return StreamError("the header is cut off");
  header.faces = faces;
  header.points = int64_t{points} + splits;
  return header;
}

// Stops before attributes that are too large.
template <typename Decoder>
class GuardedDecoder : public Decoder {
 public:
  explicit GuardedDecoder(int64_t max_points) : max_points_(max_points) {}

 protected:
  bool DecodeAllAttributes() override {
    const draco::PointCloud& cloud = *this->point_cloud();
    int64_t bytes = 0;
    for (int32_t i = 0; i < cloud.num_attributes(); ++i) {
      const draco::PointAttribute& attribute = *cloud.attribute(i);
      const int64_t components = attribute.num_components(), size = draco::DataTypeLength(attribute.data_type());
      if (components < 1 || size < 1) return false;
      bytes += components * size;
    }
    if (bytes > kMaxBytesPerPoint || cloud.num_points() > max_points_) return false;
    return Decoder::DecodeAllAttributes();
  }

 private:
  int64_t max_points_;
};

// Precondition: ReadHeader took the stream.
template <typename Decoder>
absl::Status Decode(std::string_view stream, int64_t max_points, draco::Mesh& mesh) {
  draco::DecoderBuffer buffer;
  buffer.Init(stream.data(), stream.size());
  const draco::DecoderOptions options;
  GuardedDecoder<Decoder> decoder(max_points);
  const draco::Status status = decoder.Decode(options, &buffer, &mesh);
  return status.ok() ? absl::OkStatus() : StreamError(status.error_msg_string());
}

int64_t ComponentType(draco::DataType type) {
  switch (type) {
    case draco::DT_INT8:
      return 5120;
    case draco::DT_UINT8:
      return 5121;
    case draco::DT_INT16:
      return 5122;
    case draco::DT_UINT16:
      return 5123;
    case draco::DT_UINT32:
      return 5125;
    case draco::DT_FLOAT32:
      return 5126;
    default:
      return 0;
  }
}

// Copies an attribute, trusting nothing about it.
absl::Status AddAttribute(const draco::PointAttribute& from, int64_t points, GltfDracoMesh& mesh) {
  const absl::Status bad = StreamError("an attribute is not what its header says");
  GltfDracoAttribute attribute;
  attribute.id = from.unique_id();
  attribute.components = from.num_components();
  attribute.component_type = ComponentType(from.data_type());
  if (attribute.component_type == 0) return absl::OkStatus();
  const auto size = static_cast<size_t>(attribute.components * draco::DataTypeLength(from.data_type()));
  if (from.byte_stride() != static_cast<int64_t>(size) || from.buffer() == nullptr ||
      from.buffer()->data_size() / size < from.size()) {
    return bad;
  }
  if (!from.is_mapping_identity() && static_cast<int64_t>(from.indices_map_size()) < points) return bad;
  attribute.values.resize(static_cast<size_t>(points) * size);
  for (uint32_t i = 0; i < points; ++i) {
    const draco::AttributeValueIndex value = from.mapped_index(draco::PointIndex(i));
    if (value.value() >= from.size()) return bad;
    std::memcpy(attribute.values.data() + i * size, from.GetAddress(value), size);
  }
  mesh.attributes.push_back(std::move(attribute));
  return absl::OkStatus();
}

absl::StatusOr<GltfDracoMesh> Copied(const draco::Mesh& decoded) {
  GltfDracoMesh mesh;
  mesh.points = decoded.num_points();
  mesh.faces.resize(decoded.num_faces());
  for (uint32_t i = 0; i < decoded.num_faces(); ++i) {
    const draco::Mesh::Face& face = decoded.face(draco::FaceIndex(i));
    for (size_t k = 0; k < 3; ++k) {
      if (face[k].value() >= decoded.num_points()) return StreamError("a triangle has no such vertex");
      mesh.faces[i][k] = face[k].value();
    }
  }
  for (int32_t i = 0; i < decoded.num_attributes(); ++i) {
    TILEMEND_RETURN_IF_ERROR(AddAttribute(*decoded.attribute(i), mesh.points, mesh));
  }
  return mesh;
}

absl::StatusOr<GltfDracoMesh> DecodeGuarded(std::string_view stream, const GltfDracoLimits& limits) {
  TILEMEND_ASSIGN_OR_RETURN(const Header header, ReadHeader(stream));
  const int64_t by_length = kMinCounts + kMaxPerByte * static_cast<int64_t>(stream.size());
  const int64_t max_points = std::min(limits.max_points, by_length);
  if (header.points > max_points || header.faces > std::min(limits.max_faces, by_length)) {
    return absl::ResourceExhaustedError(absl::StrCat("Draco stream: ", header.points, " points and ", header.faces,
                                                     " triangles are too many for ", stream.size(), " bytes"));
  }
  draco::Mesh mesh;
  TILEMEND_RETURN_IF_ERROR(header.method == kSequential
                               ? Decode<draco::MeshSequentialDecoder>(stream, max_points, mesh)
                               : Decode<draco::MeshEdgebreakerDecoder>(stream, max_points, mesh));
  return Copied(mesh);
}

}  // namespace

absl::StatusOr<GltfDracoMesh> DecodeGltfDraco(std::string_view stream, const GltfDracoLimits& limits) {
  // Draco and the vectors here may run out of memory; nothing of it may leave this function.
  try {
    return DecodeGuarded(stream, limits);
  } catch (const std::bad_alloc&) {
    return absl::ResourceExhaustedError("Draco stream: not enough memory to decode it");
  } catch (const std::exception& error) {
    return StreamError(error.what());
  }
}

}  // namespace tilemend
