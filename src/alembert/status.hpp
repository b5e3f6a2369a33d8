// What comes of a call of the runtime, and the checks that it rests on. In: numbers. Out: a status.
#pragma once

#include <Eigen/Core>
#include <limits>

#include "alembert/floating_point.hpp"

namespace alembert {

/// What came of a call.
enum class Status {
  ok = 0,
  not_finite = 1,                ///< an argument, M or c, or the result holds a NaN or an infinity
  not_positive_definite = 2,     ///< M has a pivot that is not positive beyond rounding: singular here
  inconsistent_constraints = 3,  ///< a row of the constraints contradicts the others
  no_convergence = 4,            ///< an iteration came to no solution
  residual_too_large = 5,        ///< the closest state is further away than was allowed
  singular_step = 6,             ///< the equations of an implicit step have no solution for its length
  missing_function = 7,          ///< the mechanism was generated without a function that is needed
};

/// The status in words, for messages.
constexpr const char* to_string(Status status) noexcept {
  switch (status) {
    case Status::ok:
      return "ok";
    case Status::not_finite:
      return "a value is not finite";
    case Status::not_positive_definite:
      return "the mass matrix is not positive definite";
    case Status::inconsistent_constraints:
      return "the constraints contradict each other";
    case Status::no_convergence:
      return "the iteration found no solution";
    case Status::residual_too_large:
      return "the closest state is too far away";
    case Status::singular_step:
      return "the equations of the implicit step are singular";
    case Status::missing_function:
      return "the mechanism was generated without a function that is needed";
  }
  return "unknown status";
}

namespace detail {

template <int R, int C, int Options, int MaxR, int MaxC>
bool all_finite(const Eigen::Matrix<double, R, C, Options, MaxR, MaxC>& x) {
  return all_finite(static_cast<std::size_t>(x.size()), x.data());
}

template <class Derived>
bool all_finite(const Eigen::MatrixBase<Derived>& x) {
  for (Eigen::Index j = 0; j < x.cols(); ++j)
    for (Eigen::Index i = 0; i < x.rows(); ++i)
      if (!is_finite(x(i, j))) return false;
  return true;
}

/// Whether a pivot of an n x n matrix tells that it is positive definite, as of factor_ldlt.
/// \param whole  the pivot as it was before rows were taken away
template <class S>
[[nodiscard]] Status status_of_pivot(const S& pivot, const S& whole, int n) {
  if (!is_finite(pivot)) return Status::not_finite;
  const bool positive = pivot > S(0) && pivot > S(n) * std::numeric_limits<S>::epsilon() * whole;
  return positive ? Status::ok : Status::not_positive_definite;
}

/// Whether a state is one: a NaN that no equation reads is an error of the caller's all the same.
template <class S, class Coordinates, class Speeds>
bool is_finite_state(const S& t, const Coordinates& q, const Speeds& u) {
  return is_finite(t) && all_finite(q) && all_finite(u);
}

}  // namespace detail
}  // namespace alembert
