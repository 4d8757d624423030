// All ways to fill that papers describe.
#ifndef TILEMEND_WORKER_PAPERS_PUBLISHED_WAYS_H_
#define TILEMEND_WORKER_PAPERS_PUBLISHED_WAYS_H_

#include "worker/fill/hole/published_ways.h"

namespace tilemend {

// For FillOptions::published. It is there as long as the program.
const PublishedWays* AllPublishedWays();

}  // namespace tilemend

#endif  // TILEMEND_WORKER_PAPERS_PUBLISHED_WAYS_H_
