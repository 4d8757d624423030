#include "tests/fuzz/append_property.h"

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <vector>

#include "common/mesh/rounding.h"

namespace tilemend {
namespace {

FilePatch SmallPatch(int32_t vertices) {
  FilePatch patch;
  patch.new_points = {{0.1, -0.2, 0.3}, {1e9, 1e-300, -0.0}, {250.0009765625, 7, 1.0 / 3}};
  patch.like = {0, -1, vertices - 1};
  patch.triangles = {{0, vertices, vertices + 1}, {vertices, vertices + 1, vertices + 2}};
  return patch;
}

// Of a format without shared vertices: points that are equal become one vertex, wherever they stand.
std::string CornerViolation(const TriMesh& before, NumberType type, const FilePatch& patch, const TriMesh& after) {
  std::vector<Point3> points = before.points;
  for (const Point3& p : patch.new_points) points.push_back(RoundedTo(type, p));
  std::vector<Triangle> triangles = before.triangles;
  triangles.insert(triangles.end(), patch.triangles.begin(), patch.triangles.end());
  if (after.triangles.size() != triangles.size()) return "other number of triangles";
  for (size_t i = 0; i < triangles.size(); ++i) {
    for (int k = 0; k < 3; ++k) {
      if (points[triangles[i][k]] != after.points[after.triangles[i][k]])
        return "triangle " + std::to_string(i) + " is different";
    }
  }
  return "";
}

bool SameBits(const Point3& a, const Point3& b) { return std::memcmp(a.data(), b.data(), 3 * sizeof(double)) == 0; }

}  // namespace

std::string AppendPropertyViolation(MeshFormat format, std::string_view bytes) {
  const absl::StatusOr<MeshFile> before = ParseMesh(format, bytes, "input");
  if (!before.ok()) {
    return before.status().code() == absl::StatusCode::kInvalidArgument ? "" : before.status().ToString();
  }
  const size_t vertices = before->mesh.points.size();
  const size_t triangles = before->mesh.triangles.size();
  const FilePatch patch = SmallPatch(static_cast<int32_t>(vertices));
  const absl::StatusOr<std::string> appended = AppendPatch(format, bytes, patch, "input");
  if (!appended.ok()) return "appending failed: " + appended.status().ToString();
  const absl::StatusOr<MeshFile> after = ParseMesh(format, *appended, "appended");
  if (!after.ok()) return "reading back failed: " + after.status().ToString();
  if (format == MeshFormat::kStl) return CornerViolation(before->mesh, before->number_type, patch, after->mesh);
  if (after->mesh.points.size() != vertices + patch.new_points.size()) return "other number of vertices";
  if (after->mesh.triangles.size() != triangles + patch.triangles.size()) return "other number of triangles";
  if (after->number_type != before->number_type) return "other number type";
  for (size_t i = 0; i < vertices; ++i) {
    if (!SameBits(before->mesh.points[i], after->mesh.points[i])) return "vertex " + std::to_string(i) + " changed";
  }
  for (size_t i = 0; i < patch.new_points.size(); ++i) {
    const Point3 wanted = RoundedTo(before->number_type, patch.new_points[i]);
    if (!SameBits(wanted, after->mesh.points[vertices + i])) return "new vertex " + std::to_string(i) + " is different";
  }
  for (size_t i = 0; i < triangles + patch.triangles.size(); ++i) {
    const Triangle& wanted = i < triangles ? before->mesh.triangles[i] : patch.triangles[i - triangles];
    if (wanted != after->mesh.triangles[i]) return "triangle " + std::to_string(i) + " is different";
  }
  return "";
}

void CheckAppendProperty(MeshFormat format, std::string_view bytes) {
  const std::string violation = AppendPropertyViolation(format, bytes);
  if (violation.empty()) return;
  std::fprintf(stderr, "%s\n", violation.c_str());
  std::abort();
}

}  // namespace tilemend
