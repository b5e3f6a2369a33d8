// Every function of the runtime with arguments that are not finite, one after the other, and with matrices
// that are singular, as compiled with the flags under test: the status says so and results stay as they were.
// Out: nothing and 0, or what is wrong and 1.
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <string>

#include "alembert/consistent_state.hpp"
#include "alembert/energy.hpp"
#include "alembert/implicit_step.hpp"
#include "alembert/integrate.hpp"
#include "alembert/inverse_dynamics_derivatives.hpp"
#include "alembert/linearize.hpp"
#include "alembert/topology.hpp"
#include "reference.hpp"
#include "runtime/constrained_models.hpp"
#include "runtime/plane_models.hpp"

namespace {

using alembert::Status;
int failures = 0;

void expect(bool right, const std::string& what) {
  if (right) return;
  std::printf("wrong: %s\n", what.c_str());
  ++failures;
}
void expect(Status found, Status expected, const std::string& what) {
  if (found == expected) return;
  std::printf("wrong: %s: '%s', expected '%s'\n", what.c_str(), to_string(found), to_string(expected));
  ++failures;
}

const double kBad[] = {not_a_number(), infinity(), -infinity()};

/// A state of M, which any entry can be spoilt of.
template <class M>
struct State {
  using S = typename M::Scalar;
  alembert::CoordinateVector<M> q;
  alembert::SpeedVector<M> u, tau;
  typename M::Inputs in;
  S h;

  static constexpr int kEntries = M::kNq + 2 * M::kNv + 2;
  S& entry(int i) {
    if (i < M::kNq) return q(i);
    if (i < M::kNq + M::kNv) return u(i - M::kNq);
    if (i < M::kNq + 2 * M::kNv) return tau(i - M::kNq - M::kNv);
    return i == kEntries - 2 ? in.t : h;
  }
  bool keeps(const State& other, int but) {
    State copy = other;
    for (int i = 0; i < kEntries; ++i)
      if (i != but && entry(i) != copy.entry(i)) return false;
    return true;
  }
};

template <class M>
State<M> state_of(const alembert::CoordinateVector<M>& q) {
  State<M> out{q, alembert::SpeedVector<M>::Zero(), alembert::SpeedVector<M>::Zero(), {}, {}};
  out.in.t = 1;
  out.h = typename M::Scalar(0.01);
  return out;
}

/// What a call is given, of the entries of a State.
enum Arguments : unsigned { of_q = 1, of_u = 2, of_tau = 4, of_t = 8, of_h = 16 };

template <class M>
unsigned kind(int entry) {
  if (entry < M::kNq) return of_q;
  if (entry < M::kNq + M::kNv) return of_u;
  if (entry < M::kNq + 2 * M::kNv) return of_tau;
  return entry == State<M>::kEntries - 2 ? of_t : of_h;
}

/// call(state) -> status, with nothing bad, and with each of its arguments bad in turn.
template <class M, class Call>
void check(const char* name, const State<M>& good, unsigned arguments, Call&& call) {
  State<M> state = good;
  expect(call(state), Status::ok, name);
  for (int i = 0; i < State<M>::kEntries; ++i) {
    if (!(arguments & kind<M>(i))) continue;
    for (const double bad : kBad) {
      state = good;
      state.entry(i) = static_cast<typename M::Scalar>(bad);
      const std::string what = std::string(name) + ", entry " + std::to_string(i) + " is bad";
      expect(call(state), Status::not_finite, what);
      expect(state.keeps(good, i), what + ": arguments stay");
    }
  }
}

template <class M>
void check_free(const char* model, const State<M>& good) {
  using S = typename M::Scalar;
  const std::string name(model);
  check<M>((name + " forward_dynamics").c_str(), good, of_q | of_u | of_tau | of_t, [](State<M>& s) {
    alembert::SpeedVector<M> qdd = alembert::SpeedVector<M>::Constant(7);
    const Status status = alembert::forward_dynamics<M>(s.q, s.u, s.tau, s.in, qdd);
    expect((qdd(0) == S(7)) == (status != Status::ok), "forward_dynamics leaves its result unless ok");
    return status;
  });
  check<M>((name + " linearize").c_str(), good, of_q | of_u | of_tau | of_t, [](State<M>& s) {
    alembert::Linearization<M> out;
    out.qdd.setConstant(7);
    const Status status = alembert::linearize<M>(s.q, s.u, s.tau, s.in, out);
    expect((out.qdd(0) == S(7)) == (status != Status::ok), "linearize leaves its result unless ok");
    return status;
  });
  if constexpr (alembert::has_derivatives_v<M>)
    check<M>((name + " inverse_dynamics_derivatives").c_str(), good, of_q | of_u | of_tau | of_t,
             [](State<M>& s) {
               alembert::SpeedMatrix<M> along, by_speeds;
               along.setConstant(7);
               by_speeds = along;
               const Status status =
                   alembert::inverse_dynamics_derivatives<M>(s.q, s.u, s.tau, s.in, along, by_speeds);
               expect((along(0, 0) == S(7)) == (status != Status::ok) &&
                          (by_speeds(0, 0) == S(7)) == (status != Status::ok),
                      "inverse_dynamics_derivatives leaves its results unless ok");
               return status;
             });
  check<M>((name + " energy").c_str(), good, of_q | of_u | of_t, [](State<M>& s) {
    alembert::Energy<S> out{7, 7};
    const Status status = alembert::energy<M>(s.q, s.u, s.in, out);
    expect((out.kinetic == S(7)) == (status != Status::ok), "energy leaves its result unless ok");
    return status;
  });
  check<M>((name + " kinetic_energy").c_str(), good, of_q | of_u | of_t, [](State<M>& s) {
    S out(7);
    const Status status = alembert::kinetic_energy<M>(s.q, s.u, s.in, out);
    expect((out == S(7)) == (status != Status::ok), "kinetic_energy leaves its result unless ok");
    return status;
  });
}

template <class M>
void check_steps(const char* model, const State<M>& good) {
  const auto force_of = [](State<M>& s) {
    return [tau = s.tau](auto, const auto&, const auto&) -> alembert::SpeedVector<M> { return tau; };
  };
  check<M>((std::string(model) + " rk4_step").c_str(), good, of_q | of_u | of_tau | of_t | of_h,
           [&](State<M>& s) { return alembert::rk4_step<M>(s.q, s.u, s.in, s.h, force_of(s)); });
  check<M>(
      (std::string(model) + " semi_implicit_euler_step").c_str(), good, of_q | of_u | of_tau | of_t | of_h,
      [&](State<M>& s) { return alembert::semi_implicit_euler_step<M>(s.q, s.u, s.in, s.h, force_of(s)); });
  if constexpr (alembert::has_derivatives_v<M>) {
    check<M>((std::string(model) + " linearly_implicit_euler_step").c_str(), good,
             of_q | of_u | of_tau | of_t | of_h, [&](State<M>& s) {
               return alembert::linearly_implicit_euler_step<M>(s.q, s.u, s.in, s.h, force_of(s));
             });
    check<M>((std::string(model) + " implicit_euler_step").c_str(), good, of_q | of_u | of_tau | of_t | of_h,
             [&](State<M>& s) { return alembert::implicit_euler_step<M>(s.q, s.u, s.in, s.h, force_of(s)); });
  }
  // A step of zero advances nothing, and a negative one leads back.
  State<M> s = good;
  expect(alembert::rk4_step<M>(s.q, s.u, s.in, 0, force_of(s)), Status::ok, "a step of zero");
  expect(s.keeps(good, -1), "a step of zero advances nothing");
  expect(alembert::rk4_step<M>(s.q, s.u, s.in, s.h, force_of(s)), Status::ok, "a step");
  expect(alembert::rk4_step<M>(s.q, s.u, s.in, -s.h, force_of(s)), Status::ok, "a step back");
  expect((s.q - good.q).norm() + (s.u - good.u).norm() < 1e-5, "a step back leads back");
  // Steps so long that the state overflows.
  s = good;
  s.tau.setOnes();
  expect(alembert::rk4_step<M>(s.q, s.u, s.in, std::numeric_limits<typename M::Scalar>::max(), force_of(s)),
         Status::not_finite, "a step too long");
}

template <class M>
void check_constrained(const char* model, const State<M>& good) {
  using S = typename M::Scalar;
  using Report = alembert::ConstraintReport<M::kNc>;
  const std::string name(model);
  check<M>((name + " constrained_forward_dynamics").c_str(), good, of_q | of_u | of_tau | of_t,
           [](State<M>& s) {
             alembert::ConstrainedMotionOf<M> out;
             out.qdd.setConstant(7);
             out.lambda.setConstant(7);
             const Status status = alembert::constrained_forward_dynamics<M>(s.q, s.u, s.tau, s.in, out);
             expect((out.lambda(0) == S(7) && out.qdd(0) == S(7)) == (status != Status::ok),
                    "it leaves its result");
             return status;
           });
  check<M>((name + " consistent_state").c_str(), good, of_q | of_u | of_t, [](State<M>& s) {
    Report report;
    return alembert::consistent_state<M>(s.q, s.u, s.in, report);
  });
  check<M>((name + " project_velocities").c_str(), good, of_q | of_u | of_t, [](State<M>& s) {
    Report report;
    return alembert::project_velocities<M>(s.q, s.u, s.in, report);
  });
  check<M>((name + " project_positions").c_str(), good, of_q | of_t, [](State<M>& s) {
    Report report;
    return alembert::project_positions<M>(s.q, s.in, report);
  });
  for (const double bad : {not_a_number(), infinity()}) {
    State<M> s = good;
    s.q(0) += S(0.01);
    const State<M> before = s;
    Report report;
    alembert::ProjectionOptionsOf<M> options;
    options.tolerance = static_cast<S>(bad);
    expect(alembert::project_positions<M>(s.q, s.in, report, options), Status::not_finite, "tolerance");
    options = {};
    options.longest_step = static_cast<S>(bad);
    // Without a bound is fine.
    expect(alembert::project_positions<M>(s.q, s.in, report, options),
           is_a_nan(bad) ? Status::not_finite : Status::ok, "longest_step");
    options = {};
    options.iterations = -1;
    s = before;
    expect(alembert::project_positions<M>(s.q, s.in, report, options), Status::no_convergence, "iterations");
    expect(s.keeps(before, -1), "failed projections change nothing");
    alembert::ConstrainedMotionOf<M> out;
    expect(alembert::constrained_forward_dynamics<M>(s.q, s.u, s.tau, s.in, out, {static_cast<S>(bad), S(0)}),
           Status::not_finite, "gain");
  }
}

void check_topology() {
  using M = models::HingedByRows;
  using Bodies = std::array<alembert::BodyMotion<double>, 2>;
  State<M> good = state_of<M>(M::Vector::Zero());
  good.q << -0.3, 0, 0, 0.3, 0, 0;
  const Bodies bodies = alembert::body_motions<M>(good.q, good.u, good.in);
  check<M>("change_topology", good, of_q | of_t,
           [&](State<M>& s) { return alembert::change_topology<M>(bodies, s.in, s.q, s.u); });
  check<M>("speeds_of_bodies", good, of_q | of_t, [&](State<M>& s) {
    alembert::TopologyChange<double> change;
    return alembert::speeds_of_bodies<M>(bodies, s.in, s.q, s.u, change);
  });
  for (int which = 0; which < 3; ++which) {
    const double bad = kBad[which];
    for (int k = 0; k < 3; ++k) {
      Bodies spoilt = bodies;
      (k == 0 ? spoilt[1].pose(0, 3) : k == 1 ? spoilt[1].angular(2) : spoilt[0].linear(0)) = bad;
      State<M> s = good;
      expect(alembert::change_topology<M>(spoilt, s.in, s.q, s.u), Status::not_finite, "a body");
      expect(s.keeps(good, -1), "change_topology leaves the state");
    }
    alembert::TopologyOptions<double> options;
    options.largest_distance = bad;
    State<M> s = good;
    expect(alembert::change_topology<M>(bodies, s.in, s.q, s.u, nullptr, options),
           which == 1 ? Status::ok : Status::not_finite, "largest_distance");
    options = {};
    options.iterations = -1;
    expect(alembert::change_topology<M>(bodies, s.in, s.q, s.u, nullptr, options), Status::no_convergence,
           "iterations");
  }
  // Velocities whose energy overflows.
  Bodies fast = bodies;
  fast[0].linear(0) = 1e200;
  State<M> s = good;
  expect(alembert::change_topology<M>(fast, s.in, s.q, s.u), Status::not_finite, "energy overflows");
}

void check_matrices() {
  Eigen::Matrix2d A;
  A << 1, 1, 1, 1;
  expect(alembert::factor_ldlt(A), Status::not_positive_definite, "singular");
  A << -1, 0, 0, 1;
  expect(alembert::factor_ldlt(A), Status::not_positive_definite, "negative");
  for (const double bad : kBad) {
    A << 1, 0, 0, bad;
    expect(alembert::factor_ldlt(A), Status::not_finite, "last pivot");
    Eigen::Matrix<double, 20, 20> large = Eigen::Matrix<double, 20, 20>::Identity();
    large(19, 3) = bad;
    expect(alembert::factor_ldlt(large), Status::not_finite, "large, by columns");
  }
  using D = models::Dense<4>;
  const D::Vector zero = D::Vector::Zero();
  D::Vector qdd;
  expect(alembert::forward_dynamics<D>(zero, zero, zero, {-1.5}, qdd), Status::not_positive_definite, "M");
  D::Vector q = zero, u = zero;
  D::Inputs in{-1.5};
  expect(alembert::rk4_step<D>(q, u, in, 0.1, models::no_force<D>), Status::not_positive_definite,
         "rk4_step");
  using R = models::PointOnRod<double, models::Rod::contradictory>;
  R::Vector p(0.5, 0), v(0, 1);
  alembert::ConstraintReport<2> report;
  expect(alembert::consistent_state<R>(p, v, {}, report), Status::inconsistent_constraints, "two rods");
  // Contradictions are told by lengths, which overflow here.
  alembert::ConstrainedMotionOf<R> motion;
  expect(alembert::constrained_forward_dynamics<R>(p, v, R::Vector(0, 1e200), {}, motion), Status::not_finite,
         "a force whose square overflows");
  using B = models::SpinningBody<>;
  for (const double bad : {0.0, not_a_number(), infinity()}) {
    Eigen::Vector4d quaternion(0, 0, 0, bad);
    expect(alembert::normalize_quaternions<B>(quaternion), Status::not_finite, "quaternion");
  }
}

/// One entry of its mass matrix, or of a derivative of inverse dynamics, can be spoilt.
struct Spoilt : models::Dense<12> {
  using Matrix = Eigen::Matrix<double, kNv, kNv>;
  struct Inputs : models::Inputs<double> {
    int matrix = -1, row = 0, column = 0;
    double entry = 0;
    void spoil(int which, Matrix& X) const {
      if (which == matrix) X(row, column) = entry;
    }
  };
  static void mass_matrix_and_bias(const Vector&, const Vector& qd, const Inputs& in, Matrix& M, Vector& c) {
    Dense::mass_matrix_and_bias(qd, qd, in, M, c);
    in.spoil(0, M);
  }
  static void inverse_dynamics_derivatives(const Vector&, const Vector&, const Vector&, const Inputs& in,
                                           Matrix& tau_q, Matrix& tau_qd) {
    tau_q.setOnes();
    tau_qd.setIdentity();
    in.spoil(1, tau_q);
    in.spoil(2, tau_qd);
  }
};

/// A tree of axes, branched, of which one entry of its frames or of what forces give can be spoilt.
/// \tparam by_bodies  solved so, not by factors of M
template <bool by_bodies>
struct SpoiltTree : models::Dense<12> {
  static constexpr std::size_t n = 12;
  struct Inputs : models::Inputs<double> {
    int array = -1;
    std::size_t at = 0;
    double entry = 0;
    void spoil(int which, double* X) const {
      if (which == array) X[at] = entry;
    }
  };
  static void mass_matrix_and_bias(const Vector&, const Vector& qd, const Inputs& in,
                                   Eigen::Matrix<double, kNv, kNv>& M, Vector& c) {
    Dense::mass_matrix_and_bias(qd, qd, in, M, c);
  }
  struct Axes {
    using Of = SpoiltTree;
    static constexpr std::array<int, n> kSpeeds{3, 2, 1, 0, 7, 6, 5, 4, 11, 10, 9, 8};
    static constexpr std::array<int, n> kParents{-1, 0, 1, 2, 1, 4, 5, 0, 7, 8, -1, 10};
    static constexpr std::array<std::array<double, n>, 3> kDirections{
        {{}, {1, 1, 0, 1, 1, 0, 1, 1, 1, 0, 1, 1}, {0, 0, 1, 0, 0, 1, 0, 0, 0, 1, 0, 0}}};
    static constexpr std::array<bool, n> kTurns{true,  false, true, true, true,  true,
                                                false, true,  true, true, false, true};
    static constexpr std::array<double, n> kMasses{1, 2, 3, 1, 2, 1, 1, 2, 1, 3, 1, 2}, kArmatures{};
    static constexpr std::array<std::array<double, n>, 3> kCenters{
        {{0.1, 0.1, 0.2, 0.1, 0.3, 0.1, 0.1, 0.2, 0.1, 0.1, 0.1, 0.4}}};
    static constexpr std::array<std::array<double, n>, 6> kInertias{{{1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1},
                                                                     {2, 1, 1, 2, 1, 1, 2, 1, 1, 2, 1, 1},
                                                                     {2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2}}};
    static constexpr std::array<bool, n> kFirstOfThree{};
    static constexpr std::array<double, 3> kGravity{0, 0, -9.81};
    static void frames(const Vector&, const Inputs& in, double* frames) {
      for (std::size_t i = 0; i < 12 * n; ++i) frames[i] = 0;
      for (std::size_t k = 0; k < n; ++k) {
        frames[k] = frames[5 * n + k] = frames[10 * n + k] = 1;
        frames[3 * n + k] = 0.3 * static_cast<double>(k);
        frames[7 * n + k] = 0.2;
      }
      in.spoil(0, frames);
    }
    static constexpr std::array<int, 4> kForceEntries{0, 17, 144, 260};
    static void forces(const Vector&, const Vector&, const Inputs& in, double* Q, double* changes) {
      for (std::size_t i = 0; i < n; ++i) Q[i] = 0.25;
      for (std::size_t i = 0; i < 4; ++i) changes[i] = -0.5;
      in.spoil(1, Q);
      in.spoil(2, changes);
    }
  };
};

}  // namespace
namespace alembert::detail {
template <>
inline constexpr bool kSolvesByBodies<SpoiltTree<true>> = true;
}  // namespace alembert::detail
namespace {

template <class Tree>
void check_linearize_of_trees() {
  static_assert(alembert::detail::kByAxes<Tree>);
  const typename Tree::Vector zero = Tree::Vector::Zero(), some = Tree::Vector::Constant(0.3);
  typename Tree::Inputs in;
  alembert::Linearization<Tree> out;
  expect(alembert::linearize<Tree>(zero, some, zero, in, out), Status::ok, "no tree spoilt");
  out.qdd.setConstant(7);
  out.qdd_q.setConstant(7);
  out.qdd_qd = out.qdd_tau = out.qdd_q;
  constexpr std::size_t n = Tree::n, sizes[] = {12 * n, n, 4};
  for (in.array = 0; in.array < 3; ++in.array)
    for (in.at = 0; in.at < sizes[in.array]; ++in.at)
      for (const double bad : kBad) {
        in.entry = bad;
        const std::string what =
            "linearize of a tree, array " + std::to_string(in.array) + ", entry " + std::to_string(in.at);
        expect(alembert::linearize<Tree>(zero, some, zero, in, out), Status::not_finite, what);
        expect(out.qdd.minCoeff() == 7 && out.qdd.maxCoeff() == 7, what + ": its result stays");
        for (const auto* X : {&out.qdd_q, &out.qdd_qd, &out.qdd_tau})
          expect(X->minCoeff() == 7 && X->maxCoeff() == 7, what + ": its matrices stay");
        if (alembert::detail::kSolvesByBodies<Tree> && in.array < 2) {
          expect(alembert::forward_dynamics<Tree>(zero, some, zero, in, out.qdd), Status::not_finite,
                 what + ", forward dynamics");
          expect(out.qdd.minCoeff() == 7 && out.qdd.maxCoeff() == 7, what + ": rates stay");
        }
        if (in.array == 1) continue;
        expect(alembert::inverse_dynamics_derivatives<Tree>(zero, some, some, in, out.qdd_q, out.qdd_qd),
               Status::not_finite, what + ", derivatives");
        for (const auto* X : {&out.qdd_q, &out.qdd_qd})
          expect(X->minCoeff() == 7 && X->maxCoeff() == 7, what + ": derivatives stay");
      }
}

void check_linearize_at_entries() {
  constexpr int n = Spoilt::kNv;
  const Spoilt::Vector zero = Spoilt::Vector::Zero();
  Spoilt::Inputs in;
  in.t = 1;
  alembert::Linearization<Spoilt> out;
  expect(alembert::linearize<Spoilt>(zero, zero, zero, in, out), Status::ok, "nothing spoilt");
  out.qdd_q.setConstant(7);
  out.qdd_qd = out.qdd_tau = out.qdd_q;
  for (in.matrix = 0; in.matrix < 3; ++in.matrix)
    for (in.row = 0; in.row < n; ++in.row)
      // The mass matrix is symmetric: its upper triangle is read.
      for (in.column = in.matrix == 0 ? in.row : 0; in.column < n; ++in.column)
        for (const double bad : kBad) {
          in.entry = bad;
          const std::string what = "linearize, matrix " + std::to_string(in.matrix) + ", row " +
                                   std::to_string(in.row) + ", column " + std::to_string(in.column);
          expect(alembert::linearize<Spoilt>(zero, zero, zero, in, out), Status::not_finite, what);
          bool stays = true;
          for (const Spoilt::Matrix* X : {&out.qdd_q, &out.qdd_qd, &out.qdd_tau})
            for (int i = 0; i < n * n; ++i) stays = stays && X->data()[i] == 7;
          expect(stays, what + ": its result stays");
        }
}

/// And where all is well, the numbers are right.
void check_numbers() {
  using M = models::Pendulum<>;
  M::Vector q(0.7), u(0.1), qdd(0.0);
  expect(alembert::forward_dynamics<M>(q, u, M::Vector(0.3), {}, qdd), Status::ok, "pendulum");
  expect(std::fabs(qdd(0) - (0.6 - 19.62 * static_cast<double>(exact_sine(0.7)))) < 1e-13,
         "its acceleration");
  M::Inputs in;
  double t = 0;
  expect(alembert::repeat_step(in.t, 1e-3, 1000000,
                               [&] {
                                 in.t += 1e-3;
                                 t += 1e-3;
                                 return Status::ok;
                               }),
         Status::ok, "a million steps");
  expect(in.t == 1000.0, "a million steps of a millisecond are a thousand seconds");
}

}  // namespace

int main() {
  State<models::Pendulum<>> pendulum = state_of<models::Pendulum<>>(models::Pendulum<>::Vector(0.3));
  check_free("pendulum", pendulum);
  check_steps("pendulum", pendulum);
  const auto in_float = state_of<models::Pendulum<float>>(models::Pendulum<float>::Vector(0.3F));
  check_free("pendulum in float", in_float);
  check_steps("pendulum in float", in_float);
  State<models::SpinningBody<>> body = state_of<models::SpinningBody<>>(Eigen::Vector4d(0, 0, 0, 1));
  body.u << 0.1, 0.2, 0.3;
  check_free("body", body);
  check_steps("body", body);
  State<models::HeldTop<>> top = state_of<models::HeldTop<>>(models::HeldTop<>::CoordinateVector::Zero());
  top.q << 0, 0, 0.3, 0, 0, 0, 1;
  check_constrained("top", top);
  check_steps("top", top);
  check_topology();
  check_matrices();
  check_linearize_at_entries();
  check_linearize_of_trees<SpoiltTree<false>>();
  check_linearize_of_trees<SpoiltTree<true>>();
  check_numbers();
  return failures == 0 ? 0 : 1;
}
