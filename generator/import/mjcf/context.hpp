// What the readers of a model's sections share.
#pragma once

#include <functional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "import/mjcf/tree.hpp"

namespace alembert {

struct MjcfContext {
  const MjcfTree& tree;
  MjcfModel& model;
  MjcfNames tendons = {}, actuators = {};  ///< by name, as they are read
  MjcfPart part = {};                      ///< that is read
  std::size_t count = 0, tried = 0;  ///< elements that were read and that were tried, once for each part
  /// Elements with a name that their part does not have, and what to say of them; `read` has those that some part could read.
  std::vector<std::pair<pugi::xml_node, InputError>> unknown = {};
  std::set<pugi::xml_node> missed = {}, read = {};

  const MjcfText& text() const { return part.file->text; }
  MjcfElement element(pugi::xml_node node, const std::vector<std::string>& tags) const {
    return part.file->defaults.element(node, tags, {});
  }
  /// The name that an attribute gives, as it is in the model.
  std::string name(const MjcfElement& element, const char* attribute = "name") const {
    return part.name(element.string(attribute));
  }
  /// Reads the elements of a section, but for those with a name that the part does not have: a copy may have it.
  void read_each(const char* section, const std::function<void(pugi::xml_node)>& read_one);
  /// Throws at an element of the model's own file that no part could read; warns of those of attached files.
  void check_unknown(const MjcfFile& own) const;
  /// The index that an attribute names. Throws at a name that is unknown.
  std::size_t find(const MjcfElement& element, const char* attribute, const char* noun,
                   const MjcfNames& names) const;
  /// The site that is one already, or becomes one: a body, geom, site or camera.
  std::size_t place(const MjcfElement& element, const char* type, const char* name);
  /// The same, called so; a round one that is there already.
  std::size_t place(MjcfPlace place, const std::string& name, const SourceLocation& where);
  /// `limited` says whether a range counts, or the compiler does where it does not.
  std::optional<std::array<double, 2>> range(const MjcfElement& element, const char* attribute,
                                             const char* limited) const;
};

void read_tendons(MjcfContext& context);
void read_equalities(MjcfContext& context);
void read_sensors(MjcfContext& context);

}  // namespace alembert
