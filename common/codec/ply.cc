#include "common/codec/ply.h"

#include <algorithm>
#include <array>
#include <span>
#include <utility>

#include "absl/strings/str_cat.h"
#include "common/codec/ply_source.h"
#include "common/codec/text.h"
#include "common/util/status_macros.h"

namespace tilemend {
namespace {

// Reads the records of a body from a source, one property after another: any layout.
template <class Source>
class RecordReader {
 public:
  RecordReader(Source source, const PlyHeader& header, const FaceVisitor& visit, std::span<const Point3> all,
               MeshFile& file)
      : source_(source), header_(header), visit_(visit), all_(all), file_(file) {}

  Source& source() { return source_; }

  absl::Status SkipRecord(const PlyElement& element) {
    for (const PlyProperty& property : element.properties) TILEMEND_RETURN_IF_ERROR(SkipProperty(property));
    return absl::OkStatus();
  }

  absl::Status ReadVertex(const PlyElement& element) {
    Point3 point;
    for (size_t i = 0; i < element.properties.size(); ++i) {
      const PlyProperty& property = element.properties[i];
      const size_t axis =
          static_cast<size_t>(std::find(header_.xyz.begin(), header_.xyz.end(), i) - header_.xyz.begin());
      if (axis == header_.xyz.size()) {
        TILEMEND_RETURN_IF_ERROR(SkipProperty(property));
        continue;
      }
      const std::optional<double> value = source_.Number(property.type);
      if (!value.has_value()) return source_.Error("a coordinate");
      if (!IsValidCoordinate(*value)) return source_.Error(kCoordinate);
      point[static_cast<Eigen::Index>(axis)] = *value;
    }
    file_.mesh.points.push_back(point);
    return absl::OkStatus();
  }

  absl::Status ReadFace(const PlyElement& element) {
    for (size_t i = 0; i < element.properties.size(); ++i) {
      if (i == header_.corners) {
        TILEMEND_RETURN_IF_ERROR(ReadCorners(element.properties[i]));
      } else {
        TILEMEND_RETURN_IF_ERROR(SkipProperty(element.properties[i]));
      }
    }
    AddPolygon(corners_, places_, visit_, file_, cut_, all_);
    return absl::OkStatus();
  }

 private:
  absl::StatusOr<int64_t> ReadCount(PlyType type) {
    const std::optional<int64_t> count = source_.Integer(type);
    if (!count.has_value() || *count < 0 || *count > kMaxListCount) {
      return source_.Error(absl::StrCat("a list count in 0 to ", kMaxListCount));
    }
    return *count;
  }

  absl::Status SkipProperty(const PlyProperty& property) {
    int64_t count = 1;
    if (property.is_list) {
      TILEMEND_ASSIGN_OR_RETURN(count, ReadCount(property.count_type));
    }
    return source_.Skip(property.type, count) ? absl::OkStatus()
                                              : source_.Error(absl::StrCat("a value of ", property.name));
  }

  absl::Status ReadCorners(const PlyProperty& property) {
    TILEMEND_ASSIGN_OR_RETURN(const int64_t count, ReadCount(property.count_type));
    const int64_t vertices = header_.elements[header_.vertex].count;
    corners_.clear();
    places_.clear();
    for (int64_t i = 0; i < count; ++i) {
      const std::optional<int64_t> index = source_.Integer(property.type);
      if (!index.has_value() || *index < 0 || *index >= vertices) {
        return source_.Error(absl::StrCat("a vertex index in 0 to ", vertices - 1));
      }
      corners_.push_back(static_cast<int32_t>(*index));
      if (visit_) places_.push_back(source_.LastRead());
    }
    return absl::OkStatus();
  }

  Source source_;
  const PlyHeader& header_;
  const FaceVisitor& visit_;
  const std::span<const Point3> all_;  // vertices, for faces that stand before them
  MeshFile& file_;
  std::vector<int32_t> corners_;
  std::vector<Triangle> cut_;      // by places in corners_
  std::vector<TextRange> places_;  // of corners_, if somebody asks
};

struct Span {
  const PlyElement& element;
  size_t begin;
};

// The byte offset of property `index` in a record without lists before it.
size_t OffsetOf(const PlyElement& element, size_t index) {
  size_t offset = 0;
  for (size_t i = 0; i < index; ++i) offset += SizeOf(element.properties[i].type);
  return offset;
}

// The fast way for vertices whose records all have the same size: one pass with fixed offsets. Returns the number of
// records before the first bad coordinate. `out` may be null.
template <class Float, bool kSwap>
size_t ReadFixedVertices(const char* p, size_t stride, const std::array<size_t, 3>& offsets, size_t count,
                         Point3* out) {
  for (size_t k = 0; k < count; ++k, p += stride) {
    const Point3 point(LoadValue<Float>(p + offsets[0], kSwap), LoadValue<Float>(p + offsets[1], kSwap),
                       LoadValue<Float>(p + offsets[2], kSwap));
    // One comparison for the record: the largest of the three, and a sum that is NaN if any of them is.
    const double largest = std::max({std::abs(point[0]), std::abs(point[1]), std::abs(point[2])});
    const double sum = point[0] + point[1] + point[2];
    if (!(largest <= kMaxCoordinate) || sum != sum) return k;
    if (out != nullptr) out[k] = point;
  }
  return count;
}

// Triangles among faces whose one list is the corners, counted in a byte, with 4-byte indices, and whose other
// properties have fixed sizes. Stops at the first face that is not a plain triangle with valid indices, or at the end
// of the bytes; returns where. `mesh` may be null.
struct FixedFaces {
  size_t before;  // bytes of a record before the list
  size_t after;
  uint32_t vertices;
};
template <bool kSwap>
const char* ReadTriangles(const char* p, const char* end, const FixedFaces& layout, size_t limit, TriMesh* mesh) {
  constexpr size_t kListBytes = 13;
  const size_t stride = layout.before + kListBytes + layout.after;
  std::array<Triangle, 512> run;  // added at once: a push_back for each takes twice the time
  size_t count = 0;
  const auto add = [&] {
    if (mesh != nullptr) mesh->triangles.insert(mesh->triangles.end(), run.begin(), run.begin() + count);
    count = 0;
  };
  for (size_t k = 0; k < limit && static_cast<size_t>(end - p) >= stride; ++k, p += stride) {
    const char* list = p + layout.before;
    if (*list != 3) break;
    const uint32_t a = LoadValue<uint32_t>(list + 1, kSwap);
    const uint32_t b = LoadValue<uint32_t>(list + 5, kSwap);
    const uint32_t c = LoadValue<uint32_t>(list + 9, kSwap);
    if (std::max(a, std::max(b, c)) >= layout.vertices || a == b || b == c || a == c) break;
    run[count] = {static_cast<int32_t>(a), static_cast<int32_t>(b), static_cast<int32_t>(c)};
    if (++count == run.size()) add();
  }
  add();
  return p;
}

// Reads a body's elements in their order.
template <class Source>
class BodyReader {
 public:
  BodyReader(std::string_view bytes, const PlyHeader& header, const std::string& name, MeshFile& file,
             PlyRecords* records, const FaceVisitor& visit, std::span<const Point3> all)
      : bytes_(bytes),
        header_(header),
        file_(file),
        records_(records),
        visits_(visit != nullptr),
        reader_(Source(bytes, header, name), header, visit, all, file) {}

  absl::Status Read() {
    for (size_t i = 0; i < header_.elements.size(); ++i) {
      const PlyElement& element = header_.elements[i];
      if (i == header_.vertex) {
        TILEMEND_RETURN_IF_ERROR(ReadVertices(element));
      } else if (i == header_.face) {
        TILEMEND_RETURN_IF_ERROR(ReadFaces(element));
      } else if (!element.properties.empty()) {
        for (int64_t k = 0; k < element.count; ++k) TILEMEND_RETURN_IF_ERROR(reader_.SkipRecord(element));
      }
      if (records_ != nullptr) records_->element_ends.push_back(reader_.source().position());
    }
    const std::string_view rest = bytes_.substr(reader_.source().position());
    if (!std::all_of(rest.begin(), rest.end(), IsSpace)) file_.bytes_after_end = static_cast<int64_t>(rest.size());
    return absl::OkStatus();
  }

 private:
  static constexpr bool kBinary = std::is_same_v<Source, BinarySource>;

  bool KeepsMesh() const { return records_ == nullptr; }

  absl::Status ReadVertices(const PlyElement& element) {
    const size_t count = static_cast<size_t>(element.count);
    if constexpr (kBinary) {
      if (!element.HasLists()) return ReadFixed(element, count);
    }
    file_.mesh.points.reserve(count);
    for (size_t k = 0; k < count; ++k) {
      TILEMEND_RETURN_IF_ERROR(reader_.ReadVertex(element));
      if (records_ != nullptr) records_->vertex_ends.push_back(reader_.source().position());
    }
    return absl::OkStatus();
  }

  absl::Status ReadFixed(const PlyElement& element, size_t count) {
    const size_t stride = element.LeastRecordBytes();
    const size_t begin = reader_.source().position();
    // The header's counts fit the file only if the lists before this element are empty.
    const size_t present = std::min(count, (bytes_.size() - begin) / stride);
    std::array<size_t, 3> offsets;
    for (size_t axis = 0; axis < 3; ++axis) offsets[axis] = OffsetOf(element, header_.xyz[axis]);
    const auto type = [&](size_t axis) { return element.properties[header_.xyz[axis]].type; };
    std::vector<Point3>& points = file_.mesh.points;
    size_t good = 0;
    if (type(0) == type(1) && type(1) == type(2)) {
      if (KeepsMesh()) points.resize(present);
      Point3* const out = KeepsMesh() ? points.data() : nullptr;
      const bool swap = NeedsSwap(header_.encoding);
      const char* p = bytes_.data() + begin;
      if (type(0) == PlyType::kFloat32) {
        good = swap ? ReadFixedVertices<float, true>(p, stride, offsets, present, out)
                    : ReadFixedVertices<float, false>(p, stride, offsets, present, out);
      } else {
        good = swap ? ReadFixedVertices<double, true>(p, stride, offsets, present, out)
                    : ReadFixedVertices<double, false>(p, stride, offsets, present, out);
      }
      if (KeepsMesh()) points.resize(good);
    }
    // The general way reads a mixed layout, and finds the words for what stopped the fast one.
    reader_.source().Seek(begin + good * stride);
    for (size_t k = good; k < count; ++k) TILEMEND_RETURN_IF_ERROR(reader_.ReadVertex(element));
    return absl::OkStatus();
  }

  absl::Status ReadFaces(const PlyElement& element) {
    const size_t count = static_cast<size_t>(element.count);
    constexpr size_t kLeastTriangleBytes = 4;  // a count and three indices of a byte each, in either encoding
    const size_t room = (bytes_.size() - reader_.source().position()) / kLeastTriangleBytes;
    if (KeepsMesh()) file_.mesh.triangles.reserve(std::min(count, room));
    const std::optional<FixedFaces> fixed = FixedLayout(element);
    for (size_t k = 0; k < count; ++k) {
      if constexpr (kBinary) {
        if (fixed.has_value() && !visits_) k += ReadTriangleRun(*fixed, count - k);
        if (k == count) break;
      }
      TILEMEND_RETURN_IF_ERROR(reader_.ReadFace(element));
      if (records_ != nullptr) records_->face_ends.push_back(reader_.source().position());
    }
    return absl::OkStatus();
  }

  std::optional<FixedFaces> FixedLayout(const PlyElement& element) const {
    const PlyProperty& corners = element.properties[header_.corners];
    const auto is_list = [](const PlyProperty& property) { return property.is_list; };
    if (std::count_if(element.properties.begin(), element.properties.end(), is_list) != 1) return std::nullopt;
    if (SizeOf(corners.count_type) != 1 || SizeOf(corners.type) != 4) return std::nullopt;
    const size_t before = OffsetOf(element, header_.corners);
    return FixedFaces{before, element.LeastRecordBytes() - before - 1,
                      static_cast<uint32_t>(header_.elements[header_.vertex].count)};
  }

  // Returns how many faces it read.
  size_t ReadTriangleRun(const FixedFaces& layout, size_t limit) {
    BinarySource& source = reader_.source();
    const size_t begin = source.position();
    const char* p = bytes_.data() + begin;
    const char* end = bytes_.data() + bytes_.size();
    TriMesh* const mesh = KeepsMesh() ? &file_.mesh : nullptr;
    const char* stop = NeedsSwap(header_.encoding) ? ReadTriangles<true>(p, end, layout, limit, mesh)
                                                   : ReadTriangles<false>(p, end, layout, limit, mesh);
    constexpr size_t kListBytes = 13;
    const size_t stride = layout.before + kListBytes + layout.after;
    const size_t faces = static_cast<size_t>(stop - p) / stride;
    if (records_ != nullptr && faces == static_cast<size_t>(header_.elements[header_.face].count)) {
      records_->face_bytes = stride;
    } else if (records_ != nullptr) {
      for (size_t k = 1; k <= faces; ++k) records_->face_ends.push_back(begin + k * stride);
    }
    source.Seek(begin + faces * stride);
    return faces;
  }

  const std::string_view bytes_;
  const PlyHeader& header_;
  MeshFile& file_;
  PlyRecords* const records_;
  const bool visits_;
  RecordReader<Source> reader_;
};

absl::StatusOr<MeshFile> ReadBody(std::string_view bytes, const PlyHeader& header, const std::string& name,
                                  PlyRecords* records, const FaceVisitor& visit, std::span<const Point3> all) {
  MeshFile file;
  file.format = MeshFormat::kPly;
  file.file_bytes = static_cast<int64_t>(bytes.size());
  const auto is_float32 = [&header](size_t property) {
    return header.elements[header.vertex].properties[property].type == PlyType::kFloat32;
  };
  const bool ascii = header.encoding == PlyEncoding::kAscii;
  const bool narrow = !ascii && std::any_of(header.xyz.begin(), header.xyz.end(), is_float32);
  file.number_type = narrow ? NumberType::kFloat32 : NumberType::kFloat64;
  TILEMEND_RETURN_IF_ERROR(ascii ? BodyReader<AsciiSource>(bytes, header, name, file, records, visit, all).Read()
                                 : BodyReader<BinarySource>(bytes, header, name, file, records, visit, all).Read());
  return file;
}

}  // namespace

absl::StatusOr<MeshFile> ReadPlyBody(std::string_view bytes, const PlyHeader& header, const std::string& name,
                                     PlyRecords* records, const FaceVisitor& visit) {
  std::vector<Point3> all;
  if (records == nullptr && header.face < header.vertex) {  // how a polygon is cut depends on its vertices
    TILEMEND_ASSIGN_OR_RETURN(MeshFile file, ReadBody(bytes, header, name, nullptr, {}, {}));
    all = std::move(file.mesh.points);
  }
  return ReadBody(bytes, header, name, records, visit, all);
}

absl::StatusOr<std::vector<size_t>> PlyFaceBegins(std::string_view bytes, const PlyHeader& header,
                                                  const PlyRecords& records, const std::string& name) {
  const size_t first = header.face == 0 ? header.body_begin : records.element_ends[header.face - 1];
  const auto begin_of = [&](size_t place) {
    if (records.face_bytes > 0) return place - (place - first) % records.face_bytes;
    const auto end = std::upper_bound(records.face_ends.begin(), records.face_ends.end(), place);
    return end == records.face_ends.begin() ? first : *(end - 1);
  };
  std::vector<size_t> begins;
  const FaceVisitor visit = [&](size_t, std::span<const TextRange> corners, std::span<const Triangle> triangles) {
    begins.insert(begins.end(), triangles.size(), begin_of(corners.front().begin));
  };
  TILEMEND_RETURN_IF_ERROR(ReadPlyBody(bytes, header, name, nullptr, visit).status());
  return begins;
}

absl::StatusOr<MeshFile> ParsePly(std::string_view bytes, const std::string& name, const FaceVisitor& visit) {
  TILEMEND_ASSIGN_OR_RETURN(const PlyHeader header, ParsePlyHeader(bytes, name));
  return ReadPlyBody(bytes, header, name, nullptr, visit);
}

}  // namespace tilemend
