// Fields of CSV files.
#ifndef TILEMEND_CLIENT_CSV_H_
#define TILEMEND_CLIENT_CSV_H_

#include <string>

namespace tilemend {

// `text` as one field, quoted as in RFC 4180 if it has to be. A text that a spreadsheet would take for a formula gets
// an apostrophe before it; a number does not.
std::string CsvField(const std::string& text);

}  // namespace tilemend

#endif  // TILEMEND_CLIENT_CSV_H_
