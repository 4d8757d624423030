// What tells a worker from all others.
#ifndef TILEMEND_WORKER_SERVICE_WORKER_ID_H_
#define TILEMEND_WORKER_SERVICE_WORKER_ID_H_

#include <string>

namespace tilemend {

// "host-pid-random".
std::string NewWorkerId();

// 32 random hexadecimal digits: nobody else can call as this worker.
std::string NewSecret();

}  // namespace tilemend

#endif  // TILEMEND_WORKER_SERVICE_WORKER_ID_H_
