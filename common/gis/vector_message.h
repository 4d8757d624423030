// The messages between a program and the process that reads vector files for it (gdal_process.h).
#ifndef TILEMEND_COMMON_GIS_VECTOR_MESSAGE_H_
#define TILEMEND_COMMON_GIS_VECTOR_MESSAGE_H_

#include <string>
#include <string_view>

#include "common/gis/vector_file.h"

namespace tilemend {

// What the first byte of a request asks for.
enum class GdalTask : char { kReadVectors = 'R', kFaultOfCrs = 'C', kWritePackage = 'W', kLonLat = 'L' };

// Both programs are of one build and run on one machine: numbers are as they are in memory.
std::string Encode(const VectorRequest& request);
std::string Encode(const VectorFile& file);

// False if these are not the bytes of one such message. Never reads beyond them, and takes no more memory than a small
// multiple of their size. The parts of a request refer to `bytes`. Cost: linear.
bool Decode(std::string_view bytes, VectorRequest& request);
bool Decode(std::string_view bytes, VectorFile& file);

}  // namespace tilemend

#endif  // TILEMEND_COMMON_GIS_VECTOR_MESSAGE_H_
