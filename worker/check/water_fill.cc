#include "worker/check/water_fill.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "common/mesh/edge_key.h"
#include "common/mesh/position_index.h"
#include "common/mesh/triangle_shape.h"
#include "worker/check/fill_pieces.h"

namespace tilemend {
namespace {

constexpr double kWallNormal = 0.7;  // upward part of the normal: steeper than 45 degrees
constexpr double kUpright = 1e-3;    // upward part of the normal: a lattice of 2^-10 m on a wall that is 1 m long

// Connected added triangles.
struct FillPiece {
  std::vector<Triangle> triangles;  // welded vertices
  std::set<int32_t> inside;         // vertices that are on no boundary of the piece
  std::set<int32_t> seam;           // those on it that original surface does not have
  Eigen::AlignedBox2d box;
};

double Cross(const Point2& a, const Point2& b, const Point2& p) {
  return (b.x() - a.x()) * (p.y() - a.y()) - (b.y() - a.y()) * (p.x() - a.x());
}

class FillPieces {
 public:
  FillPieces(const TriMesh& tile, const std::vector<bool>& added) {
    std::vector<Triangle> triangles;
    for (size_t t = 0; t < tile.triangles.size(); ++t) {
      if (!added[t]) continue;
      Triangle& welded = triangles.emplace_back();
      for (size_t k = 0; k < 3; ++k) welded[k] = index_.Insert(tile.points[tile.triangles[t][k]]);
    }
    for (std::vector<Triangle>& piece : PiecesByEdges(triangles)) pieces_.push_back({std::move(piece), {}, {}, {}});
    for (FillPiece& piece : pieces_) {
      for (const Triangle& t : piece.triangles) {
        for (const int32_t v : t) piece.box.extend(At(v));
      }
    }
    const std::vector<bool> shore = ShoreOf(tile, added);
    for (FillPiece& piece : pieces_) {
      FindInside(piece);
      for (std::set<int32_t>* of : {&piece.inside, &piece.seam}) {
        std::erase_if(*of, [&](int32_t v) { return shore[static_cast<size_t>(v)]; });
      }
      LeaveOutWalls(piece);
    }
  }

  WaterFinding Check(const WaterHole& hole) const {
    WaterFinding best;
    for (const FillPiece& piece : pieces_) {
      if (!piece.box.contains(hole.centre)) continue;
      WaterFinding finding = CheckPiece(piece, hole);
      if (Covers(piece, hole.centre)) return finding;
      if (!best.is_found || finding.off.size() < best.off.size()) best = std::move(finding);
    }
    return best;
  }

 private:
  Point2 At(int32_t v) const { return index_.positions()[v].head<2>(); }

  // Of each vertex of the fills: whether original surface has it.
  std::vector<bool> ShoreOf(const TriMesh& tile, const std::vector<bool>& added) const {
    std::vector<bool> shore(static_cast<size_t>(index_.size()), false);
    for (size_t t = 0; t < tile.triangles.size(); ++t) {
      if (added[t]) continue;
      for (const int32_t corner : tile.triangles[t]) {
        const int32_t v = index_.Find(tile.points[corner]);
        if (v >= 0) shore[static_cast<size_t>(v)] = true;
      }
    }
    return shore;
  }

  // Takes vertices out that stand on a wall of the fill up to its boundary: all of their triangles are steep, and one
  // reaches the boundary. A wall goes up to its ends: what stands out above or below all around it is none of it,
  // unless a triangle there is upright.
  void LeaveOutWalls(FillPiece& piece) const {
    std::set<int32_t> level, beside, upright;
    std::map<int32_t, std::pair<double, double>> around;  // the lowest and the highest neighbour
    for (const Triangle& t : piece.triangles) {
      const Eigen::Vector3d normal = TwiceVectorArea(index_.positions(), t);
      const bool steep = normal.z() < kWallNormal * normal.norm();
      const bool at_boundary = std::any_of(t.begin(), t.end(), [&](int32_t v) { return !piece.inside.contains(v); });
      const bool stands = std::abs(normal.z()) <= kUpright * normal.norm();
      for (int k = 0; k < 3; ++k) {
        const int32_t v = t[k];
        if (!steep) level.insert(v);
        if (at_boundary) beside.insert(v);
        if (stands) upright.insert(v);
        auto& [lowest, highest] = around.try_emplace(v, INFINITY, -INFINITY).first->second;
        for (const int32_t other : {t[(k + 1) % 3], t[(k + 2) % 3]}) {
          lowest = std::min(lowest, index_.positions()[other].z());
          highest = std::max(highest, index_.positions()[other].z());
        }
      }
    }
    const auto is_wall = [&](int32_t v) {
      const double z = index_.positions()[v].z();
      const bool is_peak = z > around[v].second + kLevelTolerance || z < around[v].first - kLevelTolerance;
      return !level.contains(v) && beside.contains(v) && (!is_peak || upright.contains(v));
    };
    std::erase_if(piece.inside, is_wall);
    std::erase_if(piece.seam, is_wall);
  }

  static void FindInside(FillPiece& piece) {
    std::vector<uint64_t> edges;
    for (const Triangle& t : piece.triangles) {
      for (int k = 0; k < 3; ++k) {
        const int32_t a = t[k], b = t[(k + 1) % 3];
        edges.push_back(EdgeKey(std::min(a, b), std::max(a, b)));
        piece.inside.insert(a);
      }
    }
    std::sort(edges.begin(), edges.end());
    for (size_t i = 0, next = 0; i < edges.size(); i = next) {
      while (next < edges.size() && edges[next] == edges[i]) ++next;
      if (next - i != 1) continue;
      for (const uint64_t end : {edges[i] >> 32, edges[i] & 0xffffffffU}) {
        piece.inside.erase(static_cast<int32_t>(end));
        piece.seam.insert(static_cast<int32_t>(end));
      }
    }
  }

  bool Covers(const FillPiece& piece, const Point2& p) const {
    return std::any_of(piece.triangles.begin(), piece.triangles.end(), [&](const Triangle& t) {
      const double a = Cross(At(t[0]), At(t[1]), p), b = Cross(At(t[1]), At(t[2]), p), c = Cross(At(t[2]), At(t[0]), p);
      return a >= 0 && b >= 0 && c >= 0 && a + b + c > 0;
    });
  }

  WaterFinding CheckPiece(const FillPiece& piece, const WaterHole& hole) const {
    WaterFinding finding{true, std::ssize(piece.inside), {}};
    const auto add_off = [&](const std::set<int32_t>& vertices, std::vector<Point3>& off) {
      for (const int32_t v : vertices) {
        const Point3& p = index_.positions()[v];
        if (p.z() < hole.lowest - kLevelTolerance || p.z() > hole.highest + kLevelTolerance) off.push_back(p);
      }
    };
    add_off(piece.inside, finding.off);
    add_off(piece.seam, finding.off_at_seam);
    return finding;
  }

  PositionIndex index_;
  std::vector<FillPiece> pieces_;
};

}  // namespace

std::vector<WaterFinding> CheckWaterFills(const TriMesh& tile, const std::vector<bool>& added,
                                          const std::vector<WaterHole>& holes) {
  std::vector<WaterFinding> findings;
  if (holes.empty()) return findings;
  const FillPieces pieces(tile, added);
  for (const WaterHole& hole : holes) findings.push_back(pieces.Check(hole));
  return findings;
}

}  // namespace tilemend
