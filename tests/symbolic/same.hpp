// Comparison of expressions in tests: a failed identity prints both sides.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "symbolic/to_string.hpp"

namespace alembert {

inline void PrintTo(const Expr& x, std::ostream* to) {
  *to << to_string(x);
}

/// Both are the same node with the same sign.
inline testing::AssertionResult same(const Expr& x, const Expr& y) {
  if (x == y) return testing::AssertionSuccess();
  return testing::AssertionFailure() << "\n  " << to_string(x) << "\nis not\n  " << to_string(y);
}

}  // namespace alembert
