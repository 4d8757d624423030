#include "tests/support/output_checks.h"

#include <gtest/gtest.h>

#include <cstring>
#include <filesystem>
#include <utility>

#include "absl/strings/match.h"
#include "absl/strings/str_cat.h"
#include "common/util/files.h"

namespace tilemend {
namespace {

namespace fs = std::filesystem;
using Edge = std::pair<int32_t, int32_t>;

// Whether both points lie on one side of the rectangle of all cells.
bool OnRim(const Point3& a, const Point3& b, const SceneMakerOptions& options) {
  const double size[2] = {options.cols * options.cell_size, options.rows * options.cell_size};
  for (const int axis : {0, 1}) {
    for (const double line : {0.0, size[axis]}) {
      if (a[axis] == line && b[axis] == line) return true;
    }
  }
  return false;
}

bool SameBits(const Point3& a, const Point3& b) { return std::memcmp(a.data(), b.data(), 3 * sizeof(double)) == 0; }

}  // namespace

SceneMakerOptions SmallScene(Cut cut) {
  SceneMakerOptions options;
  options.cols = 4;
  options.rows = 3;
  options.cell_size = 20;
  options.spacing = 1.25;
  options.relief = 4;
  options.cut = cut;
  options.ellipses = {{{40, 20}, {11, 8}}, {{20, 50}, {9, 3}}, {{70, 10}, {3, 2}}, {{70, 50}, {2, 3}}};
  return options;
}

std::string WriteMade(const SceneMakerOptions& options, const std::string& folder) {
  const absl::Status status = WriteScene(MakeScene(options), folder);
  EXPECT_TRUE(status.ok()) << status;
  return folder;
}

std::map<std::string, std::string> FilesBelow(const std::string& folder) {
  std::map<std::string, std::string> files;
  std::error_code error;
  for (fs::recursive_directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
    const std::string name = at->path().lexically_relative(folder).string();
    if (!at->is_directory()) {
      files[name] = ReadFile(at->path().string()).value_or("unreadable");
    } else if (fs::is_empty(at->path())) {
      files[name + "/"] = "";
    }
  }
  return files;
}

std::map<std::string, std::string> TilesBelow(const std::string& folder) {
  auto files = FilesBelow(folder);
  std::erase_if(files, [](const auto& file) { return !absl::EndsWith(file.first, ".ply"); });
  return files;
}

nlohmann::json ReportOf(const std::string& out) {
  return nlohmann::json::parse(ReadFile(out + "/report.json").value_or(""), nullptr, false);
}

void ExpectOriginalsKept(const std::string& scene, const std::string& out) {
  const auto before = TilesBelow(scene), after = TilesBelow(out);
  ASSERT_FALSE(before.empty());
  for (const auto& [name, bytes] : before) {
    ASSERT_TRUE(after.contains(name)) << name;
    const auto original = ParseMesh(MeshFormat::kPly, bytes, name);
    const auto filled = ParseMesh(MeshFormat::kPly, after.at(name), name);
    ASSERT_TRUE(original.ok() && filled.ok()) << original.status() << filled.status();
    const TriMesh &a = original->mesh, &b = filled->mesh;
    ASSERT_LE(a.points.size(), b.points.size()) << name;
    ASSERT_LE(a.triangles.size(), b.triangles.size()) << name;
    EXPECT_EQ(original->number_type, filled->number_type);
    for (size_t i = 0; i < a.points.size(); ++i) ASSERT_TRUE(SameBits(a.points[i], b.points[i])) << name << " " << i;
    EXPECT_TRUE(std::equal(a.triangles.begin(), a.triangles.end(), b.triangles.begin())) << name;
  }
}

void ExpectClosed(const SceneMakerOptions& options, const std::string& out) {
  std::map<std::array<double, 3>, int32_t> welded;
  std::vector<Point3> points;
  std::map<Edge, int> directed;
  for (const auto& [name, bytes] : TilesBelow(out)) {
    const auto file = ParseMesh(MeshFormat::kPly, bytes, name);
    ASSERT_TRUE(file.ok()) << file.status();
    std::vector<int32_t> number;
    for (const Point3& p : file->mesh.points) {
      const auto [at, fresh] = welded.emplace(std::array{p.x(), p.y(), p.z()}, static_cast<int32_t>(points.size()));
      if (fresh) points.push_back(p);
      number.push_back(at->second);
    }
    for (const Triangle& t : file->mesh.triangles) {
      for (int k = 0; k < 3; ++k) ++directed[{number[t[k]], number[t[(k + 1) % 3]]}];
    }
  }
  int open = 0, doubled = 0;
  for (const auto& [edge, count] : directed) {
    doubled += count > 1 ? 1 : 0;
    const bool matched = directed.contains({edge.second, edge.first});
    open += !matched && !OnRim(points[edge.first], points[edge.second], options) ? 1 : 0;
  }
  EXPECT_EQ(open, 0) << "edges with one triangle inside the area";
  EXPECT_EQ(doubled, 0) << "edges used twice in one direction";
}

}  // namespace tilemend
