// The nodes of a description while it is being made, each with a place in the file that it is made from.
#pragma once

#include <array>
#include <deque>
#include <initializer_list>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "mechanism/document.hpp"

namespace alembert {

class DescriptionNodes {
 public:
  /// `places`: where in the file the texts stand that it includes.
  explicit DescriptionNodes(std::map<const SourceText*, SourceLocation> places = {})
      : places_(std::move(places)) {}

  YamlNode& mapping(const SourceLocation& where) { return make(YamlNode::Kind::mapping, where); }
  YamlNode& sequence(const SourceLocation& where) { return make(YamlNode::Kind::sequence, where); }
  const YamlNode& text(std::string value, const SourceLocation& where);
  const YamlNode& list(std::initializer_list<std::string> values, const SourceLocation& where);
  const YamlNode& numbers(const std::array<double, 3>& values, const SourceLocation& where);
  /// Adds a key, at the place of its value.
  void put(YamlNode& mapping, std::string key, const YamlNode& value);
  /// Appends a mapping that begins with a name.
  YamlNode& add_named(YamlNode& list, std::string name, const SourceLocation& where);
  /// A coordinate's friction, of this force.
  void put_friction(YamlNode& coordinate, double force, const SourceLocation& where);
  /// Appends a holonomic constraint: all of the equations are 0.
  void add_holonomic(YamlNode& list, std::string name, const std::vector<std::string>& equations,
                     const SourceLocation& where);
  /// The whole description, which begins with its version, its name, made fit, and what it is of.
  YamlNode& root(const std::string& name, std::string description, const SourceLocation& where);
  /// {key: value}
  const YamlNode& single(std::string key, const YamlNode& value);

  std::deque<YamlNode> take() { return std::move(nodes_); }

 private:
  YamlNode& make(YamlNode::Kind kind, const SourceLocation& where);

  std::map<const SourceText*, SourceLocation> places_;
  std::deque<YamlNode> nodes_;
};

}  // namespace alembert
