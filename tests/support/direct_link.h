// A worker's link straight to Coordinator, without gRPC. ThreadSanitizer then sees all the synchronisation there
// is: the libraries of gRPC are not built for it.
#ifndef TILEMEND_TESTS_SUPPORT_DIRECT_LINK_H_
#define TILEMEND_TESTS_SUPPORT_DIRECT_LINK_H_

#include <memory>

#include "coordinator/api/coordinator.h"
#include "worker/service/work_link.h"

namespace tilemend {

// `coordinator` must outlive the link.
std::unique_ptr<WorkLink> NewDirectLink(Coordinator& coordinator);

}  // namespace tilemend

#endif  // TILEMEND_TESTS_SUPPORT_DIRECT_LINK_H_
