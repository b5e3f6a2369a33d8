// What the readers of a model's sections share.
#pragma once

#include <string>

#include "import/mjcf/tree.hpp"

namespace alembert {

struct MjcfContext {
  const MjcfText& text;
  const MjcfDefaults& defaults;
  const MjcfCompiler& compiler;
  const MjcfTree& tree;
  MjcfModel& model;
  MjcfNames tendons, actuators;  ///< by name, as they are read

  /// The index that an attribute names. Throws at a name that is unknown.
  std::size_t find(const MjcfElement& element, const char* attribute, const char* noun,
                   const MjcfNames& names) const;
  /// The site that is one already, or becomes one: a body, geom, site or camera.
  std::size_t place(const MjcfElement& element, const char* type, const char* name);
  /// `limited` says whether a range counts, or the compiler does where it does not.
  std::optional<std::array<double, 2>> range(const MjcfElement& element, const char* attribute,
                                             const char* limited) const;
};

void read_tendons(MjcfContext& context);
void read_equalities(MjcfContext& context);
void read_sensors(MjcfContext& context);

}  // namespace alembert
