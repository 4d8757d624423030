#include "common/codec/draco_mesh.h"

#include <algorithm>
#include <cstdlib>
#include <exception>
#include <limits>
#include <memory>
#include <new>

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

using LatticePosition = std::array<int32_t, 3>;
constexpr size_t kOriginBytes = 12;  // before the Draco stream

LatticePosition LeastCorner(const LatticeMesh& mesh) {
  LatticePosition least = mesh.points.front();
  for (const LatticePosition& point : mesh.points) {
    for (size_t axis = 0; axis < 3; ++axis) least[axis] = std::min(least[axis], point[axis]);
  }
  return least;
}

// Whether Draco can encode the points at a reasonable price. Its encoder counts how often each difference of successive
// points occurs, in an array as long as the largest is: 2^22 steps (4 km on a lattice of 1 mm) take it 32 MB.
bool HasSmallSteps(const LatticeMesh& mesh) {
  constexpr int64_t kMostStep = 1 << 22;
  LatticePosition last = LeastCorner(mesh);  // what the first point is predicted from
  for (const LatticePosition& point : mesh.points) {
    for (size_t axis = 0; axis < 3; ++axis) {
      if (std::abs(int64_t{point[axis]} - last[axis]) > kMostStep) return false;
    }
    last = point;
  }
  // Draco adds and subtracts in 32 bits.
  constexpr int64_t kMostExtent = std::numeric_limits<int32_t>::max() / 4;
  const LatticePosition least = LeastCorner(mesh);
  return std::all_of(mesh.points.begin(), mesh.points.end(), [&least](const LatticePosition& point) {
    return std::max({int64_t{point[0]} - least[0], int64_t{point[1]} - least[1], int64_t{point[2]} - least[2]}) <=
           kMostExtent;
  });
}

// The mesh with its points relative to `origin`.
std::unique_ptr<draco::Mesh> ToDraco(const LatticeMesh& mesh, const LatticePosition& origin) {
  auto out = std::make_unique<draco::Mesh>();
  out->set_num_points(static_cast<uint32_t>(mesh.points.size()));
  draco::GeometryAttribute position;
  position.Init(draco::GeometryAttribute::POSITION, nullptr, 3, draco::DT_INT32, false, 3 * sizeof(int32_t), 0);
  const int id = out->AddAttribute(position, true, static_cast<uint32_t>(mesh.points.size()));
  for (uint32_t i = 0; i < mesh.points.size(); ++i) {
    LatticePosition point = mesh.points[i];
    for (size_t axis = 0; axis < 3; ++axis) point[axis] -= origin[axis];
    out->attribute(id)->SetAttributeValue(draco::AttributeValueIndex(i), point.data());
  }
  out->SetNumFaces(mesh.triangles.size());
  for (uint32_t i = 0; i < mesh.triangles.size(); ++i) {
    draco::Mesh::Face face;
    for (size_t k = 0; k < 3; ++k) face[k] = static_cast<uint32_t>(mesh.triangles[i][k]);
    out->SetFace(draco::FaceIndex(i), face);
  }
  return out;
}

// The mesh's least corner and, relative to it, the mesh as a Draco stream; empty if Draco cannot encode it. Without the
// corner, the first point of a mesh far from zero would be a difference that costs the encoder a gigabyte.
std::string EncodeStream(const LatticeMesh& mesh) {
  if (mesh.points.empty() || !HasSmallSteps(mesh)) return "";
  const LatticePosition origin = LeastCorner(mesh);
  draco::Encoder encoder;
  encoder.SetEncodingMethod(draco::MESH_SEQUENTIAL_ENCODING);
  constexpr int kSpeed = 5;  // 0 is the smallest result, 10 the quickest; it hardly matters in sequential encoding
  encoder.SetSpeedOptions(kSpeed, kSpeed);
  const draco::Status predicted =
      encoder.SetAttributePredictionScheme(draco::GeometryAttribute::POSITION, draco::PREDICTION_DIFFERENCE);
  draco::EncoderBuffer buffer;
  if (!predicted.ok() || !encoder.EncodeMeshToBuffer(*ToDraco(mesh, origin), &buffer).ok()) return "";
  std::string out;
  out.reserve(kOriginBytes + buffer.size());
  for (const int32_t coordinate : origin) AppendUint32(static_cast<uint32_t>(coordinate), out);
  out.append(buffer.data(), buffer.size());
  return out;
}

// Copies a decoded mesh, trusting nothing about it.
absl::StatusOr<LatticeMesh> FromDraco(const draco::Mesh& decoded, const DracoCounts& counts,
                                      const LatticePosition& origin) {
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
    LatticePosition point;
    position.GetValue(value, point.data());
    for (size_t axis = 0; axis < 3; ++axis) {
      const int64_t coordinate = int64_t{point[axis]} + origin[axis];
      if (coordinate != static_cast<int32_t>(coordinate)) return bad;
      mesh.points[i][axis] = static_cast<int32_t>(coordinate);
    }
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

absl::StatusOr<LatticeMesh> DecodeStream(std::string_view bytes, const DracoLimits& limits) {
  if (bytes.size() < kOriginBytes) return absl::InvalidArgumentError("lattice mesh: expected a least corner");
  LatticePosition origin;
  for (size_t axis = 0; axis < 3; ++axis) origin[axis] = static_cast<int32_t>(LoadUint32(bytes.data() + 4 * axis));
  const std::string_view stream = bytes.substr(kOriginBytes);
  TILEMEND_ASSIGN_OR_RETURN(const DracoCounts counts, CheckDracoStream(stream, limits));
  draco::DecoderBuffer buffer;
  buffer.Init(stream.data(), stream.size());
  draco::Decoder decoder;
  auto decoded = decoder.DecodeMeshFromBuffer(&buffer);
  if (!decoded.ok()) {
    return absl::InvalidArgumentError(absl::StrCat("Draco stream: ", decoded.status().error_msg_string()));
  }
  return FromDraco(*decoded.value(), counts, origin);
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
