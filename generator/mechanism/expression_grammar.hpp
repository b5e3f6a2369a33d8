// Text of an expression in; its operations in postfix order out, each with the characters it came from.
// Postfix order needs no tree and no recursion to evaluate.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "support/operation.hpp"

namespace alembert {

/// One operation of an expression in postfix order. A reference is `d(NAME)`, `position(NAME)` and the like,
/// with or without `.part`, or `distance(NAME, NAME)`. A spline is any table of knots and values.
struct PostfixToken {
  enum class Kind {
    number,
    name,
    reference,
    call,
    spline,
    add,
    subtract,
    multiply,
    divide,
    power,
    negate,
    group
  };
  Kind kind;
  /// Of the number, name, operator; of a call, spline or reference: its name; of a group: parentheses
  /// included.
  std::size_t begin, end;
  std::size_t close = 0;  ///< of a call, spline or reference: one past its end
  int arguments = 0;      ///< of a call; of a spline: its argument, knots and values together
  int knots = 0;          ///< of a spline
  std::size_t referent = 0, referent_end = 0;  ///< of a reference: the name in parentheses
  std::size_t second = 0, second_end = 0;      ///< of a reference: the second name; 0: there is none
  std::size_t part = 0;  ///< of a reference: the word after its point, 0 if there is none
};

/// A text is no expression. `offset` is where in it, `message` and `note` as InputError's.
struct SyntaxError {
  std::size_t offset;
  std::string message, note;
};

/// Deepest nesting of parentheses, signs and exponents, together.
inline constexpr std::size_t kMaximumExpressionDepth = 100;
inline constexpr std::size_t kMaximumExpressionLength = std::size_t{1} << 20;

/// Parses `text`. Precedence from low to high: + -, * /, sign, ^; ^ is right associative and -x^2 is -(x^2).
/// Throws SyntaxError.
std::vector<PostfixToken> parse_expression(std::string_view text);

/// The operation that an expression may call by this name, if there is one.
std::optional<Operation> function_called(std::string_view name);
/// A function that is made of choices, of which `max(x, y)` is one: not smooth, and its name may name
/// something else as well.
struct ChoosingFunction {
  std::string_view name;
  int arguments;
};
inline constexpr ChoosingFunction kChoosingFunctions[] = {
    {"min", 2}, {"max", 2}, {"clamp", 3}, {"step", 1}, {"smoothstep", 1}, {"select", 3}, {"sign", 1}};
/// How many arguments a function takes; 0: there is no such function.
int function_arity(std::string_view name);
/// The tables of knots and values.
inline constexpr std::string_view kTables[] = {"spline", "simm_spline", "linear"};
/// What may stand before a name in parentheses, besides functions.
inline constexpr std::string_view kReferences[] = {
    "d", "position", "velocity", "rotation", "angular_velocity", "length", "rate", "distance"};
/// Names that mean something in every description: functions, `pi` and `t`.
const std::vector<std::string>& reserved_names();

}  // namespace alembert
