// A model's file in; the file and those that it includes out, read as one, every element with its place.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "import/common/xml_text.hpp"

namespace alembert {

class MjcfText {
 public:
  /// Files are read below the folder of the model and below `folders`. Throws InputError at what is not XML, and at
  /// includes that cannot be read, are included already or lie elsewhere.
  MjcfText(std::shared_ptr<const SourceText> source, std::vector<std::string> folders, Warnings& warnings);

  pugi::xml_node root() const { return texts_.front()->root(); }
  /// Elements below `parent`, in place of an <include> those of the file that it names; of one name, if it is
  /// given.
  std::vector<pugi::xml_node> children(pugi::xml_node parent, std::string_view name = {}) const;
  bool holds(pugi::xml_node element) const;
  /// The text that an element or attribute stands in.
  const XmlText& of(pugi::xml_node element) const { return holding(element.name()); }
  const XmlText& of(pugi::xml_attribute attribute) const { return holding(attribute.name()); }
  SourceLocation where(pugi::xml_node element) const { return of(element).where(element); }
  SourceLocation where(pugi::xml_attribute attribute) const { return of(attribute).where(attribute); }
  /// Where in the model's own file the texts stand that it includes.
  const std::map<const SourceText*, SourceLocation>& places() const { return places_; }
  void warn(Warning warning) const { texts_.front()->warn(std::move(warning)); }

  /// Files besides the model's own that `below` gave.
  const std::set<std::string>& named_files() const { return named_files_; }

  /// Where a file that the model names lies. Throws InputError at `where` if that is below none of the folders.
  std::filesystem::path below(const std::string& file, const SourceLocation& where) const;

 private:
  const XmlText& holding(const char* name) const;
  std::filesystem::path beside_model(const std::string& name) const;
  SourceLocation own_place(const SourceLocation& where) const;
  void include(pugi::xml_node element, const XmlText& from, Warnings& warnings);
  void include_all(std::size_t text, Warnings& warnings);

  std::vector<std::string> folders_;
  std::vector<std::unique_ptr<XmlText>> texts_;
  std::map<pugi::xml_node, std::size_t> included_;      ///< by <include>: the text
  std::map<const SourceText*, SourceLocation> places_;  ///< of includes, by text
  std::set<std::filesystem::path> files_;
  mutable std::set<std::string> named_files_;
};

}  // namespace alembert
