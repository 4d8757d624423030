// What an S3 store answers, read from XML.
#ifndef TILEMEND_COMMON_S3_S3_ANSWERS_H_
#define TILEMEND_COMMON_S3_S3_ANSWERS_H_

#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "common/util/object_store.h"

namespace tilemend {

// An <Error>; empty texts if it is none.
struct S3Error {
  std::string code, message;
};
S3Error ErrorInAnswer(const std::string& xml);

// One page of ListObjectsV2 with a delimiter.
struct S3Page {
  std::vector<ObjectEntry> entries;  // without the prefix, those that are named "" left out
  std::string next;                  // the token of the next page; "" for the last one
};
// kDataLoss if it is none.
absl::StatusOr<S3Page> ReadListing(const std::string& xml, const std::string& prefix);

}  // namespace tilemend

#endif  // TILEMEND_COMMON_S3_S3_ANSWERS_H_
