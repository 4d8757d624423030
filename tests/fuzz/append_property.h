// What must hold for any bytes that parse: a patch can be appended. The result has the original mesh bit for bit and
// the patch.
#ifndef TILEMEND_TESTS_FUZZ_APPEND_PROPERTY_H_
#define TILEMEND_TESTS_FUZZ_APPEND_PROPERTY_H_

#include <string>
#include <string_view>

#include "common/codec/mesh_file.h"

namespace tilemend {

// "" if the property holds, else what is wrong.
std::string AppendPropertyViolation(MeshFormat format, std::string_view bytes);

// Aborts with the violation on stderr.
void CheckAppendProperty(MeshFormat format, std::string_view bytes);

}  // namespace tilemend

#endif  // TILEMEND_TESTS_FUZZ_APPEND_PROPERTY_H_
