// A patch whose triangles are taken out and put in.
#ifndef TILEMEND_WORKER_FILL_SPACE_PATCH_EDIT_H_
#define TILEMEND_WORKER_FILL_SPACE_PATCH_EDIT_H_

#include <Eigen/Geometry>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "common/mesh/box_tree.h"
#include "worker/fill/hole/local_patch.h"

namespace tilemend {

using Piece = std::vector<int32_t>;  // triangles that hang together at edges, rising

inline constexpr double kFacesUp = 0.5;  // cosine
bool FacesUp(const SpaceTriangle& triangle);

// How far a triangle is above p, along the vertical; nullopt where it is neither above nor below p.
std::optional<double> HeightOver(const SpaceTriangle& triangle, const Point3& p);

// Over the boxes of triangles.
BoxTree TreeOver(std::span<const SpaceTriangle> triangles);

// New triangles come behind those that were there.
class PatchEdit {
 public:
  // Both must outlive it.
  PatchEdit(const LocalHole& hole, LocalPatch& patch);

  // Makes the patch what it has become.
  void Finish();

  int32_t count() const { return static_cast<int32_t>(patch_.triangles.size()); }
  const Triangle& Corners(int32_t t) const { return patch_.triangles[t]; }
  const SpaceTriangle& Placed(int32_t t) const { return placed_[t]; }
  Point3 At(int32_t v) const { return v < hole_.size() ? hole_.positions[v] : patch_.new_points[v - hole_.size()]; }
  const std::vector<SpaceTriangle>& AllPlaced() const { return placed_; }
  SpaceTriangle Place(const Triangle& t) const { return {At(t[0]), At(t[1]), At(t[2])}; }

  int32_t AddPoint(const Point3& p);
  void PutIn(const Triangle& t);
  void TakeOut(int32_t t);
  // All from triangle `first` on, which was put in.
  void TakeOutFrom(int32_t first);
  void PutBack(int32_t t);
  // Forgets the triangles from `first` on, which were put in and taken out.
  void DropFrom(int32_t first);

  bool IsGone(int32_t t) const { return is_gone_[t]; }
  bool FacesUp(int32_t t) const { return tilemend::FacesUp(placed_[t]); }

  // Those that are not gone, rising. O(triangles).
  std::vector<int32_t> TrianglesAt(int32_t v) const;

  // The same of an edge. O(log n).
  std::vector<int32_t> TrianglesAtEdge(int32_t a, int32_t b) const;

  // Whether a triangle has an edge with more than two, those of the surface counted.
  bool HasOverfullEdge(int32_t t) const;

  // Whether a new edge may be made between two vertices.
  bool MayJoin(int32_t a, int32_t b) const;

  // Of what lies beside an edge, in the patch or on the surface; zero if unknown.
  Eigen::Vector3d NormalBeside(int32_t from, int32_t to) const;

  // Calls use(t) for each triangle of the patch that meets the box.
  template <typename Use>
  void ForEachIn(const Eigen::AlignedBox3d& box, const Use& use) const {
    tree_.AnyMeeting(box, [&](int32_t t) {
      if (!is_gone_[t]) use(placed_[t]);
      return false;
    });
    for (size_t t = first_new_; t < placed_.size(); ++t) {
      if (!is_gone_[t]) use(placed_[t]);
    }
  }

  // The pieces that some of the triangles form.
  std::vector<Piece> PiecesOf(const std::vector<bool>& taken) const;

 private:
  VertexPair EdgeOf(int32_t t, int k) const;
  void AddEdges(int32_t t);
  std::optional<int32_t> TriangleAt(int32_t a, int32_t b) const;

  const LocalHole& hole_;
  LocalPatch& patch_;
  std::vector<SpaceTriangle> placed_;  // of patch_.triangles
  BoxTree tree_;                       // of those that were there
  size_t first_new_ = 0;
  std::vector<bool> is_gone_;
  std::map<VertexPair, std::vector<int32_t>> at_edge_;  // of those that are not gone
};

}  // namespace tilemend

#endif  // TILEMEND_WORKER_FILL_SPACE_PATCH_EDIT_H_
