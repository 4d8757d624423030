#include <cstdio>
#include <cstdlib>
#include <string_view>

#include "tests/fuzz/fuzz_target.h"
#include "tests/fuzz/gltf_property.h"
#include "tests/support/gltf_samples.h"

namespace tilemend {

std::vector<std::string> FuzzSeeds() {
  std::vector<std::string> seeds;
  for (const auto& [name, bytes] : GltfSampleFiles()) seeds.push_back(bytes);
  return seeds;
}

}  // namespace tilemend

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  const std::string violation = tilemend::GltfPropertyViolation({reinterpret_cast<const char*>(data), size});
  if (violation.empty()) return 0;
  std::fprintf(stderr, "%s\n", violation.c_str());
  std::abort();
}
