// Mechanisms with constraints in Simbody: ball joints close loops, drives are prescribed motions, a wheel is
// kept from slipping in two directions, a ball rolls on a plane.
#include <Simbody.h>

#include <map>

#include "oracles/engines/constrained_engine.hpp"
#include "oracles/taylor/poses.hpp"

namespace alembert::oracles {

namespace {

using SimTK::MobilizedBody;
using SimTK::Transform;
using SimTK::Vec3;

Vec3 vector_of(const std::array<double, 3>& v) {
  return {v[0], v[1], v[2]};
}

/// Length of a drive's leg over time: minus its equation with all variables at 0.
class DriveLength : public SimTK::Function {
 public:
  DriveLength(Expression equation, std::size_t variables)
      : equation_(std::move(equation)), variables_(variables) {}
  SimTK::Real calcValue(const SimTK::Vector& x) const override { return at(x[0]).value; }
  SimTK::Real calcDerivative(const SimTK::Array_<int>& components, const SimTK::Vector& x) const override {
    return components.size() == 1 ? at(x[0]).first : at(x[0]).second;
  }
  int getArgumentSize() const override { return 1; }
  int getMaxDerivativeOrder() const override { return 2; }

 private:
  Jet<double> at(double t) const {
    return -evaluate(equation_, std::vector<Jet<double>>(variables_, Jet<double>(0.0)),
                     Jet<double>(t, 1.0, 0.0));
  }
  Expression equation_;
  std::size_t variables_;
};

/// A row over some of a description's variables.
class Row : public SimTK::Function {
 public:
  Row(Expression equation, std::vector<std::size_t> arguments, std::size_t variables)
      : equation_(std::move(equation)), arguments_(std::move(arguments)), variables_(variables) {}
  SimTK::Real calcValue(const SimTK::Vector& x) const override { return at(x, {}).value; }
  SimTK::Real calcDerivative(const SimTK::Array_<int>& components, const SimTK::Vector& x) const override {
    const int i = components[0];
    if (components.size() == 1) return at(x, {i}).first;
    const int j = components[1];
    return i == j ? at(x, {i}).second : 0.5 * (at(x, {i, j}).second - at(x, {i}).second - at(x, {j}).second);
  }
  int getArgumentSize() const override { return static_cast<int>(arguments_.size()); }
  int getMaxDerivativeOrder() const override { return 2; }

 private:
  /// Along the sum of some arguments.
  Jet<double> at(const SimTK::Vector& x, const std::vector<int>& along) const {
    std::vector<Jet<double>> values(variables_, Jet<double>(0.0));
    for (int i = 0; i < x.size(); ++i)
      values[arguments_[static_cast<std::size_t>(i)]] = Jet<double>(x[i], 0.0, 0.0);
    for (const int i : along) values[arguments_[static_cast<std::size_t>(i)]].first = 1.0;
    return evaluate(equation_, values, Jet<double>(0.0));
  }
  Expression equation_;
  std::vector<std::size_t> arguments_;
  std::size_t variables_;
};

/// A system under construction, and how a description's state is set in it.
class Scene {
 public:
  explicit Scene(const Description& description, const State& state)
      : description_(description), given_(state), bodies_(description.bodies.size()) {
    const auto& g = description.gravity;
    SimTK::Force::UniformGravity(forces_, matter_, vector_of(g));
    (this->*constructions().at(description.name))();
  }

  using Construction = void (Scene::*)();
  static const std::map<std::string, Construction>& constructions() {
    static const std::map<std::string, Construction> table = {{"five_bar", &Scene::five_bar},
                                                              {"stewart", &Scene::stewart},
                                                              {"rolling_disc", &Scene::rolling_disc},
                                                              {"chaplygin_sleigh", &Scene::chaplygin_sleigh},
                                                              {"rolling_ball", &Scene::rolling_ball}};
    return table;
  }

  BodyAccelerations accelerations() {
    system_.realize(state_, SimTK::Stage::Acceleration);
    BodyAccelerations result = BodyAccelerations::Zero(6, static_cast<Eigen::Index>(bodies_.size()));
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      if (bodies_[i].isEmptyHandle()) continue;
      const Vec3 linear =
          bodies_[i].findStationAccelerationInGround(state_, vector_of(description_.bodies[i].com));
      const Vec3 angular = bodies_[i].getBodyAngularAcceleration(state_);
      for (int k = 0; k < 3; ++k) {
        result(k, static_cast<Eigen::Index>(i)) = linear[k];
        result(3 + k, static_cast<Eigen::Index>(i)) = angular[k];
      }
    }
    return result;
  }

 private:
  std::size_t index(const std::string& name) const {
    for (std::size_t i = 0; i < description_.bodies.size(); ++i)
      if (description_.bodies[i].name == name) return i;
    throw std::runtime_error("no body " + name);
  }
  SimTK::Body rigid(const std::string& name) const {
    const Body& body = description_.bodies[index(name)];
    const auto& I = body.inertia;
    const SimTK::Inertia central(I[0], I[1], I[2], I[3], I[4], I[5]);
    const Vec3 com = vector_of(body.com);
    return SimTK::Body::Rigid(
        SimTK::MassProperties(body.mass, com, central.shiftFromMassCenter(com, body.mass)));
  }
  MobilizedBody& keep(const std::string& name, const MobilizedBody& body) {
    return bodies_[index(name)] = body;
  }
  double parameter(const std::string& name) const { return description_.parameter(name); }
  std::size_t nq() const { return static_cast<std::size_t>(description_.nq); }
  std::size_t variables() const {
    return static_cast<std::size_t>(description_.nq + description_.nv) + 3 * description_.frames.size();
  }
  MobilizedBody& ground() { return matter_.updGround(); }
  Vec3 frame_offset(const std::string& name) const {
    for (const Frame& frame : description_.frames) {
      if (frame.name != name) continue;
      const auto pose = product_of(frame.transform, {}, Jet<double>(0.0)).translation;
      return {pose[0].value, pose[1].value, pose[2].value};
    }
    throw std::runtime_error("no frame " + name);
  }
  /// Axes whose z is the y of the body, for joints about z.
  static SimTK::Rotation z_along_y() { return {-SimTK::Pi / 2, SimTK::XAxis}; }

  void begin() {
    state_ = system_.realizeTopology();
    system_.realizeModel(state_);
    state_.setTime(given_.time);
    // Motions of all bodies, to be matched joint by joint.
    for (const BodyState& pose : body_states(description_, given_)) {
      const Eigen::Matrix3d& R = pose.R;
      poses_.emplace_back(SimTK::Rotation(SimTK::Mat33(R(0, 0), R(0, 1), R(0, 2), R(1, 0), R(1, 1), R(1, 2),
                                                       R(2, 0), R(2, 1), R(2, 2)),
                                          true),
                          Vec3(pose.origin.x(), pose.origin.y(), pose.origin.z()));
      twists_.emplace_back(Vec3(pose.omega.x(), pose.omega.y(), pose.omega.z()),
                           Vec3(pose.velocity.x(), pose.velocity.y(), pose.velocity.z()));
    }
  }
  double q(int i) const { return given_.q[static_cast<std::size_t>(i)]; }
  double u(int i) const { return given_.speeds[static_cast<std::size_t>(i)]; }
  /// Sets a body on a joint from the ground to its pose and velocity in the description.
  void match(const std::string& name) {
    const std::size_t i = index(name);
    bodies_[i].setQToFitTransform(state_, poses_[i]);
    system_.realize(state_, SimTK::Stage::Position);
    bodies_[i].setUToFitVelocity(state_, twists_[i]);
  }
  void set(const MobilizedBody& joint, const std::vector<double>& position,
           const std::vector<double>& speed) {
    for (std::size_t k = 0; k < position.size(); ++k) {
      joint.setOneQ(state_, static_cast<int>(k), position[k]);
      joint.setOneU(state_, static_cast<int>(k), speed[k]);
    }
  }

  void five_bar() {
    const double half = parameter("base") / 2, l1 = parameter("l1"), l2 = parameter("l2");
    for (const auto& [side, x] : {std::pair<std::string, double>("left", -half), {"right", half}}) {
      MobilizedBody& upper =
          keep(side + "_upper", MobilizedBody::Pin(ground(), Transform(z_along_y(), Vec3(x, 0, 0)),
                                                   rigid(side + "_upper"), Transform(z_along_y())));
      keep(side + "_lower", MobilizedBody::Pin(upper, Transform(z_along_y(), Vec3(0, 0, -l1)),
                                               rigid(side + "_lower"), Transform(z_along_y())));
    }
    const Vec3 tip(0, 0, -l2);
    SimTK::Constraint::Ball(bodies_[index("left_lower")], tip, bodies_[index("right_lower")], tip);
    begin();
    int k = 0;
    for (const char* name : {"left_upper", "left_lower", "right_upper", "right_lower"}) {
      set(bodies_[index(name)], {q(k)}, {u(k)});
      ++k;
    }
  }

  void stewart() {
    MobilizedBody& platform =
        keep("platform", MobilizedBody::Free(ground(), Transform(), rigid("platform"), Transform()));
    const Constraint& drives = description_.constraints.back();
    for (int i = 1; i <= 6; ++i) {
      const std::string leg = std::to_string(i);
      const Body& below = description_.bodies[index("cylinder" + leg)];
      const auto foot = product_of({below.transform[0]}, {}, Jet<double>(0.0)).translation;
      MobilizedBody& cylinder = keep(
          "cylinder" + leg,
          MobilizedBody::Universal(ground(), Transform(Vec3(foot[0].value, foot[1].value, foot[2].value)),
                                   rigid("cylinder" + leg), Transform()));
      // A slider is along x.
      const Transform along_z(SimTK::Rotation(-SimTK::Pi / 2, SimTK::YAxis));
      MobilizedBody& rod =
          keep("rod" + leg, MobilizedBody::Slider(cylinder, along_z, rigid("rod" + leg), along_z));
      SimTK::Constraint::Ball(platform, frame_offset("socket" + leg), rod, frame_offset("ball" + leg));
      SimTK::Constraint::PrescribedMotion(
          matter_, new DriveLength(drives.equations[static_cast<std::size_t>(i - 1)], variables()),
          rod.getMobilizedBodyIndex(), SimTK::MobilizerQIndex(0));
    }
    begin();
    match("platform");
    for (int i = 0; i < 6; ++i) {
      const std::string leg = std::to_string(i + 1);
      set(bodies_[index("cylinder" + leg)], {q(7 + 3 * i), q(8 + 3 * i)}, {u(6 + 3 * i), u(7 + 3 * i)});
      set(bodies_[index("rod" + leg)], {q(9 + 3 * i)}, {u(8 + 3 * i)});
    }
  }

  /// Rows are couplers of speeds. NoSlip1D will not do: its acceleration takes the point of the disc at the
  /// contact to stay there (Simbody's issue 135).
  void rolling_disc() {
    MobilizedBody::Planar heading(ground(), Transform(), SimTK::Body::Massless(), Transform());
    const Transform x_as_z(SimTK::Rotation(SimTK::Pi / 2, SimTK::YAxis));
    MobilizedBody::Pin lean(heading, x_as_z, SimTK::Body::Massless(), x_as_z);
    MobilizedBody& disc =
        keep("disc", MobilizedBody::Pin(lean, Transform(z_along_y(), Vec3(0, 0, parameter("R"))),
                                        rigid("disc"), Transform(z_along_y())));
    const SimTK::MobilizedBodyIndex plane = heading.getMobilizedBodyIndex();
    const std::vector<SimTK::MobilizedBodyIndex> moving{plane, plane, disc.getMobilizedBodyIndex()},
        turned{plane};
    const std::vector<SimTK::MobilizerUIndex> speeds{SimTK::MobilizerUIndex(1), SimTK::MobilizerUIndex(2),
                                                     SimTK::MobilizerUIndex(0)};
    const std::vector<SimTK::MobilizerQIndex> angles{SimTK::MobilizerQIndex(0)};
    for (const Expression& row : description_.constraints[0].equations)
      SimTK::Constraint::SpeedCoupler(matter_, new Row(row, {nq() + 0, nq() + 1, nq() + 4, 2}, variables()),
                                      moving, speeds, turned, angles);
    begin();
    set(heading, {q(2), q(0), q(1)}, {u(2), u(0), u(1)});
    set(lean, {q(3)}, {u(3)});
    set(disc, {q(4)}, {u(4)});
  }

  void chaplygin_sleigh() {
    MobilizedBody& sleigh =
        keep("sleigh", MobilizedBody::Planar(ground(), Transform(), rigid("sleigh"), Transform()));
    SimTK::Constraint::NoSlip1D(sleigh, Vec3(0), SimTK::UnitVec3(SimTK::YAxis), ground(), sleigh);
    begin();
    set(sleigh, {q(2), q(0), q(1)}, {u(2), u(0), u(1)});
  }

  void rolling_ball() {
    const SimTK::Body any = SimTK::Body::Rigid(SimTK::MassProperties(1, Vec3(0), SimTK::Inertia(1)));
    MobilizedBody& table = keep("table", MobilizedBody::Pin(ground(), Transform(), any, Transform()));
    SimTK::Motion::Steady(table, parameter("rate"));
    MobilizedBody& ball =
        keep("ball", MobilizedBody::Free(ground(), Transform(), rigid("ball"), Transform()));
    SimTK::Constraint::SphereOnPlaneContact(table, Transform(), ball, Vec3(0), parameter("a"), true);
    begin();
    match("table");
    match("ball");
  }

  const Description& description_;
  const State& given_;
  SimTK::MultibodySystem system_;
  SimTK::SimbodyMatterSubsystem matter_{system_};
  SimTK::GeneralForceSubsystem forces_{system_};
  std::vector<MobilizedBody> bodies_;  ///< by body of the description; empty handles for scenery
  std::vector<Transform> poses_;
  std::vector<SimTK::SpatialVec> twists_;
  SimTK::State state_;
};

}  // namespace

bool simbody_expresses_constraints(const Description& description) {
  return Scene::constructions().count(description.name) > 0;
}

BodyAccelerations simbody_constrained_accelerations(const Description& description, const State& state) {
  return Scene(description, state).accelerations();
}

}  // namespace alembert::oracles
