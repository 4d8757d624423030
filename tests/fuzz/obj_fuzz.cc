#include <string_view>

#include "tests/fuzz/append_property.h"
#include "tests/fuzz/fuzz_target.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  tilemend::CheckAppendProperty(tilemend::MeshFormat::kObj, {reinterpret_cast<const char*>(data), size});
  return 0;
}

namespace tilemend {

std::vector<std::string> FuzzSeeds() {
  return {
      "# seed\nmtllib a.mtl\nv 0 0 0\nv 1 0 0 1 0.5 0.25\nv 0 1 0 1\nvt 0 0\nvn 0 0 1\nusemtl m\nf 1 2 3\nf 1/1 2/1 "
      "3/1\n",
      "v 0 0 0\r\nv 1e-3 0 0\r\nv .5 +1 0.\r\nv 1 1 1\r\ng a b\r\nf -4//1 -3//1 -2//1 \\\r\n -1//1\r\nl 1 2\r\np "
      "3\r\nf 1/1/1 2/2/2 3/3/",
      "f 1 2 3 4\rv 0 0 0\rv 1 0 0\rv 0 1 0\rv 1 1 0\r", "v 0 0 \\\n0 1 1 \\\n 1\nv 1 0 0\nv 0 1 0#c\nf 1 2 3\\\n"};
}

}  // namespace tilemend
