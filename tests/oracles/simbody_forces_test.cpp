// Forces of a description against Simbody's own force elements, on a tree of pins, a slider, a ball and a free body:
// generalized forces, c, tau, accelerations and, where both know it, potential energy.
#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "oracles/alembert_process.hpp"
#include "oracles/engines/silence.hpp"
#include "oracles/engines/simbody_model.hpp"

namespace alembert::oracles {
namespace {

namespace fs = std::filesystem;
using SimTK::MobilizerQIndex;
using SimTK::MobilizerUIndex;
using SimTK::Vec3;

constexpr double kTolerance = 1e-9;  // of the largest entry
constexpr int kStates = 12;

/// No gravity, so that all potential energy is that of forces.
constexpr const char* kRig = R"yaml(alembert: 1
name: rig
gravity: [0, 0, 0]
inputs: [throttle]
coordinates:
  - {name: turn}
  - {name: reach, initial: 0.4, limits: [0.1, 0.7]}
  - {name: swing}
  - {name: grip, type: quaternion}
  - {name: x}
  - {name: y}
  - {name: z}
  - {name: roll, type: quaternion}
bodies:
  - name: mast
    transform: [{translate: [0.1, -0.2, 0.3]}, {rotate: {axis: z, angle: turn}}]
    mass: 2
    com: [0.1, 0, 0.2]
    inertia: {xx: 0.2, yy: 0.3, zz: 0.25, xy: 0.02}
  - name: arm
    parent: mast
    transform: [{rotate: {axis: y, angle: 0.4}}, {translate: [reach, 0, 0]}]
    mass: 1.5
    com: [0, 0.05, 0.1]
    inertia: {xx: 0.1, yy: 0.12, zz: 0.08}
  - name: forearm
    parent: arm
    transform: [{translate: [0.3, 0, 0.1]}, {rotate: {axis: [0, 0.6, 0.8], angle: swing}}]
    mass: 1
    com: [0.2, 0, 0]
    inertia: {xx: 0.02, yy: 0.07, zz: 0.06, yz: 0.003}
  - name: hand
    parent: forearm
    transform: [{translate: [0.4, 0.1, 0]}, {rotate: {quaternion: grip}}]
    mass: 0.7
    com: [0, 0.1, 0.05]
    inertia: {xx: 0.03, yy: 0.02, zz: 0.04}
  - name: buoy
    transform: [{translate: [x, y, z]}, {rotate: {quaternion: roll}}]
    mass: 0.9
    com: [0.02, 0, -0.1]
    inertia: {xx: 0.05, yy: 0.06, zz: 0.07}
frames:
  - {name: hook, body: world, transform: [{translate: [0.2, 0.9, 1.1]}]}
  - {name: eye, body: arm, transform: [{translate: [0.1, 0.15, -0.2]}]}
  - {name: tip, body: hand, transform: [{translate: [0.1, -0.2, 0.3]}, {rotate: {axis: z, angle: pi/2}}]}
  - {name: ring, body: buoy, transform: [{translate: [-0.1, 0.2, 0.15]}]}
  - {name: deck, body: mast, transform: [{translate: [0, 0, 0.4]}, {rotate: {axis: x, angle: pi/2}}]}
)yaml";
const Vec3 kHook(0.2, 0.9, 1.1), kEye(0.1, 0.15, -0.2), kTip(0.1, -0.2, 0.3), kRing(-0.1, 0.2, 0.15);

/// With keys of some coordinates, and forces.
std::string rig_with(const std::map<std::string, std::string>& keys, const std::string& forces) {
  std::string text = kRig;
  for (const auto& [coordinate, more] : keys) {
    const std::string name = "{name: " + coordinate;
    text.insert(text.find(name) + name.size(), ", " + more);
  }
  return forces.empty() ? text : text + "forces:\n" + forces;
}

/// What a force is, as a function of a state that is realized to velocities.
class Acting : public SimTK::Force::Custom::Implementation {
 public:
  using Bodies = SimTK::Vector_<SimTK::SpatialVec>;
  using Law = std::function<void(const SimTK::State&, Bodies&)>;
  explicit Acting(Law law) : law_(std::move(law)) {}
  void calcForce(const SimTK::State& state, Bodies& bodies, SimTK::Vector_<Vec3>&,
                 SimTK::Vector&) const override {
    law_(state, bodies);
  }
  double calcPotentialEnergy(const SimTK::State&) const override { return 0; }

 private:
  Law law_;
};

/// The rig in Simbody while forces are added to it. (Simbody's elements refer to the subsystems that they are in.)
struct Elements {
  SimbodyModel& model;
  const State& state;  ///< of the mechanism
  SimTK::GeneralForceSubsystem forces{model.system()};
  SimTK::CableTrackerSubsystem cables{model.system()};
  SimTK::GeneralContactSubsystem contacts{model.system()};
  SimTK::Force::DiscreteForces drive{forces, model.matter()};

  Elements(SimbodyModel& of, const State& at) : model(of), state(at) {}
  const SimTK::MobilizedBody& operator[](const char* link) const { return model.link(link); }
  void act(Acting::Law law) { SimTK::Force::Custom(forces, new Acting(std::move(law))); }
};

struct Options {
  bool energy = false;                            ///< whether both count the same potentials
  int acting = kStates;                           ///< at so many states some force acts, at least
  std::function<void(SimbodyModel&)> place = {};  ///< what was added
};

void expect_near(const char* what, const Eigen::VectorXd& found, const Eigen::VectorXd& expected) {
  ASSERT_EQ(found.size(), expected.size()) << what;
  const double largest = expected.cwiseAbs().maxCoeff();
  EXPECT_LE((found - expected).cwiseAbs().maxCoeff(), kTolerance * largest)
      << what << ": " << found.transpose() << "\n for " << expected.transpose();
}

std::vector<std::map<std::string, Arrays>> generated(const std::string& text,
                                                     const std::vector<State>& states,
                                                     const std::vector<Eigen::VectorXd>& tau) {
  struct File {
    fs::path path;
    ~File() { fs::remove(path); }
  };
  const File file{fs::temp_directory_path() / ("alembert_simbody_" + std::to_string(getpid()) + ".yaml")};
  std::ofstream(file.path) << text;
  return ask_functions(ALEMBERT_EXECUTABLE, file.path.string(), states, tau,
                       {"applied_forces", "bias", "inverse_dynamics", "forward_dynamics", "energy"});
}

/// The description's functions against the rig in Simbody, to which `add` gives the same forces.
void compare(const std::string& text, const std::function<void(Elements&)>& add,
             const Options& options = {}) {
  const Description description = parse_description(text);
  const JointTree tree(parse_description(kRig));
  std::mt19937_64 random(20);
  std::vector<State> states;
  std::vector<Eigen::VectorXd> tau;
  for (int i = 0; i < kStates; ++i) {
    states.push_back(random_state(description, random));
    const State other = random_state(description, random);
    tau.emplace_back(
        Eigen::Map<const Eigen::VectorXd>(other.rates.data(), static_cast<Eigen::Index>(other.rates.size())));
  }
  const auto found = generated(text, states, tau);
  int acting = 0;
  for (std::size_t i = 0; i < states.size(); ++i) {
    SCOPED_TRACE("state " + std::to_string(i));
    const State& state = states[i];
    const Silence silence;  // Simbody reports on its cables
    std::shared_ptr<Elements> elements;
    SimbodyModel model(tree, [&](SimbodyModel& built) {
      elements = std::make_shared<Elements>(built, state);
      add(*elements);
      built.keep(elements);
    });
    const SimTK::Force::DiscreteForces drive = elements->drive;
    elements.reset();
    // Joints are coordinates, in another order.
    const Eigen::MatrixXd J = tree.jacobian(state);
    ASSERT_LE((J * J.transpose() - Eigen::MatrixXd::Identity(J.rows(), J.rows())).norm(), 1e-12);
    const JointMotion moving = tree.motion(state, true), coasting = tree.motion(state, false);
    const Eigen::VectorXd residual = J.transpose() * model.inverse_dynamics(moving, tree.wrenches(state));
    const Eigen::VectorXd coriolis = J.transpose() * model.inverse_dynamics(coasting, tree.wrenches(state));
    SimTK::State& now = model.state();
    if (options.place) options.place(model);
    model.system().realize(now, SimTK::Stage::Dynamics);
    SimTK::Vector applied;
    model.matter().multiplyBySystemJacobianTranspose(
        now, model.system().getRigidBodyForces(now, SimTK::Stage::Dynamics), applied);
    applied += model.system().getMobilityForces(now, SimTK::Stage::Dynamics);
    const Eigen::VectorXd Q = J.transpose() * model.ours(applied);
    acting += Q.cwiseAbs().maxCoeff() > 0 ? 1 : 0;
    expect_near("Q", found[i].at("applied_forces").at("Q"), Q);
    expect_near("c", found[i].at("bias").at("c"), coriolis - Q);
    if (options.energy) {
      const double potential = model.system().calcPotentialEnergy(now);
      EXPECT_NEAR(found[i].at("energy").at("e")(1), potential, kTolerance * potential);
    }
    if (!options.place) expect_near("tau", found[i].at("inverse_dynamics").at("tau"), residual - Q);
    drive.setAllMobilityForces(now, model.theirs(J * tau[i]));
    model.system().realize(now, SimTK::Stage::Acceleration);
    expect_near("qdd", found[i].at("forward_dynamics").at("qdd"), J.transpose() * model.ours(now.getUDot()));
  }
  EXPECT_GE(acting, options.acting);
}

TEST(SimbodyForces, SpringsDampersAndMotorsOnCoordinates) {
  const std::string text = rig_with({{"turn", "stiffness: 7, rest: 0.3, damping: 0.4"},
                                     {"reach", "stiffness: 50, rest: -0.2"},
                                     {"y", "damping: 1.3"}},
                                    "  - {name: motor, on: swing, value: 8*throttle}\n");
  Options options;
  options.energy = true;
  compare(
      text,
      [](Elements& rig) {
        using SimTK::Force;
        Force::MobilityLinearSpring(rig.forces, rig["mast"], MobilizerQIndex(0), 7, 0.3);
        Force::MobilityLinearDamper(rig.forces, rig["mast"], MobilizerUIndex(0), 0.4);
        Force::MobilityLinearSpring(rig.forces, rig["arm"], MobilizerQIndex(0), 50, -0.2);
        // x, y, z and the ball in turn.
        const SimTK::MobilizedBody& y = rig["buoy"].getParentMobilizedBody().getParentMobilizedBody();
        Force::MobilityLinearDamper(rig.forces, y, MobilizerUIndex(0), 1.3);
        Force::MobilityConstantForce(rig.forces, rig["forearm"], MobilizerUIndex(0),
                                     8 * rig.state.inputs.at("throttle"));
      },
      options);
}

// Its law is -k x (1 + d x') beyond an upper bound and the mirror image below a lower one, never adhesive.
TEST(SimbodyForces, Stops) {
  Options options;
  options.acting = kStates / 3;
  compare(
      rig_with({}, R"yaml(
  - {name: upper, on: swing, value: "-90*max(0, swing - 0.4)*max(0, 1 + 0.7*d(swing))"}
  - {name: lower, on: turn, value: "60*max(0, -0.5 - turn)*max(0, 1 - 0.9*d(turn))"}
)yaml"),
      [](Elements& rig) {
        using Stop = SimTK::Force::MobilityLinearStop;
        Stop(rig.forces, rig["forearm"], MobilizerQIndex(0), 90, 0.7, -SimTK::Infinity, 0.4);
        Stop(rig.forces, rig["mast"], MobilizerQIndex(0), 60, 0.9, -0.5, SimTK::Infinity);
      },
      options);
}

TEST(SimbodyForces, SpringsAndDampersBetweenPoints) {
  compare(rig_with({}, R"yaml(
  - {name: spring, between: [hook, tip], tension: 35*(length - 0.8)}
  - {name: damper, between: [tip, ring], tension: 2.5*rate}
  - {name: rope, between: [eye, ring], tension: 4 + throttle}
)yaml"),
          [](Elements& rig) {
            using SimTK::Force;
            Force::TwoPointLinearSpring(rig.forces, rig["world"], kHook, rig["hand"], kTip, 35, 0.8);
            Force::TwoPointLinearDamper(rig.forces, rig["hand"], kTip, rig["buoy"], kRing, 2.5);
            // Positive pushes apart.
            Force::TwoPointConstantForce(rig.forces, rig["arm"], kEye, rig["buoy"], kRing,
                                         -4 - rig.state.inputs.at("throttle"));
          });
}

TEST(SimbodyForces, Potentials) {
  Options options;
  options.energy = true;
  compare(
      rig_with({}, R"yaml(
  - {name: spring, potential: "35/2*(distance(hook, tip) - 0.8)^2"}
  - {name: other, potential: "20/2*(distance(ring, eye) - 0.5)^2"}
  - {name: coil, potential: "5*(swing - 0.2)^2"}
)yaml"),
      [](Elements& rig) {
        using SimTK::Force;
        Force::TwoPointLinearSpring(rig.forces, rig["world"], kHook, rig["hand"], kTip, 35, 0.8);
        Force::TwoPointLinearSpring(rig.forces, rig["arm"], kEye, rig["buoy"], kRing, 20, 0.5);
        Force::MobilityLinearSpring(rig.forces, rig["forearm"], MobilizerQIndex(0), 10, 0.2);
      },
      options);
}

// CableSpring's tension is k x max(0, 1 + c x') of the stretch x; its length goes through via points.
TEST(SimbodyForces, CablesOverViaPoints) {
  compare(rig_with({}, R"yaml(
  - {name: cable, path: [hook, eye, ring, tip], tension: "40*max(0, length - 1.1)*max(0, 1 + 0.6*rate)"}
  - {name: band, path: [eye, hook, tip], tension: "25*max(0, length - 0.3)"}
)yaml"),
          [](Elements& rig) {
            SimTK::CablePath cable(rig.cables, rig["world"], kHook, rig["hand"], kTip);
            SimTK::CableObstacle::ViaPoint(cable, rig["arm"], kEye);
            SimTK::CableObstacle::ViaPoint(cable, rig["buoy"], kRing);
            SimTK::CableSpring(rig.forces, cable, 40, 1.1, 0.6);
            SimTK::CablePath band(rig.cables, rig["arm"], kEye, rig["hand"], kTip);
            SimTK::CableObstacle::ViaPoint(band, rig["world"], kHook);
            SimTK::CableSpring(rig.forces, band, 25, 0.3, 0);
          });
}

// The frame's x is y of the hand, its y is minus x of it.
TEST(SimbodyForces, ForcesAndTorquesAtFrames) {
  compare(rig_with({}, R"yaml(
  - {name: jet, at: tip, force: [1 + throttle, 2, -3], torque: [0.4, -0.5, 0.6]}
  - {name: pull, at: ring, axes: world, force: [2, -1, "0.5*throttle"], torque: [-0.3, 0.2, 0.7]}
)yaml"),
          [](Elements& rig) {
            const double throttle = rig.state.inputs.at("throttle");
            const SimTK::MobilizedBody hand = rig["hand"];
            rig.act([hand, throttle](const SimTK::State& now, Acting::Bodies& bodies) {
              const auto in_world = [&](const Vec3& v) { return hand.expressVectorInGroundFrame(now, v); };
              hand.applyForceToBodyPoint(now, kTip, in_world(Vec3(-2, 1 + throttle, -3)), bodies);
              hand.applyBodyTorque(now, in_world(Vec3(0.5, 0.4, 0.6)), bodies);
            });
            SimTK::Force::ConstantForce(rig.forces, rig["buoy"], kRing, Vec3(2, -1, 0.5 * throttle));
            SimTK::Force::ConstantTorque(rig.forces, rig["buoy"], Vec3(-0.3, 0.2, 0.7));
          });
}

TEST(SimbodyForces, DragAndSteeringByWhatFramesDo) {
  compare(rig_with({}, R"yaml(
  - name: drag
    at: tip
    axes: world
    force: [-2*velocity(tip).x, -3*velocity(tip).y, -4*velocity(tip).z]
    torque: [-0.3*angular_velocity(tip).x, -0.2*angular_velocity(tip).y, -0.1*angular_velocity(tip).z]
  - name: magnet
    at: ring
    axes: world
    force: [position(tip).x - position(ring).x, position(tip).y - position(ring).y, position(tip).z - position(ring).z]
    torque: [rotation(ring).xz, rotation(ring).yz, rotation(ring).zz]
)yaml"),
          [](Elements& rig) {
            const SimTK::MobilizedBody hand = rig["hand"], buoy = rig["buoy"];
            rig.act([hand, buoy](const SimTK::State& now, Acting::Bodies& bodies) {
              const Vec3 v = hand.findStationVelocityInGround(now, kTip),
                         w = hand.getBodyAngularVelocity(now);
              hand.applyForceToBodyPoint(now, kTip, Vec3(-2 * v[0], -3 * v[1], -4 * v[2]), bodies);
              hand.applyBodyTorque(now, Vec3(-0.3 * w[0], -0.2 * w[1], -0.1 * w[2]), bodies);
              const Vec3 apart =
                  hand.findStationLocationInGround(now, kTip) - buoy.findStationLocationInGround(now, kRing);
              buoy.applyForceToBodyPoint(now, kRing, apart, bodies);
              buoy.applyBodyTorque(now, buoy.expressVectorInGroundFrame(now, Vec3(0, 0, 1)), bodies);
            });
          });
}

/// A pair of surfaces in contact. Simbody's documentation of HuntCrossleyForce: with plane strain moduli E1 and E2,
/// s1 = E2^(2/3)/(E1^(2/3) + E2^(2/3)), R the relative radius of curvature, and depth x,
///   f = k x^(3/2) (1 + 3/2 c x'),  k = 4/3 sqrt(R) (s1 E1^(2/3))^(3/2),  c = c1 s1 + c2 (1 - s1),
/// never less than 0: our law, with our k and c. Where it acts between the two surfaces depends on s1. Ours acts on the
/// surface of the frame's sphere; so that sphere is rigid there (1e30 times as stiff: s1 of the other is 1 in double).
/// Friction is mu f min(v/v_t, 1) where the static and the dynamic coefficient are equal, ours is mu f v/sqrt(v^2 + v_s^2).
/// At velocities v_t, v_s of 1e-9 m/s both are mu f along the slip; so what is compared is sliding, not creeping.
/// (A set each: Simbody leaves out the rest of a set after a pair that moves apart too fast to touch.)
class ContactPair {
 public:
  explicit ContactPair(Elements& rig)
      : set_(rig.contacts.createContactSet()), contacts_(rig.contacts), law_(rig.forces, rig.contacts, set_) {
    law_.setTransitionVelocity(1e-9);
  }
  void sphere(const SimTK::MobilizedBody& body, const Vec3& center, double radius, double modulus,
              double dissipation, double friction) {
    add(body, SimTK::ContactGeometry::Sphere(radius), SimTK::Transform(center), modulus, dissipation,
        friction);
  }
  /// Of which the normal points out.
  void plane(const SimTK::MobilizedBody& body, const Vec3& point, const Vec3& normal, double modulus,
             double dissipation, double friction) {
    const SimTK::Rotation inward(SimTK::UnitVec3(-normal), SimTK::XAxis);
    add(body, SimTK::ContactGeometry::HalfSpace(), SimTK::Transform(inward, point), modulus, dissipation,
        friction);
  }

 private:
  void add(const SimTK::MobilizedBody& body, const SimTK::ContactGeometry& geometry,
           const SimTK::Transform& at, double modulus, double dissipation, double friction) {
    contacts_.addBody(set_, body, geometry, at);
    law_.setBodyParameters(SimTK::ContactSurfaceIndex(count_++), modulus, dissipation, friction, friction, 0);
  }
  SimTK::ContactSetIndex set_;
  SimTK::GeneralContactSubsystem& contacts_;
  SimTK::HuntCrossleyForce law_;
  int count_ = 0;
};

/// Of a surface that meets a rigid one at radius R with stiffness k.
double modulus(double k, double R) {
  return k / (4.0 / 3 * std::sqrt(R));
}
constexpr double kRigid = 1e30;

TEST(SimbodyForces, SphereOnPlanes) {
  Options options;
  options.acting = kStates / 3;
  compare(
      rig_with({}, R"yaml(
  - {name: floor, contact: {frame: tip, radius: 0.6, plane: {point: [0.1, 0.2, -0.3], normal: [0.2, -0.4, 2]}, stiffness: 900, dissipation: 0.4, friction: 0.7, slip_velocity: 1e-9}}
  - {name: tray, contact: {frame: ring, radius: 0.5, plane: {frame: deck, point: [0, -0.1, 0], normal: [0.3, 1, 0]}, stiffness: 400, dissipation: 0.2, friction: 0.3, slip_velocity: 1e-9}}
)yaml"),
      [](Elements& rig) {
        ContactPair floor(rig);
        floor.plane(rig["world"], Vec3(0.1, 0.2, -0.3), Vec3(0.2, -0.4, 2), modulus(900, 0.6), 0.4, 0.7);
        floor.sphere(rig["hand"], kTip, 0.6, kRigid, 0, 0.7);
        // The deck's y is z of the mast, its z minus y of it.
        ContactPair tray(rig);
        tray.plane(rig["mast"], Vec3(0, 0, 0.4 - 0.1), Vec3(0.3, 0, 1), modulus(400, 0.5), 0.2, 0.3);
        tray.sphere(rig["buoy"], kRing, 0.5, kRigid, 0, 0.3);
      },
      options);
}

TEST(SimbodyForces, SphereOnSphere) {
  Options options;
  options.acting = kStates / 2;
  compare(
      rig_with({}, R"yaml(
  - {name: bump, contact: {frame: tip, radius: 1.2, sphere: {frame: ring, radius: 0.9}, stiffness: 600, dissipation: 0.3, friction: 0.4, slip_velocity: 1e-9}}
  - {name: post, contact: {frame: tip, radius: 0.9, sphere: {frame: hook, radius: 0.8}, stiffness: 300, dissipation: 0.5, friction: 0, slip_velocity: 1}}
)yaml"),
      [](Elements& rig) {
        ContactPair bump(rig);
        bump.sphere(rig["hand"], kTip, 1.2, kRigid, 0, 0.4);
        bump.sphere(rig["buoy"], kRing, 0.9, modulus(600, 1.2 * 0.9 / 2.1), 0.3, 0.4);
        // Without friction it is all one where on the line of centres it acts: two materials that are alike.
        ContactPair post(rig);
        const double each = modulus(300, 0.9 * 0.8 / 1.7) * std::pow(2, 1.5);
        post.sphere(rig["hand"], kTip, 0.9, each, 0.5, 0);
        post.sphere(rig["world"], kHook, 0.8, each, 0.5, 0);
      },
      options);
}

/// What both sides of a contact are made of.
struct Material {
  double modulus, dissipation, still, sliding, viscous;
  double softness() const { return std::pow(modulus, -2.0 / 3); }
};

/// As a contact says it: what follows its surfaces, for a sphere of the first material. R is the relative radius.
std::string yielding(const Material& a, const Material& b, double R, double transition) {
  const auto mean = [](double x, double y) { return 2 * x * y / (x + y); };
  const double share = a.softness() / (a.softness() + b.softness());
  const double still = mean(a.still, b.still), sliding = mean(a.sliding, b.sliding);
  char text[400];
  std::snprintf(text, sizeof text,
                "stiffness: %.17g, dissipation: %.17g, friction: \"min(slip/%.17g, 1)*(%.17g + "
                "%.17g/(1 + (slip/%.17g)^2)) + %.17g*slip\", slip_velocity: 1e-9, flattening: %.17g",
                4.0 / 3 * std::sqrt(R) * std::pow(a.softness() + b.softness(), -1.5),
                a.dissipation * share + b.dissipation * (1 - share), transition, sliding,
                2 * (still - sliding), transition, mean(a.viscous, b.viscous), share);
  return text;
}

/// Both surfaces give way, and friction falls from its greatest as they slide faster.
TEST(SimbodyForces, SurfacesThatYield) {
  const Material sole{700, 0.3, 0.9, 0.5, 0.2}, ground{400, 0.5, 0.7, 0.4, 0.1};
  constexpr double kTransition = 0.8;
  Options options;
  options.acting = kStates / 3;
  compare(
      rig_with({},
               "\n  - {name: floor, contact: {frame: tip, radius: 0.6, plane: {point: [0.1, 0.2, -0.3], "
               "normal: [0.2, -0.4, 2]}, " +
                   yielding(sole, ground, 0.6, kTransition) +
                   "}}\n  - {name: bump, contact: {frame: tip, radius: 1.2, sphere: {frame: ring, radius: "
                   "0.9}, " +
                   yielding(ground, sole, 1.2 * 0.9 / 2.1, kTransition) + "}}\n"),
      [&](Elements& rig) {
        const auto pair = [&](const auto& add) {
          const SimTK::ContactSetIndex set = rig.contacts.createContactSet();
          SimTK::HuntCrossleyForce law(rig.forces, rig.contacts, set);
          law.setTransitionVelocity(kTransition);
          int count = 0;
          add([&](const SimTK::MobilizedBody& body, const SimTK::ContactGeometry& geometry,
                  const SimTK::Transform& at, const Material& of) {
            rig.contacts.addBody(set, body, geometry, at);
            law.setBodyParameters(SimTK::ContactSurfaceIndex(count++), of.modulus, of.dissipation, of.still,
                                  of.sliding, of.viscous);
          });
        };
        pair([&](const auto& add) {
          add(rig["hand"], SimTK::ContactGeometry::Sphere(0.6), SimTK::Transform(kTip), sole);
          add(rig["world"], SimTK::ContactGeometry::HalfSpace(),
              SimTK::Transform(SimTK::Rotation(SimTK::UnitVec3(-0.2, 0.4, -2), SimTK::XAxis),
                               Vec3(0.1, 0.2, -0.3)),
              ground);
        });
        pair([&](const auto& add) {
          add(rig["hand"], SimTK::ContactGeometry::Sphere(1.2), SimTK::Transform(kTip), ground);
          add(rig["buoy"], SimTK::ContactGeometry::Sphere(0.9), SimTK::Transform(kRing), sole);
        });
      },
      options);
}

/// Simbody's smooth contact of a sphere with a half space (Serrancoli and others, Subject-Exoskeleton Contact Model
/// Calibration Leads to Accurate Interaction Force Predictions, 2019), of both kinds of bodies and the world.
TEST(SimbodyForces, SmoothSphereOnPlanes) {
  const auto smooth = [](double E, double c, double R) {
    char text[700];
    // k = E^(2/3)/2; the force is 4/3 k sqrt(R k) (d^2 + e)^(3/4), times what fades it out as bodies part.
    const double k = std::pow(E, 2.0 / 3) / 2;
    std::snprintf(
        text, sizeof text,
        "normal_force: \"%.17g*(depth^2 + 1e-3)^0.75*(0.5 + 0.5*tanh(30*depth))*(1 + %.17g*rate)*(0.5 + "
        "0.5*tanh(5*(rate + %.17g)))\", friction: \"min(slip/0.5, 1)*(0.4 + 0.8/(1 + (slip/0.5)^2)) + "
        "0.3*slip\", slip_velocity: \"sqrt(1e-3)\", flattening: 0.5",
        4.0 / 3 * k * std::sqrt(R * k), 1.5 * c, 2 / (3 * c));
    return std::string(text);
  };
  compare(
      rig_with({},
               "\n  - {name: floor, contact: {frame: tip, radius: 0.6, plane: {point: [0.1, 0.2, -0.3], "
               "normal: [0.2, -0.4, 2]}, " +
                   smooth(900, 0.4, 0.6) +
                   "}}\n  - {name: tray, contact: {frame: ring, radius: 0.5, plane: {frame: deck, point: [0, "
                   "-0.1, 0], normal: [0.3, 1, 0]}, " +
                   smooth(400, 0.2, 0.5) + "}}\n"),
      [](Elements& rig) {
        const auto add = [&](const char* sphere, const Vec3& center, double radius, const char* plane,
                             const Vec3& point, const Vec3& normal, double E, double c) {
          SimTK::SmoothSphereHalfSpaceForce law(rig.forces);
          law.setParameters(E, c, 0.8, 0.4, 0.3, 0.5, 1e-3, 30, 5);
          law.setContactSphereBody(rig[sphere]);
          law.setContactSphereLocationInBody(center);
          law.setContactSphereRadius(radius);
          law.setContactHalfSpaceBody(rig[plane]);
          law.setContactHalfSpaceFrame(
              SimTK::Transform(SimTK::Rotation(SimTK::UnitVec3(-normal), SimTK::XAxis), point));
        };
        add("hand", kTip, 0.6, "world", Vec3(0.1, 0.2, -0.3), Vec3(0.2, -0.4, 2), 900, 0.4);
        add("buoy", kRing, 0.5, "mast", Vec3(0, 0, 0.4 - 0.1), Vec3(0.3, 0, 1), 400, 0.2);
      });
}

// Simbody has no armatures. A rotor on the ground that turns N times as far as a joint has N^2 times its inertia for it,
// and for nothing else.
TEST(SimbodyForces, ArmatureIsAGearedRotor) {
  struct Rotor {
    const char* link;
    double ratio, inertia;
  };
  const std::array<Rotor, 3> rotors{{{"mast", 20, 0.001}, {"arm", -40, 0.0005}, {"forearm", 9, 0.003}}};
  std::vector<SimTK::MobilizedBodyIndex> built;
  Options options;
  options.place = [&](SimbodyModel& model) {
    for (std::size_t i = 0; i < rotors.size(); ++i) {
      const SimTK::MobilizedBody& joint = model.link(rotors[i].link);
      const SimTK::MobilizedBody& wheel = model.matter().getMobilizedBody(built[i]);
      wheel.setOneQ(model.state(), 0, rotors[i].ratio * joint.getOneQ(model.state(), 0));
      wheel.setOneU(model.state(), 0, rotors[i].ratio * joint.getOneU(model.state(), 0));
    }
  };
  compare(
      rig_with(
          {{"turn", "armature: 0.4, damping: 0.5"}, {"reach", "armature: 0.8"}, {"swing", "armature: 0.243"}},
          ""),
      [&](Elements& rig) {
        built.clear();
        SimTK::Force::MobilityLinearDamper(rig.forces, rig["mast"], MobilizerUIndex(0), 0.5);
        for (const Rotor& rotor : rotors) {
          const SimTK::Body wheel =
              SimTK::Body::Rigid(SimTK::MassProperties(1, Vec3(0), SimTK::Inertia(rotor.inertia)));
          built.push_back(SimTK::MobilizedBody::Pin(rig.model.matter().updGround(), SimTK::Transform(), wheel,
                                                    SimTK::Transform())
                              .getMobilizedBodyIndex());
          SimTK::Vector gears(3, 0.0);  // and a constant
          gears[0] = rotor.ratio;
          gears[1] = -1;
          SimTK::Constraint::CoordinateCoupler(
              rig.model.matter(), new SimTK::Function::Linear(gears),
              std::vector<SimTK::MobilizedBodyIndex>{rig[rotor.link].getMobilizedBodyIndex(), built.back()},
              std::vector<MobilizerQIndex>(2, MobilizerQIndex(0)));
        }
      },
      options);
}

}  // namespace
}  // namespace alembert::oracles
