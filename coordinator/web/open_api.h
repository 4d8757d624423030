// The OpenAPI 3.0 document of the JSON mirror.
#ifndef TILEMEND_COORDINATOR_WEB_OPEN_API_H_
#define TILEMEND_COORDINATOR_WEB_OPEN_API_H_

#include <string>

namespace tilemend {

// JSON text, made from Routes() and the descriptors of the messages that they name. The same bytes each time.
std::string OpenApiDocument();

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_WEB_OPEN_API_H_
