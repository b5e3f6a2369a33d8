// Builds the samples.
#include "emit/sample.hpp"

#include <algorithm>
#include <array>
#include <deque>
#include <random>

#include "emit/argument_lists.hpp"
#include "functions/array_shape.hpp"
#include "program/loops/dot_products.hpp"
#include "program/loops/reroll.hpp"
#include "program/program_maker.hpp"
#include "program/schedule.hpp"
#include "support/operation.hpp"

namespace sample {

using namespace alembert;

std::uint64_t Random::next() {
  state_ += 0x9E3779B97F4A7C15u;
  std::uint64_t z = state_;
  z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
  z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
  return z ^ (z >> 31);
}

Program random_program(std::string function, std::vector<InputSlot> inputs, std::vector<OutputArray> outputs,
                       std::size_t operations, std::uint64_t seed, bool smooth) {
  Random random(seed);
  Program program;
  program.function = std::move(function);
  program.formulation = "reduced";
  program.inputs = std::move(inputs);
  for (std::uint32_t i = 0; i < program.inputs.size(); ++i) program.code.push_back({Operation::input, i, 0});
  // Shortest text of these needs from 1 to 17 digits, and exponents.
  program.constants = {1.0, -2.5, 0.1, 1.0 / 3, 1e-7, 6.02214076e23, -0.0};
  const std::uint32_t first_constant = static_cast<std::uint32_t>(program.code.size());
  for (std::uint32_t i = 0; i < program.constants.size(); ++i)
    program.code.push_back({Operation::constant, i, 0});
  const std::uint32_t small_constants = first_constant + 4;

  std::deque<std::uint32_t> unused;
  const auto add = [&](Operation op, std::uint32_t a, std::uint32_t b, bool used = false) {
    program.code.push_back({op, a, b});
    const auto value = static_cast<std::uint32_t>(program.code.size() - 1);
    if (!used) unused.push_back(value);
    return value;
  };
  // Programs have no operation on constants alone (they are folded; a compiler would fold them with more
  // digits).
  const auto varies = [&](std::uint32_t v) { return program.code[v].op != Operation::constant; };
  // Mostly values that nothing uses yet, new ones and a few waiting for long, so that little is dead and much
  // is used once; sometimes any value.
  const auto operand = [&]() -> std::uint32_t {
    const std::uint32_t kind = random.below(8);
    if (kind < 2 || unused.empty()) return random.below(static_cast<std::uint32_t>(program.code.size()));
    const bool oldest = kind < 6 && unused.size() > 30;
    const std::uint32_t value = oldest ? unused.front() : unused.back();
    oldest ? unused.pop_front() : unused.pop_back();
    return value;
  };
  const std::array<Operation, 20> all = {Operation::add,   Operation::sub,  Operation::mul,  Operation::div,
                                         Operation::neg,   Operation::sqrt, Operation::sin,  Operation::cos,
                                         Operation::tan,   Operation::asin, Operation::acos, Operation::atan,
                                         Operation::atan2, Operation::exp,  Operation::log,  Operation::abs,
                                         Operation::sign,  Operation::sinh, Operation::cosh, Operation::tanh};
  std::size_t made = 0;
  const auto one = [&](Operation op) {
    std::uint32_t a = operand();
    const std::uint32_t b = operand_count(op) == 2 ? operand() : 0;
    while (!varies(a)) a = operand();
    add(op, a, b);
    ++made;
  };
  while (made < operations) {
    const std::uint32_t pick = random.below(20);
    if (smooth) {
      constexpr std::array<Operation, 5> kSmooth = {Operation::add, Operation::sub, Operation::mul,
                                                    Operation::neg, Operation::cos};
      one(kSmooth[random.below(5)]);
    } else if (pick < 16) {
      one(all[random.below(5)]);
    } else {
      // Functions get an argument in their domain: sin(x), in [-1, 1], or cosh(sin(x)), in [1, 1.6].
      std::uint32_t angle = operand();
      while (!varies(angle)) angle = operand();
      const std::uint32_t bounded = add(Operation::sin, angle, 0, true);
      const std::uint32_t positive = add(Operation::cosh, bounded, 0, true);
      const Operation op = all[5 + random.below(15)];
      const bool needs_positive = op == Operation::sqrt || op == Operation::log;
      const std::uint32_t value = add(op, needs_positive ? positive : bounded, positive, true);
      add(Operation::pow, positive, value);
      made += 4;
    }
    // Keeps magnitudes small: every so often the sine of what there is.
    if (random.below(6) == 0) one(Operation::sin);
  }
  const auto size = static_cast<std::uint32_t>(program.code.size());
  for (OutputArray& output : program.outputs = std::move(outputs)) {
    const std::size_t entries = static_cast<std::size_t>(output.rows) * output.columns;
    for (std::size_t k = 0; k < entries; ++k) {
      const std::uint32_t kind = smooth ? 9 : random.below(10);
      if (kind == 0)
        output.values.push_back(random.below(small_constants));  // an input or a constant
      else if (kind == 1 && k > 0)
        output.values.push_back(output.values[random.below(static_cast<std::uint32_t>(k))]);  // one twice
      else
        output.values.push_back(
            size - 1 - random.below(std::min<std::uint32_t>(size - first_constant - 8, smooth ? 20 : 400)));
    }
  }
  return program;
}

namespace {

Coordinate coordinate(Mechanism& mechanism, std::string name, CoordinateType type,
                      std::vector<double> initial) {
  Coordinate c;
  c.name = std::move(name);
  c.type = type;
  c.first_q = mechanism.nq;
  c.first_speed = mechanism.nv;
  c.initial = std::move(initial);
  c.initial_speed.assign(static_cast<std::size_t>(c.nv()), 0.0);
  mechanism.nq += c.nq();
  mechanism.nv += c.nv();
  return c;
}

std::vector<InputSlot> slots_of(const Mechanism& mechanism, const OutputFunction& signature) {
  std::vector<InputSlot> slots;
  for (const ArgumentKind kind : signature.arguments) {
    const int size = kind == ArgumentKind::q ? mechanism.nq : mechanism.nv;
    for (int i = 0; i < size; ++i)
      slots.push_back(
          {kind, static_cast<std::uint32_t>(i), std::string(argument_name(kind)) + std::to_string(i)});
  }
  if (!signature.takes_inputs) return slots;
  slots.push_back({ArgumentKind::time, 0, "t"});
  std::uint32_t parameter = 0, wrench = 0;
  for (const Parameter& p : mechanism.parameters)
    if (p.runtime) slots.push_back({ArgumentKind::parameter, parameter++, p.name});
  for (const Body& body : mechanism.bodies)
    for (int i = 0; body.external_wrench && i < 6; ++i)
      slots.push_back({ArgumentKind::wrench, wrench++, body.name});
  return slots;
}

Program random_function(const Mechanism& mechanism, const OutputFunction& signature, std::size_t operations,
                        std::uint64_t seed, bool smooth = false) {
  std::vector<OutputArray> outputs;
  for (const ResultArray& result : signature.results)
    outputs.push_back(
        {std::string(result.name), static_cast<std::uint32_t>(array_shape(result, mechanism).size()), 1, {}});
  return random_program(std::string(signature.name), slots_of(mechanism, signature), std::move(outputs),
                        operations, seed, smooth);
}

/// A body over so many real coordinates.
Mechanism one_body(std::string name, int coordinates) {
  Mechanism m;
  m.name = std::move(name);
  for (int i = 0; i < coordinates; ++i)
    m.coordinates.push_back(coordinate(m, "q" + std::to_string(i), CoordinateType::real, {0.1 * i}));
  m.bodies.resize(1);
  m.bodies[0].name = "all";
  return m;
}

}  // namespace

Sample every_function() {
  Sample s;
  Mechanism& m = s.mechanism;
  m.name = "sample_all";
  m.description =
      "Every function, every kind of argument.\nA second line with */ and // and \\ and ?\?/ in it";
  m.coordinates.push_back(coordinate(m, "shoulder", CoordinateType::real, {0.25}));
  m.coordinates.back().initial_speed = {2.5};
  m.coordinates.push_back(coordinate(m, "base", CoordinateType::quaternion, {0, 0, 0, 1}));
  m.coordinates.back().initial_speed = {0, 0, -1};
  m.coordinates.push_back(coordinate(m, "slide", CoordinateType::real, {-1}));
  m.coordinates.back().limits = {-1.5, 2.0};
  m.coordinates.push_back(coordinate(m, "wrist", CoordinateType::real, {0}));
  m.parameters.resize(4);
  m.parameters[0].name = "payload";
  m.parameters[0].value = 2.5;
  m.parameters[0].runtime = true;
  m.parameters[1].name = "folded";
  m.parameters[2].name = "length";
  m.parameters[2].value = 1e-3;
  m.parameters[2].runtime = true;
  m.parameters[2].role = ParameterRole::input;
  m.parameters[3].name = "heat";
  m.parameters[3].runtime = true;
  m.parameters[3].role = ParameterRole::state;
  m.bodies.resize(3);
  m.bodies[0].name = "column";
  m.bodies[1].name = "hand";
  m.bodies[1].external_wrench = true;
  m.bodies[2].name = "tool";
  m.bodies[2].external_wrench = true;
  m.frames.resize(1);
  m.frames[0].name = "tip";
  m.forces.resize(2);
  m.forces[0].name = "pull";
  m.forces[1].name = "friction of wrist";
  m.outputs.resize(2);
  m.outputs[0].name = "reach";
  m.outputs[1].name = "sag";
  m.constraints.resize(2);
  m.constraints[0].name = "no_slip";
  m.constraints[0].type = ConstraintType::rolling;
  m.constraints[1].name = "closed";
  m.constraints[1].equations.resize(1);
  m.base_columns = {0, 2, 7};
  for (const OutputFunction& signature : kOutputFunctions) {
    std::uint64_t seed = 7;  // rows may come and go
    for (const char letter : signature.name) seed = 31 * seed + static_cast<unsigned char>(letter);
    const bool smooth = signature.name == "mass_matrix" || signature.name == "energy";
    s.programs.push_back(random_function(m, signature, smooth ? 60 : 300, seed, smooth));
  }
  return s;
}

Sample evil() {
  Sample s = every_function();
  s.mechanism.name = "sample_evil";
  s.mechanism.description = kEvilText;
  s.mechanism.coordinates[0].name = kEvilText;
  s.mechanism.bodies[1].name = kEvilText;
  s.mechanism.frames[0].name = kEvilText;
  s.mechanism.outputs[0].name = kEvilText;
  s.mechanism.forces[1].name = kEvilText;
  s.mechanism.constraints[1].name = kEvilText;
  s.mechanism.parameters[0].name = kEvilText;
  for (Program& program : s.programs) {
    program.formulation = kEvilText;
    for (InputSlot& slot : program.inputs) slot.name = kEvilText;
  }
  return s;
}

Sample big() {
  Sample s;
  Mechanism& m = s.mechanism = one_body("sample_big", 6);
  s.programs.push_back(random_function(m, *find_function("inverse_dynamics"), 20000, 100));
  s.programs.push_back(random_function(m, *find_function("mass_matrix"), 9000, 101));
  return s;
}

/// M of dot products of values of a random program, which are also c.
Program with_dot_products(const Mechanism& m, std::string_view function, std::size_t operations,
                          bool symmetric) {
  std::mt19937_64 random(operations);
  const auto n = static_cast<std::uint32_t>(m.nv);
  std::vector<OutputArray> outputs{{"M", n, n, {}}};
  if (function != "mass_matrix") outputs.push_back({"c", n, 1, {}});
  ProgramMaker maker(0);
  maker.program = random_program(std::string(function), slots_of(m, *find_function(function)),
                                 std::move(outputs), operations, operations);
  std::vector<std::vector<std::uint32_t>> left(n), right(n);
  const std::size_t values = maker.program.code.size();
  for (std::vector<std::vector<std::uint32_t>>* rows : {&left, &right})
    for (std::vector<std::uint32_t>& row : *rows)
      for (int k = 0; k < 5; ++k) row.push_back(static_cast<std::uint32_t>(random() % values));
  // An input and a constant, which are put into tables beside what is computed.
  left[2][1] = 0;
  left[3][2] = maker.constant(0.0125);
  std::vector<std::uint32_t>& M = maker.program.outputs[0].values;
  for (std::uint32_t i = 0; i < n; ++i)
    for (std::uint32_t j = symmetric ? i : 0; j < n; ++j) {
      M[i * n + j] = append_dot_product(maker, left[i], right[j], j % 2 == 1, random);
      if (symmetric) M[j * n + i] = M[i * n + j];
    }
  return gather_dot_products(schedule(std::move(maker.program)), 1);
}

/// A recursion along the coordinates, and M of dot products of its values.
Program steps(const Mechanism& m, std::string_view function, std::uint64_t seed) {
  const auto n = static_cast<std::uint32_t>(m.nv);
  const bool with_matrix = function == "mass_matrix_and_bias";
  ChainMaker chain(n, seed, with_matrix ? ChainMaker::Steps::alike : ChainMaker::Steps::varied);
  chain.m.program.function = function;
  if (with_matrix) {
    // No speeds' rates: other coordinates in their place.
    for (InputSlot& slot : chain.m.program.inputs)
      if (slot.kind == ArgumentKind::qdd) slot.kind = ArgumentKind::q;
    std::mt19937_64 random(seed);
    OutputArray M{"M", n, n, std::vector<std::uint32_t>(std::size_t{n} * n)};
    for (std::uint32_t i = 0; i < n; ++i)
      for (std::uint32_t j = i; j < n; ++j)
        M.values[i * n + j] = M.values[j * n + i] =
            append_dot_product(chain.m, chain.rows[i], chain.rows[j], i % 2 == 1, random);
    chain.m.program.outputs[0].name = "c";
    chain.m.program.outputs.insert(chain.m.program.outputs.begin(), M);
  }
  return reroll(gather_dot_products(schedule(chain.m.program), 1));
}

Sample stepping() {
  Sample s;
  Mechanism& m = s.mechanism = one_body("sample_steps", 24);
  s.programs.push_back(steps(m, "inverse_dynamics", 1));
  s.programs.push_back(steps(m, "mass_matrix_and_bias", 2));
  return s;
}

Sample looping() {
  Sample s;
  Mechanism& m = s.mechanism = one_body("sample_loops", 14);
  s.programs.push_back(with_dot_products(m, "mass_matrix", 400, true));
  s.programs.push_back(with_dot_products(m, "mass_matrix_and_bias", 6000, false));
  return s;
}

}  // namespace sample
