// Expressions of a description as the oracles read them: text in, a tree that evaluates on any scalar type
// out. This reader is written apart from the generator's on purpose: a mistake made once is then not made
// twice.
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <string>
#include <unordered_map>
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
  min,
  max,
  clamp,
  step,
  smoothstep,
  select,
  sign,
  table,
};

/// One node of an expression; shared, immutable.
struct ExpressionNode;
using Expression = std::shared_ptr<const ExpressionNode>;

/// How a table bends between its points.
enum class Fit {
  natural,   ///< a cubic spline without bend at both ends
  straight,  ///< not at all
  simm,  ///< a cubic spline whose third derivative at an end is that of the cubic through the four points there
};

/// Cubic pieces through (knot, value), straight on both sides.
struct Table {
  std::vector<double> knots, values;
  std::vector<double> bends;  ///< second derivatives at the knots

  Table() = default;
  Table(std::vector<double> knots, std::vector<double> values, Fit fit);

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
  std::array<Expression, 3> operand;
  Table table;  ///< of a table, of operand 0
};
using Expression3 = std::array<Expression, 3>;

Expression number(double value);
Expression negated(const Expression& of);
Expression product(const Expression& a, const Expression& b);

/// Parses `text`; `lookup` gives what a name stands for (null: unknown). What is asked of a frame, a path or a
/// coordinate is one name without spaces: d(q), rotation(F).xy, distance(F,G). Throws std::runtime_error.
Expression parse(const std::string& text, const std::function<Expression(const std::string&)>& lookup);

/// True if neither a coordinate nor time is inside.
bool is_constant(const Expression& expression);

template <class S>
S least(const S& a, const S& b) {
  return leading(b) < leading(a) ? b : a;
}
template <class S>
S clamped(const S& x, const S& low, const S& high) {
  return leading(x) < leading(low) ? low : leading(x) > leading(high) ? high : x;
}

template <class S>
class Evaluation;

/// Value of `e` at coordinates `q` and time `t`. Where a function has branches, jets are those of the branch that is
/// taken, and nothing else of a selection is looked at.
template <class S>
S evaluate(const Expression& e, const std::vector<S>& q, const S& t) {
  return Evaluation<S>(q, t)(e);
}

/// One evaluation, which looks once at what stands in several places.
template <class S>
class Evaluation {
 public:
  Evaluation(const std::vector<S>& q, const S& t) : q_(q), t_(t) {}

  S operator()(const Expression& e) {
    if (e.use_count() == 1 || !e->operand[0]) return value(*e);
    const auto known = known_.find(e.get());
    return known != known_.end() ? known->second : known_.emplace(e.get(), value(*e)).first->second;
  }

 private:
  S value(const ExpressionNode& e);

  const std::vector<S>& q_;
  const S& t_;
  std::unordered_map<const ExpressionNode*, S> known_;
};

template <class S>
S Evaluation<S>::value(const ExpressionNode& e) {
  using std::abs, std::acos, std::asin, std::atan, std::atan2, std::cos, std::cosh, std::exp, std::log,
      std::pow, std::sin, std::sinh, std::sqrt, std::tan, std::tanh;
  const auto operand = [&](std::size_t i) { return (*this)(e.operand[i]); };
  switch (e.operation) {
    case Operation::number:
      return S(e.number);
    case Operation::coordinate:
      return q_[static_cast<std::size_t>(e.coordinate)];
    case Operation::time:
      return t_;
    case Operation::add:
      return operand(0) + operand(1);
    case Operation::subtract:
      return operand(0) - operand(1);
    case Operation::multiply:
      return operand(0) * operand(1);
    case Operation::divide:
      return operand(0) / operand(1);
    case Operation::power:
      if (is_constant(e.operand[1]))
        return pow(operand(0), evaluate(e.operand[1], std::vector<double>{}, 0.0));
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
    case Operation::min:
      return least(operand(0), operand(1));
    case Operation::max:
      return -least(S(-operand(0)), S(-operand(1)));
    case Operation::clamp:
      return clamped(operand(0), operand(1), operand(2));
    case Operation::step:
      return S(leading(operand(0)) > 0 ? 1.0 : 0.0);
    case Operation::smoothstep: {
      const S c = clamped(operand(0), S(0.0), S(1.0));
      return c * c * (S(3.0) - S(2.0) * c);
    }
    case Operation::select:
      return leading(operand(0)) > 0 ? operand(1) : operand(2);
    case Operation::sign: {
      const double x = leading(operand(0));
      return S(x > 0 ? 1.0 : x < 0 ? -1.0 : 0.0);
    }
    case Operation::table:
      return e.table.at(operand(0));
  }
  return S(0.0);
}

inline double constant_value(const Expression& e) {
  return evaluate(e, std::vector<double>{}, 0.0);
}

}  // namespace alembert::oracles
