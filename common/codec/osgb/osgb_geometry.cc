// Geometries: arrays and primitive sets.
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <optional>
#include <utility>

#include "absl/strings/str_cat.h"
#include "common/codec/osgb/osgb_parse.h"

namespace tilemend {
namespace {

constexpr std::string_view kPrefix = "osg::";
constexpr double kMaxCoordinate = 1e9;  // metres
constexpr int32_t kBindUndefined = -1;
constexpr int32_t kBindPerVertex = 4;

struct ArrayType {
  std::string_view name;
  uint32_t bytes;  // of an element
};
// In the order of the numbers that stand for them before kOsgbArrayObjects.
constexpr ArrayType kArrayTypes[] = {
    {"ByteArray", 1},    {"UByteArray", 1},   {"ShortArray", 2},  {"UShortArray", 2}, {"IntArray", 4},
    {"UIntArray", 4},    {"FloatArray", 4},   {"DoubleArray", 8}, {"Vec2bArray", 2},  {"Vec3bArray", 3},
    {"Vec4bArray", 4},   {"Vec4ubArray", 4},  {"Vec2sArray", 4},  {"Vec3sArray", 6},  {"Vec4sArray", 8},
    {"Vec2Array", 8},    {"Vec3Array", 12},   {"Vec4Array", 16},  {"Vec2dArray", 16}, {"Vec3dArray", 24},
    {"Vec4dArray", 32},  {"Vec2ubArray", 2},  {"Vec3ubArray", 3}, {"Vec2usArray", 4}, {"Vec3usArray", 6},
    {"Vec4usArray", 8},  {"Vec2iArray", 8},   {"Vec3iArray", 12}, {"Vec4iArray", 16}, {"Vec2uiArray", 8},
    {"Vec3uiArray", 12}, {"Vec4uiArray", 16}, {"UInt64Array", 8}, {"Int64Array", 8},
};

enum PrimitiveType : uint32_t { kDrawArrays = 50, kDrawArrayLengths, kElementsUByte, kElementsUShort, kElementsUInt };
enum GlMode : uint32_t { kTriangles = 4, kTriangleStrip = 5, kTriangleFan = 6 };

struct GeometryArrays {
  int32_t vertices = -1;  // indices into OsgbParse::arrays
  int32_t uv = -1;
};

int32_t AddArray(OsgbParse& parse, const ArrayType& type, int32_t binding) {
  OsgbArray array{.type = type.name, .binding = binding};
  array.count = parse.cursor.Count(type.bytes, type.name);
  if (parse.version() < kOsgbArrayObjects) parse.cursor.Begin(type.name);
  array.offset = parse.cursor.offset();
  parse.cursor.Take(size_t{array.count} * type.bytes, type.name);
  if (parse.version() < kOsgbArrayObjects) parse.cursor.End(type.name);
  parse.arrays.push_back(array);
  return static_cast<int32_t>(parse.arrays.size()) - 1;
}

// Before kOsgbArrayObjects.
int32_t ReadNumberedArray(OsgbParse& parse) {
  OsgbCursor& cursor = parse.cursor;
  const uint32_t id = cursor.U32("the id of an array");
  parse.layout.max_array_id = std::max(parse.layout.max_array_id, id);
  if (const auto it = parse.array_ids.find(id); it != parse.array_ids.end()) return it->second;
  const size_t at = cursor.offset();
  const uint32_t type = cursor.U32("the type of an array");
  if (type >= std::size(kArrayTypes)) cursor.Fail(at, absl::StrCat("arrays of type ", type, " are not supported"));
  if (!cursor.ok()) return -1;
  const int32_t index = AddArray(parse, kArrayTypes[type], 0);
  parse.array_ids.emplace(id, index);
  return index;
}

// The array of a vertex attribute before kOsgbArrayObjects, with what follows it.
int32_t ReadBoundArray(OsgbParse& parse) {
  OsgbCursor& cursor = parse.cursor;
  cursor.Begin("a vertex attribute");
  const int32_t index = cursor.Flag("the array of a vertex attribute") ? ReadNumberedArray(parse) : -1;
  if (cursor.Flag("the indices of a vertex attribute")) cursor.Fail("vertex attributes by index are not supported");
  const int32_t binding = cursor.I32("the binding of a vertex attribute");
  cursor.U32("the normalization of a vertex attribute");
  cursor.End("a vertex attribute");
  if (index >= 0) parse.arrays[static_cast<size_t>(index)].binding = binding;
  return index;
}

void ReadBufferData(OsgbParse& parse) {
  OsgbCursor& cursor = parse.cursor;
  if (parse.version() < kOsgbBufferData || !cursor.Flag("the buffer object")) return;
  const OsgbHead head = BeginOsgbObject(parse);
  if (head.is_done) return;
  if (head.class_name != "osg::VertexBufferObject" && head.class_name != "osg::ElementBufferObject") {
    return RefuseOsgbClass(parse, head.class_name);
  }
  ReadOsgbObjectFields(parse);
  cursor.Take(2 * sizeof(uint32_t), "the target and usage of a buffer object");
  cursor.Flag("the release of a buffer object");
  EndOsgbObject(parse, head, -1);
}

// The type of the array class `class_name`; nullptr for other classes.
const ArrayType* ArrayTypeOf(std::string_view class_name) {
  if (!class_name.starts_with(kPrefix)) return nullptr;
  const auto* const it = std::ranges::find(kArrayTypes, class_name.substr(kPrefix.size()), &ArrayType::name);
  return it == std::end(kArrayTypes) ? nullptr : it;
}

// From kOsgbArrayObjects on.
int32_t ReadArrayObject(OsgbParse& parse) {
  const OsgbHead head = BeginOsgbObject(parse);
  if (head.class_name == "NULL" || !parse.cursor.ok()) return -1;
  const ArrayType* const type = ArrayTypeOf(head.class_name);
  if (type == nullptr) RefuseOsgbClass(parse, head.class_name);
  if (head.is_done || type == nullptr) return head.value;
  ReadOsgbObjectFields(parse);
  ReadBufferData(parse);
  const int32_t binding = parse.cursor.I32("the binding of an array");
  parse.cursor.Flag("the normalization of an array");
  parse.cursor.Flag("the type flag of an array");
  const int32_t index = AddArray(parse, *type, binding);
  EndOsgbObject(parse, head, index);
  return index;
}

// One of the five arrays that a geometry has besides texture coordinates and further attributes.
int32_t ReadSingleArray(OsgbParse& parse) {
  if (!parse.cursor.Flag("a vertex attribute")) return -1;
  return parse.version() < kOsgbArrayObjects ? ReadBoundArray(parse) : ReadArrayObject(parse);
}

// Returns the first array of the list.
int32_t ReadArrayList(OsgbParse& parse) {
  constexpr size_t kMinArrayBytes = 8;
  OsgbCursor& cursor = parse.cursor;
  const bool is_numbered = parse.version() < kOsgbArrayObjects;
  if (is_numbered && !cursor.Flag("a list of arrays")) return -1;
  int32_t first = -1;
  const uint32_t count = cursor.Count(kMinArrayBytes, "a list of arrays");
  if (is_numbered) cursor.Begin("a list of arrays");
  for (uint32_t i = 0; i < count && cursor.ok(); ++i) {
    const int32_t index = is_numbered ? ReadBoundArray(parse) : ReadArrayObject(parse);
    if (i == 0) first = index;
  }
  if (is_numbered) cursor.End("a list of arrays");
  return first;
}

GeometryArrays ReadArrays(OsgbParse& parse) {
  constexpr int kOthers = 4;  // normals, colours, secondary colours, fog coordinates
  GeometryArrays arrays;
  arrays.vertices = ReadSingleArray(parse);
  for (int i = 0; i < kOthers; ++i) ReadSingleArray(parse);
  arrays.uv = ReadArrayList(parse);
  ReadArrayList(parse);
  if (parse.version() < kOsgbArrayObjects) parse.cursor.Flag("the fast path hint");
  return arrays;
}

void CheckMode(OsgbCursor& cursor, size_t offset, uint32_t mode) {
  if (mode >= kTriangles && mode <= kTriangleFan) return;
  constexpr std::string_view kNames[] = {"POINTS", "LINES", "LINE_LOOP", "LINE_STRIP", "",
                                         "",       "",      "QUADS",     "QUAD_STRIP", "POLYGON"};
  cursor.Fail(offset, mode < std::size(kNames)
                          ? absl::StrCat("primitives of mode ", std::string(kNames[mode]), " are not supported")
                          : absl::StrCat("primitives of mode ", mode, " are not supported"));
}

// What a primitive set has behind its mode.
void ReadIndices(OsgbParse& parse, uint32_t type, OsgbPrimitiveSite& site) {
  OsgbCursor& cursor = parse.cursor;
  if (type == kDrawArrays) site.first = cursor.U32("the first vertex");
  site.count_offset = cursor.offset();
  if (type == kDrawArrays) {
    site.count = cursor.U32("the number of vertices");
    site.bracket = cursor.bracket();
    return;
  }
  const bool has_bracket = parse.version() < kOsgbArrayObjects;
  site.index_bytes = 1u << (type - kElementsUByte);
  site.count = cursor.Count(site.index_bytes, "indices");
  if (has_bracket) cursor.Begin("indices");
  site.bracket = cursor.bracket();
  site.data_offset = cursor.offset();
  cursor.Take(size_t{site.count} * site.index_bytes, "indices");
  if (has_bracket) cursor.End("indices");
}

// Before kOsgbArrayObjects.
void ReadNumberedPrimitives(OsgbParse& parse, OsgbPrimitiveSite& site) {
  OsgbCursor& cursor = parse.cursor;
  const size_t at = cursor.offset();
  const uint32_t type = cursor.U32("the type of a primitive set");
  site.mode = cursor.U32("the mode of a primitive set");
  CheckMode(cursor, at + sizeof(uint32_t), site.mode);
  if (parse.version() >= kOsgbInstances) cursor.U32("the number of instances");
  if (type < kDrawArrays || type > kElementsUInt || type == kDrawArrayLengths) {
    cursor.Fail(at, type == kDrawArrayLengths ? "primitive sets of class osg::DrawArrayLengths are not supported"
                                              : absl::StrCat("primitive sets of type ", type, " are not supported"));
  }
  if (cursor.ok()) ReadIndices(parse, type, site);
}

// From kOsgbArrayObjects on.
void ReadPrimitivesObject(OsgbParse& parse, OsgbPrimitiveSite& site) {
  constexpr std::pair<std::string_view, PrimitiveType> kClasses[] = {{"osg::DrawArrays", kDrawArrays},
                                                                     {"osg::DrawElementsUByte", kElementsUByte},
                                                                     {"osg::DrawElementsUShort", kElementsUShort},
                                                                     {"osg::DrawElementsUInt", kElementsUInt}};
  OsgbCursor& cursor = parse.cursor;
  const OsgbHead head = BeginOsgbObject(parse);
  if (!cursor.ok()) return;
  const auto* const found =
      std::ranges::find(kClasses, head.class_name, &std::pair<std::string_view, PrimitiveType>::first);
  if (found == std::end(kClasses)) return RefuseOsgbClass(parse, head.class_name);
  if (head.is_done) return cursor.Fail("primitive sets in several geometries are not supported");
  ReadOsgbObjectFields(parse);
  ReadBufferData(parse);
  cursor.U32("the number of instances");
  const size_t at = cursor.offset();
  site.mode = cursor.U32("the mode of a primitive set");
  CheckMode(cursor, at, site.mode);
  if (cursor.ok()) ReadIndices(parse, found->second, site);
  EndOsgbObject(parse, head, -1);
}

// Appends the primitive sets to the layout.
void ReadPrimitives(OsgbParse& parse) {
  constexpr size_t kMinPrimitiveBytes = 8;
  const uint32_t count = parse.cursor.Count(kMinPrimitiveBytes, "primitive sets");
  for (uint32_t i = 0; i < count && parse.cursor.ok(); ++i) {
    OsgbPrimitiveSite site;
    if (parse.version() < kOsgbArrayObjects) {
      ReadNumberedPrimitives(parse, site);
    } else {
      ReadPrimitivesObject(parse, site);
    }
    parse.layout.primitives.push_back(site);
  }
}

void ReadDrawableFields(OsgbParse& parse, OsgbLook& look) {
  OsgbCursor& cursor = parse.cursor;
  const uint32_t version = parse.version();
  if (version >= kOsgbDrawableNodes) look = ReadOsgbNodeFields(parse, look);
  if (version < kOsgbDrawableNodesOnly && cursor.Flag("the state set")) {
    look = OsgbLookOver(parse, ReadOsgbStateSet(parse), look);
  }
  if (cursor.Flag("the initial bound")) {
    cursor.Begin("the initial bound");
    cursor.Take(6 * sizeof(double), "the initial bound");
    cursor.End("the initial bound");
  }
  ExpectNoOsgbObject(parse, "the callback for the bound");
  ExpectNoOsgbObject(parse, "the shape");
  cursor.Take(3, "the flags of a drawable");
  if (version < kOsgbDrawableNodesOnly) {
    for (const char* const what :
         {"the update callback", "the event callback", "the cull callback", "the draw callback"}) {
      ExpectNoOsgbObject(parse, what);
    }
  }
  if (version >= kOsgbDrawableMask) cursor.U32("the node mask");
  if (version >= kOsgbDrawableCulling) cursor.Flag("the culling flag");
}

// The array of that index if it is of `type`, bound to vertices; nothing without an array or after a failure.
std::optional<OsgbArray> VertexArrayOf(OsgbParse& parse, int32_t index, std::string_view type) {
  if (index < 0 || !parse.cursor.ok()) return std::nullopt;
  const OsgbArray& array = parse.arrays[static_cast<size_t>(index)];
  if (array.type != type) {
    parse.cursor.Fail(array.offset, absl::StrCat("expected an osg::", std::string(type),
                                                 ", found an osg::", std::string(array.type)));
  } else if (array.binding != kBindPerVertex && array.binding != kBindUndefined) {
    parse.cursor.Fail(array.offset, absl::StrCat("the binding of osg::", std::string(type), " is ", array.binding,
                                                 "; only BIND_PER_VERTEX is supported"));
  }
  return parse.cursor.ok() ? std::optional(array) : std::nullopt;
}

template <size_t kSize>
std::array<float, kSize> FloatsAt(const OsgbCursor& cursor, size_t offset) {
  std::array<float, kSize> values;
  for (float& value : values) {
    value = std::bit_cast<float>(static_cast<uint32_t>(LoadOsgbNumber(cursor.bytes().data() + offset, sizeof(float))));
    offset += sizeof(float);
  }
  return values;
}

void AddVertices(OsgbParse& parse, const GeometryArrays& arrays, OsgbGeometry& geometry) {
  OsgbCursor& cursor = parse.cursor;
  OsgbFile& file = parse.layout.file;
  const std::optional<OsgbArray> vertices = VertexArrayOf(parse, arrays.vertices, "Vec3Array");
  const std::optional<OsgbArray> uv = VertexArrayOf(parse, arrays.uv, "Vec2Array");
  if (!vertices) return;
  if (uv && uv->count != vertices->count) {
    return cursor.Fail(uv->offset, absl::StrCat(uv->count, " texture coordinates for ", vertices->count, " vertices"));
  }
  // Geometries may share an array; the file's size still bounds the memory.
  if (vertices->count > cursor.bytes().size() - file.points.size()) {
    return cursor.Fail(vertices->offset, "the geometries have more vertices than the file has bytes");
  }
  geometry.vertex_count = static_cast<int32_t>(vertices->count);
  for (size_t i = 0; i < vertices->count; ++i) {
    const size_t at = vertices->offset + i * 3 * sizeof(float);
    const std::array<float, 3> p = FloatsAt<3>(cursor, at);
    for (const float x : p) {
      if (!(std::abs(x) <= kMaxCoordinate)) return cursor.Fail(at, "expected coordinates of at most 1e9 m");
    }
    file.points.emplace_back(p[0], p[1], p[2]);
    file.uv.push_back(uv ? FloatsAt<2>(cursor, uv->offset + i * 2 * sizeof(float)) : std::array<float, 2>{});
  }
}

// Vertex k of a primitive set, as an index into the geometry's vertices.
uint32_t VertexAt(const OsgbCursor& cursor, const OsgbPrimitiveSite& site, size_t k) {
  if (site.index_bytes == 0) return site.first + static_cast<uint32_t>(k);
  return static_cast<uint32_t>(
      LoadOsgbNumber(cursor.bytes().data() + site.data_offset + k * site.index_bytes, site.index_bytes));
}

// The corners of triangle k as positions in the primitive set.
std::array<size_t, 3> CornersOf(uint32_t mode, size_t k) {
  if (mode == kTriangles) return {3 * k, 3 * k + 1, 3 * k + 2};
  if (mode == kTriangleFan) return {0, k + 1, k + 2};
  return k % 2 == 0 ? std::array<size_t, 3>{k, k + 1, k + 2} : std::array<size_t, 3>{k + 1, k, k + 2};
}

bool CheckVertices(OsgbCursor& cursor, const OsgbPrimitiveSite& site, uint32_t vertex_count) {
  if (site.index_bytes == 0) {
    if (site.first <= vertex_count && site.count <= vertex_count - site.first) return true;
    cursor.Fail(site.count_offset, absl::StrCat("vertices ", site.first, " to ", uint64_t{site.first} + site.count,
                                                " of a geometry with ", vertex_count));
    return false;
  }
  for (size_t k = 0; k < site.count; ++k) {
    if (const uint32_t vertex = VertexAt(cursor, site, k); vertex >= vertex_count) {
      cursor.Fail(site.data_offset + k * site.index_bytes,
                  absl::StrCat("vertex index ", vertex, " in a geometry with ", vertex_count, " vertices"));
      return false;
    }
  }
  return true;
}

void AddTriangles(OsgbParse& parse, const OsgbGeometry& geometry, OsgbPrimitiveSite& site) {
  OsgbCursor& cursor = parse.cursor;
  std::vector<Triangle>& triangles = parse.layout.file.triangles;
  if (!CheckVertices(cursor, site, static_cast<uint32_t>(geometry.vertex_count))) return;
  const size_t count = site.mode == kTriangles ? site.count / 3 : std::max<size_t>(site.count, 2) - 2;
  // Consecutive vertices take no bytes for each triangle; the file's size still bounds the memory.
  if (count > cursor.bytes().size() - triangles.size()) {
    return cursor.Fail(site.count_offset, "the geometries have more triangles than the file has bytes");
  }
  site.first_triangle = static_cast<int32_t>(triangles.size());
  site.triangle_count = static_cast<int32_t>(count);
  for (size_t k = 0; k < count; ++k) {
    Triangle& triangle = triangles.emplace_back();
    const std::array<size_t, 3> corners = CornersOf(site.mode, k);
    for (size_t c = 0; c < 3; ++c) {
      triangle[c] = geometry.first_vertex + static_cast<int32_t>(VertexAt(cursor, site, corners[c]));
    }
  }
}

}  // namespace

void ReadOsgbGeometry(OsgbParse& parse, int32_t geode, OsgbLook look) {
  OsgbLayout& layout = parse.layout;
  const size_t first_site = layout.primitives.size();
  ReadOsgbObjectFields(parse);
  ReadDrawableFields(parse, look);
  ReadPrimitives(parse);
  const GeometryArrays arrays = ReadArrays(parse);
  OsgbGeometry geometry{.first_vertex = static_cast<int32_t>(layout.file.points.size()),
                        .first_triangle = static_cast<int32_t>(layout.file.triangles.size()),
                        .texture = look.image,
                        .colour = look.colour,
                        .geode = geode};
  AddVertices(parse, arrays, geometry);
  for (size_t i = first_site; i < layout.primitives.size() && parse.cursor.ok(); ++i) {
    AddTriangles(parse, geometry, layout.primitives[i]);
  }
  geometry.triangle_count = static_cast<int32_t>(layout.file.triangles.size()) - geometry.first_triangle;
  layout.file.geometries.push_back(geometry);
}

}  // namespace tilemend
