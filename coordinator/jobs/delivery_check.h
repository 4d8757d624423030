// Whether the files of a tile that is delivered in another format can be what was asked for.
#ifndef TILEMEND_COORDINATOR_JOBS_DELIVERY_CHECK_H_
#define TILEMEND_COORDINATOR_JOBS_DELIVERY_CHECK_H_

#include <string_view>

#include "absl/status/status.h"
#include "coordinator/jobs/result_checks.h"
#include "tilemend/v1/stages.pb.h"

namespace tilemend {

// Whether `path` may be a file of the delivery whose first file is `output`: beside it, its name beginning with the
// same stem, with the ending of a format that deliveries have.
bool IsOfDelivery(std::string_view output, std::string_view path);

// The first file is the one that was asked for, all others belong to it, and each is there once with the digest that
// the worker says. What is in them is not computed here: with `how` = kContent alone it is read. kDataLoss or
// kUnavailable as CheckAssembleResult. Precondition: the files are there with their sizes.
absl::Status CheckDelivery(const v1::AssembleInput& input, const v1::AssembleOutput& output, TileCheck how);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_JOBS_DELIVERY_CHECK_H_
