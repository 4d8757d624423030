#include "common/codec/ply_header.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "absl/strings/str_cat.h"
#include "common/codec/text.h"
#include "common/util/status_macros.h"

namespace tilemend {
namespace {

constexpr size_t kMaxHeaderEntries = 1000;  // elements, and properties of one: far more than any real file has

std::optional<PlyType> TypeOf(std::string_view word) {
  struct Name {
    std::string_view text;
    PlyType type;
  };
  constexpr Name kNames[] = {
      {"char", PlyType::kInt8},      {"int8", PlyType::kInt8},       {"uchar", PlyType::kUint8},
      {"uint8", PlyType::kUint8},    {"short", PlyType::kInt16},     {"int16", PlyType::kInt16},
      {"ushort", PlyType::kUint16},  {"uint16", PlyType::kUint16},   {"int", PlyType::kInt32},
      {"int32", PlyType::kInt32},    {"uint", PlyType::kUint32},     {"uint32", PlyType::kUint32},
      {"float", PlyType::kFloat32},  {"float32", PlyType::kFloat32}, {"double", PlyType::kFloat64},
      {"float64", PlyType::kFloat64}};
  for (const Name& name : kNames) {
    if (name.text == word) return name.type;
  }
  return std::nullopt;
}

class HeaderReader {
 public:
  HeaderReader(std::string_view bytes, const std::string& name) : bytes_(bytes), name_(name) {}

  absl::StatusOr<PlyHeader> Read() {
    if (bytes_.substr(0, 3) != "ply" || (bytes_.size() > 3 && !IsSpace(bytes_[3]))) {
      return LineError(name_, bytes_.substr(0, kMaxLineBytes), 0, "'ply'");
    }
    // Old Macintosh files end lines with "\r" alone; there may be a "\n" in a binary body, so the first line decides.
    const size_t first_end = bytes_.substr(0, kMaxLineBytes).find_first_of("\r\n");
    const bool old_mac = first_end != std::string_view::npos && bytes_.substr(first_end, 1) == "\r" &&
                         bytes_.substr(first_end + 1, 1) != "\n";
    newline_ = old_mac ? '\r' : '\n';
    header_.eol = old_mac ? "\r" : first_end != std::string_view::npos && bytes_[first_end] == '\r' ? "\r\n" : "\n";
    TILEMEND_RETURN_IF_ERROR(NextLine());
    bool has_format = false;
    for (;;) {
      TILEMEND_RETURN_IF_ERROR(NextLine());
      const std::string_view keyword = words_.empty() ? "" : Word(0);
      if (keyword == "end_header") break;
      if (keyword == "format") {
        TILEMEND_RETURN_IF_ERROR(ReadFormat());
        has_format = true;
      } else if (keyword == "element") {
        TILEMEND_RETURN_IF_ERROR(ReadElement());
      } else if (keyword == "property") {
        TILEMEND_RETURN_IF_ERROR(ReadProperty());
      } else if (!keyword.empty() && keyword != "comment" && keyword != "obj_info") {
        return Expected(0, "a header line (format, element, property, comment, obj_info or end_header)");
      }
    }
    if (!has_format) return Expected(0, "a format line before the end of the header");
    header_.body_begin = next_;
    TILEMEND_RETURN_IF_ERROR(FindVertices());
    TILEMEND_RETURN_IF_ERROR(FindFaces());
    TILEMEND_RETURN_IF_ERROR(CheckSizes());
    return std::move(header_);
  }

 private:
  struct WordRange {
    size_t begin;
    size_t end;
  };

  std::string_view Word(size_t i) const { return bytes_.substr(words_[i].begin, words_[i].end - words_[i].begin); }

  absl::Status Expected(size_t word, std::string_view what) const {
    const size_t offset = word < words_.size() ? words_[word].begin : line_end_;
    // Only the header is text: lines are counted and shown in it alone.
    return HeaderError(name_, bytes_.substr(0, std::max(offset, line_end_ + 1)), offset, what);
  }
  absl::Status Invalid(std::string_view problem) const {
    return absl::InvalidArgumentError(absl::StrCat(name_, ": ", std::string(problem)));
  }

  // Cuts the next line into words.
  absl::Status NextLine() {
    const size_t begin = next_;
    const size_t stop = bytes_.substr(begin, kMaxLineBytes).find(newline_);
    if (stop == std::string_view::npos) {
      return ByteProblem(name_, begin,
                         begin + kMaxLineBytes < bytes_.size()
                             ? "expected a header line, found one that is too long"
                             : "expected a header line or end_header, found end of file");
    }
    line_end_ = begin + stop;
    next_ = line_end_ + 1;
    words_.clear();
    for (size_t i = begin; i < line_end_;) {
      while (i < line_end_ && IsSpace(bytes_[i])) ++i;
      const size_t word = i;
      while (i < line_end_ && !IsSpace(bytes_[i])) ++i;
      if (i > word) words_.push_back({word, i});
    }
    return absl::OkStatus();
  }

  absl::Status ReadFormat() {
    const std::string_view format = words_.size() > 1 ? Word(1) : "";
    if (format == "ascii") {
      header_.encoding = PlyEncoding::kAscii;
    } else if (format == "binary_little_endian") {
      header_.encoding = PlyEncoding::kLittleEndian;
    } else if (format == "binary_big_endian") {
      header_.encoding = PlyEncoding::kBigEndian;
    } else {
      return Expected(1, "ascii, binary_little_endian or binary_big_endian");
    }
    return words_.size() > 2 && Word(2) == "1.0" ? absl::OkStatus() : Expected(2, "version 1.0");
  }

  absl::Status ReadElement() {
    if (words_.size() != 3) return Expected(words_.size() < 3 ? words_.size() : 3, "element NAME COUNT");
    PlyElement element;
    element.name = std::string(Word(1));
    const ParsedInteger count = ParseIntegerAt(Word(2).data(), Word(2).data() + Word(2).size());
    if (count.stop != Word(2).data() + Word(2).size() || count.value < 0) return Expected(2, "a number of records");
    element.count = count.value;
    element.count_begin = words_[2].begin;
    element.count_end = words_[2].end;
    element.end = next_;
    const auto same_name = [&element](const PlyElement& other) { return other.name == element.name; };
    if (std::any_of(header_.elements.begin(), header_.elements.end(), same_name)) {
      return Expected(1, "an element with a new name");
    }
    if (header_.elements.size() >= kMaxHeaderEntries) return Expected(0, "fewer elements");
    header_.elements.push_back(std::move(element));
    return absl::OkStatus();
  }

  absl::Status ReadProperty() {
    if (header_.elements.empty()) return Expected(0, "an element before its properties");
    PlyElement& element = header_.elements.back();
    PlyProperty property;
    property.is_list = words_.size() > 1 && Word(1) == "list";
    const size_t type_word = property.is_list ? 3 : 1;
    if (words_.size() != type_word + 2) {
      return Expected(std::min(words_.size(), type_word + 2), "property TYPE NAME or property list TYPE TYPE NAME");
    }
    if (property.is_list) {
      const std::optional<PlyType> count_type = TypeOf(Word(2));
      if (!count_type.has_value() || IsFloat(*count_type)) return Expected(2, "an integer type");
      property.count_type = *count_type;
    }
    const std::optional<PlyType> type = TypeOf(Word(type_word));
    if (!type.has_value()) return Expected(type_word, "a type (char to double, or int8 to float64)");
    property.type = *type;
    property.type_begin = words_[type_word].begin;
    property.type_end = words_[type_word].end;
    property.name = std::string(Word(type_word + 1));
    const auto same_name = [&property](const PlyProperty& other) { return other.name == property.name; };
    if (std::any_of(element.properties.begin(), element.properties.end(), same_name)) {
      return Expected(type_word + 1, "a property with a new name");
    }
    if (element.properties.size() >= kMaxHeaderEntries) return Expected(0, "fewer properties");
    element.properties.push_back(std::move(property));
    element.end = next_;
    return absl::OkStatus();
  }

  std::optional<size_t> FindElement(std::string_view element) const {
    for (size_t i = 0; i < header_.elements.size(); ++i) {
      if (header_.elements[i].name == element) return i;
    }
    return std::nullopt;
  }

  static std::optional<size_t> FindProperty(const PlyElement& element, std::string_view property) {
    for (size_t i = 0; i < element.properties.size(); ++i) {
      if (element.properties[i].name == property) return i;
    }
    return std::nullopt;
  }

  absl::Status FindVertices() {
    const std::optional<size_t> vertex = FindElement("vertex");
    if (!vertex.has_value() || header_.elements[*vertex].count == 0) return Invalid(kNoVertices);
    header_.vertex = *vertex;
    const PlyElement& element = header_.elements[*vertex];
    for (size_t axis = 0; axis < 3; ++axis) {
      const std::string_view coordinate = std::string_view("xyz").substr(axis, 1);
      const std::optional<size_t> found = FindProperty(element, coordinate);
      if (!found.has_value() || element.properties[*found].is_list || !IsFloat(element.properties[*found].type)) {
        return Invalid(absl::StrCat("expected a float or double vertex property ", std::string(coordinate)));
      }
      header_.xyz[axis] = *found;
    }
    return absl::OkStatus();
  }

  absl::Status FindFaces() {
    const std::optional<size_t> face = FindElement("face");
    if (!face.has_value()) return Invalid("the file has no faces (points and triangle strips are not read)");
    header_.face = *face;
    const PlyElement& element = header_.elements[*face];
    std::optional<size_t> corners = FindProperty(element, "vertex_indices");
    if (!corners.has_value()) corners = FindProperty(element, "vertex_index");
    if (!corners.has_value() || !element.properties[*corners].is_list || IsFloat(element.properties[*corners].type)) {
      return Invalid("expected an integer list vertex_indices as a property of the faces");
    }
    header_.corners = *corners;
    return absl::OkStatus();
  }

  // Before anything is allocated: every record takes at least its fixed part.
  absl::Status CheckSizes() const {
    const uint64_t available = bytes_.size() - header_.body_begin;
    uint64_t needed = 0;
    for (const PlyElement& element : header_.elements) {
      // A text value takes a digit and a separator.
      const bool ascii = header_.encoding == PlyEncoding::kAscii;
      const uint64_t least = ascii ? 2 * element.properties.size() : element.LeastRecordBytes();
      if (least == 0) continue;
      const uint64_t count = static_cast<uint64_t>(element.count);
      if (count <= (available + 1) / least) needed += count * least;
      if (count > (available + 1) / least || needed > available + (ascii ? 1 : 0)) {
        return Invalid(absl::StrCat("expected ", count, " records of element ", element.name, ", found only ",
                                    available, " bytes after the header"));
      }
    }
    if (header_.elements[header_.vertex].count > std::numeric_limits<int32_t>::max()) {
      return Invalid("expected at most 2^31 - 1 vertices");
    }
    return absl::OkStatus();
  }

  const std::string_view bytes_;
  const std::string& name_;
  char newline_ = '\n';
  size_t next_ = 0;
  size_t line_end_ = 0;
  std::vector<WordRange> words_;
  PlyHeader header_;
};

}  // namespace

size_t PlyElement::LeastRecordBytes() const {
  size_t bytes = 0;
  for (const PlyProperty& property : properties)
    bytes += SizeOf(property.is_list ? property.count_type : property.type);
  return bytes;
}

bool PlyElement::HasLists() const {
  return std::any_of(properties.begin(), properties.end(), [](const PlyProperty& p) { return p.is_list; });
}

std::optional<std::array<size_t, 3>> ColourProperties(const PlyElement& element) {
  constexpr std::array<std::string_view, 3> kNames = {"red", "green", "blue"};
  std::array<size_t, 3> found{};
  for (size_t channel = 0; channel < 3; ++channel) {
    const auto at = std::find_if(element.properties.begin(), element.properties.end(), [&](const PlyProperty& p) {
      return p.name == kNames[channel] && !p.is_list && p.type == PlyType::kUint8;
    });
    if (at == element.properties.end()) return std::nullopt;
    found[channel] = static_cast<size_t>(at - element.properties.begin());
  }
  return found;
}

absl::StatusOr<PlyHeader> ParsePlyHeader(std::string_view bytes, const std::string& name) {
  return HeaderReader(bytes, name).Read();
}

}  // namespace tilemend
