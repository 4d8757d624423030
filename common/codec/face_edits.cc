#include "common/codec/face_edits.h"

#include <algorithm>
#include <functional>
#include <map>
#include <unordered_map>
#include <utility>

#include "absl/strings/str_cat.h"
#include "common/codec/obj.h"
#include "common/codec/off.h"
#include "common/codec/ply.h"
#include "common/codec/ply_source.h"
#include "common/codec/polygons.h"
#include "common/codec/stl.h"
#include "common/codec/text.h"
#include "common/util/status_macros.h"

namespace tilemend {
namespace {

absl::StatusOr<MeshFile> Visit(MeshFormat format, std::string_view bytes, const std::string& name,
                               const FaceVisitor& visit) {
  switch (format) {
    case MeshFormat::kPly:
      return ParsePly(bytes, name, visit);
    case MeshFormat::kObj:
      return ParseObj(bytes, name, visit);
    case MeshFormat::kOff:
      return ParseOff(bytes, name, visit);
    case MeshFormat::kStl:
      return ParseStl(bytes, name, visit);
    case MeshFormat::kTileTree:
      break;
  }
  return absl::InvalidArgumentError(absl::StrCat(name, ": faces of this format are not changed one by one"));
}

// How a file writes the number of a vertex at a corner.
using WriteCorner = std::function<std::string(int32_t vertex)>;

std::string AsText(int64_t number) {
  std::string text;
  AppendNumber(number, text);
  return text;
}

absl::StatusOr<WriteCorner> PlyCorners(std::string_view bytes, const std::string& name) {
  TILEMEND_ASSIGN_OR_RETURN(const PlyHeader header, ParsePlyHeader(bytes, name));
  if (header.encoding == PlyEncoding::kAscii) return AsText;
  const PlyType type = header.elements[header.face].properties[header.corners].type;
  return [type, swap = NeedsSwap(header.encoding)](int32_t vertex) {
    return WithPlyType(type, [&](auto sample) {
      std::string value(sizeof(sample), '\0');
      StoreValue(static_cast<decltype(sample)>(vertex), swap, value.data());
      return value;
    });
  };
}

absl::StatusOr<bool> HasPlacesInImages(std::string_view ply, const std::string& name) {
  TILEMEND_ASSIGN_OR_RETURN(const PlyHeader header, ParsePlyHeader(ply, name));
  return std::ranges::any_of(header.elements[header.face].properties,
                             [](const PlyProperty& property) { return property.name == "texcoord"; });
}

struct Edit {
  size_t end = 0;
  std::string text;
};

std::string WithEdits(std::string_view bytes, const std::map<size_t, Edit>& edits) {
  std::string out;
  out.reserve(bytes.size() + edits.size());
  size_t done = 0;
  for (const auto& [begin, edit] : edits) {
    out += bytes.substr(done, begin - done);
    out += edit.text;
    done = edit.end;
  }
  return out += bytes.substr(done);
}

}  // namespace

absl::StatusOr<FileFaces> ParseFaces(MeshFormat format, std::string_view bytes, const std::string& name) {
  FileFaces faces;
  int32_t face = 0;
  const auto visit = [&](size_t, std::span<const TextRange> corners, std::span<const Triangle>) {
    faces.face_of.insert(faces.face_of.end(), corners.size() - 2, face++);
    const size_t end = corners[0].end;
    faces.has_textures |= format == MeshFormat::kObj && end + 1 < bytes.size() && bytes[end] == '/' &&
                          bytes[end + 1] != '/' && !IsSpace(bytes[end + 1]);
  };
  TILEMEND_ASSIGN_OR_RETURN(faces.file, Visit(format, bytes, name, visit));
  if (format == MeshFormat::kPly) {
    TILEMEND_ASSIGN_OR_RETURN(faces.has_textures, HasPlacesInImages(bytes, name));
  }
  return faces;
}

absl::StatusOr<std::string> ChangeTriangles(MeshFormat format, std::string_view bytes,
                                            std::span<const TriangleChange> changes, const std::string& name) {
  WriteCorner write = [](int32_t vertex) { return AsText(vertex); };
  std::vector<TextRange> corner_at;  // of STL, where a corner is a vertex
  if (format == MeshFormat::kObj) write = [](int32_t vertex) { return AsText(int64_t{vertex} + 1); };
  if (format == MeshFormat::kStl) {
    write = [&](int32_t vertex) {
      const TextRange& at = corner_at[static_cast<size_t>(vertex)];
      return std::string(bytes.substr(at.begin, at.end - at.begin));
    };
    const auto note = [&](size_t, std::span<const TextRange> c, std::span<const Triangle>) {
      corner_at.insert(corner_at.end(), c.begin(), c.end());
    };
    TILEMEND_RETURN_IF_ERROR(Visit(format, bytes, name, note).status());
  }
  if (format == MeshFormat::kPly) {
    TILEMEND_ASSIGN_OR_RETURN(write, PlyCorners(bytes, name));
  }
  std::unordered_map<size_t, const TriangleChange*> change_of;
  for (const TriangleChange& change : changes) change_of[static_cast<size_t>(change.triangle)] = &change;
  std::map<size_t, Edit> edits;
  const auto visit = [&](size_t first, std::span<const TextRange> corners, std::span<const Triangle> triangles) {
    for (size_t i = 0; i < triangles.size(); ++i) {
      const auto found = change_of.find(first + i);
      if (found == change_of.end()) continue;
      for (size_t k = 0; k < 3; ++k) {
        const int32_t to = found->second->to[k];
        if (to == found->second->from[k]) continue;
        const TextRange& place = corners[static_cast<size_t>(triangles[i][k])];
        edits[place.begin] = {place.end, write(to)};
      }
    }
  };
  TILEMEND_RETURN_IF_ERROR(Visit(format, bytes, name, visit).status());
  return WithEdits(bytes, edits);
}

}  // namespace tilemend
