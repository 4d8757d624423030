// Standard input, output and error where whoever started the program did not care for them.
#ifndef TILEMEND_COMMON_UTIL_STANDARD_STREAMS_H_
#define TILEMEND_COMMON_UTIL_STANDARD_STREAMS_H_

#include <cstddef>

#include "absl/status/status.h"

namespace tilemend {

// For the start of main. A stream that is closed (`>&-`) becomes /dev/null. Else the first file that the program opens
// gets its number, and what is printed is written into that file.
void OpenStandardStreams();

// Whether all that was printed on standard output has left the program: kResourceExhausted (disk full), kInternal. A
// reader that has gone (`| head`) has what it wanted: that is no error.
absl::Status FlushOutput();

// How many columns the terminal has that a descriptor leads to, as it is now; 0 if it is none, or does not say.
size_t ColumnsOfTerminal(int fd);

// The most columns of lines of help that are printed there: as many as the terminal has, but no more than 120, as long
// lines are hard to read; 100 without a terminal.
size_t ColumnsOfHelp(int fd);

}  // namespace tilemend

#endif  // TILEMEND_COMMON_UTIL_STANDARD_STREAMS_H_
