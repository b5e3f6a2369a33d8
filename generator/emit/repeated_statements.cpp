// Writes repeated blocks, see the header.
#include "emit/repeated_statements.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <map>
#include <set>
#include <utility>

#include "emit/literals.hpp"
#include "emit/repeated_layout.hpp"
#include "program/operation.hpp"
#include "support/error.hpp"

namespace alembert {
namespace {

// Operations in one statement.
constexpr int kMaxOperations = 12;

// Runs of consecutive elements from here on are copied by a loop, and so many equal constants are.
constexpr std::size_t kLoop = 4;
constexpr std::size_t kConstantLoop = 8;

std::string number_lines(const std::vector<std::uint32_t>& numbers) {
  std::string out, line;
  for (const std::uint32_t n : numbers) {
    const std::string next = fmt::format("{},", n);
    if (line.size() + next.size() > 110) {
      out += line + "\n";
      line.clear();
    }
    line += (line.empty() ? "" : " ") + next;
  }
  return out + line;
}

class Writer : RepeatedLayout {
 public:
  Writer(const Program& program, const FunctionSignature& signature)
      : RepeatedLayout(program), signature_(signature) {}

  FunctionBody write() {
    body_.blocks.resize(blocks_.size());
    for (std::size_t b = 0; b < blocks_.size(); ++b) write_block(blocks_[b], body_.blocks[b]);
    write_tables();
    write_driver();
    body_.crossing = places_;
    return std::move(body_);
  }

 private:
  /// Index into `constants_`.
  std::uint32_t listed_constant(std::uint32_t v) {
    const auto [entry, fresh] =
        constant_index_.try_emplace(constant_value(v), static_cast<std::uint32_t>(constants_.size()));
    if (fresh) constants_.push_back(constant_value(v));
    return entry->second;
  }

  /// `3` if the number is the same in all occurrences, otherwise `at[k]`.
  static std::string listed(RepeatedBlock& block, const std::vector<std::uint32_t>& numbers) {
    if (std::ranges::all_of(numbers, [&](std::uint32_t n) { return n == numbers[0]; }))
      return std::to_string(numbers[0]);
    const std::size_t k = block.table[0].size();
    for (std::size_t o = 0; o < numbers.size(); ++o) block.table[o].push_back(numbers[o]);
    return fmt::format("at[{}]", k);
  }

  std::string external_text(RepeatedBlock& block, const External& external) {
    std::vector<std::uint32_t> numbers;
    if (!all_constant(external)) {
      for (const std::uint32_t v : external) numbers.push_back(place_[v]);
      return fmt::format("v[{}]", listed(block, numbers));
    }
    const bool same = std::ranges::all_of(
        external, [&](std::uint32_t v) { return constant_value(v) == constant_value(external[0]); });
    if (same) return fmt::format("S({})", number_literal(constant_value(external[0])));
    for (const std::uint32_t v : external) numbers.push_back(listed_constant(v));
    return fmt::format("S(constants[{}])", listed(block, numbers));
  }

  void write_block(RepeatedBlock& block, CodeBlock& out) {
    block.table.resize(block.begins.size());
    std::vector<std::uint32_t> uses(block.length, 0), external_uses(block.externals.size(), 0);
    for (std::uint32_t i = 0; i < block.length; ++i)
      for (int k = 0; k < operands(value(block, 0, i)); ++k) {
        const Source& source = block.sources[2 * std::size_t{i} + static_cast<std::size_t>(k)];
        ++(source.kind == Source::Kind::inside ? uses : external_uses)[source.index];
      }
    std::vector<std::string> texts(block.length), externals(block.externals.size());
    std::vector<int> operations(block.length, 0);
    std::set<std::string> calls;
    const auto line = [&](const std::string& text) {
      out.statement_lines += text + "\n";
      ++out.statements;
    };
    const auto text_of = [&](std::uint32_t i, int k) {
      const Source& source = block.sources[2 * std::size_t{i} + static_cast<std::size_t>(k)];
      if (source.kind == Source::Kind::inside) return texts[source.index];
      std::string& text = externals[source.index];
      if (!text.empty()) return text;
      text = external_text(block, block.externals[source.index]);
      if (external_uses[source.index] > 1 && !text.starts_with("S(")) {
        line(fmt::format("const S x{} = {};", source.index, text));
        text = fmt::format("x{}", source.index);
      }
      return text;
    };
    const auto inlined = [&](std::uint32_t i, int k) {
      const Source& source = block.sources[2 * std::size_t{i} + static_cast<std::size_t>(k)];
      return source.kind == Source::Kind::inside ? operations[source.index] : 0;
    };
    for (std::uint32_t i = 0; i < block.length; ++i) {
      const std::uint32_t v = value(block, 0, i);
      const Operation operation = op(v);
      int count = 1;
      for (int k = 0; k < operands(v); ++k) count += inlined(i, k);
      const std::string a = text_of(i, 0);
      const std::string b = operands(v) > 1 ? text_of(i, 1) : std::string();
      std::string text;
      if (is_call(operation)) {
        calls.emplace(operation_name(operation));
        text = fmt::format("{}({}{}{})", operation_name(operation), a, b.empty() ? "" : ", ", b);
      } else if (operation == Operation::neg) {
        text = "-" + a;
      } else {
        text = fmt::format("{} {} {}", a, operation_name(operation), b);
      }
      // Places of the value: in v and in the results.
      std::vector<std::string> targets;
      std::vector<std::uint32_t> numbers;
      if (block.exported[i] != 0) {
        for (std::size_t o = 0; o < block.begins.size(); ++o) numbers.push_back(place_[value(block, o, i)]);
        targets.push_back(fmt::format("v[{}]", listed(block, numbers)));
      }
      for (std::size_t r = 0; r < results_[v].size(); ++r) {
        numbers.clear();
        for (std::size_t o = 0; o < block.begins.size(); ++o)
          numbers.push_back(results_[value(block, o, i)][r].second);
        targets.push_back(
            fmt::format("{}[{}]", signature_.results[results_[v][r].first].name, listed(block, numbers)));
      }
      if (targets.empty() && uses[i] == 1 && !is_call(operation) && count < kMaxOperations) {
        texts[i] = fmt::format("({})", text);
        operations[i] = count;
      } else if (targets.size() == 1 && uses[i] == 0) {
        line(fmt::format("{} = {};", targets[0], text));
      } else {
        texts[i] = fmt::format("t{}", i);
        line(fmt::format("const S {} = {};", texts[i], text));
        for (const std::string& target : targets) line(fmt::format("{} = {};", target, texts[i]));
      }
    }
    for (const std::string& name : calls) {
      out.calls_sign |= name == "sign";
      out.using_lines += fmt::format("using {}::{};\n", name == "sign" ? "detail" : "::std", name);
    }
    line(fmt::format("return at + {};", block.table[0].size()));
  }

  void write_tables() {
    std::vector<std::uint32_t> at, next(blocks_.size(), 0);
    for (const std::uint32_t b : sequence_) {
      const std::vector<std::uint32_t>& row = blocks_[b].table[next[b]++];
      at.insert(at.end(), row.begin(), row.end());
    }
    const std::uint32_t largest = at.empty() ? 0 : *std::ranges::max_element(at);
    body_.index_type = largest <= std::numeric_limits<std::uint16_t>::max() ? "unsigned short" : "unsigned";
    at.push_back(0);  // no array is empty
    table("at", body_.index_type, number_lines(at));
    std::vector<std::uint32_t> steps(sequence_.begin() + static_cast<std::ptrdiff_t>(calls_before_),
                                     sequence_.end());
    body_.calls = sequence_.size();
    if (steps.empty()) throw InternalError("emit: a function without operations has no blocks");
    table("steps", blocks_.size() > std::numeric_limits<std::uint16_t>::max() ? "unsigned" : "unsigned short",
          number_lines(steps));
    std::string constants;
    if (constants_.empty()) constants_.push_back(0);
    for (const double c : constants_) constants += number_literal(c) + ", ";
    constants.pop_back();
    table("constants", "double", wrap_list(constants, 0, 0));
  }

  void table(std::string_view name, std::string_view type, const std::string& text) {
    body_.tables += fmt::format("inline constexpr {} {}_{}[] = {{\n{}\n}};\n", type, program_.function, name,
                                prefix_lines(text, "    "));
  }

  void driver(const std::string& text) { body_.driver += text + "\n"; }

  /// v[to + i] = source(first + i), by a loop if there are many.
  void copy_run(std::uint32_t to, std::string_view array, std::uint32_t first, std::size_t count) {
    if (count >= kLoop) {
      driver(fmt::format("for (::std::size_t i = 0; i < {}; ++i) v[{} + i] = {}[{} + i];", count, to, array,
                         first));
    } else {
      for (std::uint32_t i = 0; i < count; ++i)
        driver(fmt::format("v[{}] = {}[{}];", to + i, array, first + i));
    }
  }

  static std::string array_of(ArgumentKind kind) {
    switch (kind) {
      case ArgumentKind::q:
      case ArgumentKind::qd:
      case ArgumentKind::qdd:
      case ArgumentKind::tau:
        return std::string(array_name(kind));
      case ArgumentKind::time:
        return "";
      case ArgumentKind::parameter:
        return "in.parameters";
      case ArgumentKind::wrench:
        return "in.wrenches";
    }
    throw InternalError("emit: input of unknown kind");
  }

  void write_inputs() {
    for (std::size_t i = 0; i < loads_.size();) {
      const auto& [kind, index] = loads_[i];
      std::size_t n = 1;
      while (i + n < loads_.size() && loads_[i + n].first == kind && loads_[i + n].second == index + n) ++n;
      if (kind == ArgumentKind::time)
        driver(fmt::format("v[{}] = in.t;", i));
      else
        copy_run(static_cast<std::uint32_t>(i), array_of(kind), index, n);
      i += n;
    }
    for (const std::uint32_t v : mixed_)
      driver(fmt::format("v[{}] = S({});", place_[v], number_literal(constant_value(v))));
  }

  std::string call(std::string_view block) const {
    std::string results;
    for (const ResultArray& result : signature_.results) results += fmt::format(", {}", result.name);
    return fmt::format("{}(v, at, detail::{}_constants{})", block, program_.function, results);
  }

  void write_driver() {
    write_inputs();
    driver(fmt::format("const {}* at = detail::{}_at;", body_.index_type, program_.function));
    for (std::size_t i = 0; i < calls_before_; ++i)
      driver(fmt::format("at = {};",
                         call(fmt::format("detail::{}_block{}<S>", program_.function, sequence_[i] + 1))));
    if (!angles_.empty()) {
      for (std::size_t i = 0; i < angles_.size();) {
        std::size_t n = 1;
        while (i + n < angles_.size() && place_[angles_[i + n]] == place_[angles_[i]] + n) ++n;
        if (constant(angles_[i]) && place_[angles_[i]] == kNoPlace) {
          driver(fmt::format("v[{}] = S({});", first_angle_ + i, number_literal(constant_value(angles_[i]))));
          n = 1;
        } else {
          copy_run(static_cast<std::uint32_t>(first_angle_ + i), "v", place_[angles_[i]], n);
        }
        i += n;
      }
      driver(fmt::format("detail::sines_and_cosines({0}, v + {1}, v + {2}, v + {3});", angles_.size(),
                         first_angle_, first_angle_ + angles_.size(), first_angle_ + 2 * angles_.size()));
      body_.blocks[0].calls_sines_and_cosines = true;
    }
    std::string types, list;
    for (const ResultArray& result : signature_.results) {
      types += ", S*";
      static_cast<void>(result);
    }
    for (std::size_t b = 0; b < blocks_.size(); ++b)
      list += fmt::format("{}detail::{}_block{}<S>", b == 0 ? "" : ", ", program_.function, b + 1);
    driver(fmt::format("using Block = const {0}* (*)(S*, const {0}*, const double*{1});", body_.index_type,
                       types));
    driver(fmt::format("static constexpr Block blocks[] = {{{}}};", wrap_list(list, 40, 4)));
    driver(fmt::format("for (const auto step : detail::{}_steps) at = {};", program_.function,
                       call("blocks[step]")));
    write_leaf_results();
  }

  /// Results that no block computes.
  void write_leaf_results() {
    std::map<std::pair<std::uint32_t, double>, std::vector<std::uint32_t>> equal;
    for (std::uint32_t v = 0; v < size_; ++v) {
      if (!is_leaf(op(v)) && angle_[v] == kNoPlace) continue;
      for (const auto& [array, index] : results_[v]) {
        if (constant(v))
          equal[{array, constant_value(v)}].push_back(index);
        else
          driver(fmt::format("{}[{}] = v[{}];", signature_.results[array].name, index, place_[v]));
      }
    }
    int tables = 0;
    for (const auto& [key, indices] : equal) {
      const std::string_view array = signature_.results[key.first].name;
      const std::string number = number_literal(key.second);
      if (indices.size() < kConstantLoop) {
        for (const std::uint32_t i : indices) driver(fmt::format("{}[{}] = S({});", array, i, number));
        continue;
      }
      const std::string name = fmt::format("equal{}", ++tables);
      table(name, "unsigned", number_lines(indices));
      driver(fmt::format("for (const auto i : detail::{}_{}) {}[i] = S({});", program_.function, name, array,
                         number));
    }
  }

  const FunctionSignature& signature_;
  std::map<double, std::uint32_t> constant_index_;
  std::vector<double> constants_;
  FunctionBody body_;
};

}  // namespace

FunctionBody repeated_body(const Program& program, const FunctionSignature& signature) {
  return Writer(program, signature).write();
}

}  // namespace alembert
