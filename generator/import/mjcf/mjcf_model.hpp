// What a model says: bodies, joints and sites, what acts between them, and where it starts. SI units, angles in
// radians; names may be empty.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "import/common/mass_properties.hpp"
#include "import/mjcf/geom.hpp"

namespace alembert {

enum class MjcfJointType { free, ball, slide, hinge };

struct MjcfJoint {
  std::string name;
  MjcfJointType type = MjcfJointType::hinge;
  std::size_t body = 0;
  RigidPose anchor;                                 ///< in the body's frame, not turned
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();  ///< likewise
  double reference = 0, rest = 0;  ///< of a hinge or slide; others are at rest at their reference
  double stiffness = 0, damping = 0, armature = 0, friction = 0;
  std::optional<std::array<double, 2>> spring_damper;  ///< time constant, damping ratio
  std::optional<std::array<double, 2>> limits;
  std::optional<std::array<double, 2>> drive;  ///< of what all actuators exert together
  SourceLocation where;
};

struct MjcfBody {
  std::string name;
  std::size_t parent = 0;
  RigidPose pose;  ///< in its parent, where no joint has moved
  BodyMass mass;   ///< in its own frame
  std::optional<Eigen::Quaterniond>
      inertial_turn;  ///< axes of its inertia before it was corrected, MuJoCo's up to order and signs; none of the world
  bool turn_is_exact = false;  ///< in order and signs too
  double weightless = 0;       ///< gravcomp: the part of its weight that is borne
  std::vector<MjcfFluidShape> fluid_shapes;
  std::vector<std::size_t> joints;
  std::vector<PlacedShape> shapes;
  SourceLocation where;
};

/// A sphere, or a cylinder about the z axis of its frame.
struct MjcfRound {
  bool cylinder = false;
  double radius = 0;
};

/// A site, or the frame of a geom or camera that something asks for.
struct MjcfPlace {
  std::string name;
  std::size_t body = 0;
  RigidPose pose;
  bool of_mesh = false;                 ///< the frame of a mesh, which MuJoCo moves to its centre of mass
  std::optional<MjcfRound> round = {};  ///< of a geom that tendons may wrap around
  SourceLocation where;
};

struct MjcfTerm {
  std::size_t joint;
  double factor;
};

/// A geom that a path wraps around, outside of it; places.
struct MjcfWrap {
  std::size_t geom;
  std::optional<std::size_t> side;
};

/// One branch of a path: sites, what its length is divided by, and what it wraps around, by the site before.
struct MjcfBranch {
  std::vector<std::size_t> sites;
  double divisor = 1;
  std::map<std::size_t, MjcfWrap> wraps = {};
};

struct MjcfTendon {
  std::string name;
  bool fixed = false;
  std::vector<MjcfTerm> terms;       ///< if fixed
  std::vector<MjcfBranch> branches;  ///< if not
  double stiffness = 0, damping = 0, armature = 0, friction = 0;
  std::array<double, 2> rest{};                 ///< between these lengths no spring acts
  std::optional<std::array<double, 2>> drive;   ///< of what all actuators pull together
  std::optional<std::array<double, 2>> limits;  ///< of its length
  SourceLocation where;
};

enum class MjcfTransmission { joint, tendon, site };
enum class MjcfActivation { none, integrator, filter, muscle };

/// MuJoCo's muscle, as part of gain or bias: lengths are `first` at the beginning of `lengths`, and grow by 1 over the
/// optimal length. It pulls by `force` times a curve of that length, between `least` and `most` with its peak at 1, and one
/// of the velocity in `fastest` optimal lengths a second; it resists by `passive` times `force` at half of the way from 1 to
/// `most`.
struct MjcfMuscle {
  std::array<double, 2> lengths{};
  double first = 0, optimal = 0, force = 0, least = 0, most = 0, fastest = 0, passive = 0, eccentric = 0;
};

/// force = gain*u + bias, each an affine function of length and velocity or a muscle's curves, u being the input or a
/// state.
struct MjcfActuator {
  std::string name;
  MjcfTransmission through = MjcfTransmission::joint;
  bool in_parent = false;  ///< of a ball or free joint: the torque is in the axes of the parent
  std::size_t of = 0;
  int group = 0;
  std::array<double, 6> gear{1, 0, 0, 0, 0, 0};
  std::array<double, 3> gain{1, 0, 0}, bias{};
  std::optional<MjcfMuscle> pull, resistance;  ///< in place of gain and bias
  std::array<double, 3> muscle_times{};        ///< activation, deactivation, width of the change between them
  MjcfActivation activation = MjcfActivation::none;
  double time_constant = 1, start = 0;
  std::optional<std::array<double, 2>> inputs, forces, activations;
  SourceLocation where;
};

enum class MjcfEqualityType { connect, weld, joint, tendon };

struct MjcfEquality {
  std::string name;
  MjcfEqualityType type = MjcfEqualityType::connect;
  std::size_t first = 0;              ///< body, joint or tendon
  std::optional<std::size_t> second;  ///< likewise
  RigidPose first_pose, second_pose;  ///< of connect and weld: what coincides, in the two bodies
  std::array<double, 5> polynomial{0, 1, 0, 0, 0};
  SourceLocation where;
};

struct MjcfSensor {
  std::string name, kind;
  std::size_t of = 0;                    ///< place, joint, tendon or actuator, as the kind has it
  std::optional<std::size_t> reference;  ///< place
  SourceLocation where;
};

struct MjcfModel {
  std::string name;
  Eigen::Vector3d gravity{0, 0, -9.81}, wind = Eigen::Vector3d::Zero();
  double density = 0, viscosity = 0;  ///< of what is around
  bool has_fluid() const { return density > 0 || viscosity > 0; }
  double time_step = 0.002;
  std::vector<MjcfBody> bodies;   ///< the first is the world
  std::vector<MjcfJoint> joints;  ///< in the order of their coordinates
  std::vector<MjcfPlace> sites;   ///< and other places, behind them
  std::vector<MjcfTendon> tendons;
  std::vector<MjcfActuator> actuators;
  std::vector<MjcfEquality> equalities;
  std::vector<MjcfSensor> sensors;
  std::vector<double> start, start_speeds;  ///< of the first keyframe, quaternions w x y z; or empty
  std::vector<double> start_inputs;
  std::map<const SourceText*, SourceLocation> places;  ///< of included texts, in the model's own
  std::vector<std::string> files;                      ///< included ones and meshes
  SourceLocation where;
};

/// How many numbers of qpos and qvel a joint has.
std::size_t position_count(MjcfJointType type);
std::size_t speed_count(MjcfJointType type);

/// Where a body is if no joint has moved, in the world.
RigidPose reference_pose(const MjcfModel& model, std::size_t body);

/// The same where springs of joints are at rest.
RigidPose rest_pose(const MjcfModel& model, std::size_t body);

/// Reads a model, and what it includes or names below its folder and `folders`. `warnings` gets what is doubtful or
/// left out and does not change the equations. Throws InputError at what is no MJCF, cannot be understood or cannot be
/// expressed.
MjcfModel read_mjcf(std::shared_ptr<const SourceText> source, const std::vector<std::string>& folders,
                    Warnings& warnings);

}  // namespace alembert
