// For engines that talk.
#pragma once

#include <iostream>

namespace alembert::oracles {

/// DART warns on standard error, of every massless node for one; while this lives it does not.
class Silence {
 public:
  Silence() : error_(std::cerr.rdbuf(nullptr)), output_(std::cout.rdbuf(nullptr)) {}
  ~Silence() {
    std::cerr.rdbuf(error_);
    std::cerr.clear();
    std::cout.rdbuf(output_);
    std::cout.clear();
  }
  Silence(const Silence&) = delete;
  Silence& operator=(const Silence&) = delete;

 private:
  std::streambuf* error_;
  std::streambuf* output_;
};

}  // namespace alembert::oracles
