// Programs for tests, made by hand or at random, and their values with error bounds. In: operations. Out:
// programs.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <span>
#include <vector>

#include "program/count.hpp"
#include "program/interpret.hpp"
#include "support/operation.hpp"

namespace alembert {

/// Builds a program instruction by instruction, exactly as told.
class ProgramMaker {
 public:
  explicit ProgramMaker(std::uint32_t inputs) {
    program.function = "made";
    for (std::uint32_t i = 0; i < inputs; ++i)
      program.inputs.push_back({ArgumentKind::q, i, fmt::format("x{}", i)});
  }
  std::uint32_t append(Operation op, std::uint32_t a = 0, std::uint32_t b = 0) {
    program.code.push_back({op, a, b});
    return static_cast<std::uint32_t>(program.code.size() - 1);
  }
  std::uint32_t input(std::uint32_t slot) { return append(Operation::input, slot); }
  std::uint32_t constant(double value) {
    program.constants.push_back(value);
    return append(Operation::constant, static_cast<std::uint32_t>(program.constants.size() - 1));
  }
  std::uint32_t add(std::uint32_t a, std::uint32_t b) { return append(Operation::add, a, b); }
  std::uint32_t sub(std::uint32_t a, std::uint32_t b) { return append(Operation::sub, a, b); }
  std::uint32_t mul(std::uint32_t a, std::uint32_t b) { return append(Operation::mul, a, b); }
  std::uint32_t div(std::uint32_t a, std::uint32_t b) { return append(Operation::div, a, b); }
  std::uint32_t neg(std::uint32_t a) { return append(Operation::neg, a); }
  std::uint32_t sin(std::uint32_t a) { return append(Operation::sin, a); }
  std::uint32_t cos(std::uint32_t a) { return append(Operation::cos, a); }
  /// Declares the values of the one output array `out`.
  const Program& returning(std::vector<std::uint32_t> values) {
    program.outputs = {{"out", static_cast<std::uint32_t>(values.size()), 1, std::move(values)}};
    return program;
  }

  Program program;
};

/// sum_k left[k] * right[k], or its negative, with factors, terms and signs in random order.
inline std::uint32_t append_dot_product(ProgramMaker& m, std::span<const std::uint32_t> left,
                                        std::span<const std::uint32_t> right, bool negative,
                                        std::mt19937_64& random) {
  std::vector<std::pair<std::uint32_t, bool>> terms;
  for (std::size_t k = 0; k < left.size(); ++k) {
    const bool turned = random() % 2 == 0;
    terms.emplace_back(turned ? m.mul(right[k], left[k]) : m.mul(left[k], right[k]), negative);
  }
  const auto take = [&] {
    std::swap(terms[random() % terms.size()], terms.back());
    const auto term = terms.back();
    terms.pop_back();
    return term;
  };
  while (terms.size() > 1) {
    const auto [a, a_negative] = take();
    const auto [b, b_negative] = take();
    const bool minus = random() % 2 == 0;  // what is negated now is put right later
    if (a_negative == b_negative && minus)
      terms.emplace_back(m.sub(m.neg(a), b), !a_negative);
    else if (a_negative == b_negative)
      terms.emplace_back(m.add(a, b), a_negative);
    else
      terms.emplace_back(m.sub(a, b), a_negative);
  }
  return terms[0].second ? m.neg(terms[0].first) : terms[0].first;
}

/// A recursion along a chain of n steps, outwards and back inwards, on elements of q, qd and qdd. Factors and
/// terms stand in random order and signs are placed at random, here and there with a negation, which changes
/// no value. The results are one of each step; rows[i] are three values of step i.
class ChainMaker {
 public:
  enum class Steps : std::uint8_t {
    alike,   ///< but for signs of sums and the order of two operands
    varied,  ///< some about the negative axis, three terms in any order, and angles from elsewhere
  };

  ChainMaker(std::uint32_t n, std::uint64_t seed, Steps steps = Steps::alike)
      : m(0), random_(seed), steps_(steps) {
    constexpr std::size_t kWidth = 4;
    std::vector<std::uint32_t> q, qd, qdd, sine, cosine;
    const auto inputs = [&](ArgumentKind kind, std::vector<std::uint32_t>& values) {
      for (std::uint32_t i = 0; i < n; ++i) {
        m.program.inputs.push_back({kind, i, ""});
        values.push_back(m.input(static_cast<std::uint32_t>(m.program.inputs.size() - 1)));
      }
    };
    inputs(ArgumentKind::q, q);
    inputs(ArgumentKind::qd, qd);
    inputs(ArgumentKind::qdd, qdd);
    if (steps == Steps::varied)
      for (std::uint32_t& angle : q) angle = m.sub(m.constant(0.3), angle);
    for (std::uint32_t i = 0; i < n; ++i) sine.push_back(m.sin(q[i]));
    for (std::uint32_t i = 0; i < n; ++i) cosine.push_back(m.cos(q[i]));
    std::vector<Signed> x(kWidth), y(kWidth);
    std::vector<std::vector<Signed>> forces(n);
    for (std::size_t k = 0; k < kWidth; ++k) x[k] = y[k] = constant();
    std::vector<bool> reversed(n, false);
    for (std::uint32_t i = 0; i < n && steps == Steps::varied; ++i) reversed[i] = coin();
    const auto rotate = [&](std::vector<Signed>& v, std::uint32_t i, bool inverse) {
      for (std::size_t k = 0; k < kWidth; k += 2) {
        const Signed s{sine[i], inverse != reversed[i]}, c{cosine[i]}, a = v[k], b = v[k + 1];
        v[k] = sum(product(c, a), product(s, b));
        v[k + 1] = sum(product(c, b), negated(product(s, a)));
      }
    };
    for (std::uint32_t i = 0; i < n; ++i) {
      rotate(x, i, false);
      const Signed rate{qd[i], reversed[i]}, its_rate{qdd[i], reversed[i]};
      x[0] = sum(x[0], product(constant(), rate));
      x[2] = sum(its_rate, x[2], product(x[0], rate));
      x[3] = sum(x[3], product(constant(), x[1]), product(constant(), x[2]));
      rows.push_back({plain(x[0]), plain(x[2]), plain(x[3])});
      forces[i] = {sum(x[0], product(x[1], x[2])), product(constant(), x[1]), negated(x[2]), x[3]};
    }
    std::vector<std::uint32_t> results(n);
    for (std::uint32_t i = n; i-- > 0;) {
      for (std::size_t k = 0; k < kWidth; ++k) y[k] = sum(y[k], forces[i][k]);
      results[i] = plain(sum(y[0], product(constant(), y[3])));
      rotate(y, i, true);
    }
    m.program.outputs = {{"tau", n, 1, results}};
  }

  ProgramMaker m;
  std::vector<std::vector<std::uint32_t>> rows;

 private:
  /// A value or its negative.
  struct Signed {
    std::uint32_t value = 0;
    bool negative = false;
  };
  static Signed negated(Signed a) { return {a.value, !a.negative}; }
  bool coin() { return random_() % 2 == 0; }
  Signed constant() {
    return {m.constant((coin() ? 1 : -1) * (0.1 + static_cast<double>(random_() % 800) * 1e-3))};
  }
  Signed product(Signed a, Signed b) {
    if (coin()) std::swap(a, b);
    return {m.mul(a.value, b.value), a.negative != b.negative};
  }
  Signed sum(Signed a, Signed b) {
    if (coin()) std::swap(a, b);
    Signed out = a.negative == b.negative ? Signed{m.add(a.value, b.value), a.negative}
                                          : Signed{m.sub(a.value, b.value), a.negative};
    if (random_() % 8 == 0) out = {m.neg(out.value), !out.negative};
    return out;
  }
  Signed sum(Signed a, Signed b, Signed c) {
    const std::uint64_t order = steps_ == Steps::varied ? random_() % 3 : 0;
    return order == 0 ? sum(a, sum(b, c)) : order == 1 ? sum(b, sum(c, a)) : sum(c, sum(a, b));
  }
  std::uint32_t plain(Signed a) { return a.negative ? m.neg(a.value) : a.value; }

  std::mt19937_64 random_;
  Steps steps_;
};

inline std::size_t output_size(const Program& program) {
  std::size_t n = 0;
  for (const OutputArray& output : program.outputs) n += output.values.size();
  return n;
}

inline std::vector<double> run(const Program& program, std::span<const double> inputs) {
  std::vector<double> out(output_size(program)), scratch;
  interpret(program, inputs, out, scratch);
  return out;
}

/// Whether operands stand before their users.
inline bool is_ordered(const Program& program) {
  for (std::size_t i = 0; i < program.code.size(); ++i) {
    const Instruction& c = program.code[i];
    const int operands = operand_count(c.op);
    if ((operands > 0 && c.a >= i) || (operands > 1 && c.b >= i)) return false;
  }
  return true;
}

/// Whether two programs have the same outputs, bit for bit but for the sign of zero; NaN equals NaN.
inline bool same_outputs(const Program& x, const Program& y, std::span<const double> inputs) {
  return std::ranges::equal(run(x, inputs), run(y, inputs),
                            [](double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); });
}

/// Outputs with running error bounds.
inline std::vector<Approximate> run_bounded(const Program& program, std::span<const double> inputs) {
  std::vector<double> out(output_size(program)), v;
  interpret(program, inputs, out, v);
  std::vector<Approximate> at(program.code.size()), result;
  for (std::size_t i = 0; i < program.code.size(); ++i) {
    const Instruction& c = program.code[i];
    const int operands = operand_count(c.op);
    at[i] = {v[i], error_bound(c.op, operands > 0 ? at[c.a] : Approximate{},
                               operands > 1 ? at[c.b] : Approximate{}, v[i])};
  }
  for (const OutputArray& output : program.outputs)
    for (const std::uint32_t value : output.values) result.push_back(at[value]);
  return result;
}

/// Whether outputs differ by no more than their rounding errors; those without a finite value or bound are
/// not compared.
inline bool same_but_for_rounding(const Program& x, const Program& y, std::span<const double> inputs) {
  return std::ranges::equal(run_bounded(x, inputs), run_bounded(y, inputs), [](Approximate a, Approximate b) {
    if (!std::isfinite(a.value) || !std::isfinite(a.error)) return true;
    return std::abs(a.value - b.value) <= 2 * (a.error + b.error) + 1e-300;
  });
}

inline std::vector<double> random_point(std::size_t size, std::mt19937_64& random) {
  std::vector<double> x(size);
  for (double& value : x) value = 0.25 + 1.5 * (static_cast<double>(random() >> 11) * 0x1p-53);
  return x;
}

/// What the random programs are made of.
enum class Mix {
  arithmetic,  ///< mostly + - * with many repeated operands, as in the equations of motion
  everything,  ///< every operation, divisions by values that may be shared
};

/// A program of about `size` instructions that no simplification has seen: repeated, cancelling, negated and
/// constant parts.
inline Program random_program(std::size_t size, Mix mix, std::mt19937_64& random) {
  ProgramMaker m(5);
  for (std::uint32_t i = 0; i < 5; ++i) m.input(i);
  for (const double c : {0.0, 1.0, -1.0, 2.0, -2.0, 0.5, 3.0, -0.75, 1.0 / 3.0}) m.constant(c);
  static constexpr Operation kArithmetic[] = {Operation::add, Operation::sub, Operation::mul, Operation::add,
                                              Operation::mul, Operation::sub, Operation::neg};
  static constexpr Operation kFunctions[] = {
      Operation::div,   Operation::sqrt, Operation::sin,  Operation::cos,  Operation::tan,
      Operation::asin,  Operation::acos, Operation::atan, Operation::exp,  Operation::log,
      Operation::atan2, Operation::sign, Operation::abs,  Operation::sinh, Operation::cosh,
      Operation::tanh,  Operation::pow,  Operation::div,  Operation::div,  Operation::div};
  while (m.program.code.size() < size) {
    const std::uint64_t r = random();
    const auto pick = [&] {
      const std::size_t n = m.program.code.size();
      const std::size_t recent = std::min<std::size_t>(n, 12);
      return static_cast<std::uint32_t>(random() % 4 == 0 ? random() % n : n - 1 - random() % recent);
    };
    const std::uint32_t a = pick(), b = pick();
    Operation op = kArithmetic[r % std::size(kArithmetic)];
    if (mix == Mix::everything && r / 7 % 3 == 0) op = kFunctions[r / 21 % std::size(kFunctions)];
    if (op == Operation::exp || op == Operation::sinh || op == Operation::cosh || op == Operation::tan) {
      const std::uint32_t bounded = m.sin(a);
      m.append(op, bounded);
    } else {
      m.append(op, a, operand_count(op) == 2 ? b : 0);
    }
  }
  std::vector<std::uint32_t> outputs;
  for (int k = 0; k < 4; ++k) outputs.push_back(static_cast<std::uint32_t>(size - 1 - random() % (size / 3)));
  m.returning(outputs);
  return m.program;
}

inline std::size_t negations(const Program& program) {
  std::size_t n = 0;
  for (const Instruction& c : program.code) n += c.op == Operation::neg;
  return n;
}

}  // namespace alembert
