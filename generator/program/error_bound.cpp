// Running error analysis, one rule an operation. See error_bound.hpp.
#include "program/error_bound.hpp"

#include <cmath>
#include <limits>

namespace alembert {
namespace {

// Functions of the C library are within a few units in the last place.
constexpr double kFunctionRoundings = 4;

double carried(Operation op, Approximate a, Approximate b, double v) {
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  switch (op) {
    case Operation::constant:
    case Operation::input:
      return 0;
    case Operation::add:
    case Operation::sub:
      return a.error + b.error;
    case Operation::mul:
      return std::abs(a.value) * b.error + std::abs(b.value) * a.error + a.error * b.error;
    case Operation::div: {
      const double divisor = std::abs(b.value) - b.error;
      return divisor > 0 ? (a.error + std::abs(v) * b.error) / divisor : kInfinite;
    }
    case Operation::neg:
    case Operation::abs:
    case Operation::sin:
    case Operation::cos:
    case Operation::tanh:
      return a.error;
    case Operation::sqrt:
      return a.error == 0 ? 0 : a.value > a.error ? a.error / v : kInfinite;
    case Operation::tan:
      return std::abs(v) * a.error < 0.5 ? 2 * a.error * (1 + v * v) : kInfinite;
    case Operation::asin:
    case Operation::acos: {
      const double x = std::abs(a.value) + a.error;
      return a.error == 0 ? 0 : x < 1 ? a.error / std::sqrt(1 - x * x) : kInfinite;
    }
    case Operation::atan: {
      const double x = std::abs(a.value) - a.error;
      return x > 0 ? a.error / (1 + x * x) : a.error;
    }
    case Operation::atan2: {  // the half line b < 0, a = 0 is a cut; -0 is 0 here
      if (b.value <= b.error && std::abs(a.value) <= a.error) return kInfinite;
      const double radius = std::hypot(a.value, b.value) - std::hypot(a.error, b.error);
      return radius > 0 ? std::hypot(a.error, b.error) / radius : kInfinite;
    }
    case Operation::exp:
      return a.error < 0.5 ? 2 * std::abs(v) * a.error : kInfinite;
    case Operation::log:
      return a.error == 0 ? 0 : a.value > a.error ? a.error / (a.value - a.error) : kInfinite;
    case Operation::sign:
      return a.error == 0 || std::abs(a.value) > a.error ? 0 : kInfinite;
    case Operation::sinh:
    case Operation::cosh:
      return a.error < 0.5 ? 2 * a.error * std::cosh(a.value) : kInfinite;
    case Operation::pow: {  // relative error: |b| da/a + |log a| db
      if (a.error == 0 && b.error == 0) return 0;
      const double base = a.value - a.error;
      if (!(base > 0)) return kInfinite;
      const double relative = std::abs(b.value) * a.error / base + std::abs(std::log(a.value)) * b.error;
      return relative < 0.5 ? 2 * relative * std::abs(v) : kInfinite;
    }
  }
  return kInfinite;
}

double roundings(Operation op) {
  switch (op) {
    case Operation::input:
    case Operation::neg:
    case Operation::abs:
    case Operation::sign:
      return 0;
    case Operation::constant:
    case Operation::add:
    case Operation::sub:
    case Operation::mul:
    case Operation::div:
    case Operation::sqrt:
      return 1;
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
      return kFunctionRoundings;
  }
  return kFunctionRoundings;
}

}  // namespace

double error_bound(Operation op, Approximate a, Approximate b, double result) {
  if (!std::isfinite(a.value) || !std::isfinite(b.value) || !std::isfinite(result))
    return std::numeric_limits<double>::infinity();
  return carried(op, a, b, result) + roundings(op) * kUnitRoundoff * std::abs(result);
}

}  // namespace alembert
