// A mechanism as the oracles read it from its YAML file: numbers for everything that is constant, expression
// trees for transforms and constraints. Joints are spelt out as the translations and rotations that they are.
#pragma once

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "oracles/description/expression.hpp"
#include "oracles/description/forces.hpp"

namespace alembert::oracles {

struct Coordinate {
  std::string name;
  bool quaternion = false;  ///< 4 coordinates x y z w and 3 speeds instead of 1 and 1
  int first_q = 0, first_speed = 0;
  std::vector<double> initial;
  std::optional<std::pair<double, double>> limits;
  double armature = 0;                                      ///< inertia of its own to each of its speeds
  double damping = 0, friction = 0, friction_velocity = 1;  ///< of each of its speeds
  double stiffness = 0, rest = 0;                           ///< of a real one
};

struct Factor;
struct Translation {
  Expression3 offset;
};
struct Rotation {
  std::array<double, 3> axis;  ///< of length 1
  Expression angle;
};
struct QuaternionRotation {
  int first_q;
};
struct Matrix {
  std::array<Expression, 12> entry;  ///< three rows of four
};
struct Curve {
  Expression3 point;
  int along;  ///< index into q
  std::optional<Expression3> reference;
};
struct Surface {
  Expression3 point;
  int u, v;  ///< indices into q
  bool flip = false;
};
struct Mate {
  Surface first, second;
  Expression spin;
};
struct Inverse {
  std::vector<Factor> of;
};
struct Factor {
  std::variant<Translation, Rotation, QuaternionRotation, Matrix, Curve, Surface, Mate, Inverse> value;
};

struct Body {
  std::string name;
  int parent = -1;  ///< index of an earlier body; -1: the world
  std::vector<Factor> transform;
  double mass = 0;
  std::array<double, 3> com{};
  std::array<double, 6> inertia{};  ///< xx yy zz xy xz yz about the centre of mass
  bool external_wrench = false;
};

/// A named frame on a body (-1: the world).
struct Frame {
  std::string name;
  int body = -1;
  std::vector<Factor> transform;
};

enum class ConstraintKind { pfaffian, rolling, holonomic };

/// Equations are over a list of variables: the nq coordinates, the nv speeds, and the world position of each
/// frame.
struct Constraint {
  std::string name;
  ConstraintKind kind = ConstraintKind::holonomic;
  std::vector<Expression> equations;  ///< none if rolling
  int body = -1;                      ///< rolling: whose transform has the mate
  std::size_t factor = 0;             ///< and which factor that is
  std::size_t rows() const { return kind == ConstraintKind::rolling ? 2 : equations.size(); }
};

struct Description {
  std::string name, text;  ///< what it is called, what it was read from
  std::array<double, 3> gravity{0, 0, -9.81};
  std::vector<std::pair<std::string, double>> parameters;
  std::map<std::string, double> runtime_parameters;  ///< those of them that stay arguments
  std::vector<Coordinate> coordinates;
  std::vector<Body> bodies;  ///< parents first
  std::vector<Frame> frames;
  std::vector<Constraint> constraints;
  std::vector<Input> inputs;
  std::vector<Integrated> states;
  std::vector<FramePath> paths;
  std::vector<AppliedForce> forces;      ///< beside those of coordinates
  std::vector<std::string> force_names;  ///< of each of them; those of a contact share one
  std::vector<Output> outputs;
  int nq = 0, nv = 0;

  bool outputs_of_speeds() const;  ///< whether one depends on speeds, which are no function of the position
  std::vector<double> armatures() const;  ///< by speed
  std::size_t constraint_rows() const;
  bool has_forces() const;                          ///< of any kind, also of coordinates
  double parameter(const std::string& name) const;  ///< throws if there is none
};

/// Reads a file; throws std::runtime_error at what the oracles do not know. Runtime parameters have their
/// defaults, or these values.
Description read_description(const std::string& path, const std::map<std::string, double>& values = {});
/// The same from text.
Description parse_description(const std::string& yaml, const std::map<std::string, double>& values = {});

}  // namespace alembert::oracles
