// The name that a job has in the logs of all programs: a W3C trace-id, in the metadata `traceparent` of a call.
#ifndef TILEMEND_COMMON_RPC_TRACE_H_
#define TILEMEND_COMMON_RPC_TRACE_H_

#include <string>
#include <string_view>

namespace tilemend {

// 32 hexadecimal digits, at random.
std::string NewTrace();

// What goes with a call: "00-TRACE-SPAN-01".
std::string TraceParent(const std::string& trace);

// The trace-id in such a text; "" if it has none.
std::string TraceOf(std::string_view parent);

}  // namespace tilemend

#endif  // TILEMEND_COMMON_RPC_TRACE_H_
