#include "worker/fill/space/patch_edit.h"

#include <algorithm>
#include <utility>

#include "common/mesh/disjoint_sets.h"
#include "common/mesh/triangle_shape.h"
#include "worker/fill/space/patch_crossings.h"

namespace tilemend {

BoxTree TreeOver(std::span<const SpaceTriangle> triangles) {
  std::vector<Eigen::AlignedBox3d> boxes;
  boxes.reserve(triangles.size());
  for (const SpaceTriangle& t : triangles) boxes.push_back(BoxOf(t));
  return BoxTree(boxes);
}

bool FacesUp(const SpaceTriangle& triangle) {
  const Eigen::Vector3d normal = TwiceVectorArea(triangle);
  return normal.z() > kFacesUp * normal.norm();
}

std::optional<double> HeightOver(const SpaceTriangle& triangle, const Point3& p) {
  const Eigen::Vector3d normal = TwiceVectorArea(triangle);
  if (normal.z() == 0) return std::nullopt;
  for (int k = 0; k < 3; ++k) {
    const Point2 side = (triangle[(k + 1) % 3] - triangle[k]).head<2>(), to = (p - triangle[k]).head<2>();
    if ((side.x() * to.y() - side.y() * to.x()) * normal.z() < 0) return std::nullopt;
  }
  return normal.dot(triangle[0] - p) / normal.z();
}

PatchEdit::PatchEdit(const LocalHole& hole, LocalPatch& patch) : hole_(hole), patch_(patch) {
  for (const Triangle& t : patch.triangles) placed_.push_back(Place(t));
  for (int32_t t = 0; t < count(); ++t) AddEdges(t);
  tree_ = TreeOver(placed_);
  first_new_ = placed_.size();
  is_gone_.assign(placed_.size(), false);
}

void PatchEdit::Finish() {
  size_t t = 0;
  std::erase_if(patch_.triangles, [&](const Triangle&) { return is_gone_[t++]; });
}

int32_t PatchEdit::AddPoint(const Point3& p) {
  patch_.new_points.push_back(p);
  return hole_.size() + static_cast<int32_t>(patch_.new_points.size()) - 1;
}

void PatchEdit::TakeOut(int32_t t) {
  is_gone_[t] = true;
  for (int k = 0; k < 3; ++k) std::erase(at_edge_[EdgeOf(t, k)], t);
}

void PatchEdit::TakeOutFrom(int32_t first) {
  for (int32_t t = first; t < count(); ++t) {
    if (!is_gone_[t]) TakeOut(t);
  }
}

void PatchEdit::PutBack(int32_t t) {
  is_gone_[t] = false;
  AddEdges(t);
}

void PatchEdit::DropFrom(int32_t first) {
  patch_.triangles.resize(static_cast<size_t>(first));
  placed_.resize(static_cast<size_t>(first));
  is_gone_.resize(static_cast<size_t>(first));
}

void PatchEdit::PutIn(const Triangle& t) {
  patch_.triangles.push_back(t);
  placed_.push_back(Place(t));
  is_gone_.push_back(false);
  AddEdges(count() - 1);
}

std::vector<int32_t> PatchEdit::TrianglesAt(int32_t v) const {
  std::vector<int32_t> at;
  for (int32_t t = 0; t < count(); ++t) {
    if (!is_gone_[t] && std::ranges::find(Corners(t), v) != Corners(t).end()) at.push_back(t);
  }
  return at;
}

std::vector<int32_t> PatchEdit::TrianglesAtEdge(int32_t a, int32_t b) const {
  const auto there = at_edge_.find(Undirected(a, b));
  if (there == at_edge_.end()) return {};
  std::vector<int32_t> at = there->second;
  std::ranges::sort(at);
  return at;
}

bool PatchEdit::HasOverfullEdge(int32_t t) const {
  for (int k = 0; k < 3; ++k) {
    const VertexPair edge = EdgeOf(t, k);
    const int beside = edge.second < hole_.size() ? hole_.TrianglesBeside(edge.first, edge.second) : 0;
    if (std::ssize(at_edge_.at(edge)) + beside > 2) return true;
  }
  return false;
}

bool PatchEdit::MayJoin(int32_t a, int32_t b) const {
  return a != b && !TriangleAt(a, b) && (std::max(a, b) >= hole_.size() || hole_.MayJoin(a, b));
}

Eigen::Vector3d PatchEdit::NormalBeside(int32_t from, int32_t to) const {
  if (const std::optional<int32_t> t = TriangleAt(from, to)) return TwiceVectorArea(placed_[*t]).normalized();
  if (std::max(from, to) >= hole_.size()) return Eigen::Vector3d::Zero();
  return hole_.NormalBeside(from, to);
}

std::vector<Piece> PatchEdit::PiecesOf(const std::vector<bool>& taken) const {
  DisjointSets sets(static_cast<int32_t>(taken.size()));
  for (const auto& [edge, around] : at_edge_) {
    if (around.size() == 2 && taken[around[0]] && taken[around[1]]) sets.Join(around[0], around[1]);
  }
  std::map<int32_t, Piece> by_lowest;
  for (int32_t t = 0; t < std::ssize(taken); ++t) {
    if (taken[t]) by_lowest[sets.LowestOf(t)].push_back(t);
  }
  std::vector<Piece> pieces;
  for (auto& [lowest, piece] : by_lowest) pieces.push_back(std::move(piece));
  return pieces;
}

VertexPair PatchEdit::EdgeOf(int32_t t, int k) const {
  return Undirected(patch_.triangles[t][k], patch_.triangles[t][(k + 1) % 3]);
}

void PatchEdit::AddEdges(int32_t t) {
  for (int k = 0; k < 3; ++k) at_edge_[EdgeOf(t, k)].push_back(t);
}

std::optional<int32_t> PatchEdit::TriangleAt(int32_t a, int32_t b) const {
  const auto there = at_edge_.find(Undirected(a, b));
  return there == at_edge_.end() || there->second.empty() ? std::nullopt : std::optional(there->second[0]);
}

}  // namespace tilemend
