#include "client/mesh/array_mesh.h"

#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

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
absl::Status CheckVertices(std::span<const Number> numbers) {
  if (numbers.empty()) return absl::InvalidArgumentError("vertices: there are none");
  TILEMEND_RETURN_IF_ERROR(CheckRows("vertices", numbers.size() / 3));
  for (size_t i = 0; i < numbers.size(); ++i) {
    if (std::isfinite(numbers[i]) && std::abs(numbers[i]) <= kMaxCoordinate) continue;
    return absl::InvalidArgumentError(absl::StrCat("vertices[", i / 3, ", ", i % 3, "] is ", numbers[i],
                                                   ": expected a finite number between -1e9 and 1e9"));
  }
  return absl::OkStatus();
}

template <typename Index>
absl::Status CheckFaces(std::span<const Index> indices, size_t vertices) {
  TILEMEND_RETURN_IF_ERROR(CheckRows("faces", indices.size() / 3));
  for (size_t i = 0; i < indices.size(); ++i) {
    if (indices[i] >= 0 && static_cast<uint64_t>(indices[i]) < vertices) continue;
    return absl::InvalidArgumentError(absl::StrCat("faces[", i / 3, ", ", i % 3, "] is ", indices[i],
                                                   ": expected an index from 0 to ", vertices - 1, ", as there are ",
                                                   vertices, " vertices"));
  }
  return absl::OkStatus();
}

template <typename Number>
std::vector<Number> NumbersOf(const PointRows& points, std::span<const Point3> new_points) {
  std::vector<Number> numbers;
  numbers.reserve(3 * (points.size() + new_points.size()));
  const auto add = [&](const Point3& p) {
    for (const double x : p) numbers.push_back(static_cast<Number>(x));
  };
  for (const Point3& p : points) add(p);
  for (const Point3& p : new_points) add(p);
  return numbers;
}

}  // namespace

absl::StatusOr<ArrayMesh> ArrayMesh::Make(const VertexNumbers& vertices, const FaceNumbers& faces) {
  TILEMEND_RETURN_IF_ERROR(std::visit([](auto numbers) { return CheckVertices(numbers); }, vertices));
  const PointRows points = std::visit([](auto numbers) { return PointRows(numbers); }, vertices);
  TILEMEND_RETURN_IF_ERROR(std::visit([&](auto indices) { return CheckFaces(indices, points.size()); }, faces));
  return ArrayMesh({points, std::visit([](auto indices) { return TriangleRows(indices); }, faces)});
}

MeshView ArrayMesh::View() const { return {given_.points, edited_ ? TriangleRows(*edited_) : given_.triangles}; }

absl::StatusOr<LookSurvey> ArrayMesh::Survey(NoFaces) const {
  return LookSurvey{SurveyTile(View(), given_.points.is_float32(), PieceAreas::kYes), {}, {}};
}

absl::StatusOr<WeldRecord> ArrayMesh::Weld(double tolerance) {
  tilemend::Weld weld = WeldRims(View(), {}, tolerance, true);
  edited_ = std::move(weld.triangles);  // the new halves of split faces count as new, as in files
  return std::move(weld.record);
}

absl::StatusOr<std::vector<int64_t>> ArrayMesh::Clear(std::span<const ClearArea> areas) {
  const TriangleRows triangles = View().triangles;
  const std::vector<int32_t> cleared_by = AreasThatClear(View(), areas);
  std::vector<int64_t> cleared(areas.size(), 0);
  std::vector<Triangle> kept;
  for (size_t t = 0; t < cleared_by.size(); ++t) {
    if (cleared_by[t] < 0) {
      kept.push_back(triangles[t]);
    } else {
      ++cleared[static_cast<size_t>(cleared_by[t])];
    }
  }
  originals_ = kept.size();
  edited_ = std::move(kept);
  return cleared;
}

absl::Status ArrayMesh::Append(const FilePatch& patch) {
  const MeshView view = View();
  const size_t vertices = view.points.size() + new_points_.size() + patch.new_points.size();
  const size_t faces = view.triangles.size() + new_triangles_.size() + patch.triangles.size();
  TILEMEND_RETURN_IF_ERROR(CheckRows("vertices, with new ones", vertices));
  TILEMEND_RETURN_IF_ERROR(CheckRows("faces, with new ones", faces));
  new_points_.insert(new_points_.end(), patch.new_points.begin(), patch.new_points.end());
  new_triangles_.insert(new_triangles_.end(), patch.triangles.begin(), patch.triangles.end());
  return absl::OkStatus();
}

FilledArrays ArrayMesh::Filled() const {
  const MeshView view = View();
  FilledArrays filled;
  if (view.points.is_float32()) {
    filled.vertices = NumbersOf<float>(view.points, new_points_);
  } else {
    filled.vertices = NumbersOf<double>(view.points, new_points_);
  }
  filled.faces.reserve(3 * (view.triangles.size() + new_triangles_.size()));
  const auto add = [&](const Triangle& t) { filled.faces.insert(filled.faces.end(), t.begin(), t.end()); };
  for (const Triangle& t : view.triangles) add(t);
  for (const Triangle& t : new_triangles_) add(t);
  filled.originals = originals_;
  return filled;
}

}  // namespace tilemend
