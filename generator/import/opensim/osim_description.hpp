// A description while it is made from a model of OpenSim: its sections, names, and the counts of what was taken
// and left out.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "import/common/counts.hpp"
#include "import/common/described.hpp"
#include "import/common/description_nodes.hpp"
#include "import/common/fit_names.hpp"
#include "import/opensim/osim_functions.hpp"
#include "import/opensim/osim_joints.hpp"
#include "import/opensim/osim_model.hpp"

namespace alembert {

struct OsimDescription {
  OsimDescription(const OsimModel& model, const OsimXml& xml, const DescribeOptions& options);

  /// What stands for a coordinate in expressions: itself, a parameter or a definition.
  const std::string& text_of(std::size_t coordinate) const { return coordinate_names[coordinate]; }

  /// The coordinate of the description that moves this one, and how far this one goes for it: itself and 1, or what
  /// it follows in proportion. None if it stands still, is prescribed, or follows along a curve.
  std::optional<std::pair<std::size_t, double>> driver(std::size_t coordinate) const;

  /// A definition, and the name that it gets.
  std::string define(const std::string& name, const std::string& text, const SourceLocation& at);
  /// A frame at a point of another, turned about x, the new y and the new z, and the name that it gets; a frame of the same
  /// name and place only once.
  std::string add_frame(const std::string& name, std::size_t on, const std::array<std::string, 3>& point,
                        const SourceLocation& at, const std::array<double, 3>& orientation = {});
  /// The same at the origin, under the frame's own name.
  std::string frame_of(std::size_t frame, const SourceLocation& at);
  /// An input, and the name that it gets.
  std::string add_input(const std::string& name, double initial, const std::array<double, 2>& limits,
                        const SourceLocation& at);
  /// A state of a name that is taken already. Limits may be infinite.
  std::string add_state(const std::string& name, double initial, const std::array<double, 2>& limits,
                        const std::string& rate, const SourceLocation& at);
  /// A force of this name; what it does is to be put into it.
  YamlNode& add_force(const std::string& name, const SourceLocation& at);
  static const std::string& name_of(const YamlNode& force) { return force.items[1]->text; }
  void put(YamlNode& mapping, const char* key, const std::string& text, const SourceLocation& at);

  void took(const std::string& what) { ++taken[what]; }
  /// Left out, with a warning.
  void left(pugi::xml_node element, const std::string& why, const std::string& note = {});
  void approximated(pugi::xml_node element, const std::string& how, const std::string& note = {});

  /// The whole description.
  YamlNode& finish();

  const OsimModel& model;
  const OsimXml& xml;
  const DescribeOptions& options;
  DescriptionNodes nodes;
  Warnings warnings;
  FitNames names{"coordinate", warnings}, body_names{"body", warnings}, frame_names{"frame", warnings},
      force_names{"force", warnings}, constraint_names{"constraint", warnings};
  OsimFactors factors;
  std::vector<std::string> bodies;            ///< names by body; the ground is the world
  std::vector<std::string> coordinate_names;  ///< by coordinate
  std::vector<bool> independent;              ///< by coordinate
  std::vector<bool> driven;                   ///< by coordinate: independent, or a function of such ones
  std::map<std::size_t, std::pair<std::size_t, double>> follows;  ///< of those coupled in proportion
  /// Sections that are lists, and the names and texts of the others.
  std::map<std::string, YamlNode*> sections;
  struct Named {
    std::string name, text;
    SourceLocation at;
  };
  std::vector<Named> parameters, definitions;
  Counts taken, left_out, nearly;

 private:
  void drop_unused();

  std::map<std::pair<std::size_t, std::string>, std::string> frames_made_;  // by frame and point
};

}  // namespace alembert
