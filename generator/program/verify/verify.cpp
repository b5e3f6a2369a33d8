// Stage `verify`: a program and the expressions it came from in; nothing out, or InternalError if the two
// differ.
//
// Three nets. The program is well formed. At random points its values are those of the expressions, within
// the running error bounds of both sides. And where both consist of + - * / sqrt sin cos and short binary
// fractions, they are equal modulo a large prime, where nothing is rounded and no cancellation hides a
// difference.
#include "program/verify/verify.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "program/interpret.hpp"
#include "program/lower.hpp"
#include "program/verify/exact_comparison.hpp"
#include "support/error.hpp"
#include "support/operation.hpp"
#include "symbolic/error_bound.hpp"
#include "symbolic/modular.hpp"

namespace alembert {
namespace {

constexpr int kPoints = 8;           ///< comparisons that each element gets ...
constexpr int kAttempts = 64;        ///< ... if so many points give them
constexpr double kBoundFactor = 64;  ///< running error bounds are of first order, and constants are folded
constexpr double kSharp = 1e-6;      ///< a tolerance above this fraction of the value shows little

[[noreturn]] void fail(const Program& program, const std::string& what) {
  throw InternalError("verify: " + program.function + ": " + what);
}

void check_form(const Program& program, std::span<const OutputExpressions> outputs,
                std::span<const SymbolBinding> bindings) {
  if (program.inputs.size() != bindings.size()) fail(program, "the inputs are not the symbols bound");
  for (std::size_t i = 0; i < bindings.size(); ++i)
    if (program.inputs[i].kind != bindings[i].slot.kind || program.inputs[i].index != bindings[i].slot.index)
      fail(program, fmt::format("input {} is not the symbol bound", i));
  for (std::size_t i = 0; i < program.code.size(); ++i) {
    const Instruction& c = program.code[i];
    const int operands = operand_count(c.op);
    const std::size_t limit = c.op == Operation::constant ? program.constants.size()
                              : c.op == Operation::input  ? program.inputs.size()
                                                          : i;
    if (c.a >= limit || (operands == 2 && c.b >= limit))
      fail(program, fmt::format("instruction {} refers to what does not precede it", i));
  }
  if (program.outputs.size() != outputs.size()) fail(program, "the number of output arrays differs");
  for (std::size_t k = 0; k < outputs.size(); ++k) {
    const OutputArray& has = program.outputs[k];
    const OutputExpressions& wants = outputs[k];
    if (has.name != wants.name || has.rows != wants.rows || has.columns != wants.columns ||
        has.values.size() != wants.values.size())
      fail(program, "output " + wants.name + " has another name or shape");
    for (const std::uint32_t v : has.values)
      if (v >= program.code.size()) fail(program, "output " + wants.name + " refers to no instruction");
  }
}

/// `array[element]` of the k-th output value.
std::string element_name(std::span<const OutputExpressions> outputs, std::size_t k) {
  for (const OutputExpressions& output : outputs) {
    if (k < output.values.size()) return fmt::format("{}[{}]", output.name, k);
    k -= output.values.size();
  }
  return {};
}

class PointSource {
 public:
  PointSource(ExprGraph& graph, std::span<const SymbolBinding> bindings) : units_(graph.symbol_count(), 1) {
    for (std::uint32_t i = 0; i < graph.symbol_count(); ++i)
      ranges_.push_back(graph.bounds(graph.symbol_at(i).ref()));
    for (const SymbolBinding& binding : bindings)
      units_[graph.symbol_index(binding.symbol.ref().node())] = binding.unit;
  }

  /// Values of all symbols, inside their ranges or a few of their units; sizes and signs vary with `attempt`,
  /// so that domains are met.
  std::vector<double> point(int attempt) {
    static constexpr double kScales[] = {2, 1, 0.5, 4};
    std::vector<double> out;
    for (std::size_t i = 0; i < ranges_.size(); ++i) {
      const Interval& range = ranges_[i];
      const double scale = kScales[attempt % 4] * units_[i];
      const double unit = static_cast<double>(random_() >> 11) * 0x1p-53;
      const bool below = std::isfinite(range.lower), above = std::isfinite(range.upper);
      if (below && above)
        out.push_back(range.lower + unit * (range.upper - range.lower));
      else if (below)
        out.push_back(range.lower + scale * unit);
      else if (above)
        out.push_back(range.upper - scale * unit);
      else
        out.push_back(attempt % 3 == 2 ? scale * unit : scale * (2 * unit - 1));
    }
    return out;
  }

 private:
  std::vector<Interval> ranges_;
  std::vector<double> units_;
  std::mt19937_64 random_{20250101};
};

/// The program's side; `scratch` holds the values of all instructions, as `interpret` left them.
std::vector<Approximate> program_values(const Program& program, const std::vector<double>& scratch,
                                        std::vector<double>& errors) {
  errors.resize(program.code.size());
  for (std::size_t i = 0; i < program.code.size(); ++i) {
    const Instruction& c = program.code[i];
    const int operands = operand_count(c.op);
    const Approximate a = operands > 0 ? Approximate{scratch[c.a], errors[c.a]} : Approximate{};
    const Approximate b = operands > 1 ? Approximate{scratch[c.b], errors[c.b]} : Approximate{};
    errors[i] = error_bound(c.op, a, b, scratch[i]);
  }
  std::vector<Approximate> out;
  for (const OutputArray& output : program.outputs)
    for (const std::uint32_t v : output.values) out.push_back({scratch[v], errors[v]});
  return out;
}

std::string text(const Modular& x) {
  return fmt::format("{} + {}i", x.re, x.im);
}

/// How often an element could be compared.
struct Comparisons {
  int sharp = 0, loose = 0;
  bool only_program_finite = false;
};

std::vector<Comparisons> compare_numerically(const Program& program, std::span<const Expr> roots,
                                             std::span<const OutputExpressions> outputs,
                                             std::span<const SymbolBinding> bindings) {
  ExprGraph& graph = roots.front().graph();
  PointSource points(graph, bindings);
  std::vector<Comparisons> done(roots.size());
  std::vector<double> inputs(bindings.size()), results(roots.size()), scratch, errors;
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    const bool enough =
        std::all_of(done.begin(), done.end(), [](const Comparisons& c) { return c.sharp >= kPoints; });
    if (enough) break;
    const std::vector<double> symbols = points.point(attempt);
    for (std::size_t i = 0; i < bindings.size(); ++i)
      inputs[i] = symbols[graph.symbol_index(bindings[i].symbol.ref().node())];
    const std::vector<Approximate> wanted = evaluate_bounded(roots, symbols);
    interpret(program, inputs, results, scratch);
    const std::vector<Approximate> found = program_values(program, scratch, errors);
    for (std::size_t k = 0; k < roots.size(); ++k) {
      if (!std::isfinite(wanted[k].value)) {
        if (std::isfinite(found[k].value)) done[k].only_program_finite = true;
        continue;
      }
      const double tolerance = kBoundFactor * (wanted[k].error + found[k].error) + 1e-300;
      if (std::isfinite(found[k].value) && !std::isfinite(tolerance)) continue;
      if (!std::isfinite(wanted[k].error)) continue;
      const double error = std::abs(found[k].value - wanted[k].value);
      if (!(error <= tolerance))
        fail(
            program,
            fmt::format("{} is {} in the program and {} by its expression: they differ by {}, where rounding "
                        "explains {}",
                        element_name(outputs, k), found[k].value, wanted[k].value, error, tolerance));
      ++(tolerance <= kSharp * std::max(1.0, std::abs(wanted[k].value)) ? done[k].sharp : done[k].loose);
    }
  }
  return done;
}

}  // namespace

void verify(const Program& program, std::span<const OutputExpressions> outputs,
            std::span<const SymbolBinding> bindings) {
  check_form(program, outputs, bindings);
  const std::vector<Expr> roots = elements(outputs);
  if (roots.empty()) return;
  const std::vector<Comparisons> done = compare_numerically(program, roots, outputs, bindings);
  const ExactComparison exact = compare_exactly(program, roots, bindings);
  if (exact.possible && exact.first_difference < roots.size())
    fail(program,
         fmt::format("{} is {} in the program and {} by its expression, modulo 2^61-1",
                     element_name(outputs, exact.first_difference), text(exact.found), text(exact.wanted)));
  if (exact.possible) return;
  // An expression without a finite value at any point (say, a function far outside its domain) is taken on
  // trust, but not if the program finds values where it has none.
  for (std::size_t k = 0; k < done.size(); ++k)
    if (done[k].sharp == 0 && done[k].loose == 0 && done[k].only_program_finite)
      fail(program, element_name(outputs, k) + " has values in the program, but none by its expression");
}

}  // namespace alembert
