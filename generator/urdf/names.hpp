// Names of a robot in, which may be any text; names that the language takes out, as near to them as can be.
#pragma once

#include <map>
#include <string>

#include "support/error.hpp"

namespace alembert {

/// What else stands in an element of one name is `_`; runs of these are one, and none is at the beginning.
/// A name that the language would refuse gets `noun` before it, if it is the first character that is wrong,
/// or after it: `2` is `joint_2`, `class` is `class_joint`.
std::string fit_name(const std::string& name, const std::string& noun);

/// Names that must differ: bodies, or coordinates and definitions.
class FitNames {
 public:
  explicit FitNames(std::string noun) : noun_(std::move(noun)) {}
  /// fit_name, entered. Throws if the name of another became the same.
  std::string add(const std::string& name, const SourceLocation& where, const std::string& suffix = "");

 private:
  std::string noun_;
  std::map<std::string, std::pair<std::string, int>> taken_;  // by fit name: the name as it was, its line
};

}  // namespace alembert
