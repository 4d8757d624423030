#include "worker/fill/space/kept_ground.h"

#include <Eigen/Geometry>
#include <cmath>
#include <optional>

#include "worker/fill/space/patch_crossings.h"

namespace tilemend {
namespace {

// Of the mean edge of what is taken out: how far surface that faces up may move there along the vertical.
constexpr double kMostOff = 0.25;

// Divides triangle t at a vertex that it does not have. False, with the triangle as it was, if a part has no area or
// crosses something.
bool Divide(int32_t t, int32_t v, const std::function<CrossingIndex()>& there, PatchEdit& edit) {
  const Triangle corners = edit.Corners(t);
  const int32_t first = edit.count();
  edit.TakeOut(t);
  const CrossingIndex others = there();
  for (int k = 0; k < 3; ++k) {
    const Triangle part = {corners[k], corners[(k + 1) % 3], v};
    const SpaceTriangle placed = edit.Place(part);
    const bool faces_up = TwiceVectorArea(placed).z() > 0;
    if (!faces_up || !HasArea(placed) || others.IsCrossedBy(placed)) {
      edit.TakeOutFrom(first);
      edit.DropFrom(first);
      edit.PutBack(t);
      return false;
    }
    edit.PutIn(part);
  }
  return true;
}

}  // namespace

KeptGround::KeptGround(const Piece& piece, const std::set<int32_t>& boundary, const PatchEdit& edit) {
  double edges = 0;
  for (const int32_t t : piece) {
    const SpaceTriangle& p = edit.Placed(t);
    for (int k = 0; k < 3; ++k) edges += (p[(k + 1) % 3] - p[k]).norm() / 3;
    vertices_.insert(edit.Corners(t).begin(), edit.Corners(t).end());
  }
  for (const int32_t v : boundary) vertices_.erase(v);
  for (const int32_t t : piece) {
    for (const int32_t v : edit.Corners(t)) {
      if (!edit.FacesUp(t)) vertices_.erase(v);
    }
  }
  most_ = kMostOff * edges / static_cast<double>(piece.size());
}

bool KeptGround::IsNear(int32_t v, int32_t first, const PatchEdit& edit) const {
  for (int32_t t = first; t < edit.count(); ++t) {
    if (edit.IsGone(t)) continue;
    const std::optional<double> height = HeightOver(edit.Placed(t), edit.At(v));
    if (height && std::abs(*height) <= most_) return true;
  }
  return false;
}

bool KeptGround::IsKept(int32_t first, const PatchEdit& edit) const {
  for (const int32_t v : vertices_) {
    if (!IsNear(v, first, edit)) return false;
  }
  return true;
}

void KeptGround::PutBack(int32_t first, const std::function<CrossingIndex()>& there, PatchEdit& edit) const {
  for (const int32_t v : vertices_) {
    if (IsNear(v, first, edit)) continue;
    for (int32_t t = first, end = edit.count(); t < end; ++t) {
      const bool may_divide = !edit.IsGone(t) && edit.FacesUp(t) && HeightOver(edit.Placed(t), edit.At(v));
      if (may_divide && Divide(t, v, there, edit)) break;
    }
  }
}

}  // namespace tilemend
