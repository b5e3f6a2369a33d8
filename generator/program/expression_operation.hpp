// The operation of a program that computes what a node of an expression means; for `lower` and `verify`.
#pragma once

#include "program/program.hpp"
#include "symbolic/expr.hpp"

namespace alembert {

/// Constants of every kind become `constant`, symbols `input`.
constexpr Operation operation_of(Op op) {
  switch (op) {
    case Op::rational:
    case Op::pi_multiple:
    case Op::real:
      return Operation::constant;
    case Op::symbol:
      return Operation::input;
    case Op::add:
      return Operation::add;
    case Op::mul:
      return Operation::mul;
    case Op::div:
      return Operation::div;
    case Op::sqrt:
      return Operation::sqrt;
    case Op::sin:
      return Operation::sin;
    case Op::cos:
      return Operation::cos;
    case Op::tan:
      return Operation::tan;
    case Op::asin:
      return Operation::asin;
    case Op::acos:
      return Operation::acos;
    case Op::atan:
      return Operation::atan;
    case Op::atan2:
      return Operation::atan2;
    case Op::exp:
      return Operation::exp;
    case Op::log:
      return Operation::log;
    case Op::abs:
      return Operation::abs;
    case Op::sign:
      return Operation::sign;
    case Op::sinh:
      return Operation::sinh;
    case Op::cosh:
      return Operation::cosh;
    case Op::tanh:
      return Operation::tanh;
    case Op::pow:
      return Operation::pow;
  }
  return Operation::constant;
}

}  // namespace alembert
