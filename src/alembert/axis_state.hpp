// A generated mechanism as a tree of axes. In: a mechanism with a struct Axes, and a state. Out: M, c and derivatives of
// inverse dynamics, by the rows of Axes. No heap where M fits the stack (matrix.hpp), no exceptions.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cstddef>
#include <type_traits>

#include "alembert/axis_tree.hpp"
#include "alembert/matrix.hpp"
#include "alembert/mechanism.hpp"

namespace alembert {
namespace detail {
inline namespace ALEMBERT_INSTRUCTIONS {

template <class M>
inline constexpr AxisTables<typename M::Scalar, M::kNv> kAxisTables{typename M::Axes()};

template <class Axes, class = void>
struct HasAxisForces : std::false_type {};
template <class Axes>
struct HasAxisForces<Axes, std::void_t<decltype(&Axes::forces)>> : std::true_type {};

template <class M>
class AxisState {
  using S = typename M::Scalar;
  using Axes = typename M::Axes;
  static constexpr int N = M::kNv;
  // Vectors may start at the last entry.
  static constexpr int kMore = NumberLanes<S>::kLanes;

 public:
  using Rows = Eigen::Matrix<S, N + kMore, 1>;
  using Square = Scratch<S, N, N * N + kMore>;  ///< row by row

  /// The speed of a row.
  static int speed(int row) { return Axes::kSpeeds[static_cast<std::size_t>(row)]; }

  AxisState(const CoordinateVector<M>& q, const SpeedVector<M>& qd, const typename M::Inputs& in)
      : tree_(kAxisTables<M>) {
    Scratch<S, N, 12 * N + kMore> frames;
    std::fill_n(frames.data() + 12 * N, kMore, S(0));
    Axes::frames(q, in, frames.data());
    for (int row = 0; row < N; ++row) u_(row) = qd(speed(row));
    tree_.set_state(frames.data(), u_.data());
    if constexpr (kHasForces) Axes::forces(q, qd, in, applied_.Q.data(), applied_.changes.data());
  }

  const AxisTree<S, N>& tree() const { return tree_; }
  /// Up to the diagonal of each row.
  void mass_matrix(Square& mass) { tree_.mass_matrix(mass.data()); }
  /// c of tau = M qdd + c.
  void bias(Rows& c) {
    tree_.set_accelerations(u_.data(), nullptr);
    tree_.forces(c.data());
    if constexpr (kHasForces) c -= applied_.Q;
  }
  void derivatives(const S* qdd, Square& tau_q, Square& tau_qd) {
    tree_.set_accelerations(u_.data(), qdd);
    tree_.derivatives(tau_q.data(), tau_qd.data());
    if constexpr (kHasForces)
      for (std::size_t k = 0; k < Axes::kForceEntries.size(); ++k) {
        const int entry = Axes::kForceEntries[k];
        (entry < N * N ? tau_q.data()[entry] : tau_qd.data()[entry - N * N]) -= applied_.changes[k];
      }
  }

 private:
  static constexpr bool kHasForces = HasAxisForces<Axes>::value;
  template <class OfAxes, bool there>
  struct Applied {
    Rows Q = Rows::Zero();
    std::array<S, OfAxes::kForceEntries.size()> changes;
  };
  template <class OfAxes>
  struct Applied<OfAxes, false> {};

  AxisTree<S, N> tree_;
  Rows u_;
  Applied<Axes, kHasForces> applied_;
};

}  // namespace ALEMBERT_INSTRUCTIONS
}  // namespace detail
}  // namespace alembert
