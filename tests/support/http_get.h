// A page from a server on this machine, over a plain socket.
#ifndef TILEMEND_TESTS_SUPPORT_HTTP_GET_H_
#define TILEMEND_TESTS_SUPPORT_HTTP_GET_H_

#include <string>

namespace tilemend {

// The whole answer to GET `path` at 127.0.0.1:`port`, headers and all; "" if there is none.
std::string HttpGet(int port, const std::string& path);

// The whole answer to the bytes `request`, likewise.
std::string HttpAsk(int port, const std::string& request);

}  // namespace tilemend

#endif  // TILEMEND_TESTS_SUPPORT_HTTP_GET_H_
