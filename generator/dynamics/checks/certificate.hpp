// How far a program is from the plain equations. In: a program in its final order. Out: the largest error of
// its results at states over the coordinates' ranges, near the initial state, far out, at rest and fast, with
// runtime parameters about their defaults, relative to the largest entry of the array; of M, of its inverse and of
// accelerations after scaling to a unit diagonal of M, so that no unit of a coordinate hides the digits of another.
//
// The program is run in double precision, its functions of the C library rounded correctly, so that the
// figures are the same on every machine; the plain equations have 50 digits. M and derivatives are compared by
// their products with vectors of random signs, to which every entry contributes: one evaluation, or the difference of
// two, instead of nv.
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "dynamics/checks/measured_error.hpp"
#include "dynamics/checks/plain_equations.hpp"
#include "program/lower.hpp"
#include "support/operation.hpp"

namespace alembert {

/// Errors above it are too large, unless those of the plain equations in double precision are as large.
inline constexpr double kLargestError = 1e-10;
/// Users are told of larger ones.
inline constexpr double kDoubtfulError = 1e-6;

/// For `interpret`: the same on every machine.
double rounded_correctly(Operation op, double a, double b);

class Certificate {
 public:
  /// All must outlive it. `states`: at how many to measure; nothing: at ten, three of very large mechanisms.
  Certificate(const Kinematics& kinematics, const std::vector<SymbolBinding>& bindings,
              std::optional<int> states = {});

  /// The program has all bindings as inputs.
  MeasuredError measure(const Program& program, FunctionKind kind) const;
  /// The same of what computes the arrays of a function, one after another, from values of all bindings.
  using Values = std::function<void(std::span<const double> inputs, std::span<double> found)>;
  MeasuredError measure(std::span<const OutputArray> outputs, FunctionKind kind,
                        const Values& values_of) const;
  /// Whether a measured error needs no explanation.
  static bool is_small(const MeasuredError& error) {
    return error.excesses.empty() && error.without_value.empty();
  }
  /// Whether the plain equations in double precision may have rounding errors as large, and have no values
  /// where the program has none (a function that overflows). Bounds of errors can be far above them: what has
  /// a small error goes before what has an explained one.
  bool explains(const MeasuredError& error, FunctionKind kind) const;

  const PlainEquations& plain() const { return plain_; }

 private:
  /// PlainEquations::inertia of a state, evaluated once for all functions.
  const VectorXe& inertia_at(std::size_t state, FunctionKind kind) const;
  /// A state, its forces in proportion to the inertia: each coordinate is accelerated about as much.
  std::vector<double> values_at(std::size_t state, const VectorXe& inertia) const;

  const Kinematics& kinematics_;
  const std::vector<SymbolBinding>& bindings_;
  PlainEquations plain_;
  int most_;                                 ///< states to measure at
  double work_;                              ///< nodes that may be evaluated for more than the fewest
  std::vector<std::vector<double>> states_;  ///< values of all symbols
  mutable std::map<std::pair<std::size_t, bool>, VectorXe> inertia_;  ///< by state; of constrained motion
};

}  // namespace alembert
