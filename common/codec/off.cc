#include "common/codec/off.h"

#include <algorithm>
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

struct TextRange {
  size_t begin = 0;
  size_t end = 0;
};

// Where the parts of a file lie.
struct OffLayout {
  TextRange vertex_count;  // the header's number
  TextRange face_count;
  int extra_columns = 0;                // of a vertex, by the keyword
  bool vertex_lines = true;             // a vertex a line, else several
  bool face_lines = true;               // a face a line, else several
  std::vector<TextRange> vertex_extra;  // per vertex: from its third coordinate to its last column
  size_t vertices_end = 0;              // just after the last vertex: its line with the ending, or its last column
  size_t faces_end = 0;                 // just after the last face, likewise
};

class OffReader {
 public:
  // `layout`, if given, is filled.
  OffReader(std::string_view bytes, const std::string& name, OffLayout* layout)
      : bytes_(bytes),
        name_(name),
        layout_(layout),
        newline_(LineEndingOf(bytes) == "\r" ? '\r' : '\n'),
        p_(bytes.data()),
        end_(bytes.data() + bytes.size()) {
    file_.format = MeshFormat::kOff;
    file_.file_bytes = static_cast<int64_t>(bytes.size());
  }

  absl::StatusOr<MeshFile> Read() {
    TILEMEND_RETURN_IF_ERROR(CheckLineLengths());
    TILEMEND_RETURN_IF_ERROR(ReadKeyword());
    TextRange where;
    TILEMEND_ASSIGN_OR_RETURN(const int64_t vertices, ReadCount("the number of vertices", &where));
    own_layout_.vertex_count = where;
    TILEMEND_ASSIGN_OR_RETURN(const int64_t faces, ReadCount("the number of faces", &where));
    own_layout_.face_count = where;
    TILEMEND_RETURN_IF_ERROR(ReadCount("the number of edges", &where).status());
    TILEMEND_RETURN_IF_ERROR(CheckCounts(vertices, faces));
    TILEMEND_RETURN_IF_ERROR(ReadVertices(vertices, faces));
    TILEMEND_RETURN_IF_ERROR(ReadFaces(faces));
    if (layout_ != nullptr) *layout_ = std::move(own_layout_);
    return std::move(file_);
  }

 private:
  size_t Offset() const { return static_cast<size_t>(p_ - bytes_.data()); }
  absl::Status Expected(std::string_view what) const { return LineError(name_, bytes_, Offset(), what); }
  bool IsTokenEnd(const char* p) const { return p == end_ || IsSpace(*p) || *p == '#'; }
  bool AtLineEnd() const { return p_ == end_ || *p_ == newline_ || *p_ == '#'; }

  absl::Status CheckLineLengths() const {
    for (const char* line = p_; line < end_;) {
      const char* stop = FindLineEnd(line);
      if (static_cast<size_t>(stop - line) > kMaxLineBytes) {
        return LineProblem(name_, bytes_, static_cast<size_t>(line - bytes_.data()),
                           absl::StrCat("the line is longer than ", kMaxLineBytes, " bytes"));
      }
      line = stop == end_ ? end_ : stop + 1;
    }
    return absl::OkStatus();
  }

  const char* FindLineEnd(const char* from) const {
    const void* found = from == end_ ? nullptr : std::memchr(from, newline_, static_cast<size_t>(end_ - from));
    return found == nullptr ? end_ : static_cast<const char*>(found);
  }

  void SkipBlanks() {
    while (p_ < end_ && IsSpace(*p_) && *p_ != newline_) ++p_;
  }
  void SkipLine() {
    p_ = FindLineEnd(p_);
    if (p_ < end_) ++p_;
  }
  // To the next token, over line ends and comments.
  void SkipToToken() {
    for (SkipBlanks(); p_ < end_ && AtLineEnd(); SkipBlanks()) SkipLine();
  }

  // Lines from here on that hold more than a comment.
  int64_t CountDataLines() const {
    OffReader ahead(bytes_, name_, nullptr);
    ahead.p_ = p_;
    int64_t lines = 0;
    for (ahead.SkipToToken(); ahead.p_ < end_; ahead.SkipToToken()) {
      ++lines;
      ahead.SkipLine();
    }
    return lines;
  }

  absl::Status ReadKeyword() {
    if (bytes_.substr(0, 3) == "\xef\xbb\xbf") p_ += 3;  // a byte order mark
    SkipToToken();
    const std::string_view rest = bytes_.substr(Offset());
    size_t length = 0;
    const auto take = [&rest, &length](std::string_view prefix) {
      const bool found = rest.substr(length, prefix.size()) == prefix;
      if (found) length += prefix.size();
      return found;
    };
    if (take("ST")) own_layout_.extra_columns += 2;
    if (take("C")) own_layout_.extra_columns += 4;
    if (take("N")) own_layout_.extra_columns += 3;
    if (!take("OFF")) return Expected("OFF, COFF, NOFF or STOFF");
    p_ += length;
    return absl::OkStatus();
  }

  absl::StatusOr<int64_t> ReadCount(std::string_view what, TextRange* where) {
    SkipToToken();
    const ParsedInteger count = ParseIntegerAt(p_, end_);
    if (count.stop == nullptr || !IsTokenEnd(count.stop) || count.value < 0) return Expected(what);
    if (count.value > std::numeric_limits<int32_t>::max())
      return Expected(absl::StrCat(std::string(what), " below 2^31"));
    where->begin = Offset();
    p_ = count.stop;
    where->end = Offset();
    return count.value;
  }

  // The shortest vertex is "0 0 0", the shortest face "0", each with a separator.
  absl::Status CheckCounts(int64_t vertices, int64_t faces) const {
    constexpr int64_t kLeastVertexBytes = 6;
    constexpr int64_t kLeastFaceBytes = 2;
    if (vertices == 0) return absl::InvalidArgumentError(absl::StrCat(name_, ": the file has no vertices"));
    if (vertices * kLeastVertexBytes + faces * kLeastFaceBytes > end_ - p_ + 1) {
      return LineProblem(name_, bytes_, own_layout_.vertex_count.begin,
                         absl::StrCat("expected data of ", vertices, " vertices and ", faces, " faces, found only ",
                                      end_ - p_, " bytes"));
    }
    return absl::OkStatus();
  }

  absl::Status ReadVertices(int64_t count, int64_t faces) {
    own_layout_.vertex_lines = CountDataLines() >= count + faces;
    file_.mesh.points.reserve(static_cast<size_t>(count));
    if (layout_ != nullptr) own_layout_.vertex_extra.reserve(static_cast<size_t>(count));
    for (int64_t k = 0; k < count; ++k) TILEMEND_RETURN_IF_ERROR(ReadVertex());
    own_layout_.vertices_end = own_layout_.faces_end = Offset();
    return absl::OkStatus();
  }

  absl::Status ReadVertex() {
    SkipToToken();
    Point3 point;
    for (int axis = 0; axis < 3; ++axis) {
      own_layout_.vertex_lines ? SkipBlanks() : SkipToToken();
      const ParsedDouble number = ParseDoubleAt(p_, end_);
      if (number.stop == nullptr || !IsTokenEnd(number.stop)) return Expected("a coordinate");
      if (!IsValidCoordinate(number.value)) return Expected("a coordinate of at most 1e9 m");
      point[axis] = number.value;
      p_ = number.stop;
    }
    file_.mesh.points.push_back(point);
    TextRange extra{Offset(), Offset()};
    if (own_layout_.vertex_lines) {
      for (SkipBlanks(); !AtLineEnd(); SkipBlanks()) extra.end = SkipToken();
      SkipLine();
    } else {
      for (int column = 0; column < own_layout_.extra_columns; ++column) {
        SkipToToken();
        if (p_ == end_) return Expected("a further column of a vertex");
        extra.end = SkipToken();
      }
    }
    if (layout_ != nullptr) own_layout_.vertex_extra.push_back(extra);
    return absl::OkStatus();
  }

  size_t SkipToken() {
    while (!IsTokenEnd(p_)) ++p_;
    return Offset();
  }

  absl::Status ReadFaces(int64_t count) {
    own_layout_.face_lines = CountDataLines() >= count;
    // A triangle takes at least "3 0 1 2".
    file_.mesh.triangles.reserve(static_cast<size_t>(std::min<int64_t>(count, (end_ - p_) / 7 + 1)));
    for (int64_t k = 0; k < count; ++k) {
      TILEMEND_RETURN_IF_ERROR(ReadFace());
      own_layout_.faces_end = Offset();
    }
    if (own_layout_.face_lines) return absl::OkStatus();
    SkipToToken();
    if (p_ < end_) return Expected(absl::StrCat("the end after ", count, " faces"));
    return absl::OkStatus();
  }

  absl::Status ReadFace() {
    SkipToToken();
    const ParsedInteger count = ParseIntegerAt(p_, end_);
    // With several faces on a line, a face without corners is more likely a colour that was left over.
    const int64_t least = own_layout_.face_lines ? 0 : 1;
    if (count.stop == nullptr || !IsTokenEnd(count.stop) || count.value < least || count.value > kMaxListCount) {
      return Expected("the number of corners of a face");
    }
    p_ = count.stop;
    corners_.clear();
    const int64_t vertices = static_cast<int64_t>(file_.mesh.points.size());
    for (int64_t k = 0; k < count.value; ++k) {
      own_layout_.face_lines ? SkipBlanks() : SkipToToken();
      const ParsedInteger index = ParseIntegerAt(p_, end_);
      if (index.stop == nullptr || !IsTokenEnd(index.stop) || index.value < 0 || index.value >= vertices) {
        return Expected(absl::StrCat("a vertex index in 0 to ", vertices - 1));
      }
      corners_.push_back(static_cast<int32_t>(index.value));
      p_ = index.stop;
    }
    AddPolygon(corners_, file_);
    if (own_layout_.face_lines) SkipLine();
    return absl::OkStatus();
  }

  const std::string_view bytes_;
  const std::string& name_;
  OffLayout* const layout_;
  const char newline_;
  const char* p_;
  const char* const end_;
  MeshFile file_;
  OffLayout own_layout_;
  std::vector<int32_t> corners_;
};

// Writes the records of a patch so that the file keeps its way of lines: where records have lines of their own, so have
// the new ones; where they share lines, the first new one shares the last old one's. (A reader tells the two apart by
// the number of lines.)
class RecordWriter {
 public:
  RecordWriter(bool own_lines, std::string_view eol, std::string& out) : own_lines_(own_lines), eol_(eol), out_(out) {
    if (own_lines_ && out_.back() != eol_.back()) out_ += eol_;
  }
  void Begin() {
    if (!own_lines_) out_ += first_ ? " " : eol_;
    first_ = false;
  }
  void End() {
    if (own_lines_) out_ += eol_;
  }

 private:
  const bool own_lines_;
  const std::string_view eol_;
  std::string& out_;
  bool first_ = true;
};

void AppendVertices(std::string_view bytes, const FilePatch& patch, const OffLayout& layout, std::string& out) {
  const std::string_view eol = LineEndingOf(bytes);
  RecordWriter writer(layout.vertex_lines, eol, out);
  for (size_t k = 0; k < patch.new_points.size(); ++k) {
    writer.Begin();
    for (int axis = 0; axis < 3; ++axis) {
      if (axis > 0) out += ' ';
      AppendNumber(patch.new_points[k][axis], out);
    }
    if (patch.like[k] >= 0) {
      const TextRange extra = layout.vertex_extra[static_cast<size_t>(patch.like[k])];
      out += FurtherColumns(bytes.substr(extra.begin, extra.end - extra.begin), eol.back(), true);
    } else {
      for (int column = 0; column < layout.extra_columns; ++column) out += " 0";
    }
    writer.End();
  }
}

void AppendFaces(std::string_view eol, const FilePatch& patch, bool own_lines, std::string& out) {
  RecordWriter writer(own_lines, eol, out);
  for (const Triangle& t : patch.triangles) {
    writer.Begin();
    out += '3';
    for (const int32_t corner : t) {
      out += ' ';
      AppendNumber(int64_t{corner}, out);
    }
    writer.End();
  }
}

}  // namespace

absl::StatusOr<MeshFile> ParseOff(std::string_view bytes, const std::string& name) {
  return OffReader(bytes, name, nullptr).Read();
}

absl::StatusOr<std::string> AppendToOff(std::string_view bytes, const FilePatch& patch, const std::string& name) {
  OffLayout layout;
  TILEMEND_ASSIGN_OR_RETURN(const MeshFile file, OffReader(bytes, name, &layout).Read());
  TILEMEND_RETURN_IF_ERROR(CheckPatch(patch, file.mesh.points.size(), name));
  const auto count_of = [bytes](TextRange range) {
    return ParseIntegerAt(bytes.data() + range.begin, bytes.data() + range.end).value;
  };
  constexpr size_t kBytesPerRecord = 64;  // a usual vertex line, to reserve for
  std::string out;
  out.reserve(bytes.size() + kBytesPerRecord * (patch.new_points.size() + patch.triangles.size() + 1));
  size_t done = 0;
  const auto copy_to = [&](size_t offset) {
    out += bytes.substr(done, offset - done);
    done = offset;
  };
  copy_to(layout.vertex_count.begin);
  AppendNumber(count_of(layout.vertex_count) + static_cast<int64_t>(patch.new_points.size()), out);
  done = layout.vertex_count.end;
  copy_to(layout.face_count.begin);
  AppendNumber(count_of(layout.face_count) + static_cast<int64_t>(patch.triangles.size()), out);
  done = layout.face_count.end;
  copy_to(layout.vertices_end);
  if (!patch.new_points.empty()) AppendVertices(bytes, patch, layout, out);
  copy_to(layout.faces_end);
  if (!patch.triangles.empty()) AppendFaces(LineEndingOf(bytes), patch, layout.face_lines, out);
  copy_to(bytes.size());
  return out;
}

}  // namespace tilemend
