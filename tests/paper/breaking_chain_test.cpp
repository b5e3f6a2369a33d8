// A chain of six links that breaks in two while it swings, and is caught again: nothing jumps where it
// breaks, the free half flies as a free body must, and the catch keeps what momentum the support leaves it.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <chain_lower/chain_lower.hpp>
#include <chain_upper/chain_upper.hpp>
#include <chain_whole/chain_whole.hpp>
#include <vector>

#include "alembert/energy.hpp"
#include "alembert/integrate.hpp"
#include "alembert/topology.hpp"

namespace {

using alembert::BodyMotion;
using alembert::Status;
namespace whole = alembert::mechanisms::chain_whole;
namespace upper = alembert::mechanisms::chain_upper;
namespace lower = alembert::mechanisms::chain_lower;
using Whole = whole::Mechanism<double>;
using Upper = upper::Mechanism<double>;
using Lower = lower::Mechanism<double>;

template <class M>
struct State {
  typename M::CoordinateVector q = M::initial_coordinates();
  typename M::SpeedVector u = M::SpeedVector::Zero();
  typename M::Inputs in;
  std::array<BodyMotion<double>, M::kNbodies> bodies() const { return alembert::body_motions<M>(q, u, in); }
  double energy() const { return alembert::energy<M>(q, u, in).total(); }
  void run(double duration) {
    const auto no_force = [](double, const auto&, const auto&) {
      return typename M::SpeedVector(M::SpeedVector::Zero());
    };
    for (int i = 0; i < std::lround(duration * 2000); ++i)
      ASSERT_EQ(alembert::rk4_step<M>(q, u, in, 1.0 / 2000, no_force), Status::ok);
  }
};

/// Momentum, and angular momentum about the point where the chain hangs.
struct Momentum {
  Eigen::Vector3d linear = Eigen::Vector3d::Zero(), angular = Eigen::Vector3d::Zero();
  Eigen::Vector3d first_moment = Eigen::Vector3d::Zero();
  double mass = 0;
  template <class M>
  void add(const State<M>& state) {
    const auto bodies = state.bodies();
    const auto inertias = M::body_inertias(state.in);
    for (std::size_t b = 0; b < bodies.size(); ++b) {
      const alembert::detail::WorldInertia<double> inertia(inertias.row(static_cast<Eigen::Index>(b)),
                                                           bodies[b].pose);
      const Eigen::Vector3d r = inertia.com_at(bodies[b].pose) - Eigen::Vector3d(0, 0, 2);
      const Eigen::Vector3d p = inertia.mass * bodies[b].linear;
      linear += p;
      angular += r.cross(p) + inertia.inertia * bodies[b].angular;
      first_moment += inertia.mass * r;
      mass += inertia.mass;
    }
  }
};

State<Whole> swinging() {
  State<Whole> chain;
  chain.u << 1, 2, -1, 0.5, 2, -2;
  chain.run(0.6);
  return chain;
}

/// Breaks it; the guesses are the descriptions' initial coordinates.
template <class Part, std::size_t n>
State<Part> part_of(const State<Whole>& chain, const std::array<std::string_view, n>& names) {
  State<Part> part;
  part.in.t = chain.in.t;
  std::array<BodyMotion<double>, Part::kNbodies> bodies;
  alembert::take_bodies(chain.bodies(), alembert::same_names(whole::kBodyNames, names), bodies);
  alembert::TopologyChange<double> change;
  EXPECT_EQ(alembert::change_topology<Part>(bodies, part.in, part.q, part.u, &change), Status::ok);
  EXPECT_LT(change.distance, 1e-13);
  EXPECT_LT(change.angle, 1e-13);
  EXPECT_NEAR(change.kinetic_after, change.kinetic_before, 1e-12);
  return part;
}

TEST(BreakingChain, NothingJumpsWhereItBreaks) {
  const State<Whole> chain = swinging();
  const State<Upper> above = part_of<Upper>(chain, upper::kBodyNames);
  const State<Lower> below = part_of<Lower>(chain, lower::kBodyNames);
  Momentum before, after;
  before.add(chain);
  after.add(above);
  after.add(below);
  EXPECT_GT(before.linear.norm(), 1);
  EXPECT_LT((before.linear - after.linear).norm(), 1e-13 * before.linear.norm());
  EXPECT_LT((before.angular - after.angular).norm(), 1e-13 * before.angular.norm());
  EXPECT_NEAR(before.mass, after.mass, 1e-15);
  EXPECT_NEAR(chain.energy(), above.energy() + below.energy(), 1e-12);
  // The halves' own coordinates are the whole's.
  EXPECT_LT((above.q - chain.q.head<3>()).norm() + (above.u - chain.u.head<3>()).norm(), 1e-12);
  EXPECT_LT((below.q.tail<2>() - chain.q.tail<2>()).norm() + (below.u.tail<2>() - chain.u.tail<2>()).norm(),
            1e-12);
}

TEST(BreakingChain, TheFreeHalfFliesOnAParabola) {
  State<Lower> below = part_of<Lower>(swinging(), lower::kBodyNames);
  const double energy = below.energy();
  Momentum start, end;
  start.add(below);
  below.run(0.5);
  end.add(below);
  const Eigen::Vector3d g(0, 0, -9.81);
  EXPECT_LT((end.linear - start.linear - 0.5 * start.mass * g).norm(), 1e-11);
  EXPECT_LT((end.first_moment - start.first_moment - 0.5 * start.linear - 0.125 * start.mass * g).norm(),
            1e-9);
  EXPECT_NEAR(below.energy(), energy, 1e-8);
  // About its centre of mass its angular momentum stays.
  const auto own = [](const Momentum& m) {
    return Eigen::Vector3d(m.angular - m.first_moment.cross(m.linear) / m.mass);
  };
  EXPECT_LT((own(start) - own(end)).norm(), 1e-9);
}

TEST(BreakingChain, CaughtAgainItKeepsTheMomentumThatTheSupportLeaves) {
  const State<Whole> chain = swinging();
  State<Upper> above = part_of<Upper>(chain, upper::kBodyNames);
  State<Lower> below = part_of<Lower>(chain, lower::kBodyNames);
  below.u.head<6>() += (Eigen::Matrix<double, 6, 1>() << 0.5, -1, 0.3, 2, 1, -1).finished();  // kicked
  std::array<BodyMotion<double>, Whole::kNbodies> bodies;
  alembert::take_bodies(above.bodies(), alembert::same_names(upper::kBodyNames, whole::kBodyNames), bodies);
  alembert::take_bodies(below.bodies(), alembert::same_names(lower::kBodyNames, whole::kBodyNames), bodies);
  State<Whole> caught;
  alembert::TopologyChange<double> change;
  ASSERT_EQ(alembert::change_topology<Whole>(bodies, caught.in, caught.q, caught.u, &change), Status::ok);
  EXPECT_LT((caught.q - chain.q).norm(), 1e-12);

  Momentum before, after;
  before.add(above);
  before.add(below);
  after.add(caught);
  // The hinge of the support is about y: only about that axis can the chain turn as a whole.
  EXPECT_NEAR(before.angular.y(), after.angular.y(), 1e-12);
  EXPECT_GT((before.angular - after.angular).norm(), 1e-2);
  EXPECT_GT((before.linear - after.linear).norm(), 1e-2);
  EXPECT_LT(caught.energy(), above.energy() + below.energy() - 0.1);
  EXPECT_NEAR(change.kinetic_before - change.kinetic_after, above.energy() + below.energy() - caught.energy(),
              1e-11);
  // Along each speed of the whole the momenta of the bodies are the same before and after.
  const auto J = Whole::body_jacobians(caught.q, caught.in);
  const auto inertias = Whole::body_inertias(caught.in);
  const auto now = caught.bodies();
  Whole::SpeedVector difference = Whole::SpeedVector::Zero();
  for (int b = 0; b < Whole::kNbodies; ++b) {
    const std::size_t i = static_cast<std::size_t>(b);
    const alembert::detail::WorldInertia<double> inertia(inertias.row(b), now[i].pose);
    difference += J.middleRows<3>(6 * b).transpose() * inertia.inertia * (now[i].angular - bodies[i].angular);
    difference += J.middleRows<3>(6 * b + 3).transpose() * inertia.mass * (now[i].linear - bodies[i].linear);
  }
  EXPECT_LT(difference.norm(), 1e-12);
}

TEST(BreakingChain, TooFarApartItCannotBeCaught) {
  const State<Whole> chain = swinging();
  State<Upper> above = part_of<Upper>(chain, upper::kBodyNames);
  State<Lower> below = part_of<Lower>(chain, lower::kBodyNames);
  below.run(0.05);
  std::array<BodyMotion<double>, Whole::kNbodies> bodies;
  alembert::take_bodies(above.bodies(), alembert::same_names(upper::kBodyNames, whole::kBodyNames), bodies);
  alembert::take_bodies(below.bodies(), alembert::same_names(lower::kBodyNames, whole::kBodyNames), bodies);
  State<Whole> caught;
  const Whole::CoordinateVector guess = caught.q;
  alembert::TopologyChange<double> change;
  EXPECT_EQ(alembert::change_topology<Whole>(bodies, caught.in, caught.q, caught.u, &change),
            Status::residual_too_large);
  EXPECT_GT(change.distance, 1e-3);
  EXPECT_GT(change.body, 0);
  EXPECT_EQ(caught.q, guess);
}

}  // namespace
