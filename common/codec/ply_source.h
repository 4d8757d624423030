// Values of a PLY body, one after another: from text, or from binary in either byte order.
#ifndef TILEMEND_COMMON_CODEC_PLY_SOURCE_H_
#define TILEMEND_COMMON_CODEC_PLY_SOURCE_H_

#include <bit>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

#include "absl/status/status.h"
#include "absl/strings/str_cat.h"
#include "common/codec/ply_header.h"
#include "common/codec/polygons.h"
#include "common/codec/text.h"

namespace tilemend {

// Reads or writes an unaligned value, its bytes reversed if `swap`.
template <class T>
T LoadValue(const char* p, bool swap) {
  T value;
  if (!swap) {
    std::memcpy(&value, p, sizeof(T));
    return value;
  }
  char reversed[sizeof(T)];
  for (size_t i = 0; i < sizeof(T); ++i) reversed[i] = p[sizeof(T) - 1 - i];
  std::memcpy(&value, reversed, sizeof(T));
  return value;
}
template <class T>
void StoreValue(T value, bool swap, char* p) {
  std::memcpy(p, &value, sizeof(T));
  if (!swap) return;
  for (size_t i = 0; i < sizeof(T) / 2; ++i) std::swap(p[i], p[sizeof(T) - 1 - i]);
}

// Calls `body` with a value of the type that `type` names.
template <class Body>
auto WithPlyType(PlyType type, Body body) {
  switch (type) {
    case PlyType::kInt8:
      return body(int8_t{});
    case PlyType::kUint8:
      return body(uint8_t{});
    case PlyType::kInt16:
      return body(int16_t{});
    case PlyType::kUint16:
      return body(uint16_t{});
    case PlyType::kInt32:
      return body(int32_t{});
    case PlyType::kUint32:
      return body(uint32_t{});
    case PlyType::kFloat32:
      return body(float{});
    case PlyType::kFloat64:
      break;
  }
  return body(double{});
}

inline bool NeedsSwap(PlyEncoding encoding) {
  return (encoding == PlyEncoding::kBigEndian) == (std::endian::native == std::endian::little);
}

// A position in a binary body. A read gives nothing at the end of the file; Error() shows the value read last, or that
// end.
class BinarySource {
 public:
  BinarySource(std::string_view bytes, const PlyHeader& header, const std::string& name)
      : bytes_(bytes), name_(name), position_(header.body_begin), swap_(NeedsSwap(header.encoding)) {}

  size_t position() const { return position_; }
  TextRange LastRead() const { return {last_, position_}; }  // a value
  void Seek(size_t position) { position_ = position; }

  std::optional<double> Number(PlyType type) { return Read<double>(type); }
  std::optional<int64_t> Integer(PlyType type) { return Read<int64_t>(type); }
  bool Skip(PlyType type, int64_t count) {
    last_ = position_;
    last_type_ = type;
    if (static_cast<uint64_t>(count) > (bytes_.size() - position_) / SizeOf(type)) {
      last_ += (bytes_.size() - position_) / SizeOf(type) * SizeOf(type);  // the first that is cut off
      return false;
    }
    position_ += static_cast<size_t>(count) * SizeOf(type);
    return true;
  }

  absl::Status Error(std::string_view expected) const {
    const std::string found =
        bytes_.size() - last_ < SizeOf(last_type_) ? "end of file" : WithPlyType(last_type_, [this](auto sample) {
          return absl::StrCat(LoadValue<decltype(sample)>(bytes_.data() + last_, swap_));
        });
    return ByteProblem(name_, last_, absl::StrCat("expected ", std::string(expected), ", found ", found));
  }

 private:
  template <class Value>
  std::optional<Value> Read(PlyType type) {
    last_ = position_;
    last_type_ = type;
    if (bytes_.size() - position_ < SizeOf(type)) return std::nullopt;
    position_ += SizeOf(type);
    return WithPlyType(type, [this](auto sample) -> Value {
      using Type = decltype(sample);
      if constexpr (std::is_integral_v<Value> && !std::is_integral_v<Type>) {
        return 0;  // counts and indices have integer types: the header reader sees to it
      } else {
        return static_cast<Value>(LoadValue<Type>(bytes_.data() + last_, swap_));
      }
    });
  }

  const std::string_view bytes_;
  const std::string& name_;
  size_t position_;
  const bool swap_;
  size_t last_ = 0;
  PlyType last_type_ = PlyType::kUint8;
};

// The same for a text body: values are words between white space, wherever the lines end.
class AsciiSource {
 public:
  AsciiSource(std::string_view bytes, const PlyHeader& header, const std::string& name)
      : bytes_(bytes), name_(name), position_(header.body_begin) {}

  size_t position() const { return position_; }  // just after the word read last
  TextRange LastRead() const { return {last_, position_}; }

  std::optional<double> Number(PlyType) {
    SkipSpace();
    const ParsedDouble parsed = ParseDoubleAt(bytes_.data() + last_, End());
    if (!Accept(parsed.stop)) return std::nullopt;
    return parsed.value;
  }
  std::optional<int64_t> Integer(PlyType) {
    SkipSpace();
    const ParsedInteger parsed = ParseIntegerAt(bytes_.data() + last_, End());
    if (!Accept(parsed.stop)) return std::nullopt;
    return parsed.value;
  }
  bool Skip(PlyType, int64_t count) {
    for (int64_t i = 0; i < count; ++i) {
      SkipSpace();
      if (last_ == bytes_.size()) return false;
      while (position_ < bytes_.size() && !IsSpace(bytes_[position_])) ++position_;
    }
    return true;
  }

  absl::Status Error(std::string_view expected) const { return LineError(name_, bytes_, last_, expected); }

 private:
  const char* End() const { return bytes_.data() + bytes_.size(); }
  void SkipSpace() {
    while (position_ < bytes_.size() && IsSpace(bytes_[position_])) ++position_;
    last_ = position_;
  }
  bool Accept(const char* stop) {
    if (stop == nullptr || (stop != End() && !IsSpace(*stop))) return false;
    position_ = static_cast<size_t>(stop - bytes_.data());
    return true;
  }

  const std::string_view bytes_;
  const std::string& name_;
  size_t position_;
  size_t last_ = 0;
};

// Where the properties of a body lie.
class PlyPlaces {
 public:
  PlyPlaces(std::string_view bytes, bool ascii, bool swap) : bytes_(bytes), ascii_(ascii), swap_(swap) {}

  int64_t BinaryCount(const PlyProperty& property, size_t at) const {
    return WithPlyType(property.count_type, [&](auto sample) {
      return static_cast<int64_t>(LoadValue<decltype(sample)>(bytes_.data() + at, swap_));
    });
  }

  // Where a property that begins at `at` ends.
  size_t EndOf(const PlyProperty& property, size_t at) const {
    if (ascii_) {
      for (int64_t words = WordsOf(property, at); words > 0; --words) at = NextWord(at).second;
      return at;
    }
    size_t size = SizeOf(property.type);
    if (property.is_list) {
      size = SizeOf(property.count_type) + static_cast<size_t>(BinaryCount(property, at)) * size;
    }
    return at + size;
  }

  // The next word of a text body from `at`, and where it ends.
  std::pair<std::string_view, size_t> NextWord(size_t at) const {
    while (at < bytes_.size() && IsSpace(bytes_[at])) ++at;
    const size_t begin = at;
    while (at < bytes_.size() && !IsSpace(bytes_[at])) ++at;
    return {bytes_.substr(begin, at - begin), at};
  }

  // Of a property that begins at `at` in a text body.
  int64_t WordsOf(const PlyProperty& property, size_t at) const {
    if (!property.is_list) return 1;
    const std::string_view count = NextWord(at).first;
    return 1 + ParseIntegerAt(count.data(), count.data() + count.size()).value;
  }

 private:
  const std::string_view bytes_;
  const bool ascii_;
  const bool swap_;
};

}  // namespace tilemend

#endif  // TILEMEND_COMMON_CODEC_PLY_SOURCE_H_
