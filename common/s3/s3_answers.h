// What an S3 store answers, read from XML.
#ifndef TILEMEND_COMMON_S3_S3_ANSWERS_H_
#define TILEMEND_COMMON_S3_S3_ANSWERS_H_

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"
#include "common/util/object_store.h"

namespace tilemend {

// An <Error>; empty texts if it is none.
struct S3Error {
  std::string code, message;
};
S3Error ErrorInAnswer(const std::string& xml);

// The text of the element `name` in the elements `above`, the outermost first; "" if there is none.
std::string TextInAnswer(const std::string& xml, std::span<const char* const> above, const char* name);

// An ETag as a header or an answer has it, without its quotation marks.
std::string UnquotedETag(std::string_view etag);

// One page of ListObjectsV2 with a delimiter.
struct S3Page {
  std::vector<ObjectEntry> entries;  // without the prefix, those that are named "" left out
  std::string next;                  // the token of the next page; "" for the last one
};
// kDataLoss if it is none.
absl::StatusOr<S3Page> ReadListing(const std::string& xml, const std::string& prefix);

}  // namespace tilemend

#endif  // TILEMEND_COMMON_S3_S3_ANSWERS_H_
