#include "common/codec/drop_faces.h"

#include <algorithm>
#include <cstdint>
#include <span>

#include "absl/strings/str_cat.h"
#include "common/codec/obj.h"
#include "common/codec/ply.h"
#include "common/codec/polygons.h"
#include "common/codec/text.h"
#include "common/util/status_macros.h"

namespace tilemend {
namespace {

// Hears of faces and keeps the place of those that go.
class DroppedFaces {
 public:
  explicit DroppedFaces(const std::vector<bool>& drop) : drop_(drop) {}

  FaceVisitor Visitor() {
    return [this](size_t first, std::span<const TextRange> corners, std::span<const Triangle> triangles) {
      for (size_t i = 0; i < triangles.size(); ++i) {
        if (!drop_[first + i]) return;
      }
      corners_.push_back({corners.front().begin, corners.back().end});
    };
  }

  // Of each face, rising: from its first corner to its last.
  const std::vector<TextRange>& corners() const { return corners_; }

 private:
  const std::vector<bool>& drop_;
  std::vector<TextRange> corners_;
};

std::string Without(std::string_view bytes, std::span<const TextRange> ranges) {
  std::string out;
  out.reserve(bytes.size());
  size_t done = 0;
  for (const TextRange& range : ranges) {
    out += bytes.substr(done, range.begin - done);
    done = range.end;
  }
  return out += bytes.substr(done);
}

// The lines of the statement whose corners lie at `corners`. A backslash at the end of a line continues it.
TextRange LinesOf(std::string_view bytes, const TextRange& corners, char newline) {
  const size_t word = bytes.rfind('f', corners.begin);
  const size_t before = word == 0 ? std::string_view::npos : bytes.rfind(newline, word - 1);
  TextRange lines{before == std::string_view::npos ? TextStart(bytes) : before + 1, corners.end};
  for (bool continued = true; continued;) {
    const size_t stop = bytes.find(newline, lines.end);
    if (stop == std::string_view::npos) return {lines.begin, bytes.size()};
    std::string_view rest = bytes.substr(lines.end, stop - lines.end);
    if (rest.ends_with('\r')) rest.remove_suffix(1);
    continued = rest.ends_with('\\') && rest.find('#') == std::string_view::npos;
    lines.end = stop + 1;
  }
  return lines;
}

absl::StatusOr<std::string> DropFromObj(std::string_view bytes, const std::vector<bool>& drop,
                                        const std::string& name) {
  DroppedFaces dropped(drop);
  TILEMEND_RETURN_IF_ERROR(ParseObj(bytes, name, dropped.Visitor()).status());
  const char newline = LineEndingOf(bytes).back();
  std::vector<TextRange> lines;
  for (const TextRange& corners : dropped.corners()) lines.push_back(LinesOf(bytes, corners, newline));
  return Without(bytes, lines);
}

// Where each face of a PLY file ends, rising; the first begins where the element before ends.
std::vector<size_t> FaceEnds(const PlyHeader& header, const PlyRecords& records, size_t begin) {
  if (records.face_bytes == 0) return records.face_ends;
  std::vector<size_t> ends;
  for (int64_t k = 1; k <= header.elements[header.face].count; ++k) {
    ends.push_back(begin + static_cast<size_t>(k) * records.face_bytes);
  }
  return ends;
}

absl::StatusOr<std::string> DropFromPly(std::string_view bytes, const std::vector<bool>& drop,
                                        const std::string& name) {
  TILEMEND_ASSIGN_OR_RETURN(const PlyHeader header, ParsePlyHeader(bytes, name));
  DroppedFaces dropped(drop);
  TILEMEND_RETURN_IF_ERROR(ReadPlyBody(bytes, header, name, nullptr, dropped.Visitor()).status());
  PlyRecords records;
  TILEMEND_RETURN_IF_ERROR(ReadPlyBody(bytes, header, name, &records).status());
  const size_t first = header.face == 0 ? header.body_begin : records.element_ends[header.face - 1];
  const std::vector<size_t> ends = FaceEnds(header, records, first);
  const PlyElement& faces = header.elements[header.face];
  std::vector<TextRange> ranges;
  for (const TextRange& corners : dropped.corners()) {
    const auto end = std::ranges::upper_bound(ends, corners.begin);
    ranges.push_back({end == ends.begin() ? first : *(end - 1), *end});
  }
  const int64_t left = faces.count - static_cast<int64_t>(dropped.corners().size());
  const std::string body = Without(bytes, ranges);
  return absl::StrCat(body.substr(0, faces.count_begin), left, body.substr(faces.count_end));
}

}  // namespace

absl::StatusOr<std::string> DropFaces(MeshFormat format, std::string_view bytes, const std::vector<bool>& drop,
                                      const std::string& name) {
  if (format == MeshFormat::kObj) return DropFromObj(bytes, drop, name);
  if (format == MeshFormat::kPly) return DropFromPly(bytes, drop, name);
  return absl::InvalidArgumentError(
      absl::StrCat(name, ": surface can be taken out (\"clear\") of OBJ and PLY files only; convert the tiles first"));
}

}  // namespace tilemend
