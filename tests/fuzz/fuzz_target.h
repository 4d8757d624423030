// What a fuzz target defines: libFuzzer's entry point, and seeds for the driver that stands in for libFuzzer.
#ifndef TILEMEND_TESTS_FUZZ_FUZZ_TARGET_H_
#define TILEMEND_TESTS_FUZZ_FUZZ_TARGET_H_

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size);

namespace tilemend {
std::vector<std::string> FuzzSeeds();
}  // namespace tilemend

#endif  // TILEMEND_TESTS_FUZZ_FUZZ_TARGET_H_
