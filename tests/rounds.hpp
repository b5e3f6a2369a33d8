// How often tests that draw at random repeat themselves.
#pragma once

#include <algorithm>
#include <cstdlib>

namespace alembert::test {

/// `all`, or of these one in as many as the environment variable ALEMBERT_ONE_ROUND_IN says, but two at least: for runs
/// that ask whether the code is sound, not whether its results are right.
inline int rounds(int all) {
  const char* const one_in = std::getenv("ALEMBERT_ONE_ROUND_IN");
  return one_in == nullptr ? all : std::max(2, all / std::max(1, std::atoi(one_in)));
}

}  // namespace alembert::test
