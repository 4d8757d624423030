// Which options have no effect beside others.
#ifndef TILEMEND_COMMON_OPTIONS_OPTION_NEEDS_H_
#define TILEMEND_COMMON_OPTIONS_OPTION_NEEDS_H_

#include <string>

#include "common/options/option.h"
#include "tilemend/v1/job_spec.pb.h"

namespace tilemend {

// Why an option with these needs has no effect in the spec, and what to do; "" if it has one. A surface or a filler of
// an unknown name counts as the default.
std::string WhyWithoutEffect(OptionNeeds needs, const v1::JobSpec& spec);

}  // namespace tilemend

#endif  // TILEMEND_COMMON_OPTIONS_OPTION_NEEDS_H_
