// Functions in expressions, and splines: what they take, where they are defined and smooth, what they build.
#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "mechanism/cubic_spline.hpp"
#include "mechanism/expression_reader.hpp"
#include "mechanism/piecewise_linear.hpp"
#include "mechanism/section.hpp"
#include "support/error.hpp"
#include "symbolic/guarded.hpp"

namespace alembert {
namespace {

constexpr std::size_t kMaximumKnots = 1000;

std::vector<std::string> function_names() {
  std::vector<std::string> names(std::begin(kReferences), std::end(kReferences));
  names.insert(names.end(), std::begin(kTables), std::end(kTables));
  for (const ChoosingFunction& function : kChoosingFunctions) names.emplace_back(function.name);
  for (const OperationFacts& row : kOperationFacts)
    if (row.in_language) names.emplace_back(row.name);
  return names;
}

}  // namespace

ExpressionReader::Operand ExpressionReader::call(const Reading& reading, const PostfixToken& token,
                                                 const std::vector<Operand>& arguments) const {
  const std::string_view function =
      std::string_view(reading.node.text).substr(token.begin, token.end - token.begin);
  const int arity = function_arity(function);
  if (arity == 0) {
    std::string message;
    if (const NameEntry* entry = scope_.find(function); entry != nullptr)
      message = fmt::format("'{}' is {}, not a function", function, a_noun(entry->kind));
    else if (function == "pi" || function == "t")
      message = fmt::format("'{}' is not a function", function);
    else
      message = fmt::format("unknown function '{}'{}", printable(function),
                            did_you_mean(function, function_names()));
    throw error(reading, token.begin, message);
  }
  if (arity != token.arguments)
    throw error(reading, token.begin,
                fmt::format("function '{}' takes {} argument{}, found {}", function, arity,
                            arity == 1 ? "" : "s", token.arguments));
  Operand out{{}, token.begin, token.close};
  bool known = true;
  for (const Operand& argument : arguments) {
    if (reading.allowed == Allowed::pfaffian && includes(argument.value.dependence, Dependence::speed))
      throw not_linear(reading, out, "is a function of speeds");
    known = known && !std::isnan(argument.value.initial);
    out.value.dependence = out.value.dependence | argument.value.dependence;
    if (out.value.roughness == nullptr) out.value.roughness = argument.value.roughness;
  }
  const Operand& x = arguments[0];
  try {
    const Operand& y = arguments.back();
    const bool may_lack_value = reading.may_lack_value(out);
    if (!may_lack_value && function == "atan2" && x.value.initial == 0 && y.value.initial == 0)
      throw error(reading, token.begin,
                  fmt::format("'{}' is undefined{}: both arguments are 0", text_of(reading, out),
                              out.value.dependence == Dependence::none ? "" : " at the initial state"));
    if (!may_lack_value) check_call(reading, function, x, out);
    if (const std::optional<Operation> op = function_called(function)) {
      out.value.initial = apply(*op, x.value.initial, y.value.initial);
      out.value.expr = apply(*op, x.value.expr, y.value.expr);
    } else {
      choose(function, arguments, out);
      // Between values that move, a condition that does not chooses once and for all.
      if (moves(function == "select" ? x.value.dependence : out.value.dependence))
        make_rough(out, fmt::format("'{}', which has a kink or a step", text_of(reading, out)));
    }
  } catch (const std::domain_error&) {
    throw error(reading, token.begin, fmt::format("'{}' has no finite value", text_of(reading, out)));
  }
  if (!std::isfinite(out.value.initial) && reading.may_lack_value(out))
    out.value.initial = std::numeric_limits<double>::quiet_NaN();
  else if (!std::isfinite(out.value.initial) && known)
    throw error(reading, token.begin,
                fmt::format("'{}' has no finite value{}", text_of(reading, out),
                            out.value.dependence == Dependence::none ? "" : " at the initial state"));
  return out;
}

void ExpressionReader::check_call(const Reading& reading, std::string_view function, const Operand& x,
                                  Operand& result) const {
  const double u = x.value.initial;
  const char* when = x.value.dependence == Dependence::none ? "" : " at the initial state";
  const auto refuse = [&](std::string_view of) {
    return error(reading, x.begin, fmt::format("{}: '{}' is {:.6g}{}", of, text_of(reading, x), u, when));
  };
  const bool moving = moves(x.value.dependence);
  if (function == "sqrt") {
    if (u < 0) throw refuse("sqrt of a negative number");
    if (u == 0 && moving)
      make_rough(result,
                 fmt::format("'{}', whose argument is 0 at the initial state", text_of(reading, result)));
  } else if (function == "log") {
    if (u == 0) throw refuse("log of zero");
    if (u < 0) throw refuse("log of a negative number");
  } else if (function == "asin" || function == "acos") {
    if (std::abs(u) > 1) throw refuse(fmt::format("{} of a number outside [-1, 1]", function));
    if (std::abs(u) == 1 && moving)
      make_rough(result, fmt::format("'{}', whose argument is {:.6g} at the initial state",
                                     text_of(reading, result), u));
  } else if (function == "abs" && moving && result.value.roughness == nullptr) {
    const Interval bounds = graph_.bounds(x.value.expr.ref());
    if (bounds.lower < 0 && bounds.upper > 0)
      make_rough(result, fmt::format("'{}', whose argument may change its sign", text_of(reading, result)));
  }
}

namespace {

/// The functions that are made of choices, of numbers and of expressions.
template <class X>
X chosen(std::string_view function, const X& zero, const X& one, const std::vector<X>& x) {
  const auto select = [](const X& c, const X& a, const X& b) {
    return if_positive(c, a) + unless_positive(c, b);
  };
  const auto clamp = [&](const X& value, const X& lower, const X& upper) {
    const X below = select(upper - value, value, upper);
    return select(lower - value, lower, below);
  };
  if (function == "select") return select(x[0], x[1], x[2]);
  if (function == "min") return select(x[1] - x[0], x[0], x[1]);
  if (function == "max") return select(x[0] - x[1], x[0], x[1]);
  if (function == "clamp") return clamp(x[0], x[1], x[2]);
  if (function == "step") return if_positive(x[0], one);
  if (function == "sign") {
    const X below = -x[0];
    return if_positive(x[0], one) - if_positive(below, one);
  }
  if (function == "smoothstep") {
    const X c = clamp(x[0], zero, one);
    return c * c * (one + one + one - (one + one) * c);
  }
  throw InternalError("there is no function of choices by this name");
}

}  // namespace

void ExpressionReader::choose(std::string_view function, const std::vector<Operand>& arguments,
                              Operand& result) {
  std::vector<double> numbers;
  std::vector<Expr> values;
  for (const Operand& argument : arguments) {
    numbers.push_back(argument.value.initial);
    values.push_back(argument.value.expr);
  }
  ExprGraph& graph = values.front().graph();
  if (function == "select") {
    values[1] = guarded(Operation::if_positive, values[0], values[1]);
    values[2] = guarded(Operation::unless_positive, values[0], values[2]);
  }
  result.value.initial = chosen<double>(function, 0, 1, numbers);
  result.value.expr = chosen<Expr>(function, graph.zero(), graph.integer(1), values);
}

ExpressionReader::Operand ExpressionReader::table(const Reading& reading, const PostfixToken& token,
                                                  const std::vector<Operand>& operands) const {
  Operand out{operands[0].value, token.begin, token.close};
  const std::string_view kind =
      std::string_view(reading.node.text).substr(token.begin, token.end - token.begin);
  if (reading.allowed == Allowed::pfaffian && includes(out.value.dependence, Dependence::speed))
    throw not_linear(reading, out, "is a function of speeds");
  const auto knot_count = static_cast<std::size_t>(token.knots);
  const std::size_t value_count = operands.size() - 1 - knot_count;
  if (knot_count != value_count)
    throw error(
        reading, token.begin,
        fmt::format("{} with {} knot{} and {} value{}; expected one value for each knot", kind, knot_count,
                    knot_count == 1 ? "" : "s", value_count, value_count == 1 ? "" : "s"));
  if (knot_count < 2 || knot_count > kMaximumKnots)
    throw error(reading, token.begin,
                fmt::format("{} with {} knot{}; expected from 2 to {}", kind, knot_count,
                            knot_count == 1 ? "" : "s", kMaximumKnots));
  std::vector<ConstantNumber> numbers;
  for (std::size_t i = 1; i < operands.size(); ++i) {
    const Operand& number = operands[i];
    const bool knot = i <= knot_count;
    if (number.value.dependence != Dependence::none)
      throw error(reading, number.begin,
                  fmt::format("expected a constant as a {} of {} {}, found '{}'", knot ? "knot" : "value",
                              kind == "linear" ? "the table" : "a", kind, text_of(reading, number)),
                  "numbers, pi and parameters that are folded in are constants");
    if (knot && i > 1 && !(number.value.initial > numbers.back().value))
      throw error(reading, number.begin,
                  fmt::format("expected knots that increase; knot {} is {:.9g}, after {:.9g}", i,
                              number.value.initial, numbers.back().value));
    numbers.push_back({number.value.expr, number.value.initial});
  }
  try {
    const std::span<const ConstantNumber> all(numbers);
    const auto use = [&](const auto& curve) {
      out.value.expr = curve(operands[0].value.expr);
      out.value.initial = curve(operands[0].value.initial);
    };
    if (kind != "linear") {
      use(CubicSpline(kind == "spline" ? SplineEnds::natural : SplineEnds::fitted_cubic,
                      all.first(knot_count), all.subspan(knot_count)));
    } else {
      use(PiecewiseLinear(all.first(knot_count), all.subspan(knot_count)));
      if (moves(out.value.dependence))
        make_rough(out, fmt::format("'{}', whose pieces meet with a kink", text_of(reading, out)));
    }
  } catch (const std::domain_error&) {
    throw error(reading, token.begin, fmt::format("the coefficients of this {} are out of range", kind));
  }
  if (!std::isfinite(out.value.initial) && !std::isnan(operands[0].value.initial))
    throw error(reading, token.begin,
                fmt::format("'{}' has no finite value{}", text_of(reading, out),
                            out.value.dependence == Dependence::none ? "" : " at the initial state"));
  return out;
}

}  // namespace alembert
