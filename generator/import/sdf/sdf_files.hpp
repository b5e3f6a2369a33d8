// A file of SDF and those that it includes in; their elements out, each with its place and its text as values.
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "import/common/rigid_pose.hpp"
#include "import/common/xml_text.hpp"

namespace alembert {

class SdfFiles {
 public:
  /// `folders`: where models are looked for, besides the folder of the file.
  SdfFiles(std::shared_ptr<const SourceText> source, std::vector<std::string> folders, Warnings& warnings);

  pugi::xml_node root() const { return texts_.front()->root(); }
  /// The text that an element stands in.
  const XmlText& of(pugi::xml_node element) const;
  SourceLocation where(pugi::xml_node element) const { return of(element).where(element); }
  SourceLocation where(pugi::xml_node element, const char* attribute) const;
  /// Of an element's text.
  SourceLocation where_text(pugi::xml_node element) const { return of(element).where_text(element); }
  void warn(Warning warning) const { texts_.front()->warn(std::move(warning)); }
  /// Where in the first file the texts stand that it includes.
  const std::map<const SourceText*, SourceLocation>& places() const { return places_; }

  /// Files besides the first that include and file_of gave.
  const std::set<std::string>& named_files() const { return named_files_; }

  /// Whether an <include> names what Gazebo brings along and nothing moves by: its sun and its ground.
  static bool is_scenery(pugi::xml_node include);
  /// The root of the file that an <include> names. Throws InputError at what is not below the file's folder or one of
  /// `folders`, cannot be read, or includes itself.
  pugi::xml_node include(pugi::xml_node element);
  /// The file that include gave has been read.
  void close() { open_.pop_back(); }
  /// A mesh's file. Throws like include.
  std::filesystem::path file_of(pugi::xml_node uri) const;
  /// The same of one that is only drawn; nothing where file_of throws.
  std::optional<std::filesystem::path> drawn_file(pugi::xml_node uri) const;

  /// Text of an element without white space around it.
  static std::string text(pugi::xml_node element);
  /// Values of a child's text; `otherwise` where there is no such child, or it is empty.
  double number(pugi::xml_node element, const char* child, double otherwise) const;
  /// The same, where inf and -inf are numbers too.
  double number_or_infinite(pugi::xml_node element, const char* child, double otherwise) const;
  bool flag(pugi::xml_node element, const char* child, bool otherwise) const;
  bool flag(pugi::xml_attribute attribute, pugi::xml_node element, bool otherwise) const;
  Eigen::Vector3d vector(pugi::xml_node element, const char* child, const Eigen::Vector3d& otherwise) const;
  /// A <pose>: six numbers, or seven with a quaternion.
  RigidPose pose(pugi::xml_node pose) const;

 private:
  std::filesystem::path resolve(pugi::xml_node uri, std::string_view kind) const;
  std::filesystem::path model_file(const std::filesystem::path& folder, pugi::xml_node uri) const;

  Warnings* warnings_;
  std::vector<std::string> folders_;
  std::vector<std::unique_ptr<XmlText>> texts_;
  std::map<std::filesystem::path, std::size_t> by_path_;
  std::map<const SourceText*, SourceLocation> places_;
  std::vector<std::filesystem::path> open_;  ///< files that are being read
  std::size_t includes_ = 0;
  mutable std::set<std::string> named_files_;
};

/// What is called so in messages: `link 'arm'`.
std::string sdf_title(pugi::xml_node element);

}  // namespace alembert
