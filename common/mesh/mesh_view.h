// A mesh that is read where it lies: in a TriMesh, or in arrays of numbers that a caller holds.
#ifndef TILEMEND_COMMON_MESH_MESH_VIEW_H_
#define TILEMEND_COMMON_MESH_MESH_VIEW_H_

#include <bit>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <iterator>
#include <optional>
#include <span>
#include <vector>

#include "common/mesh/tri_mesh.h"
#include "common/mesh/triangle_shape.h"

namespace tilemend {

// Goes over rows that are made when they are read.
template <typename Rows>
class RowIterator {
 public:
  using iterator_category = std::input_iterator_tag;
  using value_type = typename Rows::Row;
  using difference_type = std::ptrdiff_t;
  using pointer = void;
  using reference = value_type;

  RowIterator() = default;
  RowIterator(const Rows& rows, size_t row) : rows_(rows), row_(row) {}
  value_type operator*() const { return rows_[row_]; }
  RowIterator& operator++() {
    ++row_;
    return *this;
  }
  RowIterator operator++(int) { return {rows_, row_++}; }
  bool operator==(const RowIterator& other) const { return row_ == other.row_; }

 private:
  Rows rows_;  // a copy stays in registers, whatever a loop writes to
  size_t row_ = 0;
};

// Positions, three numbers each, in float32 or float64.
class PointRows {
 public:
  using Row = Point3;

  PointRows() = default;
  explicit PointRows(std::span<const Point3> points) : PointRows(points.data(), points.size(), false) {}
  // Preconditions: the length is a multiple of 3.
  explicit PointRows(std::span<const double> numbers) : PointRows(numbers.data(), numbers.size() / 3, false) {}
  explicit PointRows(std::span<const float> numbers) : PointRows(numbers.data(), numbers.size() / 3, true) {}

  Point3 operator[](size_t row) const {
    if (is_float32_) {
      Eigen::Vector3f narrow;
      std::memcpy(narrow.data(), data_ + row * sizeof(narrow), sizeof(narrow));
      return narrow.cast<double>();
    }
    Point3 point;
    std::memcpy(point.data(), data_ + row * sizeof(point), sizeof(point));
    return point;
  }
  // The rows where they lie, if their numbers are of float64.
  std::optional<std::span<const Point3>> AsSpan() const {
    if (is_float32_) return std::nullopt;
    return std::span(reinterpret_cast<const Point3*>(data_), count_);
  }
  size_t size() const { return count_; }
  bool is_float32() const { return is_float32_; }
  const void* data() const { return data_; }
  RowIterator<PointRows> begin() const { return {*this, 0}; }
  RowIterator<PointRows> end() const { return {*this, count_}; }

 private:
  PointRows(const void* data, size_t count, bool is_float32)
      : data_(static_cast<const std::byte*>(data)), count_(count), is_float32_(is_float32) {}

  const std::byte* data_ = nullptr;
  size_t count_ = 0;
  bool is_float32_ = false;
};

// Triangles, three indices each, in any type of integer of 4 or 8 bytes.
class TriangleRows {
 public:
  using Row = Triangle;

  TriangleRows() = default;
  explicit TriangleRows(std::span<const Triangle> triangles)
      : TriangleRows(triangles.data(), triangles.size(), false) {}
  // Precondition: the length is a multiple of 3, and each index is from 0 to 2^31 - 1.
  template <std::integral Index>
  explicit TriangleRows(std::span<const Index> indices)
      : TriangleRows(indices.data(), indices.size() / 3, sizeof(Index) == 8) {
    static_assert(sizeof(Index) == 4 || sizeof(Index) == 8, "indices have 32 or 64 bits");
  }

  Triangle operator[](size_t row) const {
    Triangle triangle;
    if (!is_wide_) {
      std::memcpy(triangle.data(), data_ + row * sizeof(triangle), sizeof(triangle));
      return triangle;
    }
    // The lower half of a small number of 8 bytes is the number.
    for (size_t k = 0; k < 3; ++k) std::memcpy(&triangle[k], data_ + (3 * row + k) * sizeof(int64_t), sizeof(int32_t));
    return triangle;
  }
  // All rows, in memory of their exact size.
  std::vector<Triangle> Copy() const {
    if (const auto plain = AsSpan()) return {plain->begin(), plain->end()};
    std::vector<Triangle> copy;
    copy.reserve(count_);
    for (const Triangle& t : *this) copy.push_back(t);
    return copy;
  }
  // The rows where they lie, if their indices have 32 bits.
  std::optional<std::span<const Triangle>> AsSpan() const {
    if (is_wide_) return std::nullopt;
    return std::span(reinterpret_cast<const Triangle*>(data_), count_);
  }
  size_t size() const { return count_; }
  const void* data() const { return data_; }
  RowIterator<TriangleRows> begin() const { return {*this, 0}; }
  RowIterator<TriangleRows> end() const { return {*this, count_}; }

 private:
  static_assert(std::endian::native == std::endian::little, "the lower half of an index comes first");

  TriangleRows(const void* data, size_t count, bool is_wide)
      : data_(static_cast<const std::byte*>(data)), count_(count), is_wide_(is_wide) {}

  const std::byte* data_ = nullptr;
  size_t count_ = 0;
  bool is_wide_ = false;  // indices of 8 bytes
};

// What it is made from outlives it, and is not changed meanwhile. A copy costs nothing.
struct MeshView {
  MeshView(const PointRows& of_points, const TriangleRows& of_triangles) : points(of_points), triangles(of_triangles) {}
  MeshView(const TriMesh& mesh) : points(mesh.points), triangles(mesh.triangles) {}  // NOLINT: as a span

  PointRows points;
  TriangleRows triangles;
};

inline Eigen::Vector3d TwiceVectorArea(const PointRows& points, const Triangle& t) {
  return TwiceVectorArea(points[t[0]], points[t[1]], points[t[2]]);
}

}  // namespace tilemend

#endif  // TILEMEND_COMMON_MESH_MESH_VIEW_H_
