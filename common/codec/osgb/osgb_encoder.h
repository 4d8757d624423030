// Numbers, texts, brackets and objects of OSGB files, written.
#ifndef TILEMEND_COMMON_CODEC_OSGB_OSGB_ENCODER_H_
#define TILEMEND_COMMON_CODEC_OSGB_OSGB_ENCODER_H_

#include <bit>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "common/codec/osgb/osgb_encode.h"

namespace tilemend {

class OsgbEncoder {
 public:
  explicit OsgbEncoder(OsgbEncoding& encoding) : encoding_(encoding) {}

  std::string Take() { return std::move(out_); }
  uint32_t version() const { return encoding_.version; }

  void Flag(bool value) { out_ += static_cast<char>(value); }
  void U32(uint32_t value) { Number(value, sizeof(value)); }
  void F32(float value) { U32(std::bit_cast<uint32_t>(value)); }
  void F64(double value) { Number(std::bit_cast<uint64_t>(value), sizeof(value)); }
  void Raw(std::string_view bytes) { out_ += bytes; }
  void Zeros(size_t bytes) { out_.append(bytes, '\0'); }

  void String(std::string_view text) {
    U32(static_cast<uint32_t>(text.size()));
    out_ += text;
  }

  void Begin() {
    open_.push_back(out_.size());
    Zeros(encoding_.bracket_bytes);
  }

  void End() {
    uint64_t size = out_.size() - open_.back();
    for (size_t i = 0; i < encoding_.bracket_bytes; ++i, size >>= 8) {
      out_[open_.back() + i] = static_cast<char>(size & 0xff);
    }
    open_.pop_back();
  }

  // Class, bracket, a new id and the fields of osg::Object.
  void BeginObject(std::string_view class_name) {
    String(class_name);
    Begin();
    U32(encoding_.next_object_id++);
    ObjectFields();
  }

  void ObjectFields() {
    constexpr uint32_t kUnspecified = 2;
    String("");
    U32(kUnspecified);
    Flag(false);
  }

  uint32_t NewObjectId() { return encoding_.next_object_id++; }
  uint32_t NewArrayId() { return encoding_.next_array_id++; }

 private:
  void Number(uint64_t value, size_t bytes) {
    for (size_t i = 0; i < bytes; ++i, value >>= 8) out_ += static_cast<char>(value & 0xff);
  }

  OsgbEncoding& encoding_;
  std::string out_;
  std::vector<size_t> open_;  // offsets of the sizes of open brackets
};

}  // namespace tilemend

#endif  // TILEMEND_COMMON_CODEC_OSGB_OSGB_ENCODER_H_
