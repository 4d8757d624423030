// Early return of absl::Status, which Abseil 20220623 has no macros for.
#ifndef TILEMEND_COMMON_UTIL_STATUS_MACROS_H_
#define TILEMEND_COMMON_UTIL_STATUS_MACROS_H_

#include <utility>

#include "absl/status/status.h"
#include "absl/status/statusor.h"

#define TILEMEND_CONCAT_INNER(a, b) a##b
#define TILEMEND_CONCAT(a, b) TILEMEND_CONCAT_INNER(a, b)

// Returns from the calling function if `expr`, an absl::Status, is not OK.
#define TILEMEND_RETURN_IF_ERROR(expr)                                                                 \
  do {                                                                                                 \
    if (absl::Status status_macro_value = (expr); !status_macro_value.ok()) return status_macro_value; \
  } while (false)

#define TILEMEND_ASSIGN_OR_RETURN_IMPL(result, lhs, expr) \
  auto result = (expr);                                   \
  if (!result.ok()) return result.status();               \
  lhs = std::move(result).value()

// Evaluates `expr`, an absl::StatusOr<T>; returns its status if it is an error, else assigns its value to `lhs`.
#define TILEMEND_ASSIGN_OR_RETURN(lhs, expr) \
  TILEMEND_ASSIGN_OR_RETURN_IMPL(TILEMEND_CONCAT(status_or_, __LINE__), lhs, expr)

#endif  // TILEMEND_COMMON_UTIL_STATUS_MACROS_H_
