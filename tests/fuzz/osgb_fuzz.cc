#include <cstdio>
#include <cstdlib>
#include <string_view>

#include "tests/fuzz/fuzz_target.h"
#include "tests/fuzz/osgb_property.h"
#include "tests/support/osgb_builder.h"

namespace tilemend {

std::vector<std::string> FuzzSeeds() {
  std::vector<std::string> seeds;
  for (const uint32_t version : kOsgbVersions) seeds.push_back(BuiltOsgbScene(version));
  BuiltGeometry consecutive;
  consecutive.type = 50;
  consecutive.indices = {0, 3};
  consecutive.image.clear();
  for (const uint32_t version : {80u, 161u}) {
    seeds.push_back(BuiltOsgbGeometry(consecutive, version));
    OsgbBuilder builder(version);
    seeds.push_back(builder.Scene([&] { builder.Translation(1, 2, 3, {[&] { builder.Geode({}); }}); }));
  }
  return seeds;
}

}  // namespace tilemend

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  const std::string violation = tilemend::OsgbPropertyViolation({reinterpret_cast<const char*>(data), size});
  if (violation.empty()) return 0;
  std::fprintf(stderr, "%s\n", violation.c_str());
  std::abort();
}
