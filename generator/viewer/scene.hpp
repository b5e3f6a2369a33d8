// What is to be seen: meshes, and bodies of one or several mechanisms with their poses over time. In: a
// mechanism and a motion of it, its poses worked out at every frame, because viewers know no parametric
// joints. Out: a scene, which glb.hpp and page.hpp write.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "mechanism/model.hpp"
#include "viewer/mesh.hpp"

namespace alembert {

/// Red, green, blue from 0 to 1, as on screens (sRGB).
using Color = std::array<double, 3>;

/// A mesh in its place on a body, or in the world.
struct ScenePart {
  std::size_t mesh = 0;  ///< index into Scene::meshes
  Eigen::Isometry3d placement = Eigen::Isometry3d::Identity();
  Color color{0.5, 0.5, 0.5};
};

struct SceneBody {
  std::string name;
  double mass = 0;                                           ///< kg
  Eigen::Vector3d center_of_mass = Eigen::Vector3d::Zero();  ///< body frame
  std::vector<ScenePart> parts;
  std::vector<Eigen::Vector3d> origins;  ///< one for each frame, world axes
  std::vector<Eigen::Quaterniond>
      rotations;  ///< likewise; neighbours on one side: their dot product is not negative
};

/// A value over time, to be plotted.
struct Series {
  std::string name;
  std::vector<double> values;
  std::string unit;                                 ///< empty if it is not known
  std::optional<std::pair<double, double>> limits;  ///< of a coordinate
};

/// A line from point to point that pulls, or pushes.
struct SceneLine {
  std::size_t force = 0;                             ///< its tension: index into Acting::forces
  std::vector<std::vector<Eigen::Vector3d>> points;  ///< each at every frame, world axes
};

/// A sphere that touches a plane or another sphere.
struct SceneContact {
  std::size_t force = 0;                ///< the normal force: index into Acting::forces
  std::vector<Eigen::Vector3d> points;  ///< the deepest one of the sphere at every frame, world axes
};

/// What acts on a mechanism over its motion, and what else its description wants to know of it.
struct Acting {
  std::vector<Series> forces, inputs, states, outputs;
  std::vector<SceneLine> lines;
  std::vector<SceneContact> contacts;
};

/// A number of a mechanism's parameters that a page lets the hand change.
struct Slider {
  std::string name;
  std::size_t place = 0;  ///< in the array of parameters
  double low = 0, high = 1;
  bool input = false;
};

/// What a page needs to go on by itself: functions, and the state that it starts from.
struct LiveMechanism {
  std::string module;  ///< JavaScript, an ES module
  std::vector<double> q, qd, parameters;
  double t = 0;
  std::vector<Slider> sliders;
};

struct SceneMechanism {
  std::string name;
  std::string description;
  Eigen::Isometry3d placement = Eigen::Isometry3d::Identity();  ///< its world in the scene, where z is up
  std::vector<double> times;                                    ///< seconds, increasing
  std::vector<SceneBody> bodies;
  std::vector<ScenePart> scenery;  ///< fixed to the world
  std::vector<Series> coordinates;
  std::vector<Series> energies;  ///< kinetic, potential, total
  Acting acting;
  std::optional<LiveMechanism> live;
};

struct Scene {
  std::string title;
  std::vector<Mesh> meshes;
  std::vector<SceneMechanism> mechanisms;

  /// Index of a mesh, added if there is none like it.
  std::size_t mesh_index(Mesh mesh);
};

/// A motion at its frames. All vectors have one entry a frame.
struct BakedMotion {
  std::vector<double> times;
  std::vector<std::vector<double>> q;      ///< nq each
  std::vector<std::vector<double>> poses;  ///< function body_poses: rows [R | p] of each body
  std::vector<double> kinetic, potential;  ///< J
  Acting acting;
};

/// Adds a mechanism in motion: its bodies with the shapes of the description, or default ones (looks.hpp). It
/// is turned so that its gravity points down. A name that is there already gets a number. Throws InputError
/// at a shape that cannot be drawn; `warnings` gets meshes whose files cannot be read.
void add_mechanism(Scene& scene, const Mechanism& mechanism, ExprGraph& graph, const BakedMotion& motion,
                   Warnings& warnings);

/// Box around all that a mechanism shows over its first `frames` frames, in its own world axes.
Eigen::AlignedBox3d bounds(const Scene& scene, const SceneMechanism& mechanism,
                           std::size_t frames = std::numeric_limits<std::size_t>::max());

/// Shifts the mechanisms so that they stand beside each other, in a grid of rows along x, each row and column
/// as wide as it must be, on one floor.
void place_side_by_side(Scene& scene);

}  // namespace alembert
