#include "common/codec/stl.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <limits>

#include "absl/strings/str_cat.h"
#include "common/codec/text.h"
#include "common/mesh/rounding.h"
#include "common/mesh/triangle_shape.h"
#include "common/util/status_macros.h"

namespace tilemend {
namespace {

constexpr size_t kCountAt = 80, kHeadBytes = 84, kFacetBytes = 50, kNormalBytes = 12, kCornerBytes = 12;

static_assert(std::endian::native == std::endian::little, "binary STL is little-endian");

template <typename T>
T ValueAt(std::string_view bytes, size_t offset) {
  T value;
  std::memcpy(&value, bytes.data() + offset, sizeof(T));
  return value;
}

template <typename T>
void AppendValue(T value, std::string& out) {
  char raw[sizeof(T)];
  std::memcpy(raw, &value, sizeof(T));
  out.append(raw, sizeof(T));
}

bool IsBinary(std::string_view bytes) {
  return bytes.size() >= kHeadBytes &&
         bytes.size() == kHeadBytes + kFacetBytes * static_cast<size_t>(ValueAt<uint32_t>(bytes, kCountAt));
}

// Whether a word is a keyword, which some writers put in capitals.
bool IsWord(std::string_view word, std::string_view keyword) {
  return std::ranges::equal(word, keyword, [](char a, char b) { return a == b || a + ('a' - 'A') == b; });
}

// A text has no bytes that are 0; headers of binary files may begin with `solid` as well.
bool IsText(std::string_view bytes) {
  return IsWord(bytes.substr(TextStart(bytes), 5), "solid") &&
         bytes.substr(0, kHeadBytes + kFacetBytes).find('\0') == std::string_view::npos;
}

MeshFile EmptyFile(std::string_view bytes, NumberType number_type) {
  MeshFile file;
  file.format = MeshFormat::kStl;
  file.number_type = number_type;
  file.file_bytes = static_cast<int64_t>(bytes.size());
  return file;
}

// A triangle of the last three points.
void AddTriangle(TriMesh& mesh) {
  const auto end = static_cast<int32_t>(mesh.points.size());
  mesh.triangles.push_back({end - 3, end - 2, end - 1});
}

absl::StatusOr<MeshFile> ParseBinary(std::string_view bytes, const std::string& name, const FaceVisitor& visit) {
  MeshFile file = EmptyFile(bytes, NumberType::kFloat32);
  const size_t count = (bytes.size() - kHeadBytes) / kFacetBytes;
  if (count > std::numeric_limits<int32_t>::max() / 3) return ByteProblem(name, kCountAt, "too many facets");
  file.mesh.points.reserve(3 * count);
  file.mesh.triangles.reserve(count);
  for (size_t f = 0; f < count; ++f) {
    for (size_t corner = 0; corner < 3; ++corner) {
      Point3& p = file.mesh.points.emplace_back();
      for (size_t axis = 0; axis < 3; ++axis) {
        const size_t offset = kHeadBytes + f * kFacetBytes + kNormalBytes + 4 * (3 * corner + axis);
        p[static_cast<Eigen::Index>(axis)] = ValueAt<float>(bytes, offset);
        if (!IsValidCoordinate(p[static_cast<Eigen::Index>(axis)])) {
          return ByteProblem(name, offset, absl::StrCat("expected ", kCoordinate));
        }
      }
    }
    AddTriangle(file.mesh);
    if (!visit) continue;
    const size_t at = kHeadBytes + f * kFacetBytes + kNormalBytes, next = at + kCornerBytes;
    const TextRange corners[] = {{at, next}, {next, next + kCornerBytes}, {next + kCornerBytes, at + 3 * kCornerBytes}};
    visit(f, corners, kWhole);
  }
  return file;
}

// Reads `facet normal x y z outer loop vertex x y z ... endloop endfacet` word by word, whatever the lines.
class TextReader {
 public:
  TextReader(std::string_view text, const std::string& name, const FaceVisitor& visit)
      : text_(text), name_(name), visit_(visit), at_(TextStart(text)), end_of_facets_(text.size()) {}

  absl::StatusOr<MeshFile> Read() {
    MeshFile file = EmptyFile(text_, NumberType::kFloat64);
    while (!AtEnd()) {
      const size_t start = at_;
      const std::string_view word = Word();
      if (IsWord(word, "endsolid")) end_of_facets_ = start;
      if (IsWord(word, "solid") || IsWord(word, "endsolid")) {
        at_ = std::min(text_.find_first_of("\r\n", start), text_.size());  // its name may be any text
      } else if (IsWord(word, "facet")) {
        TILEMEND_RETURN_IF_ERROR(ReadFacet(file.mesh));
      } else {
        return LineError(name_, text_, start, "`facet` or `endsolid`");
      }
    }
    return file;
  }

  // Where the last `endsolid` that was read begins, or the end.
  size_t end_of_facets() const { return end_of_facets_; }

 private:
  bool AtEnd() {
    while (at_ < text_.size() && IsSpace(text_[at_])) ++at_;
    return at_ == text_.size();
  }

  std::string_view Word() {
    AtEnd();
    const size_t start = at_;
    while (at_ < text_.size() && !IsSpace(text_[at_])) ++at_;
    return text_.substr(start, at_ - start);
  }

  absl::Status Expect(std::string_view wanted) {
    AtEnd();
    const size_t start = at_;
    if (IsWord(Word(), wanted)) return absl::OkStatus();
    return LineError(name_, text_, start, absl::StrCat("`", std::string(wanted), "`"));
  }

  absl::Status ReadFacet(TriMesh& mesh) {
    TILEMEND_RETURN_IF_ERROR(Expect("normal"));
    for (int axis = 0; axis < 3; ++axis) Word();  // some writers put `nan` there
    TILEMEND_RETURN_IF_ERROR(Expect("outer"));
    TILEMEND_RETURN_IF_ERROR(Expect("loop"));
    std::array<TextRange, 3> places;
    for (TextRange& place : places) {
      TILEMEND_RETURN_IF_ERROR(Expect("vertex"));
      AtEnd();
      place.begin = at_;
      Point3& p = mesh.points.emplace_back();
      for (int axis = 0; axis < 3; ++axis) {
        AtEnd();
        const ParsedDouble number = ParseDoubleAt(text_.data() + at_, text_.data() + text_.size());
        if (number.stop == nullptr || !IsValidCoordinate(number.value)) {
          return LineError(name_, text_, at_, kCoordinate);
        }
        p[axis] = number.value;
        at_ = static_cast<size_t>(number.stop - text_.data());
      }
      place.end = at_;
    }
    AddTriangle(mesh);
    if (visit_) visit_(mesh.triangles.size() - 1, places, kWhole);
    if (mesh.points.size() > std::numeric_limits<int32_t>::max() - 3) {
      return LineProblem(name_, text_, at_, "too many facets");
    }
    TILEMEND_RETURN_IF_ERROR(Expect("endloop"));
    return Expect("endfacet");
  }

  std::string_view text_;
  const std::string& name_;
  const FaceVisitor& visit_;
  size_t at_;
  size_t end_of_facets_;
};

// What ParseStl does. `end_of_facets` gets where further facets belong.
absl::StatusOr<MeshFile> Parse(std::string_view bytes, const std::string& name, const FaceVisitor& visit,
                               size_t& end_of_facets) {
  end_of_facets = bytes.size();
  absl::StatusOr<MeshFile> file = MeshFile();
  if (IsBinary(bytes)) {
    file = ParseBinary(bytes, name, visit);
  } else if (IsText(bytes)) {
    TextReader reader(bytes, name, visit);
    file = reader.Read();
    end_of_facets = reader.end_of_facets();
  } else if (bytes.size() >= kHeadBytes) {
    return ByteProblem(name, kCountAt,
                       absl::StrCat("the header says ", ValueAt<uint32_t>(bytes, kCountAt), " facets, the file has ",
                                    bytes.size() - kHeadBytes, " bytes of them, 50 each"));
  } else {
    return ByteProblem(name, 0, "expected `solid` or a header of 84 bytes");
  }
  if (file.ok() && file->mesh.points.empty()) return absl::InvalidArgumentError(absl::StrCat(name, ": ", kNoVertices));
  return file;
}

void AppendBinaryFacet(const SpaceTriangle& t, const Eigen::Vector3d& normal, std::string& out) {
  for (int axis = 0; axis < 3; ++axis) AppendValue(static_cast<float>(normal[axis]), out);
  for (const Point3& p : t) {
    for (int axis = 0; axis < 3; ++axis) AppendValue(static_cast<float>(p[axis]), out);
  }
  AppendValue(uint16_t{0}, out);
}

void AppendTextFacet(const SpaceTriangle& t, const Eigen::Vector3d& normal, std::string_view eol, std::string& out) {
  const auto numbers = [&](const Point3& p) {
    for (int axis = 0; axis < 3; ++axis) {
      out += ' ';
      AppendNumber(p[axis], out);
    }
    out += eol;
  };
  out += "facet normal";
  numbers(normal);
  absl::StrAppend(&out, "outer loop", std::string(eol));
  for (const Point3& p : t) {
    out += "vertex";
    numbers(p);
  }
  absl::StrAppend(&out, "endloop", std::string(eol), "endfacet", std::string(eol));
}

}  // namespace

absl::StatusOr<MeshFile> ParseStl(std::string_view bytes, const std::string& name, const FaceVisitor& visit) {
  size_t end_of_facets = 0;
  return Parse(bytes, name, visit, end_of_facets);
}

absl::StatusOr<std::string> AppendToStl(std::string_view bytes, const FilePatch& patch, const std::string& name) {
  size_t end = 0;
  TILEMEND_ASSIGN_OR_RETURN(const MeshFile file, Parse(bytes, name, {}, end));
  const bool binary = file.number_type == NumberType::kFloat32;
  const size_t originals = file.mesh.points.size();
  const std::string_view eol = binary ? "" : LineEndingOf(bytes);
  std::string out(bytes.substr(0, end));
  if (!binary && !out.empty() && !IsSpace(out.back())) out += eol;
  for (const Triangle& t : patch.triangles) {
    SpaceTriangle corners;
    for (size_t k = 0; k < 3; ++k) {
      const auto v = static_cast<size_t>(t[k]);
      if (t[k] < 0 || v >= originals + patch.new_points.size()) {
        return absl::InvalidArgumentError(absl::StrCat(name, ": the patch has a vertex that is not there"));
      }
      corners[k] =
          v < originals ? file.mesh.points[v] : Point3(RoundedTo(file.number_type, patch.new_points[v - originals]));
    }
    const Eigen::Vector3d normal = TwiceVectorArea(corners[0], corners[1], corners[2]).normalized();
    binary ? AppendBinaryFacet(corners, normal, out) : AppendTextFacet(corners, normal, eol, out);
  }
  out += bytes.substr(end);
  if (binary) {
    const auto count = static_cast<uint32_t>((out.size() - kHeadBytes) / kFacetBytes);
    std::memcpy(out.data() + kCountAt, &count, sizeof(count));
  }
  return out;
}

}  // namespace tilemend
