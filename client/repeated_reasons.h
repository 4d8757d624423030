// Long reasons of a table, each printed once.
#ifndef TILEMEND_CLIENT_REPEATED_REASONS_H_
#define TILEMEND_CLIENT_REPEATED_REASONS_H_

#include <string>
#include <vector>

namespace tilemend {

// Numbers reasons that begin alike, up to ": " or their end. The first keeps its text behind "[1]", and an equal one
// becomes "[1]". Another keeps what follows ": ", up to a comma: "[1] 15 places tell one". Reasons that stand
// alone, or are short, stay as they are.
void ShortenRepeated(const std::vector<std::string*>& reasons);

// The same for the last column of a table.
void ShortenRepeated(std::vector<std::vector<std::string>>& rows);

}  // namespace tilemend

#endif  // TILEMEND_CLIENT_REPEATED_REASONS_H_
