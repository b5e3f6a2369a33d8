// Forces of a model of OpenSim as `alembert import` describes them, one by one, against their laws.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "oracles/alembert_process.hpp"
#include "oracles/osim/imported.hpp"

namespace alembert::oracles {
namespace {

using SimTK::Vec3;

constexpr int kStates = 12;
constexpr double kDifferences = 1e-7;

struct Rig {
  explicit Rig(const std::string& name, int count = kStates)
      : file(ALEMBERT_SOURCE_DIR "/tests/osim/models/" + name), imported(file), skeleton(file) {
    std::mt19937_64 random(3);
    for (int i = 0; i < count; ++i) states.push_back(random_state(imported.description(), random));
    const std::vector<Eigen::VectorXd> tau(states.size(), Eigen::VectorXd::Zero(imported.description().nv));
    const bool has_states = !imported.description().states.empty();
    found = ask_functions(ALEMBERT_EXECUTABLE, imported.path(), states, tau,
                          has_states ? std::vector<std::string>{"force_contributions", "state_rates"}
                                     : std::vector<std::string>{"force_contributions"});
  }
  NamedMotion motion(std::size_t i) {
    NamedMotion out(imported.description(), states[i]);
    out.apply(skeleton);
    return out;
  }
  pugi::xml_node force(const char* name) const {
    return skeleton.model().child("ForceSet").child("objects").find_child_by_attribute("name", name);
  }
  /// What a force adds to the generalized forces.
  Eigen::VectorXd contribution(std::size_t i, const std::string& name) const {
    std::vector<std::string> names = imported.description().force_names;
    names.erase(std::unique(names.begin(), names.end()),
                names.end());  // both sides of a contact have its name
    const auto row = std::find(names.begin(), names.end(), name) - names.begin();
    return found[i].at("force_contributions").at("Q").row(row).transpose();
  }
  Eigen::VectorXd of_tension(const NamedMotion& motion, const char* name,
                             const std::function<double(double, double)>& tension) {
    const pugi::xml_node path = force(name).child("GeometryPath");
    const Eigen::VectorXd arms =
        numeric_gradient(skeleton, motion, [&](const OsimSkeleton& at) { return path_length(at, path); });
    return -tension(path_length(skeleton, path), rate(motion, arms)) * arms;
  }
  double rate_of(std::size_t i, const std::string& state) const {
    const auto& all = imported.description().states;
    const auto at =
        std::find_if(all.begin(), all.end(), [&](const Integrated& s) { return s.name == state; });
    return found[i].at("state_rates").at("sdot")(at - all.begin());
  }
  /// Of what has a gradient.
  static double rate(const NamedMotion& motion, const Eigen::VectorXd& gradient) {
    double sum = 0;
    for (std::size_t k = 0; k < motion.order.size(); ++k)
      sum += gradient(static_cast<Eigen::Index>(k)) * motion.u.at(motion.order[k]);
    return sum;
  }
  /// What a force or torque in world axes that stays as it is now does along a motion.
  Eigen::VectorXd of_force(const NamedMotion& motion, const char* body, const Vec3& place,
                           const Vec3& force) {
    return numeric_gradient(skeleton, motion,
                            [=](const OsimSkeleton& s) { return SimTK::dot(force, s.point(body, place)); });
  }
  Eigen::VectorXd of_torque(const NamedMotion& motion, const char* body, const Vec3& torque) {
    const SimTK::Rotation now = skeleton.pose(body, "").R();
    return numeric_gradient(skeleton, motion, [=](const OsimSkeleton& s) {
      const SimTK::Vec4 turn = (s.pose(body, "").R() * ~now).convertRotationToAngleAxis();
      return turn[0] * SimTK::dot(torque, Vec3(turn[1], turn[2], turn[3]));
    });
  }
  /// What a force along a coordinate does, which may follow others.
  Eigen::VectorXd along(const NamedMotion& motion, const char* coordinate, double value) const {
    Eigen::VectorXd out = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(motion.order.size()));
    const auto by = skeleton.gradient(coordinate);
    for (std::size_t k = 0; k < motion.order.size(); ++k)
      if (by.count(motion.order[k]) > 0) out(static_cast<Eigen::Index>(k)) = value * by.at(motion.order[k]);
    return out;
  }

  std::string file;
  Imported imported;
  OsimSkeleton skeleton;
  std::vector<State> states;
  std::vector<std::map<std::string, Arrays>> found;
};

void expect_near(const char* what, const Eigen::VectorXd& ours, const Eigen::VectorXd& theirs,
                 double tolerance) {
  EXPECT_LE((ours - theirs).cwiseAbs().maxCoeff(), tolerance * std::max(1.0, theirs.cwiseAbs().maxCoeff()))
      << what << ": " << ours.transpose() << "\n for " << theirs.transpose();
}

TEST(OsimForces, FollowTheirLaws) {
  Rig rig("forces.osim");
  int engaged = 0, cords = 0, usual_cords = 0, toes = 0, straight = 0;
  pugi::xml_document usual;
  usual.load_string(
      "<SimmSpline><x>-5 0.998 0.999 1 1.1 1.2 1.3 1.4 1.5 1.6 1.601 1.602 5</x>"
      "<y>0 0 0 0 0.035 0.12 0.26 0.55 1.17 2 2 2 2</y></SimmSpline>");
  const Law usual_curve = read_law(usual.document_element(), 1);
  for (std::size_t i = 0; i < rig.states.size(); ++i) {
    SCOPED_TRACE("state " + std::to_string(i));
    const NamedMotion motion = rig.motion(i);
    const OsimSkeleton& at = rig.skeleton;
    const auto& inputs = rig.states[i].inputs;
    const auto along = [&](const char* coordinate, double value) {
      return rig.along(motion, coordinate, value);
    };
    const auto of_energy = [&](const std::function<double(const OsimSkeleton&)>& energy) {
      return Eigen::VectorXd(-numeric_gradient(rig.skeleton, motion, energy));
    };
    const auto expect = [&](const char* name, const Eigen::VectorXd& expected, double tolerance = 1e-11) {
      expect_near(name, rig.contribution(i, name), expected, tolerance);
    };
    const double q = at.coordinate("elbow"), u = at.speed("elbow");
    expect("motor", along("elbow", 8 * inputs.at("motor")));
    expect("geared_motor", along("drive", 3 * inputs.at("geared_motor")));
    expect("coil", along("shoulder", -7 * (at.coordinate("shoulder") - 0.2) - 0.4 * at.speed("shoulder")));
    expect("geared_coil", along("drive", -5 * (at.coordinate("drive") + 0.1) - 0.6 * at.speed("drive")));
    const double degree = SimTK::Pi / 180;
    const double above = SimTK::stepUp(std::clamp((q - 30 * degree) / (25 * degree), 0.0, 1.0)),
                 below = SimTK::stepUp(std::clamp((-20 * degree - q) / (25 * degree), 0.0, 1.0));
    engaged += above > 0 || below > 0 ? 1 : 0;
    expect("stop", along("elbow", -0.8 / degree * above * (q - 30 * degree) +
                                      0.5 / degree * below * (-20 * degree - q) -
                                      0.02 / degree * (above + below) * u));
    expect("spring", of_energy([](const OsimSkeleton& s) {
             const double stretch = (s.point("/ground", SimTK::Vec3(0.3, 0.1, 0.2)) -
                                     s.point("/bodyset/lower", SimTK::Vec3(0, -0.2, 0.05)))
                                        .norm() -
                                    0.3;
             return 35.0 / 2 * stretch * stretch;
           }),
           kDifferences);
    expect(
        "bush", of_energy([](const OsimSkeleton& s) {
          const SimTK::Transform X = ~s.pose("/bodyset/cart", "") * s.pose("bush_offset", "bush");
          const SimTK::Vec3 a = X.R().convertRotationToBodyFixedXYZ(), p = X.p();
          return (2 * a[0] * a[0] + 3 * a[1] * a[1] + 4 * a[2] * a[2] + 20 * p[0] * p[0] + 30 * p[1] * p[1]) /
                 2;
        }),
        kDifferences);
    const auto of_force = [&](const char* body, const Vec3& place, const Vec3& force) {
      return rig.of_force(motion, body, place, force);
    };
    const auto of_torque = [&](const char* body, const Vec3& torque) {
      return rig.of_torque(motion, body, torque);
    };
    const SimTK::Rotation lower = at.pose("lower", "").R();
    expect("jet", of_force("lower", Vec3(0.1, -0.1, 0.05), lower * (2 * inputs.at("jet") * Vec3(1, 2, -2))),
           kDifferences);
    expect("crane", of_force("upper", Vec3(0, -0.3, 0), Vec3(0, 4 * inputs.at("crane"), 0)), kDifferences);
    const Vec3 torque = lower * (inputs.at("wheel") * Vec3(0, 3, 4));
    expect("wheel", of_torque("lower", torque), kDifferences);
    expect("wheel_reaction", of_torque("upper", -torque), kDifferences);
    expect("wind", of_torque("upper", inputs.at("wind") * std::sqrt(2.0) * Vec3(1, 0, 1)), kDifferences);
    expect("cable", rig.of_tension(motion, "cable", [&](double, double) { return 50 * inputs.at("cable"); }),
           kDifferences);
    expect("band",
           rig.of_tension(motion, "band",
                          [](double length, double rate) {
                            return 300 * std::max(0.0, length - 0.12) * (1 + 0.02 * rate);
                          }),
           kDifferences);
    expect("cord",
           rig.of_tension(motion, "cord",
                          [&](double length, double) {
                            const Law curve =
                                read_law(law_element(rig.force("cord"), "force_length_curve"), 1);
                            cords += length > 0.2 ? 1 : 0;
                            return length > 0.2 ? 40 * curve.value({length / 0.2}) : 0.0;
                          }),
           kDifferences);
    expect("usual_cord",
           rig.of_tension(motion, "usual_cord",
                          [&](double length, double) {
                            usual_cords += length > 0.3 ? 1 : 0;
                            return length > 0.3 ? 25 * usual_curve.value({length / 0.3}) : 0.0;
                          }),
           kDifferences);
    const auto ligament = [&](const char* name, double stiffness, double slack, double transition,
                              double damping) {
      expect(name,
             rig.of_tension(motion, name,
                            [&](double length, double rate) {
                              const double strain = length / slack - 1;
                              if (strain <= 0) return 0.0;
                              (strain < transition ? toes : straight) += 1;
                              const double spring = strain < transition
                                                        ? stiffness * strain * strain / (2 * transition)
                                                        : stiffness * (strain - transition / 2);
                              return spring + (rate > 0 ? damping * rate / slack *
                                                              SimTK::stepUp(std::min(strain / 0.01, 1.0))
                                                        : 0);
                            }),
             kDifferences);
    };
    ligament("fibres", 500, 0.35, 0.08, 2);
    ligament("usual_fibres", 300, 0.25, 0.06, 0.003);
  }
  EXPECT_GE(engaged, kStates / 3);
  for (const int count : {cords, usual_cords, toes, straight}) EXPECT_GT(count, 0);
  EXPECT_EQ(rig.imported.description().force_names.size(), 18U);  // that which is off is not there
}

/// A coordinate that follows another along a curve, and the dampers of a bushing: along an angle or a shift d of one frame
/// in the other, Q = -c d' grad d.
TEST(OsimForces, AreAlongCurvesAndDampedInBushings) {
  Rig rig("forces_along_curves.osim");
  int engaged = 0;
  for (std::size_t i = 0; i < rig.states.size(); ++i) {
    SCOPED_TRACE("state " + std::to_string(i));
    const NamedMotion motion = rig.motion(i);
    const OsimSkeleton& at = rig.skeleton;
    const double q = at.coordinate("drive"), u = at.speed("drive");
    const auto expect = [&](const char* name, double value) {
      expect_near(name, rig.contribution(i, name), rig.along(motion, "drive", value), 1e-11);
    };
    expect("geared_motor", 3 * rig.states[i].inputs.at("geared_motor"));
    expect("geared_coil", -5 * (q + 0.1) - 0.6 * u);
    const double above = SimTK::stepUp(std::clamp((q - 0.1) / 0.3, 0.0, 1.0)),
                 below = SimTK::stepUp(std::clamp((-0.2 - q) / 0.3, 0.0, 1.0));
    engaged += above > 0 || below > 0 ? 1 : 0;
    expect("geared_stop", -80 * above * (q - 0.1) + 50 * below * (-0.2 - q) - 2 * (above + below) * u);
    const char* names[] = {"bush_turn_x", "bush_turn_y", "bush_turn_z", "bush_shift_x", "bush_shift_z"};
    const int axes[] = {0, 1, 2, 3, 5};
    const double damping[] = {0.3, 0.2, 0.4, 0.7, 0.9};
    for (std::size_t d = 0; d < 5; ++d) {
      const Eigen::VectorXd slope =
          numeric_gradient(rig.skeleton, motion, [axis = axes[d]](const OsimSkeleton& s) {
            const SimTK::Transform X = ~s.pose("/bodyset/cart", "") * s.pose("bush_offset", "bush");
            return axis < 3 ? X.R().convertRotationToBodyFixedXYZ()[axis] : X.p()[axis - 3];
          });
      expect_near(names[d], rig.contribution(i, names[d]), -damping[d] * Rig::rate(motion, slope) * slope,
                  kDifferences);
    }
  }
  EXPECT_GE(engaged, kStates / 3);
  EXPECT_EQ(rig.imported.description().force_names.size(), 9U);
}

TEST(OsimForces, ExpressionsAndFunctionsOfTime) {
  Rig rig("expression_forces.osim");
  for (std::size_t i = 0; i < rig.states.size(); ++i) {
    SCOPED_TRACE("state " + std::to_string(i));
    const NamedMotion motion = rig.motion(i);
    const OsimSkeleton& at = rig.skeleton;
    const auto expect = [&](const char* name, const Eigen::VectorXd& expected,
                            double tolerance = kDifferences) {
      expect_near(name, rig.contribution(i, name), expected, tolerance);
    };
    const double activation = rig.states[i].states.at("servo_activation");
    expect("servo", rig.along(motion, "elbow", 30 * activation), 1e-11);
    EXPECT_NEAR(rig.rate_of(i, "servo_activation"), (rig.states[i].inputs.at("servo") - activation) / 0.035,
                1e-9);
    const double q = at.coordinate("shoulder"), u = at.speed("shoulder");
    expect(
        "stiff",
        rig.along(motion, "shoulder",
                  -2.44 * std::exp(1.5 * (q - 0.81)) + 1.51 * std::exp(-1.8 * (q + 0.5)) - 0.3 * u * u * u),
        1e-11);
    expect("geared_stiff",
           rig.along(motion, "drive",
                     -20 * std::max(at.coordinate("drive"), 0.1) - std::min(at.speed("drive"), 2.0)),
           1e-11);
    const auto distance = [](const OsimSkeleton& s) {
      return (s.point("/ground", Vec3(0.3, 0.1, 0.2)) - s.point("/bodyset/lower", Vec3(0, -0.2, 0.05)))
          .norm();
    };
    const Eigen::VectorXd line = numeric_gradient(rig.skeleton, motion, distance);
    expect("cord", -(25 * std::pow(distance(at) - 0.3, 3) + 2 * Rig::rate(motion, line)) * line);
    const auto deflection = [](const OsimSkeleton& s, int axis) {
      const SimTK::Transform X = ~s.pose("/bodyset/upper", "") * s.pose("/bodyset/lower", "");
      return axis < 3 ? X.R().convertRotationToBodyFixedXYZ()[axis] : X.p()[axis - 3];
    };
    const auto d = [&](int axis) { return deflection(at, axis); };
    const struct {
      const char* name;
      int axis;
      double force, damping;
    } cuffs[] = {{"cuff_turn_x", 0, 9.5 * d(0) - 29.5 * d(0) * d(0) + d(4), 0.1},
                 {"cuff_turn_y", 1, 0, 0.2},
                 {"cuff_turn_z", 2, 4 * std::sin(d(2)) * d(0), 0},
                 {"cuff_shift_x", 3, 3 * d(3), 0},
                 {"cuff_shift_z", 5, 0, 0.4}};
    for (const auto& cuff : cuffs) {
      const Eigen::VectorXd slope = numeric_gradient(
          rig.skeleton, motion, [&](const OsimSkeleton& s) { return deflection(s, cuff.axis); });
      expect(cuff.name, -(cuff.force + cuff.damping * Rig::rate(motion, slope)) * slope);
    }
    const double t = motion.time;
    const SimTK::Transform upper = at.pose("upper", ""), lower = at.pose("lower", "");
    expect("gust", rig.of_force(motion, "lower", Vec3(0.1 * t + 0.02, 0.1, 0), Vec3(2 * t + 1, 0, -3)) +
                       rig.of_torque(motion, "lower", Vec3(0, t + 0.5, 0.2)));
    expect("thruster",
           rig.of_force(motion, "upper", ~upper * Vec3(0.1, 0.3 * t + 0.2, 0), upper.R() * Vec3(1, 2, -1)));
    expect("tug", rig.of_force(motion, "upper", ~upper * Vec3(0.2, 0.2, 0.1), Vec3(4, 0, 1)));
    expect("twist", rig.of_torque(motion, "lower", lower.R() * Vec3(0.4, 2 * std::sin(3 * t), 0)));
  }
  EXPECT_EQ(rig.imported.description().force_names.size(), 13U);
}

/// Thelen's curves, in optimal lengths and largest forces.
struct ThelenMuscle {
  double force, fibre, slack, pennation, speed, strain = 0.04, gamma = 0.45, kpe = 5, af = 0.25, flen = 1.4;

  double active(double l) const { return std::exp(-(l - 1) * (l - 1) / gamma); }
  double passive(double l) const {
    return l > 1 ? (std::exp(kpe * (l - 1) / 0.6) - 1) / (std::exp(kpe) - 1) : 0;
  }
  /// Of its force at rest, at a speed v of the fibres.
  double over_speed(double a, double v) const {
    const double k = 0.25 + 0.75 * a;
    if (v <= 0) return std::max(0.0, (k + v) / (k - v / af));
    const double g = (2 + 2 / af) * v / (flen - 1);
    return (k + flen * g) / (k + g);
  }
  double tendon(double x) const {
    const double e3 = std::exp(3.0), toe = 99 * strain * e3 / (166 * e3 - 67), slope = 0.67 / (strain - toe);
    if (x <= 0) return 0;
    return x > toe ? slope * (x - toe) + 0.33 : 0.33 * (std::exp(3 * x / toe) - 1) / (e3 - 1);
  }
};

/// The point of quintic Bezier curves between corners (x, y, slope) at x, whose bends are given for each piece.
double bezier(const std::vector<std::array<double, 3>>& corners, const std::vector<double>& bends, double x) {
  if (x <= corners.front()[0]) return corners.front()[1] + corners.front()[2] * (x - corners.front()[0]);
  if (x >= corners.back()[0]) return corners.back()[1] + corners.back()[2] * (x - corners.back()[0]);
  std::size_t i = 0;
  while (x > corners[i + 1][0]) ++i;
  const auto [x0, y0, s0] = corners[i];
  const auto [x1, y1, s1] = corners[i + 1];
  const double corner = (y1 - y0 - x1 * s1 + x0 * s0) / (s0 - s1), c = 0.1 + 0.8 * bends[i];
  const double px[] = {x0, x0 + c * (corner - x0), x1 + c * (corner - x1), x1};
  const double py[] = {y0, y0 + s0 * (px[1] - x0), y1 + s1 * (px[2] - x1), y1};
  const auto at = [](const double* p, double t) {
    double b[] = {p[0], p[1], p[1], p[2], p[2], p[3]};
    for (int level = 5; level > 0; --level)
      for (int k = 0; k < level; ++k) b[k] += t * (b[k + 1] - b[k]);
    return b[0];
  };
  double low = 0, high = 1;
  for (int k = 0; k < 60; ++k) (at(px, (low + high) / 2) < x ? low : high) = (low + high) / 2;
  return at(py, low);
}

TEST(OsimForces, MusclesFollowTheirLaws) {
  constexpr int kMany = 150;  // of which fibres and tendons are in balance in some
  Rig rig("muscles.osim", kMany);
  const ThelenMuscle rigid{600, 0.13, 0.19, 0.2, 8};
  const ThelenMuscle elastic{600, 0.13, 0.19, 0.1, 8, 0.033, 0.5, 4, 0.3, 1.8};
  int pulling = 0, balanced = 0, extending = 0, shortening[] = {0, 0};
  for (std::size_t i = 0; i < rig.states.size(); ++i) {
    SCOPED_TRACE("state " + std::to_string(i));
    const NamedMotion motion = rig.motion(i);
    const auto& states = rig.states[i].states;
    const auto rate_of = [&](const std::string& state) { return rig.rate_of(i, state); };
    const auto rigid_muscle = [&](double fibre, double slack, double pennation, double speed,
                                  const auto& law) {
      return [=](double length, double rate) {
        const double thick = fibre * std::sin(pennation), along = std::max(0.0, length - slack);
        const double l = std::hypot(thick, along), cosine = along / l;
        return std::max(0.0, law(l / fibre, rate * cosine / fibre / speed)) * cosine;
      };
    };
    expect_near("rigid Thelen", rig.contribution(i, "rigid_flexor"),
                rig.of_tension(motion, "rigid_flexor",
                               rigid_muscle(rigid.fibre, rigid.slack, rigid.pennation, rigid.speed,
                                            [&](double l, double v) {
                                              const double a = rig.states[i].inputs.at("rigid_flexor");
                                              const double force =
                                                  a * rigid.active(l) * rigid.over_speed(a, v) +
                                                  rigid.passive(l);
                                              pulling += force > 0.02 ? 1 : 0;
                                              return rigid.force * force;
                                            })),
                kDifferences);
    // Its tendon, and the balance of what its fibres carry.
    const double a = states.at("elastic_flexor_activation"), l = states.at("elastic_flexor_fibre");
    const double sine = std::sin(elastic.pennation) / l, cosine = std::sqrt(std::max(0.01, 1 - sine * sine));
    double tension = 0;
    expect_near(
        "elastic Thelen", rig.contribution(i, "elastic_flexor"),
        rig.of_tension(motion, "elastic_flexor",
                       [&](double length, double) {
                         tension = elastic.tendon((length - elastic.fibre * l * cosine) / elastic.slack - 1);
                         return elastic.force * tension;
                       }),
        kDifferences);
    const double load = tension / cosine - elastic.passive(l), active = a * elastic.active(l);
    const double v = rate_of("elastic_flexor_fibre") / elastic.speed;
    if (load > 0 && load < 0.95 * elastic.flen * active) {
      ++balanced;
      EXPECT_NEAR(active * elastic.over_speed(a, v), load, 1e-9);
    } else {
      EXPECT_EQ(v > 0, load > active);
    }
    const double change = rig.states[i].inputs.at("elastic_flexor") - a;
    EXPECT_NEAR(rate_of("elastic_flexor_activation"),
                change / (change > 0 ? 0.01 * (0.5 + 1.5 * a) : 0.04 / (0.5 + 1.5 * a)), 1e-9);
    const double b = states.at("rigid_extensor_activation");
    const std::vector<std::array<double, 3>> over_length = {{0.4441, 0, 0},
                                                            {0.58705, 0.405224, 1.25 * 0.810448 / 0.2859},
                                                            {0.84, 0.905224, 0.8616},
                                                            {1, 1, 0},
                                                            {1.43115, 0.5, -1 / 0.7123},
                                                            {1.8123, 0, 0}};
    const double foot = 0.1 * 0.35;
    const std::vector<std::array<double, 3>> stretched = {
        {1, 0, 0}, {1 + foot, 0.1 * foot, 0.2}, {1.7, 1, 2 / 0.7}};
    const std::vector<std::array<double, 3>> speeds = {
        {-1, 0, 0}, {-0.9, 0.0125, 0.25}, {0, 1, 5}, {0.9, 1.3925, 0.15}, {1, 1.4, 0}};
    // The curves are splines here, within 0.004 of the Bezier curves; arms are shorter than 4 cm.
    const Eigen::VectorXd extended = rig.of_tension(
        motion, "rigid_extensor", rigid_muscle(0.1, 0.2, 0.15, 10, [&](double x, double w) {
          return 800 *
                 (b * bezier(over_length, {1, 1, 1, 1, 1}, x) * bezier(speeds, {0.6, 0.6, 0.9, 0.9}, w) +
                  bezier(stretched, {0.75, 0.75}, x) + 0.05 * w);
        }));
    const Eigen::VectorXd millard = rig.contribution(i, "rigid_extensor");
    EXPECT_LE((millard - extended).cwiseAbs().maxCoeff(), 0.004 * (1.4 + 1 + 1) * 800 * 0.04)
        << millard.transpose() << "\n for " << extended.transpose();
    extending += extended.cwiseAbs().maxCoeff() > 2 ? 1 : 0;
    // On elastic tendons. Without damping, active forces do not fall below a tenth, and speeds are found at any load.
    const double stiff = 1.375 / 0.049, toe = 0.049 - 1 / stiff / 3, half = 0.049 - 2 / stiff / 3;
    const double rise = 1.0 / 3 / (half - toe / 10), meet = (toe / 10 + half) / 2;
    const std::vector<std::array<double, 3>> tendon = {
        {0, 0, 0}, {meet, rise * (meet - toe / 10), rise}, {toe, 2.0 / 3, stiff}};
    for (const double damping : {0.0, 0.1}) {
      const std::string name = damping > 0 ? "damped_extensor" : "elastic_extensor";
      SCOPED_TRACE(name);
      std::vector<std::array<double, 3>> over_fibre = over_length, over_speed = speeds;
      if (!(damping > 0)) {
        over_fibre.front()[1] = over_fibre.back()[1] = 0.1;
        over_speed = {
            {-1, 0, 0.125}, {-0.9, 0.01875, 0.25}, {0, 1, 5}, {0.9, 1.38875, 0.15}, {1, 1.4, 0.075}};
      }
      const double x = states.at(name + "_fibre");
      const double thin = std::sin(0.15) / x, slant = std::sqrt(1 - thin * thin);
      double bears = 0;
      const Eigen::VectorXd pulled = rig.of_tension(motion, name.c_str(), [&](double length, double) {
        bears = bezier(tendon, {0.5, 0.5}, (length - 0.1 * x * slant) / 0.2 - 1);
        return 800 * bears;
      });
      EXPECT_LE((rig.contribution(i, name) - pulled).cwiseAbs().maxCoeff(), 0.004 * 800 * 0.04);
      const double carries = bears / slant - bezier(stretched, {0.75, 0.75}, x);
      const double pulls = states.at(name + "_activation") * bezier(over_fibre, {1, 1, 1, 1, 1}, x),
                   w = rate_of(name + "_fibre") / 10;
      // Curves are 0.004 off: tendon, fibres, active force, force over speed or, undamped, speed over force, of which the force is
      // five times as much where it is steepest.
      EXPECT_NEAR(
          pulls * bezier(over_speed, {0.6, 0.6, 0.9, 0.9}, w) + damping * w, carries,
          0.004 * (2 + 1.4 + (damping > 0 ? 1 : 5) * pulls) + (damping > 0 ? 0 : 0.02 * std::abs(carries)));
      shortening[damping > 0] += w > -1 && w < 1 ? 1 : 0;
    }
  }
  EXPECT_GE(shortening[0], 3);
  EXPECT_GE(shortening[1], 3);
  EXPECT_GE(extending, kMany / 3);
  EXPECT_GE(pulling, kMany / 2);
  EXPECT_GE(balanced, 3);
  // Fibres that are as short as they get do not become shorter, however little they bear.
  State shortest = rig.states.front();
  for (const char* name : {"elastic_extensor_fibre", "damped_extensor_fibre"})
    shortest.states.at(name) = 0.44;
  const auto found = ask_functions(ALEMBERT_EXECUTABLE, rig.imported.path(), {shortest},
                                   {Eigen::VectorXd::Zero(2)}, {"state_rates"});
  const auto& all = rig.imported.description().states;
  for (std::size_t k = 0; k < all.size(); ++k) {
    const double rate = found[0].at("state_rates").at("sdot")(static_cast<Eigen::Index>(k));
    if (shortest.states.at(all[k].name) == 0.44) {
      EXPECT_GE(rate, -1e-12) << all[k].name;
    }
  }
}

/// Curves of De Groote and others as they are published, but for tendons, which bear nothing at their slack length.
struct DeGrooteMuscle {
  double force, fibre, slack, pennation, speed, width = 1, passive_strain = 0.6, tendon_strain = 0.049;

  double active(double l) const {
    const double b[3][4] = {{0.8150671134243542, 1.055033428970575, 0.162384573599574, 0.063303448465465},
                            {0.433004984392647, 0.716775413397760, -0.029947116970696, 0.200356847296188},
                            {0.1, 1, 0.353553390593274, 0}};
    const double x = (l - 1) / width + 1;
    double sum = 0;
    for (const auto& [scale, at, wide, wider] : b) {
      const double from = (x - at) / (wide + wider * x);
      sum += scale * std::exp(-from * from / 2);
    }
    return sum;
  }
  double passive(double l) const {
    const double least = std::exp(4 * (0.2 - 1) / passive_strain);
    return (std::exp(4 * (l - 1) / passive_strain) - least) / (std::exp(4.0) - least);
  }
  static double over_speed(double v) {
    return -0.3211346127989808 * std::asinh(-8.149 * v - 0.374) + 0.8825327733249912;
  }
  double tendon(double stretched) const {
    return 0.2 * std::exp(std::log(6.0) / tendon_strain * (stretched - 1)) - 0.2;
  }
};

TEST(OsimForces, MusclesOfDeGrooteFollowTheirLaws) {
  constexpr int kMany = 60;
  Rig rig("degroote_muscles.osim", kMany);
  const DeGrooteMuscle rigid{600, 0.13, 0.19, 0.2, 8}, flexor{700, 0.12, 0.2, 0.1, 9, 1.5, 0.5, 0.04},
      extensor{800, 0.1, 0.2, 0, 10};
  int balanced = 0;
  for (std::size_t i = 0; i < rig.states.size(); ++i) {
    SCOPED_TRACE("state " + std::to_string(i));
    const NamedMotion motion = rig.motion(i);
    expect_near("rigid", rig.contribution(i, "rigid_flexor"),
                rig.of_tension(motion, "rigid_flexor",
                               [&](double length, double rate) {
                                 const double along = length - rigid.slack,
                                              l = std::hypot(along, rigid.fibre * std::sin(rigid.pennation)),
                                              cosine = along / l, x = l / rigid.fibre,
                                              v = rate * cosine / rigid.fibre / rigid.speed;
                                 return rigid.force * cosine *
                                        (rig.states[i].inputs.at("rigid_flexor") * rigid.active(x) *
                                             DeGrooteMuscle::over_speed(v) +
                                         rigid.passive(x) + 0.03 * v);
                               }),
                kDifferences);
    // The state is what the tendon bears: its length leaves that of the fibres, and its rate their speed, at which they
    // bear as much.
    const auto elastic = [&](const char* name, const DeGrooteMuscle& muscle, bool passive, double rise,
                             double fall, double steep) {
      SCOPED_TRACE(name);
      const std::string called = name;
      const double bears = rig.states[i].states.at(called + "_tendon_force"),
                   a = rig.states[i].states.at(called + "_activation");
      double length = 0, rate = 0;
      expect_near("tension", rig.contribution(i, name),
                  rig.of_tension(motion, name,
                                 [&](double path, double changing) {
                                   length = path;
                                   rate = changing;
                                   return muscle.force * bears;
                                 }),
                  kDifferences);
      double low = 0.9, high = 1.3;
      for (int k = 0; k < 60; ++k) (muscle.tendon((low + high) / 2) < bears ? low : high) = (low + high) / 2;
      const double step = 1e-5, slope = (muscle.tendon(low + step) - muscle.tendon(low - step)) / (2 * step);
      const double along = length - muscle.slack * low,
                   l = std::hypot(along, muscle.fibre * std::sin(muscle.pennation)), cosine = along / l,
                   x = l / muscle.fibre;
      const double along_rate = rate - rig.rate_of(i, called + "_tendon_force") / slope * muscle.slack,
                   v = along_rate * cosine / muscle.fibre / muscle.speed;
      const double pulls =
          a * muscle.active(x) * DeGrooteMuscle::over_speed(v) + (passive ? muscle.passive(x) : 0);
      // Where fibres are far from what they can bear, speeds are beyond all measure.
      if (std::abs(v) < 100) {
        ++balanced;
        EXPECT_NEAR(pulls * cosine, bears, 1e-7);
      }
      const double change = rig.states[i].inputs.at(name) - a, ease = 0.5 + 1.5 * a,
                   half = std::tanh(steep * change) / 2;
      EXPECT_NEAR(rig.rate_of(i, called + "_activation"),
                  ((half + 0.5) / (rise * ease) + (0.5 - half) * ease / fall) * change, 1e-9);
    };
    elastic("elastic_flexor", flexor, true, 0.01, 0.04, 10);
    elastic("elastic_extensor", extensor, false, 0.015, 0.06, 0.1);
  }
  EXPECT_GE(balanced, kMany / 4);
}

/// Curves of Schutte and others; those that a file does not give as OpenSim has them.
struct SchutteMuscle {
  double force, fibre, slack, pennation, scale, rise, fall, damping;
  std::function<double(double)> active, passive, tendon;

  SchutteMuscle(pugi::xml_node element, double time_scale, double activation1, double activation2,
                double damped)
      : scale(time_scale), rise(activation1 / time_scale), fall(activation2 / time_scale), damping(damped) {
    const auto number = [&](const char* name) { return element.child(name).text().as_double(); };
    force = number("max_isometric_force");
    fibre = number("optimal_fiber_length");
    slack = number("tendon_slack_length");
    pennation = number("pennation_angle_at_optimal");
    usual_.load_string(
        "<Usual><SimmSpline name='active_force_length_curve'>"
        "<x>-5.307692 -4.307692 -1.923077 -0.884615 -0.269231 0.230769 0.461538 0.52725 0.62875 0.71875 "
        "0.86125 "
        "1.045 1.2175 1.43875 1.5 1.615385 2 2.961538 3.692308 5.461538 9.901902</x>"
        "<y>0.012188 0.021899 0.036466 0.052493 0.075312 0.114158 0.157859 0.226667 0.636667 0.856667 0.95 "
        "0.993333 0.77 0.246667 0.193821 0.133252 0.072683 0.044417 0.036341 0.021899 "
        "0.007332</y></SimmSpline>"
        "<SimmSpline name='tendon_force_length_curve'>"
        "<x>-10 -0.002 -0.001 0 0.00131 0.00281 0.00431 0.00581 0.00731 0.00881 0.0103 0.0118 0.0123 9.2 "
        "9.201 "
        "9.202 20</x>"
        "<y>0 0 0 0 0.0108 0.0257 0.0435 0.0652 0.0915 0.123 0.161 0.208 0.227 345 345 345 "
        "345</y></SimmSpline>"
        "</Usual>");
    const auto curve = [&](const char* name) -> std::function<double(double)> {
      pugi::xml_node given = law_element(element, name);
      if (!given) given = law_element(usual_.document_element(), name);
      if (!given) return [](double x) { return std::exp(8 * (x - 1)) / std::exp(4.0); };
      return [law = read_law(given, 1)](double x) { return law.value({x}); };
    };
    active = [read = curve("active_force_length_curve")](double x) { return std::max(0.0, read(x)); };
    passive = curve("passive_force_length_curve");
    tendon = [read = curve("tendon_force_length_curve")](double x) { return x < 0 ? 0 : read(x); };
  }
  /// Of the fibres, at a speed in optimal lengths in the scale of time.
  double pull(double a, double x, double v) const {
    const double s = 0.13 * 0.15 / 1.15;
    return a * active(x) * (v > 0 ? (1.4 * v + s) / (v + s) : std::max(0.0, 1 + v) / (1 - v / 0.15)) +
           damping * v;
  }

 private:
  pugi::xml_document usual_;
};

TEST(OsimForces, MusclesOfSchutteFollowTheirLaws) {
  constexpr int kMany = 150;
  Rig rig("schutte_muscles.osim", kMany);
  const SchutteMuscle flexor(rig.force("flexor"), 0.12, 6, 1.5, 0.05),
      extensor(rig.force("extensor"), 0.1, 7.667, 1.459854, 0.1),
      tendonless(rig.force("tendonless"), 0.1, 7.667, 1.459854, 0.1);
  int shortening = 0, lengthening = 0, pulling = 0;
  for (std::size_t i = 0; i < rig.states.size(); ++i) {
    SCOPED_TRACE("state " + std::to_string(i));
    const NamedMotion motion = rig.motion(i);
    const auto& states = rig.states[i].states;
    const auto activation = [&](const char* name, const SchutteMuscle& muscle) {
      const double a = states.at(std::string(name) + "_activation"), e = rig.states[i].inputs.at(name);
      EXPECT_NEAR(rig.rate_of(i, std::string(name) + "_activation"),
                  (e - a) * (e > a ? muscle.rise * e + muscle.fall : muscle.fall), 1e-9);
      return a;
    };
    for (const auto& [name, muscle] :
         {std::pair<const char*, const SchutteMuscle&>("flexor", flexor), {"extensor", extensor}}) {
      SCOPED_TRACE(name);
      const double a = activation(name, muscle), x = states.at(std::string(name) + "_fibre"),
                   sine = std::sin(muscle.pennation) / x, cosine = std::sqrt(1 - sine * sine);
      double bears = 0;
      expect_near("tension", rig.contribution(i, name),
                  rig.of_tension(motion, name,
                                 [&, &of = muscle](double length, double) {
                                   bears = of.tendon((length - of.fibre * x * cosine) / of.slack - 1);
                                   return of.force * bears;
                                 }),
                  kDifferences);
      // At the speed of the fibres they pull as much as the tendon does; or nothing, as fast as they can.
      const double load = std::max(0.0, bears / cosine - muscle.passive(x)),
                   v = rig.rate_of(i, std::string(name) + "_fibre") * muscle.scale;
      EXPECT_NEAR(muscle.pull(a, x, v), load, 1e-9 * std::max(1.0, load));
      (v > 0 ? lengthening : shortening) += load > 0.01 ? 1 : 0;
    }
    const double a = activation("tendonless", tendonless);
    expect_near("tendonless", rig.contribution(i, "tendonless"),
                rig.of_tension(
                    motion, "tendonless",
                    [&](double length, double rate) {
                      const double l = std::hypot(length, tendonless.fibre * std::sin(tendonless.pennation)),
                                   x = l / tendonless.fibre, cosine = length / l,
                                   v = rate * cosine / tendonless.fibre * tendonless.scale;
                      const double pull = std::max(0.0, tendonless.pull(a, x, v) + tendonless.passive(x));
                      pulling += pull > 0.05 ? 1 : 0;
                      return tendonless.force * cosine * pull;
                    }),
                kDifferences);
  }
  EXPECT_GE(shortening, 3);
  EXPECT_GE(lengthening, 10);
  EXPECT_GE(pulling, kMany / 4);
}

// With a slack tendon, and with fibres shorter than their curves allow, OpenSim's muscles do not pull, however they move. Beyond
// the longest active fibres only what is passive does.
TEST(OsimForces, SlackMusclesDoNotPull) {
  const Imported imported(ALEMBERT_SOURCE_DIR "/tests/osim/models/slack_muscles.osim");
  std::mt19937_64 random(5);
  std::vector<State> states;
  struct At {
    double way, speed;
  };
  // Fibres end at 0.2 + 0.04441 - 0.1; those of Thelen have no shortest ones.
  const std::vector<At> slack = {{0.05, 0}, {0.05, 1}, {0.09, -1}, {0.0999, 2}},
                        short_ones = {{0.13, 0}, {0.139, 1}}, taut = {{0.2, 0}, {0.2, 0.1}};
  std::vector<At> all = slack;
  for (const std::vector<At>& more : {short_ones, taut}) all.insert(all.end(), more.begin(), more.end());
  for (const At& at : all) {
    State state = random_state(imported.description(), random);
    state.q = {at.way};
    state.speeds = {at.speed};
    for (auto& [name, value] : state.inputs) value = 1;
    states.push_back(state);
  }
  const std::vector<Eigen::VectorXd> tau(states.size(), Eigen::VectorXd::Zero(1));
  const auto found =
      ask_functions(ALEMBERT_EXECUTABLE, imported.path(), states, tau, {"force_contributions"});
  for (std::size_t i = 0; i < states.size(); ++i) {
    const Eigen::MatrixXd each = found[i].at("force_contributions").at("Q");
    ASSERT_EQ(each.size(), 3);
    const bool is_slack = i < slack.size(), is_short = !is_slack && i < slack.size() + short_ones.size();
    for (Eigen::Index k = 0; k < 3; ++k) {
      SCOPED_TRACE(std::to_string(i) + ", muscle " + std::to_string(k));
      const double pull = each.reshaped()(k);
      if (is_slack || (is_short && k < 2)) {
        EXPECT_EQ(pull, 0);
      } else {
        EXPECT_LT(pull, -100);
      }
    }
  }
}

/// Of one element several contacts may come.
TEST(OsimForces, ContactsAreThoseOfSimbody) {
  constexpr int kMany = 40;
  Rig rig("contacts.osim", kMany);
  const std::map<std::string, std::vector<std::string>> contacts = {
      {"smooth", {"smooth"}},
      {"smooth_default", {"smooth_default"}},
      {"hunt", {"hunt"}},
      {"bump", {"bump_stone_heel", "bump_stone_knob", "bump_heel_knob"}}};
  std::map<std::string, int> touching;
  for (std::size_t i = 0; i < rig.states.size(); ++i) {
    SCOPED_TRACE("state " + std::to_string(i));
    const NamedMotion motion = rig.motion(i);
    for (const auto& [name, parts] : contacts) {
      const Eigen::VectorXd expected = rig.skeleton.contact(name, motion.order);
      Eigen::VectorXd sum = Eigen::VectorXd::Zero(expected.size());
      for (const std::string& part : parts) {
        sum += rig.contribution(i, part);
        touching[part] += rig.contribution(i, part).norm() > 1 ? 1 : 0;
      }
      expect_near(name.c_str(), sum, expected, 1e-9);
    }
  }
  for (const auto& [name, parts] : contacts)
    for (const std::string& part : parts) EXPECT_GE(touching[part], 3) << part;
}

TEST(OsimConstraints, HoldPointsAndFrames) {
  const std::string file = ALEMBERT_SOURCE_DIR "/tests/osim/models/constraints.osim";
  const Imported imported(file);
  OsimSkeleton skeleton(file);
  std::mt19937_64 random(4);
  std::vector<State> states;
  for (int i = 0; i < 4; ++i) states.push_back(random_state(imported.description(), random));
  const std::vector<Eigen::VectorXd> tau(states.size(), Eigen::VectorXd::Zero(imported.description().nv));
  const auto found = ask_functions(ALEMBERT_EXECUTABLE, imported.path(), states, tau, {"constraints"});
  const auto weld = [](const OsimSkeleton& s, int row) {
    const SimTK::Transform a = s.pose("weld_1", "weld"), b = s.pose("/bodyset/buoy", "");
    if (row < 3) return a.p()[row] - b.p()[row];
    const SimTK::Rotation R = ~a.R() * b.R();
    return row == 3 ? R[1][0] : row == 4 ? R[2][0] : R[2][1];
  };
  const auto nail = [](const OsimSkeleton& s, int row) {
    return (s.point("/bodyset/cart", Vec3(0.1, 0.2, 0)) - s.point("/bodyset/float", Vec3(0, 0, 0.1)))[row];
  };
  const auto rod = [](const OsimSkeleton& s) {
    return (s.point("/ground", Vec3(0.4, 0.1, 0.2)) - s.point("/bodyset/float", Vec3(0.1, 0, 0))).normSqr() -
           0.4 * 0.4;
  };
  // Half of the square of the distance to the line.
  const auto rail = [](const OsimSkeleton& s) {
    const Vec3 line = s.point("/bodyset/cart", Vec3(0, 0.1, 0)),
               on = s.point("/bodyset/cart", Vec3(1, 2.1, 0.5));
    const Vec3 off = s.point("/bodyset/lower", Vec3(0.1, 0, 0)) - line, along = (on - line).normalize();
    return (off - SimTK::dot(off, along) * along).normSqr() / 2;
  };
  for (std::size_t i = 0; i < states.size(); ++i) {
    SCOPED_TRACE("state " + std::to_string(i));
    const NamedMotion motion(imported.description(), states[i]);
    motion.apply(skeleton);
    const Eigen::MatrixXd P = found[i].at("constraints").at("P"),
                          phi = found[i].at("constraints").at("position");
    ASSERT_EQ(P.rows(), 12);
    const auto expect = [&](int row, const std::function<double(const OsimSkeleton&)>& of) {
      EXPECT_NEAR(phi(row), of(skeleton), 1e-9) << row;
      expect_near("P", P.row(row).transpose(), numeric_gradient(skeleton, motion, of), kDifferences);
    };
    for (int row = 0; row < 6; ++row) expect(row, [&](const OsimSkeleton& s) { return weld(s, row); });
    for (int row = 0; row < 3; ++row) expect(6 + row, [&](const OsimSkeleton& s) { return nail(s, row); });
    expect(9, rod);
    EXPECT_NEAR((phi(10) * phi(10) + phi(11) * phi(11)) / 2, rail(skeleton), 1e-9);
    expect_near("P of the rail", (phi(10) * P.row(10) + phi(11) * P.row(11)).transpose(),
                numeric_gradient(skeleton, motion, rail), kDifferences);
  }
}

}  // namespace
}  // namespace alembert::oracles
