// The acceptance check for people and programs.
#ifndef TILEMEND_CLIENT_ACCEPTANCE_TEXT_H_
#define TILEMEND_CLIENT_ACCEPTANCE_TEXT_H_

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "client/acceptance.h"

namespace tilemend {

// "accepted: ..." or "not accepted: ...", one line without its end.
std::string VerdictOf(const Acceptance& acceptance);

// The verdict, what was compared, and each kind with its first places.
std::string AcceptanceText(const Acceptance& acceptance);

// The same with all places that were kept.
nlohmann::ordered_json AcceptanceJson(const Acceptance& acceptance);

// One line a place: what,fault,column,row,x,y,z,hole,note. Quoted as in RFC 4180; a text that a spreadsheet would take
// for a formula gets an apostrophe before it.
std::string AcceptanceCsv(const Acceptance& acceptance);
// Its first line.
std::string_view AcceptanceCsvHead();

}  // namespace tilemend

#endif  // TILEMEND_CLIENT_ACCEPTANCE_TEXT_H_
