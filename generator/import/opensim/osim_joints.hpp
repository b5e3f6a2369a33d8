// Joints of OpenSim: their coordinates, and the motion of the child frame in the parent frame as factors of a
// transform.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "import/common/description_nodes.hpp"
#include "import/opensim/osim_functions.hpp"
#include "import/opensim/osim_model.hpp"

namespace alembert {

/// Adds a joint's coordinates to `all`, and their indices to the joint. Throws InputError at a type of joint
/// that is not known, and at a wrong number of coordinates.
void read_osim_coordinates(const OsimXml& xml, OsimJoint& joint, std::size_t index,
                           std::vector<OsimCoordinate>& all);

class OsimFactors {
 public:
  /// What a longer function of coordinates is to be called: a definition is made of it.
  using Define = std::function<std::string(const std::string& name, const std::string& text,
                                           const SourceLocation& where)>;
  OsimFactors(DescriptionNodes& nodes, const OsimXml& xml, double snap_angles, Define define)
      : nodes_(nodes), xml_(xml), snap_angles_(snap_angles), define_(std::move(define)) {}

  void add_offset(YamlNode& out, const OsimOffset& offset, const SourceLocation& where) const;
  void add_offsets(YamlNode& out, const OsimFrame& frame, const SourceLocation& where) const;
  /// The inverse of all of a frame's offsets.
  void add_inverse(YamlNode& out, const OsimFrame& frame, const SourceLocation& where) const;
  /// \param q  what stands for each of the joint's coordinates
  void add_motion(YamlNode& out, const OsimJoint& joint, const std::vector<std::string>& q,
                  const std::vector<std::string>& coordinate_names) const;

 private:
  void add_turn(YamlNode& out, const std::string& axis, const std::string& angle,
                const SourceLocation& where) const;
  void add_turn(YamlNode& out, const std::array<double, 3>& axis, const std::string& angle,
                const SourceLocation& where) const;
  void add_shift(YamlNode& out, const std::array<std::string, 3>& by, const SourceLocation& where) const;
  void add_turns(YamlNode& out, const std::vector<std::string>& angles, const SourceLocation& where) const;
  void add_spatial(YamlNode& out, const OsimJoint& joint, const std::vector<std::string>& q,
                   const std::vector<std::string>& coordinate_names) const;
  void add_ellipsoid(YamlNode& out, const OsimJoint& joint, const std::vector<std::string>& q,
                     const std::array<double, 3>& radii) const;
  void add_scapula(YamlNode& out, const OsimJoint& joint, const std::vector<std::string>& q) const;

  DescriptionNodes& nodes_;
  const OsimXml& xml_;
  double snap_angles_;
  Define define_;
};

}  // namespace alembert
