#include "common/codec/off.h"

#include <algorithm>
#include <cstring>
#include <limits>
#include <utility>
#include <vector>

#include "absl/strings/str_cat.h"
#include "common/codec/text.h"
#include "common/util/status_macros.h"

namespace tilemend {
namespace {

struct OffHeader {
  int64_t vertices = 0;
  int64_t faces = 0;
  TextRange vertex_count;  // the number of vertices in the text
  TextRange face_count;
  int extra_columns = 0;  // of a vertex, by the keyword
};

// Goes through the text of a file: the header, then tokens and lines.
class OffCursor {
 public:
  OffCursor(std::string_view bytes, const std::string& name)
      : bytes_(bytes),
        name_(name),
        newline_(LineEndingOf(bytes) == "\r" ? '\r' : '\n'),
        p_(bytes.data()),
        end_(bytes.data() + bytes.size()) {}

 protected:
  size_t Offset() const { return static_cast<size_t>(p_ - bytes_.data()); }
  absl::Status Expected(std::string_view what) const { return LineError(name_, bytes_, Offset(), what); }
  bool IsTokenEnd(const char* p) const { return p == end_ || IsSpace(*p) || *p == '#'; }
  bool AtLineEnd() const { return p_ == end_ || *p_ == newline_ || *p_ == '#'; }

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
  void SkipToken() {
    while (!IsTokenEnd(p_)) ++p_;
  }

  // Lines from here on that hold more than a comment.
  int64_t CountDataLines() const {
    OffCursor ahead = *this;
    int64_t lines = 0;
    for (ahead.SkipToToken(); ahead.p_ < end_; ahead.SkipToToken()) {
      ++lines;
      ahead.SkipLine();
    }
    return lines;
  }

  absl::Status ReadHeader() {
    TILEMEND_RETURN_IF_ERROR(CheckLineLengths());
    TILEMEND_RETURN_IF_ERROR(ReadKeyword());
    TILEMEND_ASSIGN_OR_RETURN(header_.vertices, ReadCount("the number of vertices", &header_.vertex_count));
    TILEMEND_ASSIGN_OR_RETURN(header_.faces, ReadCount("the number of faces", &header_.face_count));
    TextRange unused;
    TILEMEND_RETURN_IF_ERROR(ReadCount("the number of edges", &unused).status());
    TILEMEND_RETURN_IF_ERROR(CheckCounts());
    data_lines_ = CountDataLines();
    return absl::OkStatus();
  }

  // Whether vertices, and faces after all vertices are read, have a line each; else several share one.
  bool VertexLines() const { return data_lines_ >= header_.vertices + header_.faces; }
  bool FaceLines() const {
    return (VertexLines() ? data_lines_ - header_.vertices : CountDataLines()) >= header_.faces;
  }

  const std::string_view bytes_;
  const std::string& name_;
  const char newline_;
  const char* p_;
  const char* const end_;
  OffHeader header_;

 private:
  absl::Status CheckLineLengths() const {
    for (size_t line = 0; bytes_.size() - line > kMaxLineBytes;) {
      const size_t last = bytes_.substr(line, kMaxLineBytes + 1).rfind(newline_);
      if (last == std::string_view::npos) {
        return LineProblem(name_, bytes_, line, absl::StrCat("the line is longer than ", kMaxLineBytes, " bytes"));
      }
      line += last + 1;
    }
    return absl::OkStatus();
  }

  const char* FindLineEnd(const char* from) const {
    const void* found = from == end_ ? nullptr : std::memchr(from, newline_, static_cast<size_t>(end_ - from));
    return found == nullptr ? end_ : static_cast<const char*>(found);
  }

  absl::Status ReadKeyword() {
    p_ += TextStart(bytes_);
    SkipToToken();
    const std::string_view rest = bytes_.substr(Offset());
    size_t length = 0;
    const auto take = [&rest, &length](std::string_view prefix) {
      const bool found = rest.substr(length, prefix.size()) == prefix;
      if (found) length += prefix.size();
      return found;
    };
    if (take("ST")) header_.extra_columns += 2;
    if (take("C")) header_.extra_columns += 4;
    if (take("N")) header_.extra_columns += 3;
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
  absl::Status CheckCounts() const {
    constexpr int64_t kLeastVertexBytes = 6;
    constexpr int64_t kLeastFaceBytes = 2;
    if (header_.vertices == 0) return absl::InvalidArgumentError(absl::StrCat(name_, ": ", kNoVertices));
    if (header_.faces == 0) return absl::InvalidArgumentError(absl::StrCat(name_, ": the file has no faces"));
    if (header_.vertices * kLeastVertexBytes + header_.faces * kLeastFaceBytes > end_ - p_ + 1) {
      return LineProblem(name_, bytes_, header_.vertex_count.begin,
                         absl::StrCat("expected data of ", header_.vertices, " vertices and ", header_.faces,
                                      " faces, found only ", end_ - p_, " bytes"));
    }
    return absl::OkStatus();
  }

  int64_t data_lines_ = 0;  // after the header
};

class OffReader : private OffCursor {
 public:
  OffReader(std::string_view bytes, const std::string& name, const FaceVisitor& visit)
      : OffCursor(bytes, name), visit_(visit) {
    file_.format = MeshFormat::kOff;
    file_.file_bytes = static_cast<int64_t>(bytes.size());
  }

  absl::StatusOr<MeshFile> Read() {
    TILEMEND_RETURN_IF_ERROR(ReadHeader());
    vertex_lines_ = VertexLines();
    file_.mesh.points.reserve(static_cast<size_t>(header_.vertices));
    for (int64_t k = 0; k < header_.vertices; ++k) TILEMEND_RETURN_IF_ERROR(ReadVertex());
    face_lines_ = FaceLines();
    // A triangle takes at least "3 0 1 2".
    file_.mesh.triangles.reserve(static_cast<size_t>(std::min<int64_t>(header_.faces, (end_ - p_) / 7 + 1)));
    for (int64_t k = 0; k < header_.faces; ++k) TILEMEND_RETURN_IF_ERROR(ReadFace());
    if (face_lines_) return std::move(file_);
    SkipToToken();
    if (p_ < end_) return Expected(absl::StrCat("the end after ", header_.faces, " faces"));
    return std::move(file_);
  }

 private:
  absl::Status ReadVertex() {
    SkipToToken();
    Point3 point;
    for (int axis = 0; axis < 3; ++axis) {
      vertex_lines_ ? SkipBlanks() : SkipToToken();
      const ParsedDouble number = ParseDoubleAt(p_, end_);
      if (number.stop == nullptr || !IsTokenEnd(number.stop)) return Expected("a coordinate");
      if (!IsValidCoordinate(number.value)) return Expected(kCoordinate);
      point[axis] = number.value;
      p_ = number.stop;
    }
    file_.mesh.points.push_back(point);
    if (vertex_lines_) {
      SkipLine();
      return absl::OkStatus();
    }
    for (int column = 0; column < header_.extra_columns; ++column) {
      SkipToToken();
      if (p_ == end_) return Expected("a further column of a vertex");
      SkipToken();
    }
    return absl::OkStatus();
  }

  absl::Status ReadFace() {
    SkipToToken();
    const ParsedInteger count = ParseIntegerAt(p_, end_);
    // With several faces on a line, a face without corners is more likely a colour that was left over.
    const int64_t least = face_lines_ ? 0 : 1;
    if (count.stop == nullptr || !IsTokenEnd(count.stop) || count.value < least || count.value > kMaxListCount) {
      return Expected("the number of corners of a face");
    }
    p_ = count.stop;
    corners_.clear();
    places_.clear();
    const int64_t vertices = static_cast<int64_t>(file_.mesh.points.size());
    for (int64_t k = 0; k < count.value; ++k) {
      face_lines_ ? SkipBlanks() : SkipToToken();
      const ParsedInteger index = ParseIntegerAt(p_, end_);
      if (index.stop == nullptr || !IsTokenEnd(index.stop) || index.value < 0 || index.value >= vertices) {
        return Expected(absl::StrCat("a vertex index in 0 to ", vertices - 1));
      }
      corners_.push_back(static_cast<int32_t>(index.value));
      if (visit_) places_.push_back({Offset(), static_cast<size_t>(index.stop - bytes_.data())});
      p_ = index.stop;
    }
    AddPolygon(corners_, places_, visit_, file_, cut_);
    if (face_lines_) SkipLine();
    return absl::OkStatus();
  }

  const FaceVisitor& visit_;
  MeshFile file_;
  bool vertex_lines_ = true;
  bool face_lines_ = true;
  std::vector<int32_t> corners_;
  std::vector<Triangle> cut_;      // by places in corners_
  std::vector<TextRange> places_;  // of corners_
};

// Where the parts of a file lie.
struct OffLayout {
  OffHeader header;
  bool vertex_lines = true;    // a vertex a line, else several
  bool face_lines = true;      // a face a line, else several
  std::vector<size_t> vertex;  // per vertex: its first column
  size_t vertices_end = 0;     // just after the last vertex: its line with the ending, or its last column
  size_t faces_end = 0;        // just after the last face, likewise
};

// Finds the parts of a file that OffReader reads, without reading a coordinate or an index again.
class OffLayoutFinder : private OffCursor {
 public:
  using OffCursor::OffCursor;

  absl::StatusOr<OffLayout> Find() {
    TILEMEND_RETURN_IF_ERROR(ReadHeader());
    layout_.header = header_;
    layout_.vertex_lines = VertexLines();
    layout_.vertex.reserve(static_cast<size_t>(header_.vertices));
    for (int64_t k = 0; k < header_.vertices; ++k) {
      SkipToToken();
      if (p_ == end_) return Expected("a coordinate");
      layout_.vertex.push_back(Offset());
      layout_.vertex_lines ? SkipLine() : SkipTokens(kCoordinates + header_.extra_columns);
    }
    layout_.vertices_end = layout_.faces_end = Offset();
    layout_.face_lines = FaceLines();
    for (int64_t k = 0; k < header_.faces; ++k) {
      SkipToToken();
      if (p_ == end_) return Expected("the number of corners of a face");
      layout_.face_lines ? SkipLine()
                         : SkipTokens(1 + std::clamp<int64_t>(ParseIntegerAt(p_, end_).value, 0, kMaxListCount));
      layout_.faces_end = Offset();
    }
    return std::move(layout_);
  }

  // The further columns of a vertex, each after a space.
  std::string FurtherColumnsOf(const OffLayout& layout, int32_t vertex) {
    p_ = bytes_.data() + layout.vertex[static_cast<size_t>(vertex)];
    SkipTokens(kCoordinates);
    const size_t begin = Offset();
    layout.vertex_lines ? SkipLine() : SkipTokens(layout.header.extra_columns);
    return FurtherColumns(bytes_.substr(begin, Offset() - begin), newline_, true);
  }

 private:
  static constexpr int kCoordinates = 3;

  // To the end of the last of `count` tokens.
  void SkipTokens(int64_t count) {
    for (int64_t k = 0; k < count && p_ < end_; ++k) {
      SkipToToken();
      SkipToken();
    }
  }

  OffLayout layout_;
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

void AppendVertices(std::string_view eol, const FilePatch& patch, const OffLayout& layout, OffLayoutFinder& finder,
                    std::string& out) {
  RecordWriter writer(layout.vertex_lines, eol, out);
  for (size_t k = 0; k < patch.new_points.size(); ++k) {
    writer.Begin();
    for (int axis = 0; axis < 3; ++axis) {
      if (axis > 0) out += ' ';
      AppendNumber(patch.new_points[k][axis], out);
    }
    if (patch.like[k] >= 0) {
      out += finder.FurtherColumnsOf(layout, patch.like[k]);
    } else {
      for (int column = 0; column < layout.header.extra_columns; ++column) out += " 0";
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

absl::StatusOr<MeshFile> ParseOff(std::string_view bytes, const std::string& name, const FaceVisitor& visit) {
  return OffReader(bytes, name, visit).Read();
}

absl::StatusOr<std::string> AppendToOff(std::string_view bytes, const FilePatch& patch, const std::string& name) {
  OffLayoutFinder finder(bytes, name);
  TILEMEND_ASSIGN_OR_RETURN(const OffLayout layout, finder.Find());
  TILEMEND_RETURN_IF_ERROR(CheckPatch(patch, layout.vertex.size(), name));
  const std::string_view eol = LineEndingOf(bytes);
  constexpr size_t kBytesPerRecord = 64;  // a usual vertex line, to reserve for
  std::string out;
  out.reserve(bytes.size() + kBytesPerRecord * (patch.new_points.size() + patch.triangles.size() + 1));
  size_t done = 0;
  const auto copy_to = [&](size_t offset) {
    out += bytes.substr(done, offset - done);
    done = offset;
  };
  copy_to(layout.header.vertex_count.begin);
  AppendNumber(layout.header.vertices + static_cast<int64_t>(patch.new_points.size()), out);
  done = layout.header.vertex_count.end;
  copy_to(layout.header.face_count.begin);
  AppendNumber(layout.header.faces + static_cast<int64_t>(patch.triangles.size()), out);
  done = layout.header.face_count.end;
  copy_to(layout.vertices_end);
  if (!patch.new_points.empty()) AppendVertices(eol, patch, layout, finder, out);
  copy_to(layout.faces_end);
  if (!patch.triangles.empty()) AppendFaces(eol, patch, layout.face_lines, out);
  copy_to(bytes.size());
  return out;
}

}  // namespace tilemend
