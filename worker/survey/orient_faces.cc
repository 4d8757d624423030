#include "worker/survey/orient_faces.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

#include "common/mesh/edge_key.h"
#include "common/mesh/position_index.h"

namespace tilemend {
namespace {

// The face across an edge, and whether it is turned the other way.
struct Neighbour {
  int32_t face = -1;  // none
  bool disagrees = false;
};

// One side of an edge: the face there, which of its edges it is, and whether it runs from the lower vertex.
struct EdgeSide {
  uint64_t key;
  int32_t face;
  int8_t edge;
  bool upwards;
};

std::vector<EdgeSide> SortedSides(const PointRows& points, const std::vector<Triangle>& faces) {
  PositionIndex index;
  std::vector<int32_t> weld;
  weld.reserve(points.size());
  for (const Point3& p : points) weld.push_back(index.Insert(p));
  std::vector<EdgeSide> sides;
  sides.reserve(3 * faces.size());
  for (size_t f = 0; f < faces.size(); ++f) {
    const Triangle& t = faces[f];
    const std::array<int32_t, 3> w = {weld[t[0]], weld[t[1]], weld[t[2]]};
    if (w[0] == w[1] || w[1] == w[2] || w[2] == w[0]) continue;
    for (int8_t k = 0; k < 3; ++k) {
      const int32_t from = w[k], to = w[(k + 1) % 3];
      sides.push_back({EdgeKey(std::min(from, to), std::max(from, to)), static_cast<int32_t>(f), k, from < to});
    }
  }
  std::ranges::sort(sides, {}, [](const EdgeSide& s) { return std::pair(s.key, s.face); });
  return sides;
}

std::vector<std::array<Neighbour, 3>> NeighboursOf(const PointRows& points, const std::vector<Triangle>& faces) {
  std::vector<std::array<Neighbour, 3>> neighbours(faces.size());
  const std::vector<EdgeSide> sides = SortedSides(points, faces);
  for (size_t i = 0; i < sides.size();) {
    size_t j = i + 1;
    while (j < sides.size() && sides[j].key == sides[i].key) ++j;
    if (j - i == 2) {
      const EdgeSide &a = sides[i], &b = sides[i + 1];
      const bool disagrees = a.upwards == b.upwards;
      neighbours[a.face][a.edge] = {b.face, disagrees};
      neighbours[b.face][b.edge] = {a.face, disagrees};
    }
    i = j;
  }
  return neighbours;
}

enum class Side : uint8_t { kUnknown, kFront, kBack };

Side Across(Side side, bool disagrees) {
  if (!disagrees) return side;
  return side == Side::kFront ? Side::kBack : Side::kFront;
}

// The faces of the piece of `first`, with their sides in `sides`; none if it has one side only.
std::vector<int32_t> TakePiece(int32_t first, const std::vector<std::array<Neighbour, 3>>& neighbours,
                               std::vector<Side>& sides) {
  std::vector<int32_t> piece = {first};
  sides[first] = Side::kFront;
  bool has_two_sides = true;
  for (size_t next = 0; next < piece.size(); ++next) {
    const int32_t face = piece[next];
    for (const auto& [other, disagrees] : neighbours[face]) {
      if (other < 0) continue;
      const Side side = Across(sides[face], disagrees);
      if (sides[other] == Side::kUnknown) {
        sides[other] = side;
        piece.push_back(other);
      }
      has_two_sides = has_two_sides && sides[other] == side;
    }
  }
  return has_two_sides ? piece : std::vector<int32_t>();
}

}  // namespace

int64_t OrientFaces(const PointRows& points, std::vector<Triangle>& faces) {
  const std::vector<std::array<Neighbour, 3>> neighbours = NeighboursOf(points, faces);
  std::vector<Side> sides(faces.size(), Side::kUnknown);
  int64_t turned = 0;
  for (size_t f = 0; f < sides.size(); ++f) {
    if (sides[f] != Side::kUnknown) continue;
    const std::vector<int32_t> piece = TakePiece(static_cast<int32_t>(f), neighbours, sides);
    const auto backs = std::ranges::count_if(piece, [&](int32_t face) { return sides[face] == Side::kBack; });
    const Side wrong = 2 * backs > std::ssize(piece) ? Side::kFront : Side::kBack;
    for (const int32_t face : piece) {
      if (sides[face] != wrong) continue;
      std::swap(faces[face][1], faces[face][2]);
      ++turned;
    }
  }
  return turned;
}

}  // namespace tilemend
