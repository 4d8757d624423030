#include "common/assemble/assemble.h"

#include <set>
#include <string>
#include <utility>

#include "common/mesh/vertex_lists.h"

namespace tilemend {
namespace {

class PatchMerger {
 public:
  PatchMerger(std::span<const RimVertex> vertices, CellId cell, int32_t tile_vertices, const FillColours& colours)
      : vertices_(vertices),
        cell_(cell),
        tile_vertices_(tile_vertices),
        colours_(colours),
        number_(vertices.size(), -1) {}

  void Add(const HolePatch& patch) {
    colour_ = colours_.of_holes.at(patch.hole);
    std::string material = MaterialName(colour_);
    if (result_.materials.empty() || result_.materials.back().material != material) {
      result_.materials.push_back(
          {static_cast<int32_t>(result_.triangles.size()), std::move(material), colour_.colour});
    }
    std::vector<int32_t> own(patch.new_points.size(), -1);
    for (const Triangle& t : patch.triangles) {
      Triangle out;
      for (int k = 0; k < 3; ++k) {
        out[k] = t[k] >= 0 ? RimNumber(t[k]) : NewNumber(patch.new_points[-1 - t[k]], own[-1 - t[k]]);
      }
      result_.triangles.push_back(out);
    }
  }

  FilePatch Finish() {
    SpreadLikes();
    return std::move(result_);
  }

 private:
  int32_t RimNumber(int32_t v) {
    const RimVertex& vertex = vertices_[v];
    if (vertex.index >= 0 && vertex.tile == cell_ && tile_vertices_ > 0) return vertex.index;
    return NewNumber(vertex.position, number_[v]);
  }

  int32_t NewNumber(const Point3& p, int32_t& number) {
    if (number < 0) {
      number = tile_vertices_ + static_cast<int32_t>(result_.new_points.size());
      result_.new_points.push_back(p);
      result_.like.push_back(-1);
      if (colours_.on_vertices) result_.colours.push_back(colour_.colour);
    }
    return number;
  }

  // Hands the tile's own vertices on from corner to corner, ring by ring from the rim.
  void SpreadLikes() {
    const auto like = [&](int32_t v) { return v < tile_vertices_ ? v : result_.like[v - tile_vertices_]; };
    const std::vector<Triangle>& triangles = result_.triangles;
    std::vector<int32_t> ring;  // triangles
    for (size_t t = 0; t < triangles.size(); ++t) {
      for (const int32_t v : triangles[t]) {
        if (v < tile_vertices_) ring.push_back(static_cast<int32_t>(t));
      }
    }
    const VertexLists around(result_.like.size(), [&](const auto& use) {
      for (size_t t = 0; t < triangles.size(); ++t) {
        for (const int32_t v : triangles[t]) {
          if (v >= tile_vertices_) use(v - tile_vertices_, static_cast<int32_t>(t));
        }
      }
    });
    while (!ring.empty()) {
      std::vector<int32_t> next_ring;
      for (const int32_t t : ring) {
        int32_t known = -1;
        for (const int32_t v : triangles[t]) known = known < 0 ? like(v) : known;
        for (const int32_t v : triangles[t]) {
          if (like(v) >= 0) continue;
          result_.like[v - tile_vertices_] = known;
          const std::span<const int32_t> reached = around.Of(v - tile_vertices_);
          next_ring.insert(next_ring.end(), reached.begin(), reached.end());
        }
      }
      ring = std::move(next_ring);
    }
  }

  std::span<const RimVertex> vertices_;
  const CellId cell_;
  const int32_t tile_vertices_;
  const FillColours& colours_;
  FillColour colour_;  // of the patch that is being added
  std::vector<int32_t> number_;
  FilePatch result_;
};

}  // namespace

FilePatch MergePatches(std::span<const RimVertex> vertices, std::span<const HolePatch> patches, CellId cell,
                       int32_t tile_vertices, const FillColours& colours) {
  PatchMerger merger(vertices, cell, tile_vertices, colours);
  for (const HolePatch& patch : patches) {
    if (patch.failure.empty()) merger.Add(patch);
  }
  return merger.Finish();
}

std::vector<FillMaterial> MaterialsOf(std::span<const HolePatch> patches, const FillColours& colours) {
  std::vector<FillMaterial> materials;
  std::set<std::string> names;
  for (const HolePatch& patch : patches) {
    if (!patch.failure.empty()) continue;
    const FillColour& colour = colours.of_holes.at(patch.hole);
    if (names.insert(MaterialName(colour)).second) materials.push_back({MaterialName(colour), colour.colour});
  }
  return materials;
}

}  // namespace tilemend
