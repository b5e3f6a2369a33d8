// `identify`: which parameters of the bodies can be known from forces and motions, and a program that finds them.
#pragma once

#include <string>

#include "commands/common_options.hpp"

namespace alembert {

struct IdentifyOptions {
  bool json = false;
  std::string example;  ///< folder to write an example into; empty: none
};
int run_identify(const CommonOptions& common, const IdentifyOptions& options);

}  // namespace alembert
