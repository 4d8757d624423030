#include "worker/weld/welding_mesh.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "common/mesh/position_index.h"
#include "common/mesh/triangle_shape.h"

namespace tilemend {
namespace {

using Eigen::Vector3d;

// Surfaces that are turned against each other by more than 120 degrees are the two sides of a wall, and not parts of
// one surface.
constexpr double kAgainst = -0.5;
// Twice the area of a triangle over the square of its longest edge: below this it has none but for rounding.
constexpr double kFlat = 1e-9;

constexpr char kLosesArea[] = "a face would lose its area";
constexpr char kFacesAgainst[] = "the surfaces there face opposite ways";
constexpr char kCrowds[] = "an edge would have more than two faces";

bool HasCorner(const std::array<int32_t, 3>& t, int32_t place) {
  return t[0] == place || t[1] == place || t[2] == place;
}

bool IsFlat(const SpaceTriangle& t) {
  const double longest =
      std::max({(t[1] - t[0]).squaredNorm(), (t[2] - t[1]).squaredNorm(), (t[0] - t[2]).squaredNorm()});
  return TwiceVectorArea(t).norm() <= kFlat * longest;
}

}  // namespace

WeldingMesh::WeldingMesh(const MeshView& mesh, std::span<const int32_t> boundary, std::span<const int32_t> face_of)
    : mesh_(mesh), face_of_(face_of), triangles_(mesh.triangles.Copy()) {
  PositionIndex index;
  for (size_t v = 0; v < mesh.points.size(); ++v) {
    place_of_.push_back(index.Insert(mesh.points[v]));
    if (place_of_.back() == std::ssize(vertex_at_)) vertex_at_.push_back(static_cast<int32_t>(v));
  }
  for (size_t p = 0; p < vertex_at_.size(); ++p) merged_into_.push_back(static_cast<int32_t>(p));
  for (const int32_t v : boundary) {
    boundary_.push_back(place_of_[v]);
    triangles_at_[place_of_[v]];
    members_[place_of_[v]] = {place_of_[v]};
  }
  for (size_t t = 0; t < triangles_.size(); ++t) {
    original_.push_back(static_cast<int32_t>(t));
    const auto places = PlacesOf(static_cast<int32_t>(t));
    if (places[0] == places[1] || places[1] == places[2] || places[2] == places[0]) continue;
    for (const int32_t place : places) {
      if (const auto at = triangles_at_.find(place); at != triangles_at_.end()) at->second.push_back(original_.back());
    }
  }
}

int32_t WeldingMesh::StaysAs(int32_t place) const {
  while (merged_into_[place] != place) place = merged_into_[place];
  return place;
}

std::array<int32_t, 3> WeldingMesh::PlacesOf(int32_t triangle) const {
  const Triangle& t = triangles_[triangle];
  return {PlaceOf(t[0]), PlaceOf(t[1]), PlaceOf(t[2])};
}

std::span<const int32_t> WeldingMesh::TrianglesAt(int32_t place) const {
  const auto at = triangles_at_.find(place);
  return at == triangles_at_.end() ? std::span<const int32_t>() : std::span<const int32_t>(at->second);
}

int WeldingMesh::Count(int32_t at, int32_t from, int32_t to) const {
  int count = 0;
  for (const int32_t t : TrianglesAt(at)) {
    const auto places = PlacesOf(t);
    for (int k = 0; k < 3; ++k) count += places[k] == from && places[(k + 1) % 3] == to;
  }
  return count;
}

bool WeldingMesh::Has(int32_t at, int32_t other) const { return Count(at, at, other) + Count(at, other, at) > 0; }

Vector3d WeldingMesh::NormalAt(int32_t place) const {
  Vector3d sum = Vector3d::Zero();
  for (const int32_t t : TrianglesAt(place)) sum += TwiceVectorArea(mesh_.points, mesh_.triangles[original_[t]]);
  return sum;
}

bool WeldingMesh::FacesAgainst(const Vector3d& normal, const Vector3d& other) const {
  return normal.dot(other) < kAgainst * normal.norm() * other.norm();
}

bool WeldingMesh::IsWhole(int32_t triangle) const {
  const int32_t t = original_[triangle];
  const auto is_of_its_face = [&](int32_t other) {
    return other >= 0 && other < std::ssize(face_of_) && face_of_[other] == face_of_[t];
  };
  return !is_of_its_face(t - 1) && !is_of_its_face(t + 1);
}

bool WeldingMesh::SharesFace(int32_t triangle, int32_t place) const {
  const int32_t original = original_[triangle];
  if (HasCorner(PlacesOf(triangle), place)) return true;
  for (const int step : {-1, 1}) {
    for (int32_t t = original + step; t >= 0 && t < std::ssize(face_of_) && face_of_[t] == face_of_[original];
         t += step) {
      if (HasCorner(PlacesOf(t), place)) return true;
    }
  }
  return false;
}

const char* WeldingMesh::ShapeFault(int32_t triangle, const SpaceTriangle& corners) const {
  if (IsFlat(corners)) return kLosesArea;
  const Vector3d normal = TwiceVectorArea(mesh_.points, mesh_.triangles[original_[triangle]]);
  return TwiceVectorArea(corners).dot(normal) > 0 ? nullptr : "a face would turn over";
}

bool WeldingMesh::WouldCrowd(int32_t keep, int32_t gone, int32_t other) const {
  if (!Has(keep, other)) return false;
  return Count(keep, keep, other) + Count(gone, gone, other) > 1 ||
         Count(keep, other, keep) + Count(gone, other, gone) > 1;
}

const char* WeldingMesh::MergeFault(int32_t keep, int32_t gone) const {
  for (const auto& [one, other] : {std::pair(gone, keep), std::pair(keep, gone)}) {
    for (const int32_t t : TrianglesAt(one)) {
      if (SharesFace(t, other)) return kLosesArea;
    }
  }
  if (FacesAgainst(NormalAt(keep), NormalAt(gone))) return kFacesAgainst;
  for (const int32_t t : TrianglesAt(gone)) {
    const auto places = PlacesOf(t);
    SpaceTriangle corners;
    for (int k = 0; k < 3; ++k) corners[k] = PositionOf(places[k] == gone ? keep : places[k]);
    if (const char* fault = ShapeFault(t, corners)) return fault;
    for (const int32_t w : places) {
      if (w != gone && WouldCrowd(keep, gone, w)) return kCrowds;
    }
  }
  return nullptr;
}

void WeldingMesh::Merge(int32_t keep, int32_t gone) {
  for (const int32_t t : TrianglesAt(gone)) {
    for (int32_t& v : triangles_[t]) v = PlaceOf(v) == gone ? vertex_at_[keep] : v;
  }
  merged_into_[gone] = keep;
  for (auto* lists : {&triangles_at_, &members_}) {
    std::vector<int32_t>& from = lists->at(gone);
    lists->at(keep).insert(lists->at(keep).end(), from.begin(), from.end());
    lists->erase(gone);
  }
}

std::pair<int32_t, int32_t> WeldingMesh::EndsOf(const Edge& edge) const {
  const auto places = PlacesOf(edge.triangle);
  return {places[edge.corner], places[(edge.corner + 1) % 3]};
}

std::vector<WeldingMesh::Edge> WeldingMesh::OpenEdges() const {
  std::vector<int32_t> near;
  for (const auto& [place, triangles] : triangles_at_) near.insert(near.end(), triangles.begin(), triangles.end());
  std::sort(near.begin(), near.end());
  near.erase(std::unique(near.begin(), near.end()), near.end());
  std::vector<Edge> open;
  for (const int32_t t : near) {
    for (int k = 0; k < 3; ++k) {
      if (IsOpen({t, k})) open.push_back({t, k});
    }
  }
  return open;
}

bool WeldingMesh::IsOpen(const Edge& edge) const {
  const auto [a, b] = EndsOf(edge);
  return triangles_at_.contains(a) && triangles_at_.contains(b) && Count(a, a, b) + Count(a, b, a) == 1;
}

bool WeldingMesh::IsAtOpenEdge(int32_t place) const {
  return std::ranges::any_of(TrianglesAt(place), [&](int32_t t) {
    const auto places = PlacesOf(t);
    for (int k = 0; k < 3; ++k) {
      if ((places[k] == place || places[(k + 1) % 3] == place) && IsOpen({t, k})) return true;
    }
    return false;
  });
}

const char* WeldingMesh::SplitFault(const Edge& edge, int32_t place) const {
  const auto [a, b] = EndsOf(edge);
  const auto places = PlacesOf(edge.triangle);
  const int32_t c = places[(edge.corner + 2) % 3];
  if (!IsWhole(edge.triangle)) return "the face of the edge has more than three corners";
  if (FacesAgainst(NormalAt(place), TwiceVectorArea(mesh_.points, mesh_.triangles[original_[edge.triangle]]))) {
    return kFacesAgainst;
  }
  for (const int32_t moved : {a, b}) {
    SpaceTriangle corners;
    for (int k = 0; k < 3; ++k) corners[k] = PositionOf(places[k] == moved ? place : places[k]);
    if (const char* fault = ShapeFault(edge.triangle, corners)) return fault;
  }
  const bool crowds = c == place || Has(place, c) || Count(place, a, place) + Count(place, place, b) > 0 ||
                      Count(place, place, a) > 1 || Count(place, b, place) > 1;
  return crowds ? kCrowds : nullptr;
}

void WeldingMesh::Split(const Edge& edge, int32_t place) {
  const auto [a, b] = EndsOf(edge);
  const auto added = static_cast<int32_t>(triangles_.size());
  Triangle half = triangles_[edge.triangle];
  half[edge.corner] = vertex_at_[place];
  triangles_[edge.triangle][(edge.corner + 1) % 3] = vertex_at_[place];
  triangles_.push_back(half);
  original_.push_back(original_[edge.triangle]);
  std::erase(triangles_at_.at(b), edge.triangle);
  triangles_at_.at(b).push_back(added);
  triangles_at_.at(place).push_back(edge.triangle);
  triangles_at_.at(place).push_back(added);
  const int32_t c = PlaceOf(half[(edge.corner + 2) % 3]);
  if (const auto at = triangles_at_.find(c); at != triangles_at_.end()) at->second.push_back(added);
}

}  // namespace tilemend
