#include "client/mesh/array_mesh.h"

#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>

#include "absl/strings/str_cat.h"
#include "common/mesh/clear_area.h"
#include "common/util/status_macros.h"
#include "worker/survey/survey.h"
#include "worker/weld/weld_rims.h"

namespace tilemend {
namespace {

constexpr double kMaxCoordinate = 1e9;  // as of files (common/codec/mesh_file.h)
constexpr auto kMaxRows = static_cast<size_t>(std::numeric_limits<int32_t>::max());

absl::Status CheckRows(const char* array, size_t rows) {
  if (rows <= kMaxRows) return absl::OkStatus();
  return absl::InvalidArgumentError(absl::StrCat(array, ": ", rows, " rows; expected at most ", kMaxRows));
}

template <typename Number>
absl::StatusOr<std::vector<Point3>> PointsOf(std::span<const Number> numbers) {
  const size_t rows = numbers.size() / 3;
  if (rows == 0) return absl::InvalidArgumentError("vertices: there are none");
  TILEMEND_RETURN_IF_ERROR(CheckRows("vertices", rows));
  std::vector<Point3> points;
  points.reserve(rows);
  for (size_t i = 0; i < rows; ++i) {
    const Point3 p(numbers[3 * i], numbers[3 * i + 1], numbers[3 * i + 2]);
    for (int k = 0; k < 3; ++k) {
      if (std::isfinite(p[k]) && std::abs(p[k]) <= kMaxCoordinate) continue;
      return absl::InvalidArgumentError(
          absl::StrCat("vertices[", i, ", ", k, "] is ", p[k], ": expected a finite number between -1e9 and 1e9"));
    }
    points.push_back(p);
  }
  return points;
}

template <typename Index>
absl::StatusOr<std::vector<Triangle>> TrianglesOf(std::span<const Index> indices, size_t vertices) {
  const size_t rows = indices.size() / 3;
  TILEMEND_RETURN_IF_ERROR(CheckRows("faces", rows));
  std::vector<Triangle> triangles(rows);
  for (size_t i = 0; i < indices.size(); ++i) {
    const Index index = indices[i];
    if (index < 0 || static_cast<uint64_t>(index) >= vertices) {
      return absl::InvalidArgumentError(absl::StrCat("faces[", i / 3, ", ", i % 3, "] is ", index,
                                                     ": expected an index from 0 to ", vertices - 1, ", as there are ",
                                                     vertices, " vertices"));
    }
    triangles[i / 3][i % 3] = static_cast<int32_t>(index);
  }
  return triangles;
}

}  // namespace

absl::StatusOr<ArrayMesh> ArrayMesh::Make(const VertexNumbers& vertices, const FaceNumbers& faces) {
  TriMesh mesh;
  TILEMEND_ASSIGN_OR_RETURN(mesh.points, std::visit([](auto numbers) { return PointsOf(numbers); }, vertices));
  TILEMEND_ASSIGN_OR_RETURN(mesh.triangles,
                            std::visit([&](auto indices) { return TrianglesOf(indices, mesh.points.size()); }, faces));
  const bool is_float32 = std::holds_alternative<std::span<const float>>(vertices);
  return ArrayMesh(std::move(mesh), is_float32 ? NumberType::kFloat32 : NumberType::kFloat64);
}

absl::StatusOr<LookSurvey> ArrayMesh::Survey(NoFaces) const {
  return LookSurvey{SurveyTile(mesh_, number_type_ == NumberType::kFloat32, PieceAreas::kYes), {}, {}};
}

absl::StatusOr<WeldRecord> ArrayMesh::Weld(double tolerance) {
  tilemend::Weld weld = WeldRims(mesh_, {}, tolerance, true);
  mesh_.triangles = std::move(weld.triangles);  // the new halves of split faces count as new, as in files
  return std::move(weld.record);
}

absl::StatusOr<std::vector<int64_t>> ArrayMesh::Clear(std::span<const ClearArea> areas) {
  const std::vector<int32_t> cleared_by = AreasThatClear(mesh_, areas);
  std::vector<int64_t> cleared(areas.size(), 0);
  std::vector<Triangle> kept;
  for (size_t t = 0; t < cleared_by.size(); ++t) {
    if (cleared_by[t] < 0) {
      kept.push_back(mesh_.triangles[t]);
    } else {
      ++cleared[static_cast<size_t>(cleared_by[t])];
    }
  }
  mesh_.triangles = std::move(kept);
  originals_ = mesh_.triangles.size();
  return cleared;
}

absl::Status ArrayMesh::Append(const FilePatch& patch) {
  TILEMEND_RETURN_IF_ERROR(CheckRows("vertices, with new ones", mesh_.points.size() + patch.new_points.size()));
  TILEMEND_RETURN_IF_ERROR(CheckRows("faces, with new ones", mesh_.triangles.size() + patch.triangles.size()));
  // Not twice as much: the caller of Python keeps these arrays.
  mesh_.points.reserve(mesh_.points.size() + patch.new_points.size());
  mesh_.triangles.reserve(mesh_.triangles.size() + patch.triangles.size());
  for (const Point3& p : patch.new_points) mesh_.points.push_back(RoundedTo(number_type_, p));
  mesh_.triangles.insert(mesh_.triangles.end(), patch.triangles.begin(), patch.triangles.end());
  return absl::OkStatus();
}

}  // namespace tilemend
