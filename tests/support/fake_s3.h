// An S3 store in this process, which answers as a test says.
#ifndef TILEMEND_TESTS_SUPPORT_FAKE_S3_H_
#define TILEMEND_TESTS_SUPPORT_FAKE_S3_H_

#include <gtest/gtest.h>
#include <httplib.h>
#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "common/s3/s3_store.h"

namespace tilemend {

inline constexpr char kFakeSecret[] = "very-secret";
inline constexpr char kHelloMd5[] = "5d41402abc4b2a76b9719d911017c592";  // of "hello"

// A store that answers as it is told. What it is asked is kept.
class FakeS3 : public testing::Test {
 protected:
  void SetUp() override {
    const auto handle = [this](const httplib::Request& request, httplib::Response& answer) {
      const std::lock_guard lock(mutex_);
      requests_.push_back(request);
      answer.status = failures_-- > 0 ? failure_ : 200;
      if (answers_ && answers_(request, answer)) return;
      if (answer.status != 200) return answer.set_content(failure_text_, "application/xml");
      answer.set_header("ETag", "\"" + etag_ + "\"");
      answer.set_content(content_, "application/octet-stream");
    };
    server_.set_keep_alive_timeout(1);  // seconds, which its end waits for
    server_.Get(".*", handle);
    server_.Put(".*", handle);
    server_.Post(".*", handle);
    server_.Delete(".*", handle);
    port_ = server_.bind_to_any_port("127.0.0.1");
    serving_ = std::thread([this] { server_.listen_after_bind(); });
    values_ = {{"AWS_ENDPOINT_URL", "http://127.0.0.1:" + std::to_string(port_)},
               {"AWS_ACCESS_KEY_ID", "key-id"},
               {"AWS_SECRET_ACCESS_KEY", kFakeSecret},
               {"AWS_REGION", "eu-north-1"}};
    store_ = NewS3Store(
        [this](const char* name) {
          const auto found = values_.find(name);
          return found == values_.end() ? nullptr : found->second.c_str();
        },
        {1000, part_bytes_}, {3, absl::Milliseconds(1)});
  }
  void TearDown() override {
    store_.reset();  // whose open connections the server would wait for
    server_.stop();
    serving_.join();
  }
  std::string TextOf(int file) {
    char text[64];
    const ssize_t size = ::pread(file, text, sizeof(text), 0);
    ::close(file);
    return {text, static_cast<size_t>(std::max<ssize_t>(size, 0))};
  }

  httplib::Server server_;
  int64_t part_bytes_ = int64_t{64} << 20;
  int port_ = 0;
  std::thread serving_;
  std::mutex mutex_;
  std::vector<httplib::Request> requests_;
  std::function<bool(const httplib::Request&, httplib::Response&)> answers_;  // false: as below
  int failures_ = 0, failure_ = 503;
  std::string failure_text_, etag_ = kHelloMd5, content_ = "hello";
  std::map<std::string, std::string> values_;
  std::unique_ptr<ObjectStore> store_;
};

}  // namespace tilemend

#endif  // TILEMEND_TESTS_SUPPORT_FAKE_S3_H_
