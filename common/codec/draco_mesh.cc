#include "common/codec/draco_mesh.h"

#include <algorithm>
#include <exception>
#include <limits>
#include <memory>
#include <new>
#include <utility>

#include "absl/strings/str_cat.h"
#include "common/codec/draco_frame.h"
#include "common/util/status_macros.h"
#include "draco/compression/decode.h"
#include "draco/compression/encode.h"

namespace tilemend {
namespace {

// Two counts, the coordinates, the indices.
std::string EncodePlain(const LatticeMesh& mesh) {
  std::string out;
  out.reserve(8 + 12 * (mesh.points.size() + mesh.triangles.size()));
  AppendUint32(static_cast<uint32_t>(mesh.points.size()), out);
  AppendUint32(static_cast<uint32_t>(mesh.triangles.size()), out);
  for (const std::array<int32_t, 3>& point : mesh.points) {
    for (const int32_t coordinate : point) AppendUint32(static_cast<uint32_t>(coordinate), out);
  }
  for (const Triangle& triangle : mesh.triangles) {
    for (const int32_t corner : triangle) AppendUint32(static_cast<uint32_t>(corner), out);
  }
  return out;
}

absl::StatusOr<LatticeMesh> DecodePlain(std::string_view bytes, const DracoLimits& limits) {
  if (bytes.size() < 8) return absl::InvalidArgumentError("lattice mesh: expected two counts");
  const uint64_t points = LoadUint32(bytes.data());
  const uint64_t triangles = LoadUint32(bytes.data() + 4);
  TILEMEND_RETURN_IF_ERROR(CheckCounts(points, triangles, limits));
  if (bytes.size() != 8 + 12 * (points + triangles)) {
    return absl::InvalidArgumentError(absl::StrCat("lattice mesh: expected ", points, " points and ", triangles,
                                                   " triangles, found ", bytes.size(), " bytes"));
  }
  LatticeMesh mesh;
  mesh.points.resize(points);
  mesh.triangles.resize(triangles);
  const char* p = bytes.data() + 8;
  const auto fill = [&p](auto& records) {
    for (std::array<int32_t, 3>& record : records) {
      for (int32_t& value : record) value = static_cast<int32_t>(LoadUint32(p)), p += 4;
    }
  };
  fill(mesh.points);
  fill(mesh.triangles);
  return mesh;
}

// Draco's prediction works with differences in 32 bits.
bool HasNarrowRange(const LatticeMesh& mesh) {
  constexpr int32_t kMost = std::numeric_limits<int32_t>::max() / 4;
  const auto narrow = [](int32_t coordinate) { return coordinate > -kMost && coordinate < kMost; };
  return std::all_of(mesh.points.begin(), mesh.points.end(),
                     [&narrow](const auto& point) { return std::all_of(point.begin(), point.end(), narrow); });
}

std::unique_ptr<draco::Mesh> ToDraco(const LatticeMesh& mesh) {
  auto out = std::make_unique<draco::Mesh>();
  out->set_num_points(static_cast<uint32_t>(mesh.points.size()));
  draco::GeometryAttribute position;
  position.Init(draco::GeometryAttribute::POSITION, nullptr, 3, draco::DT_INT32, false, 3 * sizeof(int32_t), 0);
  const int id = out->AddAttribute(position, true, static_cast<uint32_t>(mesh.points.size()));
  for (uint32_t i = 0; i < mesh.points.size(); ++i) {
    out->attribute(id)->SetAttributeValue(draco::AttributeValueIndex(i), mesh.points[i].data());
  }
  out->SetNumFaces(mesh.triangles.size());
  for (uint32_t i = 0; i < mesh.triangles.size(); ++i) {
    draco::Mesh::Face face;
    for (size_t k = 0; k < 3; ++k) face[k] = static_cast<uint32_t>(mesh.triangles[i][k]);
    out->SetFace(draco::FaceIndex(i), face);
  }
  return out;
}

// The mesh as a Draco stream; empty if Draco refuses it.
std::string EncodeStream(const LatticeMesh& mesh) {
  if (mesh.points.empty() || !HasNarrowRange(mesh)) return "";
  draco::Encoder encoder;
  encoder.SetEncodingMethod(draco::MESH_SEQUENTIAL_ENCODING);
  constexpr int kSpeed = 5;  // 0 is the smallest result, 10 the quickest; it hardly matters in sequential encoding
  encoder.SetSpeedOptions(kSpeed, kSpeed);
  const draco::Status predicted =
      encoder.SetAttributePredictionScheme(draco::GeometryAttribute::POSITION, draco::PREDICTION_DIFFERENCE);
  draco::EncoderBuffer buffer;
  if (!predicted.ok() || !encoder.EncodeMeshToBuffer(*ToDraco(mesh), &buffer).ok()) return "";
  return std::string(buffer.data(), buffer.size());
}

// Copies a decoded mesh, trusting nothing about it.
absl::StatusOr<LatticeMesh> FromDraco(const draco::Mesh& decoded, const DracoCounts& counts) {
  const absl::Status bad = absl::InvalidArgumentError("Draco stream: the decoded mesh is not what its header says");
  if (decoded.num_points() != counts.points || decoded.num_faces() != counts.triangles) return bad;
  if (decoded.num_attributes() != 1) return bad;
  const draco::PointAttribute& position = *decoded.attribute(0);
  if (position.data_type() != draco::DT_INT32 || position.num_components() != 3) return bad;
  LatticeMesh mesh;
  mesh.points.resize(counts.points);
  for (uint32_t i = 0; i < counts.points; ++i) {
    const draco::AttributeValueIndex value = position.mapped_index(draco::PointIndex(i));
    if (value.value() >= position.size()) return bad;
    position.GetValue(value, mesh.points[i].data());
  }
  mesh.triangles.resize(counts.triangles);
  for (uint32_t i = 0; i < counts.triangles; ++i) {
    const draco::Mesh::Face& face = decoded.face(draco::FaceIndex(i));
    for (size_t k = 0; k < 3; ++k) {
      if (face[k].value() >= counts.points) return bad;
      mesh.triangles[i][k] = static_cast<int32_t>(face[k].value());
    }
  }
  return mesh;
}

absl::StatusOr<LatticeMesh> DecodeStream(std::string_view stream, const DracoLimits& limits) {
  TILEMEND_ASSIGN_OR_RETURN(const DracoCounts counts, CheckDracoStream(stream, limits));
  draco::DecoderBuffer buffer;
  buffer.Init(stream.data(), stream.size());
  draco::Decoder decoder;
  auto decoded = decoder.DecodeMeshFromBuffer(&buffer);
  if (!decoded.ok()) {
    return absl::InvalidArgumentError(absl::StrCat("Draco stream: ", decoded.status().error_msg_string()));
  }
  return FromDraco(*decoded.value(), counts);
}

absl::Status CheckTriangles(const LatticeMesh& mesh) {
  const int64_t points = static_cast<int64_t>(mesh.points.size());
  for (const Triangle& triangle : mesh.triangles) {
    for (const int32_t corner : triangle) {
      if (corner < 0 || corner >= points)
        return absl::InvalidArgumentError(absl::StrCat("lattice mesh: no point ", corner));
    }
  }
  return absl::OkStatus();
}

}  // namespace

std::string EncodeDraco(const LatticeMesh& mesh) {
  const std::string stream = EncodeStream(mesh);
  // Some meshes Draco encodes but cannot decode (a single point, for one), so what it wrote is read back.
  constexpr int64_t kAll = std::numeric_limits<int64_t>::max();
  const absl::StatusOr<LatticeMesh> back = DecodeStream(stream, {.max_points = kAll, .max_triangles = kAll});
  if (!back.ok() || back->points != mesh.points || back->triangles != mesh.triangles) {
    return WrapFrame(FrameContent::kPlain, EncodePlain(mesh));
  }
  return WrapFrame(FrameContent::kDraco, stream);
}

absl::StatusOr<LatticeMesh> DecodeDraco(std::string_view bytes, const DracoLimits& limits) {
  TILEMEND_ASSIGN_OR_RETURN(const Frame frame, UnwrapFrame(bytes));
  // Draco and the vectors here may run out of memory; nothing of it may leave this function.
  try {
    absl::StatusOr<LatticeMesh> mesh = frame.content == FrameContent::kPlain ? DecodePlain(frame.payload, limits)
                                                                             : DecodeStream(frame.payload, limits);
    if (mesh.ok()) TILEMEND_RETURN_IF_ERROR(CheckTriangles(*mesh));
    return mesh;
  } catch (const std::bad_alloc&) {
    return absl::ResourceExhaustedError("lattice mesh: not enough memory to decode it");
  } catch (const std::exception& error) {
    return absl::InvalidArgumentError(absl::StrCat("Draco stream: ", error.what()));
  }
}

}  // namespace tilemend
