#include <string_view>

#include "tests/fuzz/append_property.h"
#include "tests/fuzz/fuzz_target.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  tilemend::CheckAppendProperty(tilemend::MeshFormat::kOff, {reinterpret_cast<const char*>(data), size});
  return 0;
}

namespace tilemend {

std::vector<std::string> FuzzSeeds() {
  return {"OFF\n4 2 0\n0 0 0\n1 0 0\n0 1 0 # c\n1 1 0\n3 0 1 2 255 0 0\n4 0 1 3 2\n",
          "STCNOFF 3 1 3\r\n0 0 0 1 1 1 1 0 0 1 .5 .5\r\n1 0 0 1 1 1 1 0 0 1 .5 .5\r\n\r\n0 1 0 1 1 1 1 0 0 1 .5 "
          ".5\r\n3 0 1 2",
          "# free\nCOFF 3\n1 0 0 0 0 1 1 1 1 1 0 0 1 1 1 1\n0 1 0 1 1 1 1 3 0 1 2", "OFF 3 0 0 0 0 0 1 0 0 0 1 0 # end",
          "OFF\n3 1 0\n0 0 0 1 0 0 0 1 0\n3 0 1 2 0.5 0.5 0.5 1\n"};
}

}  // namespace tilemend
