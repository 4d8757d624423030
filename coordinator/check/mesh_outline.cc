#include "coordinator/check/mesh_outline.h"

#include <algorithm>
#include <bit>
#include <optional>

#include "common/mesh/position_index.h"
#include "common/mesh/triangle_copies.h"

namespace tilemend {
namespace {

uint64_t Mix(uint64_t x) {  // splitmix64's finaliser: a bijection
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ULL;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebULL;
  return x ^ (x >> 31);
}

uint64_t HashOf(const Point3& p, uint64_t key) {
  uint64_t hash = key;
  for (int axis = 0; axis < 3; ++axis) hash = Mix(hash + std::bit_cast<uint64_t>(p[axis] + 0.0));  // -0.0 is 0.0
  return hash;
}

// The same for both directions.
uint64_t HashOfEdge(uint64_t a, uint64_t b) { return Mix((a + b) ^ std::rotl(a * b, 32)); }

}  // namespace

uint64_t OutlineSumOfEdge(const Point3& a, const Point3& b, uint64_t key) {
  return HashOfEdge(HashOf(a, key), HashOf(b, key));
}

OutlineSum OutlineSumOf(const TriMesh& mesh, uint64_t key) {
  std::vector<uint64_t> hash;
  hash.reserve(mesh.points.size());
  for (const Point3& p : mesh.points) hash.push_back(HashOf(p, key));
  OutlineSum result;
  for (const Triangle& t : mesh.triangles) {
    const uint64_t a = hash[t[0]], b = hash[t[1]], c = hash[t[2]];
    if (a == b || b == c || a == c) {
      ++result.flat_triangles;
      continue;
    }
    result.sum ^= HashOfEdge(a, b) ^ HashOfEdge(b, c) ^ HashOfEdge(c, a);
  }
  return result;
}

std::vector<OutlineEdge> OutlineOf(const TriMesh& mesh) {
  PositionIndex index;
  std::vector<int32_t> lowest;  // vertex at each position
  std::vector<int32_t> number;  // the lowest vertex at the position of each
  number.reserve(mesh.points.size());
  for (size_t v = 0; v < mesh.points.size(); ++v) {
    const auto position = static_cast<size_t>(index.Insert(mesh.points[v]));
    if (position == lowest.size()) lowest.push_back(static_cast<int32_t>(v));
    number.push_back(lowest[position]);
  }
  const std::optional<std::vector<Triangle>> once = WithoutCopies(mesh);
  std::vector<OutlineEdge> edges;
  edges.reserve(3 * mesh.triangles.size());
  for (const Triangle& t : once ? *once : mesh.triangles) {
    const int32_t n[3] = {number[t[0]], number[t[1]], number[t[2]]};
    if (n[0] == n[1] || n[1] == n[2] || n[0] == n[2]) continue;
    for (int k = 0; k < 3; ++k) edges.emplace_back(std::minmax(n[k], n[(k + 1) % 3]));
  }
  std::sort(edges.begin(), edges.end());
  std::vector<OutlineEdge> outline;
  for (size_t i = 0; i < edges.size();) {
    size_t j = i;
    while (j < edges.size() && edges[j] == edges[i]) ++j;
    if (j - i == 1) outline.push_back(edges[i]);
    i = j;
  }
  return outline;
}

}  // namespace tilemend
