// What each operation of a program means: its number of operands, its parity, its name and its value. In: an
// operation and operands. Out: one correctly rounded step, the same that the emitted code takes.
#pragma once

#include <cmath>
#include <string_view>

#include "program/program.hpp"

namespace alembert {

/// Number of operands that are values of other instructions (0 for constants and inputs).
constexpr int operand_count(Operation op) {
  switch (op) {
    case Operation::constant:
    case Operation::input:
      return 0;
    case Operation::add:
    case Operation::sub:
    case Operation::mul:
    case Operation::div:
    case Operation::atan2:
    case Operation::pow:
      return 2;
    case Operation::neg:
    case Operation::sqrt:
    case Operation::sin:
    case Operation::cos:
    case Operation::tan:
    case Operation::asin:
    case Operation::acos:
    case Operation::atan:
    case Operation::exp:
    case Operation::log:
    case Operation::abs:
    case Operation::sign:
    case Operation::sinh:
    case Operation::cosh:
    case Operation::tanh:
      return 1;
  }
  return 0;
}

/// How f(-x) relates to f(x), for functions of one operand.
enum class Parity { odd, even, none };

constexpr Parity parity(Operation op) {
  switch (op) {
    case Operation::neg:
    case Operation::sin:
    case Operation::tan:
    case Operation::asin:
    case Operation::atan:
    case Operation::sign:
    case Operation::sinh:
    case Operation::tanh:
      return Parity::odd;
    case Operation::cos:
    case Operation::abs:
    case Operation::cosh:
      return Parity::even;
    case Operation::constant:
    case Operation::input:
    case Operation::add:
    case Operation::sub:
    case Operation::mul:
    case Operation::div:
    case Operation::sqrt:
    case Operation::acos:
    case Operation::atan2:
    case Operation::exp:
    case Operation::log:
    case Operation::pow:
      return Parity::none;
  }
  return Parity::none;
}

/// sin, cos and tan: the calls that the counting convention lists apart.
constexpr bool is_trigonometric(Operation op) {
  return op == Operation::sin || op == Operation::cos || op == Operation::tan;
}

/// What the C library computes, whose roundings differ between machines; + - * / and square roots are rounded
/// correctly everywhere.
constexpr bool is_function(Operation op) {
  switch (op) {
    case Operation::sin:
    case Operation::cos:
    case Operation::tan:
    case Operation::asin:
    case Operation::acos:
    case Operation::atan:
    case Operation::atan2:
    case Operation::exp:
    case Operation::log:
    case Operation::sinh:
    case Operation::cosh:
    case Operation::tanh:
    case Operation::pow:
      return true;
    case Operation::constant:
    case Operation::input:
    case Operation::add:
    case Operation::sub:
    case Operation::mul:
    case Operation::div:
    case Operation::neg:
    case Operation::sqrt:
    case Operation::abs:
    case Operation::sign:
      return false;
  }
  return false;
}

/// How an operation is written, in C++ and in dumps: the sign of + - * / and negation, the name of a
/// function; empty for constants and inputs.
constexpr std::string_view operation_name(Operation op) {
  switch (op) {
    case Operation::constant:
    case Operation::input:
      return "";
    case Operation::add:
      return "+";
    case Operation::sub:
    case Operation::neg:
      return "-";
    case Operation::mul:
      return "*";
    case Operation::div:
      return "/";
    case Operation::sqrt:
      return "sqrt";
    case Operation::sin:
      return "sin";
    case Operation::cos:
      return "cos";
    case Operation::tan:
      return "tan";
    case Operation::asin:
      return "asin";
    case Operation::acos:
      return "acos";
    case Operation::atan:
      return "atan";
    case Operation::atan2:
      return "atan2";
    case Operation::exp:
      return "exp";
    case Operation::log:
      return "log";
    case Operation::abs:
      return "abs";
    case Operation::sign:
      return "sign";
    case Operation::sinh:
      return "sinh";
    case Operation::cosh:
      return "cosh";
    case Operation::tanh:
      return "tanh";
    case Operation::pow:
      return "pow";
  }
  return "";
}

/// Value of an operation on `a` (and `b`); constants and inputs have none here and give `a`.
template <class Real>
Real apply(Operation op, Real a, Real b) {
  using std::abs, std::acos, std::asin, std::atan, std::atan2, std::cos, std::cosh, std::exp, std::log,
      std::pow, std::sin, std::sinh, std::sqrt, std::tan, std::tanh;
  switch (op) {
    case Operation::constant:
    case Operation::input:
      return a;
    case Operation::add:
      return a + b;
    case Operation::sub:
      return a - b;
    case Operation::mul:
      return a * b;
    case Operation::div:
      return a / b;
    case Operation::neg:
      return -a;
    case Operation::sqrt:
      return sqrt(a);
    case Operation::sin:
      return sin(a);
    case Operation::cos:
      return cos(a);
    case Operation::tan:
      return tan(a);
    case Operation::asin:
      return asin(a);
    case Operation::acos:
      return acos(a);
    case Operation::atan:
      return atan(a);
    case Operation::atan2:
      return atan2(a, b);
    case Operation::exp:
      return exp(a);
    case Operation::log:
      return log(a);
    case Operation::abs:
      return abs(a);
    case Operation::sign:
      return static_cast<Real>((a > 0) - (a < 0));
    case Operation::sinh:
      return sinh(a);
    case Operation::cosh:
      return cosh(a);
    case Operation::tanh:
      return tanh(a);
    case Operation::pow:
      return pow(a, b);
  }
  return a;
}

}  // namespace alembert
