// The table of operations: what is known of each stands in its row and nowhere else. Expressions, programs,
// counting, differentiation, proofs and printers take it from here, so an operation that has a row works
// everywhere, and new names, languages or weights are columns.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string_view>
#include <tuple>
#include <utility>

#include "support/interval.hpp"

namespace alembert {

/// Leaves first. Nodes of expressions have signs, and no `sub` and `neg`; their operands are told at each.
enum class Operation : std::uint8_t {
  rational,     ///< expressions: exact rational constant >= 0
  pi_multiple,  ///< expressions: exact rational > 0 times pi
  real,         ///< double constant; in expressions > 0, and only where a rational overflows
  symbol,       ///< variable; in programs an input
  add,          ///< a + b; in expressions a is unsigned, b may carry a sign
  mul,          ///< a * b; in expressions both unsigned, a constant factor first
  div,          ///< a / b; in expressions both unsigned
  sqrt,
  sin,
  cos,
  tan,
  asin,
  acos,
  atan,
  atan2,
  exp,
  log,
  abs,
  sign,
  sinh,
  cosh,
  tanh,
  pow,              ///< a^b where b is no integer (integers become products)
  if_positive,      ///< b where a > 0, else 0, whatever b is there
  unless_positive,  ///< 0 where a > 0, else b
  rounding,         ///< a times the epsilon of the type that computes: 2^-52, in float 2^-23
  sub,              ///< programs: a - b
  neg,              ///< programs: -a
  constant = real,
  input = symbol,
};
inline constexpr std::size_t kOperations = static_cast<std::size_t>(Operation::neg) + 1;

/// How f(-x) relates to f(x), for functions of one operand.
enum class Parity { odd, even, none };

/// What an operation is counted as.
enum class Counted { free, add, mul, div, trig, other };

/// Its value in a finite field: exact, by the rational parametrisation of the circle or of the hyperbola, or
/// a hash of the operands that keeps the parity. What is chosen is linear in what there is to choose.
enum class FieldValue {
  exact,
  sine,
  cosine,
  tangent,
  hyperbolic_sine,
  hyperbolic_cosine,
  hyperbolic_tangent,
  opaque,
  chosen  ///< the second operand times a hash h of the first, or times 1 - h
};

/// A computed value and a bound on its distance to the exact value, to first order.
struct Approximate {
  double value = 0;
  double error = 0;
};

struct OperationFacts {
  Operation operation;
  std::string_view name;  ///< as it is written: the sign of + - * / and negation, the name of a function
  int operands;           ///< that are values of other instructions or nodes
  Counted counted = Counted::free;
  unsigned weight = 0;   ///< about the time it takes, in additions
  double roundings = 1;  ///< of its value, in half units in the last place; those of the C library have a few
  bool in_language = false;  ///< a function that descriptions may call by this name
  Parity parity = Parity::none;
  FieldValue field = FieldValue::exact;
};

/// -1, 0 or 1.
template <class Real>
Real sign_of(const Real& x) {
  return Real((x > 0 ? 1 : 0) - (x < 0 ? 1 : 0));
}

/// `x` where c > 0, else 0; and the other way round. Without a branch where the compiler can.
template <class Real>
Real if_positive(const Real& c, const Real& x) {
  return c > 0 ? x : Real(0);
}
template <class Real>
Real unless_positive(const Real& c, const Real& x) {
  return c > 0 ? Real(0) : x;
}

/// What one rounding of x may be, with the sign of x. Expressions are of double precision wherever they are evaluated.
template <class Real>
Real rounding(const Real& x) {
  return x * Real(std::numeric_limits<double>::epsilon());
}

/// The rows. `value(a, b)` in any arithmetic that has the functions of <cmath>; `partial(one, a, b, v, slot)`
/// for v = value(a, b), by a (slot 0) or b (slot 1), of anything that has the operations; `bounds(a, b)` of
/// intervals; `carried(a, b, v)`: what errors of the operands become through the derivative, infinite where
/// the operation is not continuous within them. Functions of one operand do not read b.
namespace rows {

inline constexpr double kInfinite = std::numeric_limits<double>::infinity();
inline constexpr unsigned kDivision = 4, kRoot = 5, kFunction = 12, kChoice = 2;
inline constexpr double kFunctionRoundings =
    4;  // functions of the C library are within a few units in the last place

/// A function of the C library.
constexpr OperationFacts library(Operation op, std::string_view name, Parity parity, FieldValue field,
                                 int operands = 1, bool in_language = true) {
  const bool trig = field == FieldValue::sine || field == FieldValue::cosine || field == FieldValue::tangent;
  return {op,          name,   operands, trig ? Counted::trig : Counted::other, kFunction, kFunctionRoundings,
          in_language, parity, field};
}

using interval::down, interval::up, interval::widened;
using std::abs, std::acos, std::asin, std::atan, std::atan2, std::cos, std::cosh, std::exp, std::log,
    std::pow, std::sin, std::sinh, std::sqrt, std::tan, std::tanh;

struct Leaf {
  static auto value(const auto& a, const auto&) { return a; }
  static auto partial(const auto& one, const auto&, const auto&, const auto&, int) { return one; }
  static Interval bounds(Interval, Interval) { return interval::kWhole; }
  static double carried(Approximate, Approximate, double) { return 0; }
};
struct RationalLeaf : Leaf {
  static constexpr OperationFacts facts{Operation::rational, "", 0};
};
struct PiMultipleLeaf : Leaf {
  static constexpr OperationFacts facts{Operation::pi_multiple, "", 0};
};
struct RealLeaf : Leaf {
  static constexpr OperationFacts facts{Operation::real, "", 0};
};
struct SymbolLeaf : Leaf {
  static constexpr OperationFacts facts{Operation::symbol, "", 0, Counted::free, 0, 0};
};

struct Add {
  static constexpr OperationFacts facts{Operation::add, "+", 2, Counted::add, 1};
  static auto value(const auto& a, const auto& b) { return a + b; }
  static auto partial(const auto& one, const auto&, const auto&, const auto&, int) { return one; }
  static Interval bounds(Interval a, Interval b) { return interval::sum(a, b); }
  static double carried(Approximate a, Approximate b, double) { return a.error + b.error; }
};
struct Sub {
  static constexpr OperationFacts facts{Operation::sub, "-", 2, Counted::add, 1};
  static auto value(const auto& a, const auto& b) { return a - b; }
  static auto partial(const auto& one, const auto&, const auto&, const auto&, int slot) {
    return slot == 0 ? one : -one;
  }
  static Interval bounds(Interval a, Interval b) { return interval::sum(a, interval::negated(b)); }
  static double carried(Approximate a, Approximate b, double) { return a.error + b.error; }
};
struct Mul {
  static constexpr OperationFacts facts{Operation::mul, "*", 2, Counted::mul, 1};
  static auto value(const auto& a, const auto& b) { return a * b; }
  static auto partial(const auto&, const auto& a, const auto& b, const auto&, int slot) {
    return slot == 0 ? b : a;
  }
  static Interval bounds(Interval a, Interval b) { return interval::product(a, b); }
  static double carried(Approximate a, Approximate b, double) {
    return std::abs(a.value) * b.error + std::abs(b.value) * a.error + a.error * b.error;
  }
};
struct Div {
  static constexpr OperationFacts facts{Operation::div, "/", 2, Counted::div, kDivision};
  static auto value(const auto& a, const auto& b) { return a / b; }
  static auto partial(const auto& one, const auto&, const auto& b, const auto& v, int slot) {
    const auto reciprocal = one / b;  // serves both slots, and v is there already
    return slot == 0 ? reciprocal : -(v * reciprocal);
  }
  static Interval bounds(Interval a, Interval b) { return interval::product(a, interval::reciprocal(b)); }
  static double carried(Approximate a, Approximate b, double v) {
    const double divisor = std::abs(b.value) - b.error;
    return divisor > 0 ? (a.error + std::abs(v) * b.error) / divisor : kInfinite;
  }
};
struct Neg {
  static constexpr OperationFacts facts{Operation::neg, "-", 1, Counted::free, 0, 0, false, Parity::odd};
  static auto value(const auto& a, const auto&) { return -a; }
  static auto partial(const auto& one, const auto&, const auto&, const auto&, int) { return -one; }
  static Interval bounds(Interval a, Interval) { return interval::negated(a); }
  static double carried(Approximate a, Approximate, double) { return a.error; }
};

struct Sqrt {
  static constexpr OperationFacts facts{Operation::sqrt, "sqrt", 1, Counted::other, kRoot, 1, true};
  static auto value(const auto& a, const auto&) { return sqrt(a); }
  static auto partial(const auto& one, const auto&, const auto&, const auto& v, int) {
    return one / ((one + one) * v);
  }
  static Interval bounds(Interval a, Interval) { return interval::root(a); }
  static double carried(Approximate a, Approximate, double v) {
    return a.error == 0 ? 0 : a.value > a.error ? a.error / v : kInfinite;
  }
};
struct Sin {
  static constexpr OperationFacts facts = library(Operation::sin, "sin", Parity::odd, FieldValue::sine);
  static auto value(const auto& a, const auto&) { return sin(a); }
  static auto partial(const auto&, const auto& a, const auto&, const auto&, int) { return cos(a); }
  static Interval bounds(Interval a, Interval) { return interval::wave(false, a); }
  static double carried(Approximate a, Approximate, double) { return a.error; }
};
struct Cos {
  static constexpr OperationFacts facts = library(Operation::cos, "cos", Parity::even, FieldValue::cosine);
  static auto value(const auto& a, const auto&) { return cos(a); }
  static auto partial(const auto&, const auto& a, const auto&, const auto&, int) { return -sin(a); }
  static Interval bounds(Interval a, Interval) { return interval::wave(true, a); }
  static double carried(Approximate a, Approximate, double) { return a.error; }
};
struct Tan {
  static constexpr OperationFacts facts = library(Operation::tan, "tan", Parity::odd, FieldValue::tangent);
  static auto value(const auto& a, const auto&) { return tan(a); }
  static auto partial(const auto& one, const auto&, const auto&, const auto& v, int) { return one + v * v; }
  static Interval bounds(Interval a, Interval) {
    // The pole of a branch lies half a period from its centre; only one branch is looked at.
    return a.lower > -1.57 && a.upper < 1.57 ? widened(std::tan(a.lower), std::tan(a.upper))
                                             : interval::kWhole;
  }
  static double carried(Approximate a, Approximate, double v) {
    return std::abs(v) * a.error < 0.5 ? 2 * a.error * (1 + v * v) : kInfinite;
  }
};
struct Asin {
  static constexpr OperationFacts facts = library(Operation::asin, "asin", Parity::odd, FieldValue::opaque);
  static auto value(const auto& a, const auto&) { return asin(a); }
  static auto partial(const auto& one, const auto& a, const auto&, const auto&, int) {
    return one / sqrt(one - a * a);
  }
  static Interval bounds(Interval a, Interval) {
    return widened(std::asin(a.lower > -1 ? a.lower : -1), std::asin(a.upper < 1 ? a.upper : 1));
  }
  static double carried(Approximate a, Approximate, double) {
    const double x = std::abs(a.value) + a.error;
    return a.error == 0 ? 0 : x < 1 ? a.error / std::sqrt(1 - x * x) : kInfinite;
  }
};
struct Acos {
  static constexpr OperationFacts facts = library(Operation::acos, "acos", Parity::none, FieldValue::opaque);
  static auto value(const auto& a, const auto&) { return acos(a); }
  static auto partial(const auto& one, const auto& a, const auto&, const auto&, int) {
    return -(one / sqrt(one - a * a));
  }
  static Interval bounds(Interval a, Interval) {
    const Interval range =
        widened(std::acos(a.upper < 1 ? a.upper : 1), std::acos(a.lower > -1 ? a.lower : -1));
    return {range.lower > 0 ? range.lower : 0, range.upper};
  }
  static double carried(Approximate a, Approximate b, double v) { return Asin::carried(a, b, v); }
};
struct Atan {
  static constexpr OperationFacts facts = library(Operation::atan, "atan", Parity::odd, FieldValue::opaque);
  static auto value(const auto& a, const auto&) { return atan(a); }
  static auto partial(const auto& one, const auto& a, const auto&, const auto&, int) {
    return one / (one + a * a);
  }
  static Interval bounds(Interval a, Interval) { return widened(std::atan(a.lower), std::atan(a.upper)); }
  static double carried(Approximate a, Approximate, double) {
    const double x = std::abs(a.value) - a.error;
    return x > 0 ? a.error / (1 + x * x) : a.error;
  }
};
struct Atan2 {
  static constexpr OperationFacts facts =
      library(Operation::atan2, "atan2", Parity::none, FieldValue::opaque, 2);
  static auto value(const auto& a, const auto& b) { return atan2(a, b); }
  static auto partial(const auto&, const auto& a, const auto& b, const auto&, int slot) {
    const auto a_squared = a * a;
    const auto b_squared = b * b;
    const auto squared_radius = a_squared + b_squared;
    return slot == 0 ? b / squared_radius : -(a / squared_radius);
  }
  static Interval bounds(Interval a, Interval) {
    return {a.lower >= 0 ? 0 : -up(interval::kPi), up(interval::kPi)};
  }
  static double carried(Approximate a, Approximate b, double) {
    // The half line b < 0, a = 0 is a cut; -0 is 0 here.
    if (b.value <= b.error && std::abs(a.value) <= a.error) return kInfinite;
    const double radius = std::hypot(a.value, b.value) - std::hypot(a.error, b.error);
    return radius > 0 ? std::hypot(a.error, b.error) / radius : kInfinite;
  }
};
struct Exp {
  static constexpr OperationFacts facts = library(Operation::exp, "exp", Parity::none, FieldValue::opaque);
  static auto value(const auto& a, const auto&) { return exp(a); }
  static auto partial(const auto&, const auto&, const auto&, const auto& v, int) { return v; }
  static Interval bounds(Interval a, Interval) {
    const double lower = down(down(std::exp(a.lower)));
    return {lower > 0 ? lower : 0, up(up(std::exp(a.upper)))};
  }
  static double carried(Approximate a, Approximate, double v) {
    return a.error < 0.5 ? 2 * std::abs(v) * a.error : kInfinite;
  }
};
struct Log {
  static constexpr OperationFacts facts = library(Operation::log, "log", Parity::none, FieldValue::opaque);
  static auto value(const auto& a, const auto&) { return log(a); }
  static auto partial(const auto& one, const auto& a, const auto&, const auto&, int) { return one / a; }
  static Interval bounds(Interval a, Interval) {
    return widened(a.lower > 0 ? std::log(a.lower) : -kInfinite, a.upper > 0 ? std::log(a.upper) : kInfinite);
  }
  static double carried(Approximate a, Approximate, double) {
    return a.error == 0 ? 0 : a.value > a.error ? a.error / (a.value - a.error) : kInfinite;
  }
};
struct Abs {
  static constexpr OperationFacts facts{
      Operation::abs, "abs", 1, Counted::other, kRoot, 0, true, Parity::even, FieldValue::opaque};
  static auto value(const auto& a, const auto&) { return abs(a); }
  static auto partial(const auto&, const auto& a, const auto&, const auto&, int) { return sign(a); }
  static Interval bounds(Interval a, Interval) { return interval::absolute(a); }
  static double carried(Approximate a, Approximate, double) { return a.error; }
};
struct Sign {
  static constexpr OperationFacts facts{
      Operation::sign, "sign", 1, Counted::other, kRoot, 0, false, Parity::odd, FieldValue::opaque};
  static auto value(const auto& a, const auto&) { return sign_of(a); }
  static auto partial(const auto& one, const auto&, const auto&, const auto&, int) { return one - one; }
  static Interval bounds(Interval a, Interval) {
    return {a.lower > 0 ? 1.0 : a.lower >= 0 ? 0.0 : -1.0, a.upper < 0 ? -1.0 : a.upper <= 0 ? 0.0 : 1.0};
  }
  static double carried(Approximate a, Approximate, double) {
    return a.error == 0 || std::abs(a.value) > a.error ? 0 : kInfinite;
  }
};
struct Sinh {
  static constexpr OperationFacts facts =
      library(Operation::sinh, "sinh", Parity::odd, FieldValue::hyperbolic_sine);
  static auto value(const auto& a, const auto&) { return sinh(a); }
  static auto partial(const auto&, const auto& a, const auto&, const auto&, int) { return cosh(a); }
  static Interval bounds(Interval a, Interval) { return widened(std::sinh(a.lower), std::sinh(a.upper)); }
  static double carried(Approximate a, Approximate, double) {
    return a.error < 0.5 ? 2 * a.error * std::cosh(a.value) : kInfinite;
  }
};
struct Cosh {
  static constexpr OperationFacts facts =
      library(Operation::cosh, "cosh", Parity::even, FieldValue::hyperbolic_cosine);
  static auto value(const auto& a, const auto&) { return cosh(a); }
  static auto partial(const auto&, const auto& a, const auto&, const auto&, int) { return sinh(a); }
  static Interval bounds(Interval a, Interval) {
    const Interval size = interval::absolute(a);
    const double lower = down(down(std::cosh(size.lower)));
    return {lower > 1 ? lower : 1, up(up(std::cosh(size.upper)))};
  }
  static double carried(Approximate a, Approximate b, double v) { return Sinh::carried(a, b, v); }
};
struct Tanh {
  static constexpr OperationFacts facts =
      library(Operation::tanh, "tanh", Parity::odd, FieldValue::hyperbolic_tangent);
  static auto value(const auto& a, const auto&) { return tanh(a); }
  static auto partial(const auto& one, const auto&, const auto&, const auto& v, int) { return one - v * v; }
  static Interval bounds(Interval a, Interval) {
    const double lower = down(down(std::tanh(a.lower))), upper = up(up(std::tanh(a.upper)));
    return {lower > -1 ? lower : -1, upper < 1 ? upper : 1};
  }
  static double carried(Approximate a, Approximate, double) { return a.error; }
};
struct Pow {
  static constexpr OperationFacts facts =
      library(Operation::pow, "pow", Parity::none, FieldValue::opaque, 2, false);
  static auto value(const auto& a, const auto& b) { return pow(a, b); }
  static auto partial(const auto& one, const auto& a, const auto& b, const auto& v, int slot) {
    if (slot == 0) return b * pow(a, b - one);  // rather than b v / a: right at a = 0 too
    return v * log(a);
  }
  static Interval bounds(Interval a, Interval b) { return interval::power(a, b); }
  static double carried(Approximate a, Approximate b, double v) {
    if (a.error == 0 && b.error == 0) return 0;
    const double base = a.value - a.error;
    if (!(base > 0)) return kInfinite;
    const double relative = std::abs(b.value) * a.error / base + std::abs(std::log(a.value)) * b.error;
    return relative < 0.5 ? 2 * relative * std::abs(v) : kInfinite;
  }
};

struct Rounding {
  static constexpr OperationFacts facts{
      Operation::rounding, "rounding", 1, Counted::other, 1, 0, false, Parity::odd, FieldValue::opaque};
  static auto value(const auto& a, const auto&) { return rounding(a); }
  static auto partial(const auto& one, const auto&, const auto&, const auto&, int) { return rounding(one); }
  static Interval bounds(Interval a, Interval) { return {down(rounding(a.lower)), up(rounding(a.upper))}; }
  static double carried(Approximate a, Approximate, double) { return rounding(a.error); }
};

constexpr OperationFacts choice(Operation op, std::string_view name) {
  return {op, name, 2, Counted::other, kChoice, 0, false, Parity::none, FieldValue::chosen};
}
constexpr bool is_decided(Approximate condition) {
  return condition.error == 0 || condition.value > condition.error || condition.value < -condition.error;
}
/// b where a > 0 if `positive`, elsewhere if not; 0 on the other side.
template <bool positive>
struct Choice {
  static constexpr OperationFacts facts = positive ? choice(Operation::if_positive, "if_positive")
                                                   : choice(Operation::unless_positive, "unless_positive");
  static auto value(const auto& a, const auto& b) {
    if constexpr (positive)
      return if_positive(a, b);
    else
      return unless_positive(a, b);
  }
  static auto partial(const auto& one, const auto& a, const auto&, const auto&, int slot) {
    return slot == 0 ? one - one : value(a, one);
  }
  static Interval bounds(Interval a, Interval b) {
    if (a.lower > 0) return positive ? b : Interval{0, 0};
    if (a.upper <= 0) return positive ? Interval{0, 0} : b;
    return interval::with_zero(b);
  }
  static double carried(Approximate a, Approximate b, double) {
    if (is_decided(a)) return (a.value > 0) == positive ? b.error : 0;
    return std::abs(b.value) + b.error;
  }
};
using IfPositive = Choice<true>;
using UnlessPositive = Choice<false>;

/// Those that most steps are come first.
using All = std::tuple<Mul, Add, Sub, Neg, Div, Sin, Cos, SymbolLeaf, RealLeaf, RationalLeaf, PiMultipleLeaf,
                       Sqrt, Tan, Asin, Acos, Atan, Atan2, Exp, Log, Abs, Sign, Sinh, Cosh, Tanh, Pow,
                       IfPositive, UnlessPositive, Rounding>;

template <class Result, class Use, class... Rows>
constexpr Result use(Operation op, Result otherwise, const Use& with, std::tuple<Rows...>*) {
  Result result = std::move(otherwise);
  static_cast<void>(((op == Rows::facts.operation && (result = with(Rows{}), true)) || ...));
  return result;
}

}  // namespace rows

/// `with(row)` for the row of an operation.
template <class Result, class Use>
constexpr Result use_row(Operation op, Result otherwise, const Use& with) {
  return rows::use(op, std::move(otherwise), with, static_cast<rows::All*>(nullptr));
}

inline constexpr auto kOperationFacts = [] {
  static_assert(std::tuple_size_v<rows::All> == kOperations);
  std::array<OperationFacts, kOperations> table{};
  for (std::size_t i = 0; i < kOperations; ++i)
    table[i] = use_row(static_cast<Operation>(i), OperationFacts{}, [](auto row) { return row.facts; });
  return table;
}();
constexpr const OperationFacts& facts(Operation op) {
  return kOperationFacts[static_cast<std::size_t>(op)];
}

/// Number of operands that are values of other instructions (0 for constants and inputs).
constexpr int operand_count(Operation op) {
  return facts(op).operands;
}
constexpr Parity parity(Operation op) {
  return facts(op).parity;
}
/// How an operation is written, in C++, in descriptions and in dumps; empty for constants and inputs.
constexpr std::string_view operation_name(Operation op) {
  return facts(op).name;
}
/// sin, cos and tan: the calls that the counting convention lists apart.
constexpr bool is_trigonometric(Operation op) {
  return facts(op).counted == Counted::trig;
}
/// True for constants and inputs.
constexpr bool is_leaf(Operation op) {
  return operand_count(op) == 0;
}
/// True for what is written as a call: sin(x), not a + b.
constexpr bool is_call(Operation op) {
  return facts(op).counted == Counted::trig || facts(op).counted == Counted::other;
}

/// True for a choice between an operand and 0.
constexpr bool is_choice(Operation op) {
  return facts(op).field == FieldValue::chosen;
}

/// True for what the C library computes, whose rounding differs between machines; the others are rounded
/// correctly.
constexpr bool is_of_library(Operation op) {
  return facts(op).roundings > 1;
}

/// Value of an operation on `a` (and `b`); constants and inputs have none here and give `a`.
template <class Real>
Real apply(Operation op, const Real& a, const Real& b) {
  return use_row(op, a, [&](auto row) { return Real(row.value(a, b)); });
}

/// The partial derivative of v = op(a, b) by a (slot 0) or b (slot 1).
template <class X>
X partial_derivative(Operation op, const X& one, const X& a, const X& b, const X& v, int slot) {
  return use_row(op, one, [&](auto row) { return row.partial(one, a, b, v, slot); });
}

/// An interval that holds op(a, b) for operands in these.
Interval bounds_of(Operation op, Interval a, Interval b);

/// Half the distance from 1 to the next double.
inline constexpr double kUnitRoundoff = 0x1p-53;

/// Error of `result` = op(a, b): that of the operands carried through the derivative, and the operation's own
/// rounding. Infinite where the operation is not continuous within the errors of its operands. Source: N. J.
/// Higham, Accuracy and Stability of Numerical Algorithms, 2nd ed., section 3.3 (running error analysis).
double error_bound(Operation op, Approximate a, Approximate b, double result);

}  // namespace alembert
