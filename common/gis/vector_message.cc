#include "common/gis/vector_message.h"

#include <cstdint>
#include <cstring>
#include <optional>
#include <type_traits>
#include <vector>

namespace tilemend {
namespace {

template <typename T>
concept Plain = std::is_arithmetic_v<T> || std::is_enum_v<T>;

class Packer {
 public:
  template <Plain T>
  void operator()(const T& value) {
    text_.append(reinterpret_cast<const char*>(&value), sizeof value);
  }
  void operator()(std::string_view text) {
    (*this)(uint64_t{text.size()});
    text_.append(text);
  }
  void operator()(const std::string& text) { (*this)(std::string_view(text)); }
  template <typename T>
  void operator()(const std::optional<T>& value) {
    (*this)(value.has_value());
    if (value) (*this)(*value);
  }
  template <typename T>
  void operator()(const std::vector<T>& list) {
    (*this)(uint64_t{list.size()});
    for (const T& item : list) Each(*this, item);
  }
  std::string Text() && { return std::move(text_); }

 private:
  std::string text_;
};

class Unpacker {
 public:
  explicit Unpacker(std::string_view bytes) : bytes_(bytes) {}

  template <Plain T>
  void operator()(T& value) {
    if (bytes_.size() < sizeof value) return Fail();
    std::memcpy(&value, bytes_.data(), sizeof value);
    bytes_.remove_prefix(sizeof value);
  }
  void operator()(bool& value) {
    char byte = 0;
    (*this)(byte);
    value = byte != 0;
  }
  void operator()(std::string_view& text) {
    const uint64_t size = Count();
    text = bytes_.substr(0, size);
    bytes_.remove_prefix(size);
  }
  void operator()(std::string& text) {
    std::string_view view;
    (*this)(view);
    text = view;
  }
  template <typename T>
  void operator()(std::optional<T>& value) {
    bool has_value = false;
    (*this)(has_value);
    if (has_value) (*this)(value.emplace());
  }
  template <typename T>
  void operator()(std::vector<T>& list) {
    for (uint64_t left = Count(); left > 0 && good_; --left) Each(*this, list.emplace_back());
  }
  bool Done() const { return good_ && bytes_.empty(); }

 private:
  // Of items, each of which takes a byte at least.
  uint64_t Count() {
    uint64_t count = 0;
    (*this)(count);
    if (count <= bytes_.size()) return count;
    Fail();
    return 0;
  }
  void Fail() {
    good_ = false;
    bytes_ = {};
  }

  std::string_view bytes_;
  bool good_ = true;
};

// What the members of each are, in order, for both ways. T may be const.
template <typename Archive, typename T>
void Each(Archive& archive, T& item) {
  using Type = std::remove_const_t<T>;
  if constexpr (std::is_same_v<Type, Point2>) {
    archive(item.x()), archive(item.y());
  } else if constexpr (std::is_same_v<Type, MemoryPart>) {
    archive(item.name), archive(item.bytes);
  } else if constexpr (std::is_same_v<Type, VectorFeature>) {
    archive(item.label), archive(item.polygon.rings), archive(item.line), archive(item.water), archive(item.level);
    archive(item.kind), archive(item.clear), archive(item.clear_height), archive(item.body);
    archive(item.level_sigma), archive(item.is_as_found);
    archive(item.holes), archive(item.decision);
  } else {
    archive(item);
  }
}

template <typename Archive, typename Request>
void RequestMembers(Archive& archive, Request& r) {
  archive(r.format), archive(r.opened), archive(r.parts), archive(r.name), archive(r.names_crs), archive(r.crs_name);
  archive(r.features), archive(r.use), archive(r.frame.crs);
  archive(r.frame.origin.x()), archive(r.frame.origin.y()), archive(r.frame.origin.z());
  Each(archive, r.frame.lo), Each(archive, r.frame.hi);
}

template <typename Archive, typename File>
void FileMembers(Archive& archive, File& f) {
  archive(f.features), archive(f.coordinates), archive(f.warnings), archive(f.error);
}

// Whether a value is one of `kind`: a byte of a message may be any.
bool IsKind(WaterKind kind) {
  return kind == WaterKind::kUnsaid || kind == WaterKind::kLake || kind == WaterKind::kRiver;
}

bool IsDecision(ReviewDecision decision) {
  return decision >= ReviewDecision::kNone && decision <= ReviewDecision::kOpen;
}

}  // namespace

std::string Encode(const VectorRequest& request) {
  Packer packer;
  RequestMembers(packer, request);
  return std::move(packer).Text();
}

std::string Encode(const VectorFile& file) {
  Packer packer;
  FileMembers(packer, file);
  return std::move(packer).Text();
}

bool Decode(std::string_view bytes, VectorRequest& request) {
  Unpacker unpacker(bytes);
  RequestMembers(unpacker, request);
  return unpacker.Done();
}

bool Decode(std::string_view bytes, VectorFile& file) {
  Unpacker unpacker(bytes);
  FileMembers(unpacker, file);
  for (const VectorFeature& feature : file.features) {
    if (!IsKind(feature.kind) || !IsDecision(feature.decision)) return false;
  }
  return unpacker.Done();
}

}  // namespace tilemend
