// Expressions of a description as the oracles read them: text in, a tree that evaluates on any scalar type
// out. This reader is written apart from the generator's on purpose: a mistake made once is then not made
// twice.
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "oracles/taylor/jet.hpp"

namespace alembert::oracles {

enum class Operation {
  number,
  coordinate,
  time,
  add,
  subtract,
  multiply,
  divide,
  power,
  negate,
  sin,
  cos,
  tan,
  asin,
  acos,
  atan,
  atan2,
  sqrt,
  exp,
  log,
  abs,
  sinh,
  cosh,
  tanh,
  spline,
};

/// One node of an expression; shared, immutable.
struct ExpressionNode;
using Expression = std::shared_ptr<const ExpressionNode>;

/// Natural cubic spline through (knot, value), straight on both sides.
struct Spline {
  std::vector<double> knots, values;
  std::vector<double> bends;  ///< second derivatives at the knots, 0 at the first and the last

  Spline() = default;
  Spline(std::vector<double> knots, std::vector<double> values);

  /// Between two knots the line through their values, and what the bends add to it.
  template <class S>
  S at(const S& x) const {
    const double where = leading(x);
    const std::size_t last = knots.size() - 1;
    std::size_t i = 0;
    while (i + 1 < last && where >= knots[i + 1]) ++i;
    const double length = knots[i + 1] - knots[i], slope = (values[i + 1] - values[i]) / length;
    const double bend = bends[i], next = bends[i + 1];
    if (where < knots[0]) return S(values[0]) + S(slope - length / 6 * (2 * bend + next)) * (x - S(knots[0]));
    if (where > knots[last])
      return S(values[last]) + S(slope + length / 6 * (bend + 2 * next)) * (x - S(knots[last]));
    const S left = x - S(knots[i]), right = S(knots[i + 1]) - x;
    return S(values[i]) + S(slope) * left -
           left * right *
               (S(bend / (6 * length)) * (right + S(length)) + S(next / (6 * length)) * (left + S(length)));
  }
};

struct ExpressionNode {
  Operation operation = Operation::number;
  double number = 0;   ///< of a number
  int coordinate = 0;  ///< of a coordinate: index into q (of a constraint's: into all its variables)
  std::array<Expression, 2> operand;
  Spline spline;  ///< of a spline, of operand 0
};
using Expression3 = std::array<Expression, 3>;

Expression number(double value);
Expression negated(const Expression& of);
Expression product(const Expression& a, const Expression& b);

/// Parses `text`; `lookup` gives what a name stands for (null: unknown). Throws std::runtime_error.
Expression parse(const std::string& text, const std::function<Expression(const std::string&)>& lookup);

/// True if neither a coordinate nor time is inside.
bool is_constant(const Expression& expression);

/// Value of `e` at coordinates `q` and time `t`.
template <class S>
S evaluate(const Expression& e, const std::vector<S>& q, const S& t) {
  using std::abs, std::acos, std::asin, std::atan, std::atan2, std::cos, std::cosh, std::exp, std::log,
      std::pow, std::sin, std::sinh, std::sqrt, std::tan, std::tanh;
  const auto operand = [&](std::size_t i) { return evaluate(e->operand[i], q, t); };
  switch (e->operation) {
    case Operation::number:
      return S(e->number);
    case Operation::coordinate:
      return q[static_cast<std::size_t>(e->coordinate)];
    case Operation::time:
      return t;
    case Operation::add:
      return operand(0) + operand(1);
    case Operation::subtract:
      return operand(0) - operand(1);
    case Operation::multiply:
      return operand(0) * operand(1);
    case Operation::divide:
      return operand(0) / operand(1);
    case Operation::power:
      if (is_constant(e->operand[1]))
        return pow(operand(0), evaluate(e->operand[1], std::vector<double>{}, 0.0));
      return exp(operand(1) * log(operand(0)));
    case Operation::negate:
      return -operand(0);
    case Operation::sin:
      return sin(operand(0));
    case Operation::cos:
      return cos(operand(0));
    case Operation::tan:
      return tan(operand(0));
    case Operation::asin:
      return asin(operand(0));
    case Operation::acos:
      return acos(operand(0));
    case Operation::atan:
      return atan(operand(0));
    case Operation::atan2:
      return atan2(operand(0), operand(1));
    case Operation::sqrt:
      return sqrt(operand(0));
    case Operation::exp:
      return exp(operand(0));
    case Operation::log:
      return log(operand(0));
    case Operation::abs:
      return abs(operand(0));
    case Operation::sinh:
      return sinh(operand(0));
    case Operation::cosh:
      return cosh(operand(0));
    case Operation::tanh:
      return tanh(operand(0));
    case Operation::spline:
      return e->spline.at(operand(0));
  }
  return S(0.0);
}

inline double constant_value(const Expression& e) {
  return evaluate(e, std::vector<double>{}, 0.0);
}

}  // namespace alembert::oracles
