// What a job does, in the words of its user.
#ifndef TILEMEND_CLIENT_STAGE_NAME_H_
#define TILEMEND_CLIENT_STAGE_NAME_H_

#include <string>
#include <string_view>

namespace tilemend {

// What a phase of a job does: "look at the tiles" for "survey". Printable. web/src/stages.ts has the same words.
std::string StageName(std::string_view phase);

}  // namespace tilemend

#endif  // TILEMEND_CLIENT_STAGE_NAME_H_
