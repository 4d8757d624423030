#include "worker/check/water_fill.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "common/mesh/disjoint_sets.h"
#include "common/mesh/edge_key.h"
#include "common/mesh/position_index.h"

namespace tilemend {
namespace {

// Connected added triangles.
struct FillPiece {
  std::vector<Triangle> triangles;  // welded vertices
  std::set<int32_t> inside;         // vertices that are on no boundary of the piece
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
    DisjointSets sets(index_.size());
    for (const Triangle& t : triangles) {
      sets.Join(t[0], t[1]);
      sets.Join(t[0], t[2]);
    }
    std::map<int32_t, FillPiece> by_vertex;
    for (const Triangle& t : triangles) {
      FillPiece& piece = by_vertex[sets.LowestOf(t[0])];
      piece.triangles.push_back(t);
      for (const int32_t v : t) piece.box.extend(At(v));
    }
    for (auto& [lowest, piece] : by_vertex) pieces_.push_back(std::move(piece));
    for (FillPiece& piece : pieces_) FindInside(piece);
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
      piece.inside.erase(static_cast<int32_t>(edges[i] >> 32));
      piece.inside.erase(static_cast<int32_t>(edges[i] & 0xffffffffU));
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
    for (const int32_t v : piece.inside) {
      const Point3& p = index_.positions()[v];
      if (p.z() < hole.lowest - kLevelTolerance || p.z() > hole.highest + kLevelTolerance) finding.off.push_back(p);
    }
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
