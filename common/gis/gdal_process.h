// The process that GDAL runs in.
//
// Files of others are read by a program of its own, `tilemend-gdal`, which lives for one request. It has no network
// if the kernel allows a user to give it up, and opens no file but in its memory. It ends when the thread that asks
// ends. It also ends when it takes more memory or time than the size of its input explains (gdal_limits.h). A fault in
// one of GDAL's drivers is an error of one file.
#ifndef TILEMEND_COMMON_GIS_GDAL_PROCESS_H_
#define TILEMEND_COMMON_GIS_GDAL_PROCESS_H_

#include <stop_token>
#include <string>
#include <string_view>

#include "absl/status/statusor.h"

namespace tilemend {

// Sends `request` to such a process and returns its answer (vector_message.h). `name` is that of the file or the CRS,
// for messages. Starting it takes some 40 ms.
//
// Returns kInvalidArgument with `name` if the process dies of the request or exceeds its limits. Returns kCancelled
// soon after a stop is requested: the process is killed. Returns kInternal if the program is missing: it lies beside
// the calling one, or in ../bin or ../lib/tilemend from there.
absl::StatusOr<std::string> AskGdal(std::string_view request, const std::string& name,
                                    const std::stop_token& stop = {});

}  // namespace tilemend

#endif  // TILEMEND_COMMON_GIS_GDAL_PROCESS_H_
