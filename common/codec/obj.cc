#include "common/codec/obj.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <map>
#include <utility>

#include "absl/hash/hash.h"
#include "absl/strings/str_cat.h"
#include "absl/strings/str_format.h"
#include "common/codec/text.h"
#include "common/util/status_macros.h"

namespace tilemend {
namespace {

// The number of `text` in `names`, where it is put if it is new.
int32_t NumberOf(std::string_view text, std::map<std::string_view, int32_t>& numbers, std::vector<std::string>& names) {
  const auto [it, fresh] = numbers.try_emplace(text, static_cast<int32_t>(names.size()));
  if (fresh) names.emplace_back(text);
  return it->second;
}

// Adds the triangles of a face from its first corner, and puts them into `cut` by places of its corners.
void AddFan(const std::vector<int32_t>& corners, MeshFile& file, std::vector<Triangle>& cut) {
  for (size_t i = 2; i < corners.size(); ++i) {
    cut.push_back({0, static_cast<int32_t>(i) - 1, static_cast<int32_t>(i)});
    file.mesh.triangles.push_back({corners[0], corners[i - 1], corners[i]});
  }
}

class ObjReader {
 public:
  // `vertex_tails`, if given, gets for each vertex the offset just after its third coordinate.
  ObjReader(std::string_view bytes, const std::string& name, std::vector<size_t>* vertex_tails,
            ObjTextures* textures = nullptr, FaceVisitor visit = {}, NoFaces no_faces = NoFaces::kRefuse,
            FlatFaces flat_faces = FlatFaces::kLeaveOut)
      : bytes_(bytes),
        name_(name),
        vertex_tails_(vertex_tails),
        textures_(textures),
        visit_(std::move(visit)),
        no_faces_(no_faces),
        flat_faces_(flat_faces),
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
    if (vertices == 0) return absl::InvalidArgumentError(absl::StrCat(name_, ": ", kNoVertices));
    if (faces_ == 0 && no_faces_ == NoFaces::kRefuse)
      return absl::InvalidArgumentError(absl::StrCat(name_, ": the file has no faces"));
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
    p_ += TextStart(bytes_);
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
    if (length == 1 && *begin == 'f' && !vertices_only_) return ReadFace();
    if (textures_ != nullptr) ReadTextureStatement({begin, length}, stop);
    const bool letter = (*begin >= 'a' && *begin <= 'z') || (*begin >= 'A' && *begin <= 'Z');
    if (!letter) return Expected("an OBJ statement");
    p_ = stop;
    return absl::OkStatus();
  }

  // Statements on the look of the surface are taken as they come: damage in them is no damage to the geometry.
  void ReadTextureStatement(std::string_view word, const char* p) {
    if (word == "vt") {
      textures_->coordinates.push_back(CoordinatesAt(p));
    } else if (word == "usemtl") {
      const auto first = static_cast<int32_t>(file_.mesh.triangles.size());
      textures_->runs.push_back({first, NumberOf(RestOfLine(p), materials_, textures_->materials)});
    } else if (word == "mtllib") {
      NumberOf(RestOfLine(p), libraries_, textures_->libraries);
    } else if (word == "g") {
      const bool is_filled = RestOfLine(p) == kFilledGroup;
      textures_->groups.push_back({static_cast<int32_t>(file_.mesh.triangles.size()), is_filled});
    } else if (word == "l" || word == "p") {
      ++textures_->lines_and_points;
    }
  }

  // Of the vertex whose coordinates were read: three numbers from 0 to 1. One number more is a weight.
  void NoteVertexColour() {
    const std::optional<Rgb> colour = ColourAt(p_);
    std::vector<std::optional<Rgb>>& colours = textures_->vertex_colours;
    if (!colour && colours.empty()) return;
    colours.resize(file_.mesh.points.size() - 1);  // vertices before the first colour have none
    colours.push_back(colour);
  }

  std::optional<Rgb> ColourAt(const char* p) const {
    const auto skip_blanks = [&] {
      while (p < end_ && IsSpace(*p) && *p != newline_) ++p;
    };
    std::array<uint8_t, 3> channels{};
    for (uint8_t& channel : channels) {
      skip_blanks();
      const ParsedDouble number = ParseDoubleAt(p, end_);
      if (number.stop == nullptr || !std::isfinite(number.value)) return std::nullopt;
      channel = static_cast<uint8_t>(std::lround(255 * std::clamp(number.value, 0.0, 1.0)));
      p = number.stop;
    }
    skip_blanks();
    if (p < end_ && *p != newline_ && *p != '#') return std::nullopt;
    return Rgb{channels[0], channels[1], channels[2]};
  }

  std::array<float, 2> CoordinatesAt(const char* p) const {
    std::array<float, 2> result;
    for (float& value : result) {
      while (p < end_ && IsSpace(*p) && *p != newline_) ++p;
      const ParsedDouble number = ParseDoubleAt(p, end_);
      if (number.stop == nullptr) return {std::nanf(""), std::nanf("")};
      value = static_cast<float>(number.value);
      p = number.stop;
    }
    return result;
  }

  // Without the blanks around it.
  std::string_view RestOfLine(const char* p) const {
    const char* stop = std::find(p, end_, newline_);
    while (p < stop && IsSpace(*p)) ++p;
    while (p < stop && IsSpace(stop[-1])) --stop;
    return {p, static_cast<size_t>(stop - p)};
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
      if (!IsValidCoordinate(number.value)) return Expected(kCoordinate);
      point[axis] = number.value;
      p_ = number.stop;
    }
    file_.mesh.points.push_back(point);
    if (vertex_tails_ != nullptr) vertex_tails_->push_back(Offset());
    if (textures_ != nullptr) NoteVertexColour();
    if (textures_ != nullptr) ReadFurtherColumns();
    return absl::OkStatus();
  }

  void ReadFurtherColumns() {
    SkipBlanks();
    if (AtStatementEnd()) return;
    textures_->vertex_columns.resize(file_.mesh.points.size());
    textures_->vertex_columns.back() = absl::HashOf(FurtherColumns(bytes_.substr(Offset()), newline_, false));
  }

  absl::Status ReadFace() {
    const size_t statement = Offset();
    ++p_;
    ++faces_;
    corners_.clear();
    places_.clear();
    texture_corners_.clear();
    for (SkipBlanks(); !AtStatementEnd(); SkipBlanks()) {
      TILEMEND_RETURN_IF_ERROR(ReadCorner(statement));
      if (static_cast<int64_t>(corners_.size()) > kMaxListCount) {
        return LineProblem(name_, bytes_, statement,
                           absl::StrCat("the face has more than ", kMaxListCount, " corners"));
      }
    }
    if (corners_.size() < 3 && p_ == end_)
      return LineProblem(name_, bytes_, statement, "the file ends within a face: it is cut off");
    const bool is_early = corners_.size() > 3 && *std::ranges::max_element(corners_) >= std::ssize(file_.mesh.points);
    if (is_early && all_points_.empty()) TILEMEND_RETURN_IF_ERROR(ReadAllPoints());
    AddPolygon(corners_, places_, visit_, file_, cut_, all_points_);
    if (cut_.empty() && flat_faces_ == FlatFaces::kKeep) AddFan(corners_, file_, cut_);
    if (textures_ != nullptr) {
      textures_->short_faces += corners_.size() < 3 ? 1 : 0;
      for (const auto& [a, b, c] : cut_) {
        textures_->corners.push_back({texture_corners_[a], texture_corners_[b], texture_corners_[c]});
      }
    }
    return absl::OkStatus();
  }

  // How a polygon is cut depends on its vertices, which this one stands before.
  absl::Status ReadAllPoints() {
    ObjReader reader(bytes_, name_, nullptr, nullptr, {}, NoFaces::kAccept);
    reader.vertices_only_ = true;
    TILEMEND_ASSIGN_OR_RETURN(MeshFile file, reader.Read());
    all_points_ = std::move(file.mesh.points);
    return absl::OkStatus();
  }

  // "v", "v/vt", "v//vn", "v/vt/vn", also with an index left out after a slash ("2/2/").
  absl::Status ReadCorner(size_t statement) {
    const ParsedInteger index = ParseIntegerAt(p_, end_);
    if (index.stop == nullptr) return Expected("a vertex index");
    const char* stop = index.stop;
    int64_t texture = 0;
    for (int slashes = 0; slashes < 2 && stop < end_ && *stop == '/'; ++slashes) {
      ++stop;
      const ParsedInteger other = ParseIntegerAt(stop, end_);
      if (other.stop == nullptr) continue;
      stop = other.stop;
      if (slashes == 0) texture = other.value;
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
    if (visit_) places_.push_back({Offset(), static_cast<size_t>(index.stop - bytes_.data())});
    if (textures_ != nullptr) texture_corners_.push_back(TextureIndex(texture));
    p_ = stop;
    return absl::OkStatus();
  }

  // -1 for an index that cannot be right.
  int32_t TextureIndex(int64_t index) const {
    const int64_t known = static_cast<int64_t>(textures_->coordinates.size());
    const int64_t resolved = index > 0 ? index - 1 : known + index;
    const bool valid = index != 0 && resolved >= 0 && resolved < std::numeric_limits<int32_t>::max();
    return valid ? static_cast<int32_t>(resolved) : -1;
  }

  const std::string_view bytes_;
  const std::string& name_;
  std::vector<size_t>* const vertex_tails_;
  ObjTextures* const textures_;
  const FaceVisitor visit_;
  const NoFaces no_faces_;
  const FlatFaces flat_faces_;
  const char newline_;
  const char* p_;
  const char* const end_;
  MeshFile file_;
  int64_t faces_ = 0;
  int64_t largest_index_ = -1;
  size_t largest_index_offset_ = 0;
  bool vertices_only_ = false;
  std::vector<Point3> all_points_;  // of the file, once a polygon stands before its vertices
  std::vector<int32_t> corners_;
  std::vector<Triangle> cut_;      // by places in corners_
  std::vector<TextRange> places_;  // of corners_: their vertex numbers
  std::vector<int32_t> texture_corners_;
  std::map<std::string_view, int32_t> materials_, libraries_;  // numbers in textures_
};

// `places`: texture coordinates that the file has before the patch's.
void AppendFaces(const FilePatch& patch, size_t places, std::string_view eol, std::string& out) {
  for (const std::array<float, 2>& place : patch.texture_places) {
    // Fixed to a hundredth of a pixel of the largest image.
    absl::StrAppendFormat(&out, "vt %.6f %.6f", double{place[0]}, double{place[1]});
    out += eol;
  }
  if (!patch.library.empty()) ((out += "mtllib ") += patch.library) += eol;
  ((out += "g ") += kFilledGroup) += eol;
  auto run = patch.materials.begin();
  for (size_t k = 0; k < patch.triangles.size(); ++k) {
    for (; run != patch.materials.end() && run->first <= static_cast<int64_t>(k); ++run) {
      ((out += "usemtl ") += run->material) += eol;
    }
    out += 'f';
    for (size_t c = 0; c < 3; ++c) {
      out += ' ';
      AppendNumber(int64_t{patch.triangles[k][c]} + 1, out);
      if (patch.texture_corners.empty()) continue;
      out += '/';
      AppendNumber(static_cast<int64_t>(places) + patch.texture_corners[k][c] + 1, out);
    }
    out += eol;
  }
}

}  // namespace

absl::StatusOr<MeshFile> ParseObj(std::string_view bytes, const std::string& name, const FaceVisitor& visit,
                                  NoFaces no_faces) {
  return ObjReader(bytes, name, nullptr, nullptr, visit, no_faces).Read();
}

absl::StatusOr<ObjFile> ParseTexturedObj(std::string_view bytes, const std::string& name, NoFaces no_faces,
                                         FlatFaces flat_faces) {
  ObjFile result;
  TILEMEND_ASSIGN_OR_RETURN(result.file,
                            ObjReader(bytes, name, nullptr, &result.textures, {}, no_faces, flat_faces).Read());
  const auto known = static_cast<int32_t>(result.textures.coordinates.size());
  for (Triangle& corners : result.textures.corners) {
    for (int32_t& corner : corners) corner = corner < known ? corner : -1;
  }
  return result;
}

absl::StatusOr<std::string> AppendToObj(std::string_view bytes, const FilePatch& patch, const std::string& name) {
  std::vector<size_t> tails;
  ObjTextures textures;
  ObjTextures* const counted = patch.texture_corners.empty() ? nullptr : &textures;
  TILEMEND_ASSIGN_OR_RETURN(const MeshFile file, ObjReader(bytes, name, &tails, counted, {}, NoFaces::kAccept).Read());
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
  if (!patch.triangles.empty()) AppendFaces(patch, textures.coordinates.size(), eol, out);
  return out;
}

}  // namespace tilemend
