#include "common/util/version.h"

namespace tilemend {

const char* Version() { return TILEMEND_VERSION; }

}  // namespace tilemend
