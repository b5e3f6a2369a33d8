// What a model file of OpenSim says of a skeleton: bodies, frames on them, joints and coordinates, with their
// places. Forces, constraints and markers stay elements. SI units; angles in radians.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "import/opensim/osim_xml.hpp"
#include "support/error.hpp"

namespace alembert {

/// Shift by `translation`, then rotation about x, the new y and the new z.
struct OsimOffset {
  std::array<double, 3> translation{}, orientation{};
  bool is_identity() const {
    return translation == std::array<double, 3>{} && orientation == std::array<double, 3>{};
  }
};

/// Of a frame that is so far off another one, in its axes.
Eigen::Isometry3d pose_of(const std::vector<OsimOffset>& offsets);

/// A frame that is fixed to a body: bodies themselves have one without offsets.
struct OsimFrame {
  std::string name, path;           ///< path: /bodyset/femur_r/socket
  std::size_t body = 0;             ///< index
  std::vector<OsimOffset> offsets;  ///< from the body's frame, outermost first
  bool own = false;                 ///< whether it is there for its own sake, and of no joint
  SourceLocation where;
};

struct OsimBody {
  std::string name;
  double mass = 0;  ///< kg
  std::array<double, 3> mass_center{};
  std::array<double, 6> inertia{};  ///< xx yy zz xy xz yz about the centre of mass
  pugi::xml_node element;
  SourceLocation where;
};

struct OsimCoordinate {
  std::string name;
  double value = 0, speed = 0;
  std::optional<std::array<double, 2>> range;
  bool locked = false;
  pugi::xml_node prescribed;  ///< function of time, or null
  std::size_t joint = 0;
  bool rotational = true;  ///< in radians
  SourceLocation where;
};

struct OsimJoint {
  std::string name, type;
  std::size_t parent = 0, child = 0;     ///< frames
  std::vector<std::size_t> coordinates;  ///< indices
  bool reversed = false;                 ///< the parent moves, and the child is nearer to the ground
  pugi::xml_node element;
  SourceLocation where;
};

/// Two frames that are one: what a joint closes a chain by.
struct OsimClosure {
  pugi::xml_node joint;
  std::array<std::size_t, 2> frames;
};

/// Joints make a tree; body 0 is the ground. A joint that would close a chain moves a copy of its body instead: the
/// two are welded, and share the mass. A WeldJoint that would close one is only the weld.
struct OsimModel {
  void add_frame(OsimFrame frame);

  std::string name;
  std::array<double, 3> gravity{};
  std::vector<OsimBody> bodies;
  std::vector<OsimFrame> frames;                                   ///< frame i is body i's, but for copies
  std::map<std::string, std::size_t> frame_of_path;                ///< the first one of each
  std::map<std::string, std::vector<std::size_t>> frames_of_name;  ///< in their order
  std::map<pugi::xml_node, std::array<std::size_t, 2>>
      places;  ///< of welds and bushings before 4.0: their frames
  std::vector<OsimJoint> joints;
  std::vector<OsimClosure> closures;
  std::vector<OsimCoordinate> coordinates;
  std::vector<std::size_t> joint_of;  ///< by body: that which moves it; of the ground: none
  pugi::xml_node element;             ///< <Model>
  SourceLocation where;
};

/// Throws InputError at what is no model, cannot be understood or does not reach the ground.
OsimModel read_osim_model(const OsimXml& xml, pugi::xml_node root);

}  // namespace alembert
