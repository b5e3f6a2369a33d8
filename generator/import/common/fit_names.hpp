// Names of a robot in, which may be any text; names that the language takes out, as near to them as can be.
#pragma once

#include <map>
#include <set>
#include <string>
#include <utility>

#include "support/error.hpp"

namespace alembert {

/// What else stands in an element of one name is `_`; runs of these are one, and none is at the beginning.
/// A name that the language would refuse gets `noun` before it, if it is the first character that is wrong,
/// or after it: `2` is `joint_2`, `class` is `class_joint`.
std::string fit_name(const std::string& name, const std::string& noun);

/// The same for a mechanism, which becomes a namespace.
std::string fit_mechanism_name(const std::string& name);

/// Names that must differ: bodies, or coordinates and definitions.
class FitNames {
 public:
  FitNames(std::string noun, Warnings& warnings) : noun_(std::move(noun)), warnings_(warnings) {}
  /// Keeps a name for the one who has it already, if it is fit as it is.
  void reserve(const std::string& name);
  /// fit_name, cut to the length of names. If another has it, a number makes it differ, and a warning tells.
  std::string add(const std::string& name, const SourceLocation& where, const std::string& suffix = "");

 private:
  std::string noun_;
  Warnings& warnings_;
  std::set<std::string> reserved_;
  std::map<std::string, std::pair<std::string, int>> taken_;  // by fit name: the name as it was, its line
  std::map<std::string, int> last_;                           // by fit name: the number last given
};

}  // namespace alembert
