#include "common/codec/obj.h"

#include <cstring>
#include <limits>
#include <utility>
#include <vector>

#include "absl/strings/str_cat.h"
#include "common/codec/polygons.h"
#include "common/codec/text.h"
#include "common/util/status_macros.h"

namespace tilemend {
namespace {

class ObjReader {
 public:
  // `vertex_tails`, if given, gets for each vertex the offset just after its third coordinate.
  ObjReader(std::string_view bytes, const std::string& name, std::vector<size_t>* vertex_tails)
      : bytes_(bytes),
        name_(name),
        vertex_tails_(vertex_tails),
        newline_(LineEndingOf(bytes) == "\r" ? '\r' : '\n'),
        p_(bytes.data()),
        end_(bytes.data() + bytes.size()) {
    file_.format = MeshFormat::kObj;
    file_.file_bytes = static_cast<int64_t>(bytes.size());
  }

  absl::StatusOr<MeshFile> Read() {
    TILEMEND_RETURN_IF_ERROR(CheckKind());
    while (p_ < end_) {
      TILEMEND_RETURN_IF_ERROR(ReadStatement());
      TILEMEND_RETURN_IF_ERROR(SkipLine());
    }
    const int64_t vertices = static_cast<int64_t>(file_.mesh.points.size());
    if (vertices == 0) return absl::InvalidArgumentError(absl::StrCat(name_, ": the file has no vertices"));
    if (faces_ == 0) return absl::InvalidArgumentError(absl::StrCat(name_, ": the file has no faces"));
    if (largest_index_ >= vertices) {
      return LineProblem(name_, bytes_, largest_index_offset_,
                         absl::StrCat("expected a vertex index of at most ", vertices, ", found ", largest_index_ + 1));
    }
    return std::move(file_);
  }

 private:
  size_t Offset() const { return static_cast<size_t>(p_ - bytes_.data()); }
  absl::Status Expected(std::string_view what) const { return LineError(name_, bytes_, Offset(), what); }

  absl::Status CheckKind() {
    constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";
    if (bytes_.substr(0, 3) == kByteOrderMark) p_ += 3;
    for (const std::string_view other : {"ply", "OFF", "COFF", "NOFF", "STOFF", "solid ", "glTF"}) {
      if (bytes_.substr(0, other.size()) == other) return Expected("an OBJ statement");
    }
    return absl::OkStatus();
  }

  bool AtBreak() const { return p_ == end_ || *p_ == newline_; }

  // The length of a line continuation at p_: a backslash and the line's end; 0 if there is none.
  size_t ContinuationLength() const {
    if (p_ == end_ || *p_ != '\\') return 0;
    if (end_ - p_ >= 2 && p_[1] == newline_) return 2;
    return end_ - p_ >= 3 && p_[1] == '\r' && p_[2] == newline_ ? 3 : 0;
  }

  void SkipBlanks() {
    while (p_ < end_) {
      if (IsSpace(*p_) && *p_ != newline_) {
        ++p_;
      } else if (const size_t length = ContinuationLength(); length > 0) {
        p_ += length;
      } else {
        return;
      }
    }
  }

  // Whether a token may end at `p`.
  bool IsTokenEnd(const char* p) const { return p == end_ || IsSpace(*p) || *p == '\\' || *p == '#'; }
  bool AtStatementEnd() const { return AtBreak() || *p_ == '#'; }

  // Goes past the end of the line, continued lines included. A comment is not continued: a backslash at the end of one
  // is part of somebody's path.
  absl::Status SkipLine() {
    while (p_ < end_) {
      const char* stop = static_cast<const char*>(std::memchr(p_, newline_, static_cast<size_t>(end_ - p_)));
      if (stop == nullptr) stop = end_;
      if (static_cast<size_t>(stop - p_) > kMaxLineBytes) {
        return LineProblem(name_, bytes_, Offset(), absl::StrCat("the line is longer than ", kMaxLineBytes, " bytes"));
      }
      const std::string_view line(p_, static_cast<size_t>(stop - p_));
      const bool comment = line.find('#') != std::string_view::npos;
      size_t length = line.size();
      if (length > 0 && line[length - 1] == '\r') --length;
      const bool continued = !comment && length > 0 && line[length - 1] == '\\';
      p_ = stop == end_ ? end_ : stop + 1;
      if (!continued) return absl::OkStatus();
    }
    return absl::OkStatus();
  }

  absl::Status ReadStatement() {
    SkipBlanks();
    if (AtStatementEnd()) return absl::OkStatus();
    const char* begin = p_;
    const char* stop = p_;
    while (!IsTokenEnd(stop)) ++stop;
    const size_t length = static_cast<size_t>(stop - begin);
    if (length == 1 && *begin == 'v') return ReadVertex();
    if (length == 1 && *begin == 'f') return ReadFace();
    const bool letter = (*begin >= 'a' && *begin <= 'z') || (*begin >= 'A' && *begin <= 'Z');
    if (!letter) return Expected("an OBJ statement");
    p_ = stop;
    return absl::OkStatus();
  }

  absl::Status ReadVertex() {
    ++p_;
    if (file_.mesh.points.size() >= static_cast<size_t>(std::numeric_limits<int32_t>::max())) {
      return Expected("at most 2^31 - 1 vertices");
    }
    Point3 point;
    for (int axis = 0; axis < 3; ++axis) {
      SkipBlanks();
      const ParsedDouble number = ParseDoubleAt(p_, end_);
      if (number.stop == nullptr || !IsTokenEnd(number.stop)) return Expected("a coordinate");
      if (!IsValidCoordinate(number.value)) return Expected("a coordinate of at most 1e9 m");
      point[axis] = number.value;
      p_ = number.stop;
    }
    file_.mesh.points.push_back(point);
    if (vertex_tails_ != nullptr) vertex_tails_->push_back(Offset());
    return absl::OkStatus();
  }

  absl::Status ReadFace() {
    const size_t statement = Offset();
    ++p_;
    ++faces_;
    corners_.clear();
    for (SkipBlanks(); !AtStatementEnd(); SkipBlanks()) {
      TILEMEND_RETURN_IF_ERROR(ReadCorner(statement));
      if (static_cast<int64_t>(corners_.size()) > kMaxListCount) {
        return LineProblem(name_, bytes_, statement,
                           absl::StrCat("the face has more than ", kMaxListCount, " corners"));
      }
    }
    AddPolygon(corners_, file_);
    return absl::OkStatus();
  }

  // "v", "v/vt", "v//vn", "v/vt/vn", also with an index left out after a slash ("2/2/").
  absl::Status ReadCorner(size_t statement) {
    const ParsedInteger index = ParseIntegerAt(p_, end_);
    if (index.stop == nullptr) return Expected("a vertex index");
    const char* stop = index.stop;
    for (int slashes = 0; slashes < 2 && stop < end_ && *stop == '/'; ++slashes) {
      ++stop;
      const ParsedInteger other = ParseIntegerAt(stop, end_);
      if (other.stop != nullptr) stop = other.stop;
    }
    if (!IsTokenEnd(stop)) return Expected("v, v/vt, v//vn or v/vt/vn");
    const int64_t known = static_cast<int64_t>(file_.mesh.points.size());
    const int64_t resolved = index.value > 0 ? index.value - 1 : known + index.value;
    if (index.value == 0 || resolved < 0 || resolved > std::numeric_limits<int32_t>::max()) {
      return Expected(absl::StrCat("a vertex index in 1 to ", known, " or -", known, " to -1"));
    }
    if (resolved > largest_index_) {
      largest_index_ = resolved;
      largest_index_offset_ = statement;
    }
    corners_.push_back(static_cast<int32_t>(resolved));
    p_ = stop;
    return absl::OkStatus();
  }

  const std::string_view bytes_;
  const std::string& name_;
  std::vector<size_t>* const vertex_tails_;
  const char newline_;
  const char* p_;
  const char* const end_;
  MeshFile file_;
  int64_t faces_ = 0;
  int64_t largest_index_ = -1;
  size_t largest_index_offset_ = 0;
  std::vector<int32_t> corners_;
};

}  // namespace

absl::StatusOr<MeshFile> ParseObj(std::string_view bytes, const std::string& name) {
  return ObjReader(bytes, name, nullptr).Read();
}

absl::StatusOr<std::string> AppendToObj(std::string_view bytes, const FilePatch& patch, const std::string& name) {
  std::vector<size_t> tails;
  TILEMEND_ASSIGN_OR_RETURN(const MeshFile file, ObjReader(bytes, name, &tails).Read());
  TILEMEND_RETURN_IF_ERROR(CheckPatch(patch, file.mesh.points.size(), name));
  const std::string_view eol = LineEndingOf(bytes);
  constexpr size_t kBytesPerLine = 64;  // a usual vertex line, to reserve for
  std::string out;
  out.reserve(bytes.size() + kBytesPerLine * (patch.new_points.size() + patch.triangles.size() + 2));
  out += bytes;
  if (patch.new_points.empty() && patch.triangles.empty()) return out;
  if (bytes.back() != eol.back()) out += eol;
  // A backslash at the very end would continue into the appended text.
  const size_t last = bytes.find_last_not_of("\r\n");
  if (last != std::string_view::npos && bytes[last] == '\\') out += eol;
  for (size_t k = 0; k < patch.new_points.size(); ++k) {
    out += 'v';
    for (int axis = 0; axis < 3; ++axis) {
      out += ' ';
      AppendNumber(patch.new_points[k][axis], out);
    }
    if (patch.like[k] >= 0)
      out += FurtherColumns(bytes.substr(tails[static_cast<size_t>(patch.like[k])]), eol.back(), false);
    out += eol;
  }
  if (!patch.triangles.empty()) {
    for (const std::string_view line : {"g tilemend_filled", "usemtl tilemend_filled"}) (out += line) += eol;
  }
  for (const Triangle& t : patch.triangles) {
    out += 'f';
    for (const int32_t corner : t) {
      out += ' ';
      AppendNumber(int64_t{corner} + 1, out);
    }
    out += eol;
  }
  return out;
}

}  // namespace tilemend
