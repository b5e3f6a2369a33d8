// The typed mechanism: what a description says, in SI units, immutable once loaded, every part with its
// place. Expressions are over the graph's symbols: coordinates by their names (a quaternion `base` has base.x
// base.y base.z base.w), runtime parameters by their names, time as `t`. Other parameters are already folded
// in.
#pragma once

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "mechanism/wrapped_path.hpp"
#include "support/error.hpp"
#include "symbolic/expr.hpp"
#include "symbolic/matrix.hpp"

namespace alembert {

/// Inputs and states are always at runtime, inputs behind the other parameters and states behind inputs. Only
/// forces, outputs and rates of states depend on them.
enum class ParameterRole {
  parameter,
  input,  ///< what a controller or a player sets from step to step
  state,  ///< what is integrated beside coordinates and speeds, such as a muscle's activation
};

struct Parameter {
  std::string name;
  double value = 0;      ///< default, if runtime; of a state, its initial value
  bool runtime = false;  ///< stays an argument of the generated functions
  SourceLocation where;
  ParameterRole role = ParameterRole::parameter;
  std::optional<std::pair<double, double>> limits = {};
  /// What an input is given by, if not by its argument. Forces, outputs and rates hold the input's symbol:
  /// derivatives along speeds leave inputs as they are.
  std::optional<Expr> law = {};
  Expr rate = {};  ///< of a state, as of a force: per second
  bool is_input() const { return role == ParameterRole::input; }
  bool is_state() const { return role == ParameterRole::state; }
};

enum class CoordinateType { real, quaternion };

/// q of size `nq` from index `first_q`; speeds of size `nv` from `first_speed`. Real: 1 and 1. Quaternion
/// (order x y z w, rotation of the child relative to its parent): 4 and 3, the speeds being the angular
/// velocity in the child's axes.
struct Coordinate {
  std::string name;
  CoordinateType type = CoordinateType::real;
  int first_q = 0, first_speed = 0;
  int nq() const { return type == CoordinateType::real ? 1 : 4; }
  int nv() const { return type == CoordinateType::real ? 1 : 3; }
  std::vector<double> initial;        ///< size nq
  std::vector<double> initial_speed;  ///< size nv
  std::optional<std::pair<double, double>> limits;
  Expr armature;  ///< inertia of its own to every speed: constant, or of runtime parameters
  std::optional<double> effort_limit, speed_limit;  ///< magnitudes; the equations do not enforce them
  std::vector<Expr> symbols;                        ///< size nq: q
  std::vector<Expr> speed_symbols;                  ///< size nv: d(name), or d(name).x .y .z
  std::vector<Expr> rate_symbols;                   ///< size nv: dd(name), or dd(name).x .y .z
  SourceLocation where;
};

/// Shift by `offset`, in the axes reached so far.
struct Translation {
  Vec3 offset;
};
/// Rotation about coordinate axis 0, 1 or 2.
struct AxisRotation {
  int axis;
  Expr angle;
};
/// Rotation about a constant unit vector.
struct VectorRotation {
  Vec3 axis;
  Expr angle;
};
/// Rotation by a quaternion coordinate (index into Mechanism::coordinates).
struct QuaternionRotation {
  int coordinate;
};
/// A rigid motion written out: rotation and translation.
struct RigidMatrix {
  Mat3 rotation;
  Vec3 translation;
};
/// [b p n f]: tangent b, n normal (Frenet, or b x reference normalised), p = n x b; f the point
/// (generator/dynamics/README.md).
struct CurveFrame {
  Vec3 point;
  Expr along;
  std::optional<Vec3> reference;
};
/// [p0 p1 n f] with n = f_u x f_v normalised, negated if `flip`, p0 = f_u normalised, p1 = n x p0.
struct SurfaceFrame {
  Vec3 point;
  Expr u, v;
  bool flip = false;
};

/// A rigid motion, or its inverse. Mates, inverses of products and joints in descriptions are products of these
/// (transforms.cpp).
struct Factor {
  std::variant<Translation, AxisRotation, VectorRotation, QuaternionRotation, RigidMatrix, CurveFrame,
               SurfaceFrame>
      value;
  SourceLocation where;
  bool inverse = false;
};

/// Product of factors, left to right, from parent to child.
struct Transform {
  std::vector<Factor> factors;
};

/// Mass, centre of mass (body frame) and inertia about it (body axes): constants or functions of runtime
/// parameters.
struct MassProperties {
  Expr mass;
  Vec3 com;
  Mat3 inertia;  ///< symmetric
  bool is_point() const {
    return std::ranges::all_of(inertia.entries, [](const Expr& entry) { return entry.is_zero(); });
  }
  bool is_zero() const { return mass.is_zero() && is_point(); }
};

enum class ShapeKind { box, sphere, ellipsoid, cylinder, capsule, torus, tube, surface, mesh };

/// What a viewer draws for a body. Sizes in metres: box, the edges x y z; sphere, the radius; ellipsoid, the
/// semi-axes x y z; cylinder and capsule, radius and length along z (a capsule's between the centres of its
/// caps), centred; torus, the radius of its centre line about z and of its tube; tube, its radius; mesh, by what its
/// vertices are multiplied along x y z.
struct Shape {
  ShapeKind kind = ShapeKind::sphere;
  std::vector<double> sizes;
  Vec3 point;  ///< tube: a curve in u; surface: a function of u and v; both over symbols of their own
  Expr u, v;
  std::array<double, 2> u_range{}, v_range{};
  std::string file;     ///< mesh: its name as given, from the folder of the description
  Transform transform;  ///< from the body's frame, constant; runtime parameters at their defaults
  std::optional<std::array<double, 3>> color;  ///< red green blue, 0 to 1
  SourceLocation where;
};

/// A transform may depend on so many speeds: a body has no more freedom.
inline constexpr int kMostSpeedsOfATransform = 6;

struct Body {
  std::string name;
  int parent = -1;  ///< index of an earlier body, or -1 for the world: bodies are ordered parents first
  Transform transform;
  MassProperties mass_properties;
  bool external_wrench = false;
  std::vector<Shape> geometry;
  SourceLocation where;
};

/// A named frame fixed to (or moving with) a body.
struct Frame {
  std::string name;
  int body = -1;
  Transform transform;
  SourceLocation where;
};

/// What expressions say of frames, in world axes: `position(frame).x .y .z` and the origin's velocity, the
/// entries of the rotation `.xx .xy ... .zz` (row, column), and the angular velocity.
enum class FrameQuantity { position, velocity, rotation, angular_velocity };

/// Such a quantity of a frame. The symbols stand in its place until the kinematics are known.
struct FrameSymbols {
  FrameQuantity quantity;
  int frame;                  ///< index into Mechanism::frames
  std::vector<Expr> symbols;  ///< 3, or 9 row by row
};

/// The distance between the origins of two frames, for which the symbol `distance(from, to)` stands.
struct FrameDistance {
  int from, to;  ///< indices into Mechanism::frames
  Expr symbol;
};

enum class ConstraintType {
  pfaffian,   ///< rows linear in the speeds (and affine with time): row(q, u, t) = 0
  rolling,    ///< no slip in the tangent plane of a mate: two rows (eq. 16)
  holonomic,  ///< equation(q, t) = 0
};

struct Constraint {
  std::string name;
  ConstraintType type = ConstraintType::holonomic;
  std::vector<Expr> equations;  ///< pfaffian: over coordinates, speed symbols and t; holonomic: coordinates,
                                ///< t, and positions of Mechanism::frame_symbols; rolling: none
  int body = -1;                ///< rolling: the body whose transform has the mate, ...
  std::size_t factor = 0;       ///< ... and which factor it begins with (mate.hpp)
  std::size_t rows() const { return type == ConstraintType::rolling ? 2 : equations.size(); }
  SourceLocation where;
};

enum class ForceKind {
  on_speed,   ///< added along a speed
  potential,  ///< minus its derivative along every speed; counts as potential energy
  along,      ///< along any function of the coordinates
  path,       ///< a line of a tension, from frame to frame, that is to be shorter
  wrench,     ///< force at the origin of a frame and torque on it
};

/// A point that a path leads over where `when` is positive; always, if there is none.
struct PathPoint {
  int frame;  ///< index into Mechanism::frames
  std::optional<Expr> when = {};
};

/// What a path leads around on its way from a point to the next.
struct PathObstacle {
  RoundObstacle shape;           ///< about the origin, or the z axis, of the frame
  int frame;                     ///< index into Mechanism::frames
  std::optional<int> side = {};  ///< likewise: on the side of its origin
};

/// What acts besides gravity and external wrenches: expressions over coordinates, speeds, t, runtime
/// parameters, inputs, Mechanism::frame_symbols and distances.
struct Force {
  std::string name;
  ForceKind kind = ForceKind::on_speed;
  int speed = -1;  ///< on_speed: which one
  Expr value;      ///< on_speed, along: the generalized force; potential: J; path: the tension, N
  std::vector<PathPoint> path;                    ///< path: from end to end
  std::map<std::size_t, PathObstacle> obstacles;  ///< path: by the point before them
  Expr length;                                    ///< path: its length; along: the function
  Expr rate;               ///< path, along: the symbol that stands for the rate of that
  int frame = -1;          ///< wrench: index into Mechanism::frames
  bool frame_axes = true;  ///< wrench: in the axes of the frame, else in the world's
  Vec3 force, torque;
  bool passive = false;  ///< on_speed: damping and friction of a coordinate, not of a drive
  SourceLocation where;
};

/// A sphere that touches a plane or another sphere, for those who look at it: its forces are among
/// Mechanism::forces, by the same name. Expressions as of forces.
struct SphereContact {
  std::string name;
  int frame = -1;                  ///< of the sphere's centre: index into Mechanism::frames
  int other = -1;                  ///< of the plane or the other sphere; -1: the world
  Expr radius;                     ///< of the sphere
  Vec3 normal;                     ///< towards the sphere, world axes
  Expr depth;                      ///< m; negative: apart
  Expr strength;                   ///< the normal force, N
  bool plane = false;              ///< else a sphere
  Expr other_radius;               ///< sphere
  Vec3 plane_point, plane_normal;  ///< plane: in the axes of `other`
};

/// A quantity that is worth having, with its derivatives: an expression as of a force.
struct Output {
  std::string name;
  Expr value;
  bool of_speeds = false;  ///< depends on speeds: it has no Jacobian along them
  SourceLocation where;
  std::optional<std::pair<double, double>> limits = {};  ///< which nothing enforces
};

struct Mechanism {
  std::string name;
  std::string description;
  Vec3 gravity;
  std::vector<Parameter> parameters;  ///< all, in file order
  std::vector<Coordinate> coordinates;
  std::vector<Body> bodies;
  std::vector<Frame> frames;
  std::vector<Constraint> constraints;
  std::vector<Force> forces;  ///< those of coordinates (damping, friction, stiffness) first
  std::vector<SphereContact> contacts;
  std::vector<Output> outputs;
  std::vector<FrameSymbols> frame_symbols;  ///< those that constraints, forces and outputs use
  std::vector<FrameDistance> distances;     ///< likewise
  Expr time;                                ///< the symbol t
  int nq = 0, nv = 0;
  std::vector<int> base_columns;  ///< those of the regressor that base_regressor has, once it is asked for
  std::vector<double>
      row_lengths;    ///< dynamics/choice/row_lengths.hpp, once the function constraints is asked for
  Warnings warnings;  ///< what is doubtful in the description
  SourceLocation where;
};

}  // namespace alembert
