// How long the test's own process has computed: what else the machine does is not in it.
#pragma once

#include <ctime>

namespace alembert::test {

class ProcessorTime {
 public:
  /// Since it was made.
  double seconds() const { return static_cast<double>(std::clock() - start_) / CLOCKS_PER_SEC; }

 private:
  std::clock_t start_ = std::clock();
};

}  // namespace alembert::test
