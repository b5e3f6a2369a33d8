// Changes of topology of two rods in a plane: hinges that break, hinges that catch, welds. What must be kept
// is.
#include "alembert/topology.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "runtime/allocation_counter.hpp"
#include "runtime/plane_models.hpp"

namespace {

using alembert::BodyMotion;
using alembert::Status;
using models::Apart;
using models::Hinged;
using models::HingedByRows;
using models::TwoRods;
using models::Welded;
using Bodies = std::array<BodyMotion<double>, 2>;

static_assert(alembert::has_bodies_v<TwoRods<Hinged>>);
static_assert(!alembert::has_bodies_v<models::Pendulum<>>);

/// Linear momentum x y, angular momentum about the origin, kinetic energy.
Eigen::Vector4d momenta(const Bodies& bodies) {
  Eigen::Vector4d out = Eigen::Vector4d::Zero();
  for (std::size_t b = 0; b < 2; ++b) {
    const double m = TwoRods<Apart>::kMass[b], J = TwoRods<Apart>::kInertia[b], w = bodies[b].angular(2);
    const Eigen::Vector2d r = bodies[b].pose.col(3).head<2>(), v = bodies[b].linear.head<2>();
    out.head<2>() += m * v;
    out(2) += m * (r(0) * v(1) - r(1) * v(0)) + J * w;
    out(3) += m * v.squaredNorm() / 2 + J * w * w / 2;
  }
  return out;
}

template <class M>
Bodies bodies_of(const alembert::CoordinateVector<M>& q, const alembert::SpeedVector<M>& u) {
  return alembert::body_motions<M>(q, u, {});
}

const Eigen::Vector4d kHingedState(0.4, -0.2, 0.5, 1.1), kHingedSpeeds(0.7, -0.3, 2.0, -1.5);

TEST(Topology, BreakingAHingeChangesNothing) {
  const Bodies before = bodies_of<TwoRods<Hinged>>(kHingedState, kHingedSpeeds);
  using After = TwoRods<Apart>;
  After::Vector q = After::Vector::Zero(), u;
  alembert::TopologyChange<double> change;
  ASSERT_EQ(alembert::change_topology<After>(before, {}, q, u, &change), Status::ok);
  const Bodies after = bodies_of<After>(q, u);
  for (std::size_t b = 0; b < 2; ++b) {
    EXPECT_LT((after[b].pose - before[b].pose).norm(), 1e-14);
    EXPECT_LT((after[b].linear - before[b].linear).norm(), 1e-14);
    EXPECT_LT((after[b].angular - before[b].angular).norm(), 1e-14);
  }
  EXPECT_LT((momenta(after) - momenta(before)).norm(), 1e-14);
  EXPECT_LT(change.distance, 1e-14);
  EXPECT_NEAR(change.kinetic_before, momenta(before)(3), 1e-14);
  EXPECT_NEAR(change.kinetic_after, change.kinetic_before, 1e-14);
}

/// Two free rods whose ends meet, moving anyhow.
TwoRods<Apart>::Vector meeting_rods() {
  const auto places = Hinged::places(kHingedState);
  TwoRods<Apart>::Vector q;
  q << places[0], places[1];
  return q;
}
const TwoRods<Apart>::Vector kAnySpeeds = (TwoRods<Apart>::Vector() << 1, 0.2, -2, -0.5, 0.8, 3).finished();

template <class After>
void check_catch(typename After::Vector q, double angle_tolerance) {
  const Bodies before = bodies_of<TwoRods<Apart>>(meeting_rods(), kAnySpeeds);
  typename After::Vector u;
  alembert::TopologyOptions<double> options;
  options.largest_angle = angle_tolerance;
  options.largest_distance = angle_tolerance;
  alembert::TopologyChange<double> change;
  ASSERT_EQ(alembert::change_topology<After>(before, {}, q, u, &change, options), Status::ok);
  const Bodies after = bodies_of<After>(q, u);
  // Carnot: what is lost is the energy of the velocities lost.
  double lost = 0;
  for (std::size_t b = 0; b < 2; ++b) {
    lost += After::kMass[b] * (after[b].linear - before[b].linear).squaredNorm() / 2;
    lost += After::kInertia[b] * (after[b].angular - before[b].angular).squaredNorm() / 2;
  }
  EXPECT_GT(lost, 0.01);  // these speeds do not fit together
  EXPECT_NEAR(momenta(before)(3) - momenta(after)(3), lost, 1e-13);
  EXPECT_NEAR(change.kinetic_before, momenta(before)(3), 1e-13);
  EXPECT_NEAR(change.kinetic_after, momenta(after)(3), 1e-13);
  EXPECT_LT((momenta(before) - momenta(after)).head<2>().norm(), 1e-14);
  if (angle_tolerance < 1e-2) {
    EXPECT_NEAR(momenta(before)(2), momenta(after)(2), 1e-14);
  }
  // A second change of the same kind has nothing to do.
  const typename After::Vector once = u;
  ASSERT_EQ(alembert::change_topology<After>(after, {}, q, u, &change, options), Status::ok);
  EXPECT_LT((u - once).norm(), 1e-13);
}

TEST(Topology, CatchingAHingeKeepsMomentumAndLosesEnergy) {
  check_catch<TwoRods<Hinged>>(TwoRods<Hinged>::Vector::Zero(), 1e-3);
}

TEST(Topology, AHingeOfConstraintsIsTheSame) {
  check_catch<HingedByRows>(HingedByRows::Vector::Zero(), 1e-3);
  const Bodies before = bodies_of<TwoRods<Apart>>(meeting_rods(), kAnySpeeds);
  TwoRods<Hinged>::Vector q = TwoRods<Hinged>::Vector::Zero(), u;
  HingedByRows::Vector q_rows = HingedByRows::Vector::Zero(), u_rows;
  alembert::TopologyChange<double> change, change_rows;
  ASSERT_EQ(alembert::change_topology<TwoRods<Hinged>>(before, {}, q, u, &change), Status::ok);
  ASSERT_EQ(alembert::change_topology<HingedByRows>(before, {}, q_rows, u_rows, &change_rows), Status::ok);
  const Bodies a = bodies_of<TwoRods<Hinged>>(q, u), b = bodies_of<HingedByRows>(q_rows, u_rows);
  EXPECT_LT((momenta(a) - momenta(b)).norm(), 1e-12);
  EXPECT_LT((a[0].linear - b[0].linear).norm() + (a[1].angular - b[1].angular).norm(), 1e-12);
  EXPECT_NEAR(change.kinetic_after, change_rows.kinetic_after, 1e-12);
}

TEST(Topology, AWeldTakesTheMeanOfTheAngles) {
  // The rods stand at 0.5 and 1.1; welded straight they must both turn, which is told and, by default,
  // refused.
  const Bodies before = bodies_of<TwoRods<Apart>>(meeting_rods(), kAnySpeeds);
  using After = TwoRods<Welded>;
  After::Vector q = After::Vector::Zero(), u(7, 7, 7);
  alembert::TopologyChange<double> change;
  EXPECT_EQ(alembert::change_topology<After>(before, {}, q, u, &change), Status::residual_too_large);
  EXPECT_EQ(change.body, 0);
  EXPECT_GT(change.angle, 0.1);
  EXPECT_EQ(q, Eigen::Vector3d::Zero());
  EXPECT_EQ(u, Eigen::Vector3d(7, 7, 7));
  check_catch<After>(After::Vector::Zero(), 1.0);
  // The least sum of squares: no direction of the three goes down.
  alembert::TopologyOptions<double> options;
  options.largest_angle = options.largest_distance = 1;
  ASSERT_EQ(alembert::coordinates_of_bodies<After>(before, {}, q, options, change), Status::ok);
  alembert::detail::BodyFit<After> best, other;
  alembert::detail::fit_poses<After>(q, {}, before, best);
  for (int i = 0; i < 3; ++i) {
    for (const double h : {1e-4, -1e-4}) {
      After::Vector moved = q;
      moved(i) += h;
      alembert::detail::fit_poses<After>(moved, {}, before, other);
      EXPECT_GT(other.squares, best.squares);
    }
  }
  EXPECT_GT(q(2), 0.5);
  EXPECT_LT(q(2), 1.1);
}

TEST(Topology, ABodyThatIsNotKnownLeavesItsCoordinatesOpen) {
  Bodies before = bodies_of<TwoRods<Hinged>>(kHingedState, kHingedSpeeds);
  before[1].known = false;
  using After = TwoRods<Apart>;
  After::Vector q = After::Vector::Zero(), u = After::Vector::Zero();
  EXPECT_EQ(alembert::change_topology<After>(before, {}, q, u), Status::not_positive_definite);
  EXPECT_EQ(q, After::Vector::Zero());
  before[1] = before[0];
  before[1].pose(0, 3) = std::nan("");
  EXPECT_EQ(alembert::change_topology<After>(before, {}, q, u), Status::not_finite);
}

TEST(Topology, TooFewIterationsAreReported) {
  const Bodies before = bodies_of<TwoRods<Hinged>>(kHingedState, kHingedSpeeds);
  using After = TwoRods<Apart>;
  After::Vector q = After::Vector::Constant(3.0), u;
  alembert::TopologyOptions<double> options;
  options.iterations = 2;
  EXPECT_EQ(alembert::change_topology<After>(before, {}, q, u, nullptr, options), Status::no_convergence);
  EXPECT_EQ(q, After::Vector::Constant(3.0));
}

TEST(Topology, BodiesAreFoundByName) {
  constexpr std::array<std::string_view, 3> from{"hook", "link1", "link2"};
  constexpr std::array<std::string_view, 4> to{"link2", "link", "link12", "hook"};
  constexpr std::array<int, 4> expected{2, -1, -1, 0};
  static_assert(alembert::same_names(from, to)[0] == 2);
  EXPECT_EQ(alembert::same_names(from, to), expected);
  std::array<BodyMotion<double>, 3> a;
  std::array<BodyMotion<double>, 4> b;
  for (std::size_t i = 0; i < 3; ++i) {
    a[i].known = true;
    a[i].angular(0) = static_cast<double>(i + 1);
  }
  alembert::take_bodies(a, expected, b);
  EXPECT_EQ(b[0].angular(0), 3);
  EXPECT_FALSE(b[1].known || b[2].known);
  EXPECT_EQ(b[3].angular(0), 1);
}

TEST(Topology, NoHeap) {
  const Bodies before = bodies_of<TwoRods<Apart>>(meeting_rods(), kAnySpeeds);
  HingedByRows::Vector q = HingedByRows::Vector::Zero(), u;
  Eigen::internal::set_is_malloc_allowed(false);
  const std::size_t count = allocation_count();
  const Status status = alembert::change_topology<HingedByRows>(before, {}, q, u);
  const std::size_t after = allocation_count();
  Eigen::internal::set_is_malloc_allowed(true);
  EXPECT_EQ(status, Status::ok);
  EXPECT_EQ(after, count);
}

}  // namespace
