// Oracles are held against formulas that need no oracle: textbook equations of motion, laws of mechanics, and
// derivatives that are known.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <fstream>
#include <string>

#include "oracles/comparison.hpp"
#include "oracles/random_mechanism.hpp"
#include "oracles/taylor/numeric_lagrangian.hpp"
#include "oracles/taylor/poses.hpp"
#include "oracles/urdf/newton_euler.hpp"

namespace alembert::oracles {
namespace {

constexpr double kTolerance = 1e-12;
constexpr double kG = 9.81;

Description mechanism(const std::string& name) {
  return read_description(std::string(ALEMBERT_SOURCE_DIR) + "/mechanisms/" + name + ".yaml");
}

/// M and c of a mechanism by a formula.
struct Textbook {
  Eigen::MatrixXd M;
  Eigen::VectorXd c;
};

template <class Formula>
void expect_formula(const std::string& name, Formula formula) {
  const Description description = mechanism(name);
  std::mt19937_64 random(7);
  for (int i = 0; i < 20; ++i) {
    const State state = random_state(description, random);
    const Textbook expected = formula(description, state);
    const Dynamics found = numeric_lagrangian(description, state);
    const Eigen::Map<const Eigen::VectorXd> rates(state.rates.data(), description.nv);
    EXPECT_LE(relative_error(found.mass_matrix, expected.M), kTolerance);
    EXPECT_LE(relative_error(found.bias, expected.c), kTolerance);
    EXPECT_LE(relative_error(found.tau, expected.M * rates + expected.c), kTolerance);
  }
}

TEST(ClosedForm, Pendulum) {
  expect_formula("pendulum", [](const Description& d, const State& s) {
    const double m = d.parameter("m"), l = d.parameter("l"), I = d.parameter("I");
    Textbook t{Eigen::MatrixXd(1, 1), Eigen::VectorXd(1)};
    t.M << I + m * l * l;
    t.c << m * kG * l * std::sin(s.q[0]);
    return t;
  });
}

TEST(ClosedForm, DoublePendulum) {
  expect_formula("double_pendulum", [](const Description& d, const State& s) {
    const double m1 = d.parameter("m1"), m2 = d.parameter("m2"), l1 = d.parameter("l1"),
                 c1 = d.parameter("c1"), c2 = d.parameter("c2"), I1 = d.parameter("I1"),
                 I2 = d.parameter("I2");
    const double q1 = s.q[0], q2 = s.q[1], u1 = s.speeds[0], u2 = s.speeds[1];
    const double h = m2 * l1 * c2;
    Textbook t{Eigen::MatrixXd(2, 2), Eigen::VectorXd(2)};
    const double m22 = I2 + m2 * c2 * c2;
    const double m12 = m22 + h * std::cos(q2);
    t.M << I1 + m1 * c1 * c1 + m2 * l1 * l1 + m22 + 2 * h * std::cos(q2), m12, m12, m22;
    const double swing = m2 * kG * c2 * std::sin(q1 + q2);
    t.c << -h * std::sin(q2) * (2 * u1 * u2 + u2 * u2) + (m1 * c1 + m2 * l1) * kG * std::sin(q1) + swing,
        h * std::sin(q2) * u1 * u1 + swing;
    return t;
  });
}

TEST(ClosedForm, CartPole) {
  expect_formula("cart_pole", [](const Description& d, const State& s) {
    const double mc = d.parameter("mc"), mp = d.parameter("mp"), l = d.parameter("l"), I = d.parameter("I");
    const double q = s.q[1], u = s.speeds[1];
    Textbook t{Eigen::MatrixXd(2, 2), Eigen::VectorXd(2)};
    t.M << mc + mp, mp * l * std::cos(q), mp * l * std::cos(q), I + mp * l * l;
    t.c << -mp * l * std::sin(q) * u * u - s.wrenches.at("cart")[0], -mp * kG * l * std::sin(q);
    return t;
  });
}

// Newton and Euler about the centre of mass c of a free body, with r = R c the arm from its origin:
// m (pdd + al x r + om x (om x r)) = f and I al + om x I om = torque, in the speeds (pd, om in body axes).
TEST(ClosedForm, FreeBody) {
  expect_formula("free_body", [](const Description& d, const State& s) {
    const Body& body = d.bodies[0];
    const double m = body.mass;
    const Eigen::Vector3d c(body.com[0], body.com[1], body.com[2]), om(s.speeds[3], s.speeds[4], s.speeds[5]);
    const Eigen::Matrix3d R = Eigen::Quaterniond(s.q[6], s.q[3], s.q[4], s.q[5]).toRotationMatrix();
    Eigen::Matrix3d I, skew;
    I << body.inertia[0], body.inertia[3], body.inertia[4], body.inertia[3], body.inertia[1], body.inertia[5],
        body.inertia[4], body.inertia[5], body.inertia[2];
    skew << 0, -c[2], c[1], c[2], 0, -c[0], -c[1], c[0], 0;
    const Wrench& w = s.wrenches.at("body");
    const Eigen::Vector3d force(w[0], w[1], w[2]), torque(w[3], w[4], w[5]);
    const Eigen::Vector3d linear = m * (R * om.cross(om.cross(c))) - m * Eigen::Vector3d(0, 0, -kG) - force;
    Textbook t{Eigen::MatrixXd(6, 6), Eigen::VectorXd(6)};
    t.M.topLeftCorner<3, 3>() = m * Eigen::Matrix3d::Identity();
    t.M.topRightCorner<3, 3>() = -m * R * skew;
    t.M.bottomLeftCorner<3, 3>() = t.M.topRightCorner<3, 3>().transpose();
    t.M.bottomRightCorner<3, 3>() = I - m * skew * skew;
    t.c.head<3>() = linear;
    t.c.tail<3>() = om.cross(I * om) - R.transpose() * torque + c.cross(R.transpose() * linear);
    return t;
  });
}

// With the centre of mass on a circle and a rotation of constant rate: T = 1/2 (m v^2 + I w^2).
TEST(ClosedForm, WheelWhoseCentreOfMassIsItsCentre) {
  const Description description = parse_description(R"(
name: wheel
gravity: [0, -9.81, 0]
parameters: {R: 1.3, r: 0.25, m: 2.1, I: 0.07}
coordinates: [q]
bodies:
  - name: wheel
    transform:
      - translate: [R*cos(q), R*sin(q), 0]
      - rotate: {axis: z, angle: R/r*q}
    mass: m
    inertia: {xx: 1, yy: 1, zz: I}
)");
  const State state{{0.7}, {1.1}, {-0.6}, 0, {}};
  const Dynamics found = numeric_lagrangian(description, state);
  const double m = 2.1 * 1.3 * 1.3 + 0.07 * (1.3 / 0.25) * (1.3 / 0.25);
  EXPECT_NEAR(found.mass_matrix(0, 0), m, 1e-13);
  EXPECT_NEAR(found.bias[0], 2.1 * kG * 1.3 * std::cos(0.7), 1e-13);
  EXPECT_NEAR(found.tau[0], m * -0.6 + 2.1 * kG * 1.3 * std::cos(0.7), 1e-12);
}

// d/dt of the energy is the power of tau, of wrenches and of nothing else where no motion is prescribed. The
// derivative is taken along the motion by central differences of fourth order.
TEST(Laws, PowerIsTheRateOfEnergy) {
  for (const char* name :
       {"bead_on_helix", "body_on_torus", "tori_mated", "tree_every_joint", "four_bar_knee", "chain6r"}) {
    const Description description = mechanism(name);
    std::mt19937_64 random(11);
    for (int i = 0; i < 5; ++i) {
      State state = random_state(description, random);
      state.wrenches.clear();
      const auto total = [&](double dt) {
        State moved = state;
        const std::vector<double> qd = coordinate_rates(description, state.q, state.speeds);
        const std::vector<double> from_rates = coordinate_rates(description, state.q, state.rates);
        const std::vector<double> from_turn = coordinate_rates(description, qd, state.speeds);
        for (const Coordinate& c : description.coordinates) {
          double square = 0;
          for (int k = 0; k < (c.quaternion ? 4 : 1); ++k) {
            const auto at = static_cast<std::size_t>(c.first_q + k);
            moved.q[at] += dt * qd[at] + dt * dt / 2 * (from_rates[at] + (c.quaternion ? from_turn[at] : 0));
            square += moved.q[at] * moved.q[at];
          }
          for (int k = 0; c.quaternion && k < 4; ++k)
            moved.q[static_cast<std::size_t>(c.first_q + k)] /= std::sqrt(square);
        }
        for (std::size_t k = 0; k < moved.speeds.size(); ++k) moved.speeds[k] += dt * state.rates[k];
        const auto [kinetic, potential] = energy(description, moved);
        return kinetic + potential;
      };
      const double h = 1e-3;
      const double rate = (8 * (total(h) - total(-h)) - (total(2 * h) - total(-2 * h))) / (12 * h);
      const Dynamics dynamics = numeric_lagrangian(description, state);
      const double power =
          dynamics.tau.dot(Eigen::Map<const Eigen::VectorXd>(state.speeds.data(), description.nv));
      EXPECT_NEAR(rate, power, 1e-6 * std::max(1.0, dynamics.tau.norm())) << name;
    }
  }
}

TEST(Laws, TauIsMTimesRatesPlusC) {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    const Description description = parse_description(random_mechanism(seed));
    for (const State& state : comparable_states(description, 3, seed)) {
      const Dynamics d = numeric_lagrangian(description, state);
      const Eigen::Map<const Eigen::VectorXd> rates(state.rates.data(), description.nv);
      EXPECT_LE(relative_error(d.mass_matrix * rates + d.bias, d.tau), kTolerance) << seed;
    }
  }
}

// Frames on curves and surfaces are rigid motions, also along a motion: R^T R = 1 up to second derivatives.
TEST(Frames, StayOrthonormalAlongAMotion) {
  for (const char* name : {"bead_on_helix", "body_on_torus", "tori_mated"}) {
    const Description description = mechanism(name);
    std::mt19937_64 random(3);
    const State state = random_state(description, random);
    std::vector<Jet<double>> q;
    for (std::size_t i = 0; i < state.q.size(); ++i)
      q.emplace_back(state.q[i], state.speeds[i], state.rates[i]);
    for (const auto& pose : world_poses(description, q, Jet<double>(0.0))) {
      for (std::size_t a = 0; a < 3; ++a) {
        for (std::size_t b = 0; b < 3; ++b) {
          const Jet<double> product = dot(pose.column[a], pose.column[b]);
          EXPECT_NEAR(product.value, a == b ? 1 : 0, 1e-14);
          EXPECT_NEAR(product.first, 0, 1e-13);
          EXPECT_NEAR(product.second, 0, 1e-12);
        }
      }
      EXPECT_NEAR(dot(cross(pose.column[0], pose.column[1]), pose.column[2]).value, 1, 1e-14);
    }
  }
}

// The helix has the tangent (-R sin s, R cos s, h)/|.|, and its second derivative points at the axis.
TEST(Frames, OfAHelix) {
  const Description description = mechanism("bead_on_helix");
  const double R = description.parameter("R"), h = description.parameter("h"), s = 0.6,
               length = std::hypot(R, h);
  const auto pose = world_poses(description, {Jet<double>(s), Jet<double>(0.0)}, Jet<double>(0.0))[0];
  const Eigen::Vector3d b = Eigen::Vector3d(-R * std::sin(s), R * std::cos(s), h) / length;
  const Eigen::Vector3d inward(-std::cos(s), -std::sin(s), 0);
  const Eigen::Vector3d n = b.cross(inward), p = n.cross(b);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(pose.column[0][i].value, b[static_cast<int>(i)], 1e-15);
    EXPECT_NEAR(pose.column[1][i].value, p[static_cast<int>(i)], 1e-15);
    EXPECT_NEAR(pose.column[2][i].value, n[static_cast<int>(i)], 1e-15);
  }
}

// On the outside of a torus the normal of (u, v) points away from the tube's centre.
TEST(Frames, OfATorus) {
  const Description description = mechanism("body_on_torus");
  const double u = 0.4, v = -0.9;
  const auto pose =
      world_poses(description, {Jet<double>(u), Jet<double>(v), Jet<double>(0.0)}, Jet<double>(0.0))[0];
  EXPECT_NEAR(pose.column[0][0].value, -std::sin(u), 1e-15);
  EXPECT_NEAR(pose.column[0][1].value, std::cos(u), 1e-15);
  EXPECT_NEAR(pose.column[2][0].value, std::cos(u) * std::cos(v), 1e-15);
  EXPECT_NEAR(pose.column[2][2].value, std::sin(v), 1e-15);
}

/// A point mass at the end of a slide that hangs from a link `world`, which the file may declare or not.
TEST(ClosedForm, UndeclaredWorldOfUrdf) {
  const std::string file = ::testing::TempDir() + "alembert_undeclared_world.urdf";
  for (const std::string world : {"", "<link name=\"world\"/>"}) {
    std::ofstream(file) << "<robot name=\"slide\">" << world
                        << "<link name=\"mass\"><inertial><mass value=\"2\"/><inertia ixx=\"0\" iyy=\"0\" "
                           "izz=\"0\"/></inertial></link>"
                           "<joint name=\"slide\" type=\"prismatic\"><parent link=\"world\"/><child "
                           "link=\"mass\"/><axis xyz=\"0 0 1\"/></joint></robot>";
    const UrdfTree tree = read_urdf_tree(file, false);
    EXPECT_EQ(tree.bodies.size(), 2U);
    const Dynamics found = newton_euler_dynamics<double>(tree, {{0.3}, {1}, {0.5}, 0});
    EXPECT_NEAR(found.mass_matrix(0, 0), 2, kTolerance);
    EXPECT_NEAR(found.tau[0], 2 * (kG + 0.5), 2 * kG * kTolerance);
  }
}

}  // namespace
}  // namespace alembert::oracles
