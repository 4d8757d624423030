#include "common/util/without_exceptions.h"

#include <gtest/gtest.h>

namespace tilemend {
namespace {

TEST(WithoutExceptionsTest, GivesWhatWasThrownAsAStatus) {
  EXPECT_TRUE(WithoutExceptions([] { return absl::OkStatus(); }).ok());
  EXPECT_EQ(WithoutExceptions([] { return absl::NotFoundError("x"); }), absl::NotFoundError("x"));
  EXPECT_TRUE(absl::IsResourceExhausted(WithoutExceptions([]() -> absl::Status { throw std::bad_alloc(); })));
  EXPECT_TRUE(absl::IsResourceExhausted(WithoutExceptions([]() -> absl::Status {
    throw std::system_error(std::make_error_code(std::errc::resource_unavailable_try_again));
  })));
}

}  // namespace
}  // namespace tilemend
