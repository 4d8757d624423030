#include "tests/support/http_get.h"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cstdint>

namespace tilemend {

std::string HttpAsk(int port, const std::string& request) {
  const int connection = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(static_cast<uint16_t>(port));
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  std::string answer;
  if (connect(connection, reinterpret_cast<const sockaddr*>(&address), sizeof(address)) == 0) {
    if (write(connection, request.data(), request.size()) == static_cast<ssize_t>(request.size())) {
      std::array<char, 4096> buffer;
      for (ssize_t n = 1; n > 0;) {
        n = read(connection, buffer.data(), buffer.size());
        if (n > 0) answer.append(buffer.data(), static_cast<size_t>(n));
      }
    }
  }
  close(connection);
  return answer;
}

std::string HttpGet(int port, const std::string& path) {
  return HttpAsk(port, "GET " + path + " HTTP/1.0\r\nConnection: close\r\n\r\n");
}

}  // namespace tilemend
