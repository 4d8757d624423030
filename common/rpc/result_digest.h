// By which two results of one task are compared.
#ifndef TILEMEND_COMMON_RPC_RESULT_DIGEST_H_
#define TILEMEND_COMMON_RPC_RESULT_DIGEST_H_

#include <string>

#include "common/store/digest.h"
#include "common/util/stage.h"
#include "tilemend/v1/stages.pb.h"

namespace tilemend {

// FileDigest of a result, without what depends on when it was computed: the stamp of a survey.
inline std::string ResultDigest(Stage stage, const std::string& output) {
  v1::SurveyOutput survey;
  if (stage != Stage::kSurvey || !survey.ParseFromString(output)) return FileDigest(output);
  survey.clear_stamp();
  return FileDigest(survey.SerializeAsString());
}

}  // namespace tilemend

#endif  // TILEMEND_COMMON_RPC_RESULT_DIGEST_H_
