// Elements of a model with what default classes say of them.
#pragma once

#include <Eigen/Core>
#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "import/mjcf/text.hpp"

namespace alembert {

/// An element, and below it those of its default class and of the classes around that.
class MjcfElement {
 public:
  MjcfElement(const MjcfText& text, std::vector<pugi::xml_node> layers, std::string what)
      : text_(&text), layers_(std::move(layers)), what_(std::move(what)) {}

  const MjcfText& text() const { return *text_; }
  pugi::xml_node node() const { return layers_.front(); }
  const std::vector<pugi::xml_node>& layers() const { return layers_; }
  const std::string& what() const { return what_; }  ///< in messages
  SourceLocation where() const { return text_->where(node()); }
  SourceLocation where(const char* name) const;
  /// The first attribute of a name among the layers; none if no layer has it.
  pugi::xml_attribute attribute(const char* name) const;
  bool has(const char* name) const { return static_cast<bool>(attribute(name)); }
  std::string string(const char* name, const char* otherwise = "") const;
  double number(const char* name, double otherwise) const;
  std::vector<double> list(const char* name, std::size_t least, std::size_t most) const;  ///< empty if absent
  /// Of up to `most` numbers: those that a layer gives hide the first ones of the layers around it, and leave the rest.
  std::vector<double> overlaid(const char* name, std::size_t most) const;
  /// red green blue of `rgba`; none, with a warning, where it is no colour: it is only seen.
  std::optional<std::array<double, 3>> colour() const;
  Eigen::Vector3d vector(const char* name, const Eigen::Vector3d& otherwise) const;
  /// `true` or `false`.
  bool flag(const char* name, bool otherwise) const;
  /// `true`, `false`, or none: `auto`, or absent.
  std::optional<bool> flag_or_auto(const char* name) const;
  /// The index of the attribute's value among `words`. Throws at others.
  std::size_t word(const char* name, std::initializer_list<std::string_view> words,
                   std::size_t otherwise) const;
  InputError error(const char* name, const std::string& message, const std::string& note = {}) const {
    return {has(name) ? where(name) : where(), message, note};
  }

 private:
  const MjcfText* text_;
  std::vector<pugi::xml_node> layers_;
  std::string what_;
};

/// The default classes of a model.
class MjcfDefaults {
 public:
  explicit MjcfDefaults(const MjcfText& text);

  /// `tags`: what defaults the element takes, as <general> does those of <motor>. `scope`: the class that is
  /// around it, or empty.
  MjcfElement element(pugi::xml_node node, const std::vector<std::string>& tags,
                      const std::string& scope) const;
  MjcfElement element(pugi::xml_node node, const std::string& scope = {}) const {
    return element(node, {node.name()}, scope);
  }
  /// Throws at a class that does not exist.
  void require(pugi::xml_attribute name) const;

 private:
  struct Class {
    std::string parent;
    std::size_t of_parent =
        0;  ///< elements that the parent had when the class began: later ones are not its own
    std::vector<pugi::xml_node> elements;
  };
  void read(pugi::xml_node element, const std::string& parent, int depth);

  const MjcfText* text_;
  std::map<std::string, Class, std::less<>> classes_;
};

}  // namespace alembert
