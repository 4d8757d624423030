// Tables that keep to the width of a terminal.
#ifndef TILEMEND_CLIENT_FITTED_TABLE_H_
#define TILEMEND_CLIENT_FITTED_TABLE_H_

#include <cstddef>
#include <string>
#include <vector>

namespace tilemend {

struct FittedColumn {
  std::string heading;
  int spare = 0;            // columns with more go first where room is short; 0: stays
  bool squeezable = false;  // of long cells the two ends do
};

// As Table (output.h). With `columns` > 0, the width of the terminal, the table is made narrower until no line is
// longer, as far as that goes. First long cells are squeezed to 20 columns, then columns are left out, then cells are
// squeezed to 8.
std::string FittedTable(std::vector<FittedColumn> table, std::vector<std::vector<std::string>> rows, size_t columns);

// As Table, of rows that end with a text. With `columns` > 0, the texts stand below their rows if a line would be
// longer than that. They are broken between words then. If lines are still too long, more columns move below, one at a
// time from the last.
std::string TableWithTexts(std::vector<std::string> headings, std::vector<std::vector<std::string>> rows,
                           size_t columns);

}  // namespace tilemend

#endif  // TILEMEND_CLIENT_FITTED_TABLE_H_
