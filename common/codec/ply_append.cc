#include <algorithm>
#include <array>
#include <cstring>
#include <limits>
#include <optional>
#include <utility>

#include "absl/strings/str_cat.h"
#include "common/codec/ply.h"
#include "common/codec/ply_source.h"
#include "common/codec/polygons.h"
#include "common/codec/text.h"
#include "common/mesh/rounding.h"
#include "common/util/status_macros.h"

namespace tilemend {
namespace {

// Appends a value as binary, converted to `type`.
template <class Value>
void AppendBinary(Value value, PlyType type, bool swap, std::string& out) {
  WithPlyType(type, [&](auto sample) {
    char bytes[sizeof(sample)];
    StoreValue(static_cast<decltype(sample)>(value), swap, bytes);
    out.append(bytes, sizeof(bytes));
  });
}

int64_t LargestIndexOf(PlyType type) {
  switch (type) {
    case PlyType::kInt8:
      return std::numeric_limits<int8_t>::max();
    case PlyType::kUint8:
      return std::numeric_limits<uint8_t>::max();
    case PlyType::kInt16:
      return std::numeric_limits<int16_t>::max();
    case PlyType::kUint16:
      return std::numeric_limits<uint16_t>::max();
    default:
      return std::numeric_limits<int32_t>::max();
  }
}

bool IsAlpha(const PlyProperty& property) {
  return !property.is_list && property.name == "alpha" && property.type == PlyType::kUint8;
}

size_t PlaceIn(const std::array<size_t, 3>& properties, size_t property) {
  return static_cast<size_t>(std::find(properties.begin(), properties.end(), property) - properties.begin());
}

std::optional<Rgb> ColourOfFace(const FilePatch& patch, size_t t) {
  const auto& runs = patch.materials;
  const auto next = std::upper_bound(runs.begin(), runs.end(), static_cast<int64_t>(t),
                                     [](int64_t k, const FilePatch::MaterialRun& run) { return k < run.first; });
  return next == runs.begin() ? std::nullopt : (next - 1)->colour;
}

// Writes the records of a patch and copies those of the file: what text and binary bodies have in common.
class PlyAppender {
 public:
  // `cut_faces`: where the face begins that each new one was cut from (FilePatch::cut_from).
  PlyAppender(std::string_view bytes, const PlyHeader& header, const PlyRecords& records, const FilePatch& patch,
              std::vector<size_t> cut_faces, NumberType number_type)
      : bytes_(bytes),
        header_(header),
        records_(records),
        patch_(patch),
        cut_faces_(std::move(cut_faces)),
        number_type_(number_type),
        vertex_(header.elements[header.vertex]),
        face_(header.elements[header.face]),
        ascii_(header.encoding == PlyEncoding::kAscii),
        swap_(NeedsSwap(header.encoding)),
        places_(bytes, ascii_, swap_) {
    const auto is_mark = [](const PlyProperty& property) { return property.name == kFilledProperty; };
    add_mark_ = std::none_of(face_.properties.begin(), face_.properties.end(), is_mark);
    if (!patch.colours.empty()) colour_properties_ = ColourProperties(vertex_);
    face_colours_ = ColourProperties(face_);
    const int64_t vertices = vertex_.count + static_cast<int64_t>(patch.new_points.size());
    widen_ = vertices - 1 > LargestIndexOf(Corners().type);
    index_type_ = widen_ ? PlyType::kInt32 : Corners().type;
  }

  std::string Write() {
    constexpr size_t kBytesPerRecord = 64;  // a usual new record, to reserve for
    const size_t marks = 2 * static_cast<size_t>(face_.count);
    const size_t wider = widen_ ? 3 * bytes_.size() : 0;
    out_.reserve(bytes_.size() + marks + wider +
                 kBytesPerRecord * (patch_.new_points.size() + patch_.triangles.size() + 2));
    WriteHeader();
    body_begin_ = out_.size();
    size_t begin = header_.body_begin;
    for (size_t i = 0; i < header_.elements.size(); ++i) {
      const size_t end = records_.element_ends[i];
      if (i == header_.face) {
        CopyFaces(begin);
        WriteNewFaces();
      } else {
        out_ += bytes_.substr(begin, end - begin);
        if (i == header_.vertex) WriteNewVertices(begin);
      }
      begin = end;
    }
    out_ += bytes_.substr(begin);
    return std::move(out_);
  }

 private:
  struct Edit {
    size_t begin;
    size_t end;
    std::string text;
  };

  const PlyProperty& Corners() const { return face_.properties[header_.corners]; }

  void WriteHeader() {
    std::vector<Edit> edits;
    const auto count_edit = [&edits](const PlyElement& element, size_t more) {
      edits.push_back(
          {element.count_begin, element.count_end, absl::StrCat(element.count + static_cast<int64_t>(more))});
    };
    count_edit(vertex_, patch_.new_points.size());
    count_edit(face_, patch_.triangles.size());
    if (widen_) edits.push_back({Corners().type_begin, Corners().type_end, "int"});
    if (add_mark_) {
      edits.push_back({face_.end, face_.end,
                       absl::StrCat("property uchar ", std::string(kFilledProperty), std::string(header_.eol))});
    }
    std::sort(edits.begin(), edits.end(), [](const Edit& a, const Edit& b) { return a.begin < b.begin; });
    size_t done = 0;
    for (const Edit& edit : edits) {
      out_ += bytes_.substr(done, edit.begin - done);
      out_ += edit.text;
      done = edit.end;
    }
    out_ += bytes_.substr(done, header_.body_begin - done);
  }

  void CopyFaces(size_t begin) {
    constexpr size_t kTriangle = 13;  // a count and three indices of four bytes
    if (records_.face_bytes == kTriangle && add_mark_) return CopyMarked<kTriangle>(begin);
    for (size_t k = 0; k < static_cast<size_t>(face_.count) && records_.face_bytes > 0; ++k) {
      out_ += bytes_.substr(begin + k * records_.face_bytes, records_.face_bytes);
      if (add_mark_) out_ += '\0';
    }
    for (const size_t end : records_.face_ends) {
      if (widen_ && !ascii_) {
        CopyWidened(begin);
      } else {
        out_ += bytes_.substr(begin, end - begin);
      }
      if (add_mark_) out_ += ascii_ ? std::string_view(" 0") : std::string_view("\0", 1);
      begin = end;
    }
  }

  // The usual faces, with the number of their bytes known to the compiler.
  template <size_t kBytes>
  void CopyMarked(size_t begin) {
    const size_t faces = static_cast<size_t>(face_.count);
    const size_t at = out_.size();
    out_.resize(at + faces * (kBytes + 1));  // every mark is 0 with it
    const char* from = bytes_.data() + begin;
    char* to = out_.data() + at;
    for (size_t k = 0; k < faces; ++k, from += kBytes, to += kBytes + 1) std::memcpy(to, from, kBytes);
  }

  // Copies a binary property that begins at `at`; returns where it ends.
  size_t CopyProperty(const PlyProperty& property, size_t at) {
    const size_t end = places_.EndOf(property, at);
    out_ += bytes_.substr(at, end - at);
    return end;
  }

  void CopyWidened(size_t at) {
    for (size_t i = 0; i < face_.properties.size(); ++i) {
      const PlyProperty& property = face_.properties[i];
      if (i != header_.corners) {
        at = CopyProperty(property, at);
        continue;
      }
      const int64_t count = places_.BinaryCount(property, at);
      out_ += bytes_.substr(at, SizeOf(property.count_type));
      at += SizeOf(property.count_type);
      for (int64_t k = 0; k < count; ++k, at += SizeOf(property.type)) {
        WithPlyType(property.type, [&](auto sample) {
          AppendBinary(LoadValue<decltype(sample)>(bytes_.data() + at, swap_), index_type_, swap_, out_);
        });
      }
    }
  }

  // A value, or a list's count, of a new record.
  template <class Value>
  void Put(Value value, PlyType type) {
    if (!ascii_) {
      AppendBinary(value, type, swap_, out_);
      return;
    }
    if (!line_begins_) out_ += ' ';
    line_begins_ = false;
    AppendNumber(value, out_);
  }

  // What nothing is known of: 0, but opaque.
  void PutDefault(const PlyProperty& property) {
    constexpr int64_t kOpaque = 255;
    Put(IsAlpha(property) ? kOpaque : 0, property.is_list ? property.count_type : property.type);
  }

  // New lines of a text body follow the last word of the old ones, whose line end comes after them; only at the very
  // beginning of a body there is none to follow.
  void BeginRecord() {
    line_begins_ = true;
    if (ascii_ && out_.size() > body_begin_) out_ += header_.eol;
  }
  void EndRecords(bool at_body_begin) {
    if (ascii_ && at_body_begin) out_ += header_.eol;
  }

  void WriteNewVertices(size_t element_begin) {
    for (size_t k = 0; k < patch_.new_points.size(); ++k) {
      BeginRecord();
      const int32_t like = patch_.like[k];
      if (like < 0) {
        WriteVertex(k, [this](const PlyProperty& property) { PutDefault(property); });
      } else if (ascii_) {
        size_t at = VertexBegin(static_cast<size_t>(like), element_begin);
        WriteVertex(
            k, [&](const PlyProperty& property) { at = CopyWords(property, at); }, &at);
      } else {
        size_t at = VertexBegin(static_cast<size_t>(like), element_begin);
        WriteVertex(
            k, [&](const PlyProperty& property) { at = CopyProperty(property, at); }, &at);
      }
    }
  }

  size_t VertexBegin(size_t k, size_t element_begin) const {
    if (records_.vertex_ends.empty()) return element_begin + k * vertex_.LeastRecordBytes();
    return k == 0 ? element_begin : records_.vertex_ends[k - 1];
  }

  // Writes new vertex `k`, its further properties by `other`. `at`, if given, is the place in the vertex that it is
  // like, which moves over the coordinates and colours that are not copied.
  template <class Other>
  void WriteVertex(size_t k, Other other, size_t* at = nullptr) {
    for (size_t i = 0; i < vertex_.properties.size(); ++i) {
      const PlyProperty& property = vertex_.properties[i];
      const size_t axis = PlaceIn(header_.xyz, i);
      const size_t channel = colour_properties_ ? PlaceIn(*colour_properties_, i) : 3;
      if (axis < header_.xyz.size()) {
        Put(RoundedTo(number_type_, patch_.new_points[k][static_cast<Eigen::Index>(axis)]), property.type);
      } else if (channel < 3) {
        PutChannel(patch_.colours[k], channel);
      } else {
        other(property);
        continue;
      }
      if (at != nullptr) *at = ascii_ ? places_.NextWord(*at).second : *at + SizeOf(property.type);
    }
  }

  void PutChannel(const Rgb& c, size_t channel) {
    Put(int64_t{std::array{c.r, c.g, c.b}[channel]}, PlyType::kUint8);  // as ColourProperties has them
  }

  size_t CopyWords(const PlyProperty& property, size_t at) {
    const int64_t words = places_.WordsOf(property, at);
    for (int64_t i = 0; i < words; ++i) {
      const auto [word, end] = places_.NextWord(at);
      if (!line_begins_) out_ += ' ';
      line_begins_ = false;
      out_ += word;
      at = end;
    }
    return at;
  }

  void WriteNewFaces() {
    const bool at_body_begin = out_.size() == body_begin_ && !patch_.triangles.empty();
    for (size_t t = 0; t < patch_.triangles.size(); ++t) {
      BeginRecord();
      if (cut_faces_.empty()) {
        WriteFilledFace(t);
      } else {
        WriteCutFace(t);
      }
      if (add_mark_) Put(int64_t{1}, PlyType::kUint8);
    }
    EndRecords(at_body_begin);
  }

  void PutCorners(const Triangle& triangle) {
    Put(int64_t{3}, Corners().count_type);
    for (const int32_t corner : triangle) Put(int64_t{corner}, index_type_);
  }

  void WriteFilledFace(size_t t) {
    const std::optional<Rgb> colour = face_colours_ ? ColourOfFace(patch_, t) : std::nullopt;
    for (size_t i = 0; i < face_.properties.size(); ++i) {
      const PlyProperty& property = face_.properties[i];
      const size_t channel = colour ? PlaceIn(*face_colours_, i) : 3;
      if (i == header_.corners) {
        PutCorners(patch_.triangles[t]);
      } else if (property.name == kFilledProperty && !property.is_list) {
        Put(int64_t{1}, property.type);
      } else if (channel < 3) {
        PutChannel(*colour, channel);
      } else {
        PutDefault(property);
      }
    }
  }

  // With the properties of the face that it was cut from, but marked as new.
  void WriteCutFace(size_t t) {
    size_t at = cut_faces_[t];
    for (size_t i = 0; i < face_.properties.size(); ++i) {
      const PlyProperty& property = face_.properties[i];
      if (i == header_.corners) {
        PutCorners(patch_.triangles[t]);
        at = places_.EndOf(property, at);
      } else if (property.name == kFilledProperty && !property.is_list) {
        Put(int64_t{1}, property.type);
        at = places_.EndOf(property, at);
      } else {
        at = ascii_ ? CopyWords(property, at) : CopyProperty(property, at);
      }
    }
  }

  const std::string_view bytes_;
  const PlyHeader& header_;
  const PlyRecords& records_;
  const FilePatch& patch_;
  const std::vector<size_t> cut_faces_;
  const NumberType number_type_;
  const PlyElement& vertex_;
  const PlyElement& face_;
  const bool ascii_;
  const bool swap_;
  const PlyPlaces places_;
  bool add_mark_ = true;
  bool widen_ = false;
  PlyType index_type_ = PlyType::kInt32;
  std::optional<std::array<size_t, 3>> colour_properties_;  // of vertices, where the patch has colours for them
  std::optional<std::array<size_t, 3>> face_colours_;       // properties of faces
  bool line_begins_ = false;
  size_t body_begin_ = 0;
  std::string out_;
};

// Where the face begins that each triangle of the patch was cut from; empty if they were not cut from any.
absl::StatusOr<std::vector<size_t>> CutFaces(std::string_view bytes, const PlyHeader& header, const PlyRecords& records,
                                             const FilePatch& patch, const std::string& name) {
  std::vector<size_t> faces;
  if (patch.cut_from.empty()) return faces;
  TILEMEND_ASSIGN_OR_RETURN(const std::vector<size_t> begins, PlyFaceBegins(bytes, header, records, name));
  for (const int32_t t : patch.cut_from) {
    if (t < 0 || t >= std::ssize(begins)) {
      return absl::InvalidArgumentError(absl::StrCat(name, ": bad patch: no triangle ", t, " to be cut from"));
    }
    faces.push_back(begins[static_cast<size_t>(t)]);
  }
  return faces;
}

}  // namespace

absl::StatusOr<std::string> AppendToPly(std::string_view bytes, const FilePatch& patch, const std::string& name) {
  TILEMEND_ASSIGN_OR_RETURN(const PlyHeader header, ParsePlyHeader(bytes, name));
  PlyRecords records;
  TILEMEND_ASSIGN_OR_RETURN(const MeshFile file, ReadPlyBody(bytes, header, name, &records));
  const auto vertices = static_cast<size_t>(header.elements[header.vertex].count);
  TILEMEND_RETURN_IF_ERROR(CheckPatch(patch, vertices, name));
  TILEMEND_ASSIGN_OR_RETURN(std::vector<size_t> cut_faces, CutFaces(bytes, header, records, patch, name));
  return PlyAppender(bytes, header, records, patch, std::move(cut_faces), file.number_type).Write();
}

std::string NewPlyFile(const FilePatch& patch, NumberType number_type, FaceMark mark) {
  const bool narrow = number_type == NumberType::kFloat32;
  const char* const type = narrow ? "float" : "double";
  std::string out = absl::StrCat("ply\nformat binary_little_endian 1.0\nelement vertex ", patch.new_points.size());
  for (const char* axis : {"x", "y", "z"}) absl::StrAppend(&out, "\nproperty ", type, " ", axis);
  const bool coloured = !patch.colours.empty();
  if (coloured) out += "\nproperty uchar red\nproperty uchar green\nproperty uchar blue";
  absl::StrAppend(&out, "\nelement face ", patch.triangles.size(), "\nproperty list uchar int vertex_indices");
  const bool marked = mark == FaceMark::kFilled;
  if (marked) absl::StrAppend(&out, "\nproperty uchar ", std::string(kFilledProperty));
  out += "\nend_header\n";
  constexpr size_t kFaceBytes = 14;
  out.reserve(out.size() + patch.new_points.size() * (narrow ? 12 : 24) + patch.triangles.size() * kFaceBytes);
  const bool swap = NeedsSwap(PlyEncoding::kLittleEndian);
  for (size_t k = 0; k < patch.new_points.size(); ++k) {
    for (int axis = 0; axis < 3; ++axis) {
      AppendBinary(patch.new_points[k][axis], narrow ? PlyType::kFloat32 : PlyType::kFloat64, swap, out);
    }
    if (!coloured) continue;
    const Rgb c = patch.colours[k];
    for (const uint8_t channel : {c.r, c.g, c.b}) out += static_cast<char>(channel);
  }
  for (const Triangle& triangle : patch.triangles) {
    out += '\3';
    for (const int32_t corner : triangle) AppendBinary(corner, PlyType::kInt32, swap, out);
    if (marked) out += '\1';
  }
  return out;
}

}  // namespace tilemend
