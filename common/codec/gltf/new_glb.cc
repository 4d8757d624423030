#include "common/codec/gltf/new_glb.h"

#include <Eigen/Core>
#include <utility>
#include <vector>

#include "absl/status/status.h"
#include "absl/strings/str_cat.h"
#include "common/codec/gltf/gltf_builder.h"
#include "common/codec/gltf/gltf_container.h"

namespace tilemend {

absl::StatusOr<std::string> NewGlb(std::span<const GltfPatch> surfaces, const std::string& name) {
  GltfContainer container;
  container.has_bin = true;
  OrderedJson json = {{"asset", {{"version", "2.0"}, {"generator", "tilemend"}}},
                      {"extensionsUsed", OrderedJson::array({"KHR_materials_unlit"})},
                      {"scene", 0},
                      {"scenes", OrderedJson::array({{{"nodes", OrderedJson::array({0})}}})}};
  OrderedJson children = OrderedJson::array();
  for (size_t k = 1; k <= surfaces.size(); ++k) children.push_back(k);
  // From z up to y up, column by column.
  json["nodes"].push_back(
      {{"matrix", {1, 0, 0, 0, 0, 0, -1, 0, 0, 1, 0, 0, 0, 0, 0, 1}}, {"children", std::move(children)}});
  GltfBuilder builder(json, 0);
  for (const GltfPatch& surface : surfaces) {
    if (surface.points.empty() || surface.triangles.empty()) {
      return absl::InvalidArgumentError(absl::StrCat(name, ": a surface without triangles"));
    }
    std::vector<Eigen::Vector3f> points;
    points.reserve(surface.points.size());
    for (const Point3& point : surface.points) points.push_back(point.cast<float>());
    const int64_t mesh =
        builder.AddPatchMesh(surface, points, surface.triangles, {.is_unlit = true, .is_double_sided = true});
    builder.Append("nodes", {{"mesh", mesh}});
  }
  builder.SetBufferLength();
  return WriteGltfContainer(container, json, builder.added(), name);
}

}  // namespace tilemend
