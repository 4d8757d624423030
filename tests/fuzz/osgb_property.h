// What must hold for any bytes that parse as OSGB: geometry can be appended and triangles can be taken out. Everything
// else is as it was.
#ifndef TILEMEND_TESTS_FUZZ_OSGB_PROPERTY_H_
#define TILEMEND_TESTS_FUZZ_OSGB_PROPERTY_H_

#include <string>
#include <string_view>

namespace tilemend {

// "" if the property holds, else what is wrong.
std::string OsgbPropertyViolation(std::string_view bytes);

}  // namespace tilemend

#endif  // TILEMEND_TESTS_FUZZ_OSGB_PROPERTY_H_
