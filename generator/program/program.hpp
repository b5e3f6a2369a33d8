// Straight-line programs: what is counted, interpreted, verified and emitted. One flat array of operations;
// value i is the result of instruction i, and operands are smaller indices.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "support/operation.hpp"

namespace alembert {

struct Instruction {
  Operation op;
  std::uint32_t a = 0, b = 0;
};

/// Where an input value comes from: element `index` of an argument array of the generated function.
enum class ArgumentKind : std::uint8_t {
  q,          ///< coordinates, size nq
  qd,         ///< speeds, size nv
  qdd,        ///< rates of the speeds, size nv
  time,       ///< scalar t, index 0
  parameter,  ///< runtime parameters, in file order
  wrench,     ///< 6 per body with external_wrench: force x y z (world, at the centre of mass), torque x y z
              ///< (world)
  tau,        ///< generalized forces, size nv
  mu,         ///< weights of the generalized forces, size nv
};
/// What the argument is called.
constexpr std::string_view argument_name(ArgumentKind kind) {
  switch (kind) {
    case ArgumentKind::q:
      return "q";
    case ArgumentKind::qd:
      return "qd";
    case ArgumentKind::qdd:
      return "qdd";
    case ArgumentKind::time:
      return "t";
    case ArgumentKind::parameter:
      return "parameter";
    case ArgumentKind::wrench:
      return "wrench";
    case ArgumentKind::tau:
      return "tau";
    case ArgumentKind::mu:
      return "mu";
  }
  return "";
}

struct InputSlot {
  ArgumentKind kind;
  std::uint32_t index;
  std::string name;  ///< for comments in the output and for dumps
};

/// A result array of the generated function, row major; element k is value `values[k]`.
struct OutputArray {
  std::string name;  ///< tau, M, c, ...
  std::uint32_t rows = 0, columns = 1;
  std::vector<std::uint32_t> values;
};

/// Elements of one result array that are dot products of the rows of two tables of values, and nothing else.
struct DotProducts {
  /// Row `left` with rows `right`, `right` + 1, ..., `count` of them. The i-th is element `first` + i
  /// `stride` and element `mirror` + i `step`, which may be the same in all; otherwise `stride` is 1.
  struct Run {
    std::uint32_t left, right, count, first, stride, mirror, step;
    bool mirrored() const { return first != mirror || stride != step; }
  };
  std::uint32_t output;                    ///< the array
  std::uint32_t terms;                     ///< in a row
  std::vector<std::uint32_t> left, right;  ///< row after row
  std::vector<Run> runs;
};

/// Instructions `first`, `first` + 1, ... of a program: `count` iterations of `length` each. Instruction i is
/// in all of them the same operation, each operand in all the same instruction of its own iteration, or in
/// none.
struct Loop {
  std::uint32_t first, length, count;
};

struct Program {
  std::string function;  ///< inverse_dynamics, mass_matrix, ...
  std::string formulation;
  std::optional<double> error;  ///< of results against the plain equations, relative, as measured
  std::vector<Instruction> code;
  std::vector<double> constants;
  std::vector<InputSlot> inputs;
  std::vector<OutputArray> outputs;
  std::vector<Loop> loops;                ///< to be written as such, see `reroll`; ascending, without overlap
  std::vector<DotProducts> dot_products;  ///< to be written as loops, see `gather_dot_products`
  std::uint32_t dot_product_code = 0;     ///< instructions that they are, the last ones of the code
};

}  // namespace alembert
