// Writes programs as statements, see the header.
#include "emit/statements.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <queue>
#include <set>
#include <string_view>

#include "emit/literals.hpp"
#include "program/operation.hpp"
#include "support/error.hpp"

namespace alembert {
namespace {

// Bounds of an expression written in one statement: nesting and number of operations. Deep enough for a
// compiler that contracts a*b + c only inside one expression, small enough to read.
constexpr int kMaxDepth = 12;
constexpr int kMaxOperations = 16;
constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

/// How strongly the text of a value binds.
enum class Binding : std::uint8_t { sum, product, sign, primary };

std::string_view call_name(Operation op) {
  switch (op) {
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
    case Operation::constant:
    case Operation::input:
    case Operation::add:
    case Operation::sub:
    case Operation::mul:
    case Operation::div:
    case Operation::neg:
      break;
  }
  return {};
}

bool is_leaf(Operation op) {
  return op == Operation::constant || op == Operation::input;
}

std::string input_local(const InputSlot& slot) {
  switch (slot.kind) {
    case ArgumentKind::q:
      return fmt::format("q{}", slot.index);
    case ArgumentKind::qd:
      return fmt::format("qd{}", slot.index);
    case ArgumentKind::qdd:
      return fmt::format("qdd{}", slot.index);
    case ArgumentKind::tau:
      return fmt::format("tau{}", slot.index);
    case ArgumentKind::time:
      return "time";
    case ArgumentKind::parameter:
      return fmt::format("p{}", slot.index);
    case ArgumentKind::wrench:
      return fmt::format("f{}", slot.index);
  }
  throw InternalError("emit: input of unknown kind");
}

std::string input_source(const InputSlot& slot) {
  switch (slot.kind) {
    case ArgumentKind::q:
      return fmt::format("q[{}]", slot.index);
    case ArgumentKind::qd:
      return fmt::format("qd[{}]", slot.index);
    case ArgumentKind::qdd:
      return fmt::format("qdd[{}]", slot.index);
    case ArgumentKind::tau:
      return fmt::format("tau[{}]", slot.index);
    case ArgumentKind::time:
      return "in.t";
    case ArgumentKind::parameter:
      return fmt::format("in.parameters[{}]", slot.index);
    case ArgumentKind::wrench:
      return fmt::format("in.wrenches[{}]", slot.index);
  }
  throw InternalError("emit: input of unknown kind");
}

/// Layout of one program: what is live, named, in which block, and where values cross.
class Layout {
 public:
  explicit Layout(const Program& program) : program_(program), size_(program.code.size()) {
    collect_uses();
    choose_names();
    assign_blocks();
    assign_crossings();
  }

  bool live(std::uint32_t v) const { return uses_[v] > 0; }
  /// Has a statement of its own. Leaves have none.
  bool named(std::uint32_t v) const { return named_[v]; }
  /// Number of a named value, in the order of the code.
  std::uint32_t number(std::uint32_t v) const { return number_[v]; }
  std::uint32_t block(std::uint32_t v) const { return block_[v]; }
  std::uint32_t blocks() const { return blocks_; }
  /// Place in w, or kNone.
  std::uint32_t place(std::uint32_t v) const { return place_[v]; }
  std::size_t crossing() const { return crossing_; }
  /// Results that value v is, in order: pairs of output array and index.
  const std::vector<std::pair<std::uint32_t, std::uint32_t>>& results(std::uint32_t v) const {
    return results_[v];
  }
  /// A single result and nothing else: `tau[0] = ...` without a name.
  bool result_only(std::uint32_t v) const { return results_[v].size() == 1 && uses_[v] == 1; }

 private:
  int operands(std::uint32_t v) const { return operand_count(program_.code[v].op); }

  void collect_uses() {
    uses_.assign(size_, 0);
    results_.resize(size_);
    for (std::uint32_t array = 0; array < program_.outputs.size(); ++array) {
      const auto& values = program_.outputs[array].values;
      for (std::uint32_t k = 0; k < values.size(); ++k) {
        results_[values[k]].emplace_back(array, k);
        ++uses_[values[k]];
      }
    }
    for (std::uint32_t v = static_cast<std::uint32_t>(size_); v-- > 0;) {
      const Instruction& instruction = program_.code[v];
      if ((operands(v) > 0 && instruction.a >= v) || (operands(v) > 1 && instruction.b >= v))
        throw InternalError("emit: a value of " + program_.function + " is used before it is computed");
      if (!live(v)) continue;
      if (operands(v) > 0) ++uses_[instruction.a];
      if (operands(v) > 1) ++uses_[instruction.b];
    }
  }

  void choose_names() {
    named_.assign(size_, false);
    std::vector<int> depth(size_, 0), operations(size_, 0);
    for (std::uint32_t v = 0; v < size_; ++v) {
      const Instruction& instruction = program_.code[v];
      if (!live(v) || is_leaf(instruction.op)) continue;
      depth[v] = 1;
      operations[v] = 1;
      const std::array<std::uint32_t, 2> operand{instruction.a, instruction.b};
      for (int k = 0; k < operands(v); ++k) {
        const std::uint32_t child = operand[static_cast<std::size_t>(k)];
        if (named_[child] || is_leaf(program_.code[child].op)) continue;
        if (operations[v] + operations[child] > kMaxOperations || depth[child] + 1 > kMaxDepth) {
          named_[child] = true;  // too much for one line: the child gets a name after all
          continue;
        }
        depth[v] = std::max(depth[v], depth[child] + 1);
        operations[v] += operations[child];
      }
      named_[v] = uses_[v] > 1 || !results_[v].empty() || !call_name(instruction.op).empty();
    }
  }

  void assign_blocks() {
    std::size_t statements = 0;
    for (std::uint32_t v = 0; v < size_; ++v) statements += live(v) && named_[v] ? 1 : 0;
    const std::size_t count = statements > kBlockThreshold ? (statements + kBlockSize - 1) / kBlockSize : 1;
    blocks_ = static_cast<std::uint32_t>(count);
    block_.assign(size_, kNone);
    number_.assign(size_, kNone);
    std::uint32_t number = 0;
    for (std::uint32_t v = 0; v < size_; ++v) {
      if (!live(v) || !named_[v]) continue;
      block_[v] = static_cast<std::uint32_t>(number * count / statements);
      number_[v] = number++;
    }
    // What is written into its user belongs to the user's block; users have larger indices.
    for (std::uint32_t v = static_cast<std::uint32_t>(size_); v-- > 0;) {
      if (!live(v) || is_leaf(program_.code[v].op)) continue;
      const std::array<std::uint32_t, 2> operand{program_.code[v].a, program_.code[v].b};
      for (int k = 0; k < operands(v); ++k) {
        const std::uint32_t child = operand[static_cast<std::size_t>(k)];
        if (!named_[child] && !is_leaf(program_.code[child].op)) block_[child] = block_[v];
      }
    }
  }

  void assign_crossings() {
    std::vector<std::uint32_t> last(size_, 0);  // block of the last use
    for (std::uint32_t v = 0; v < size_; ++v) {
      if (!live(v) || is_leaf(program_.code[v].op)) continue;
      const std::array<std::uint32_t, 2> operand{program_.code[v].a, program_.code[v].b};
      for (int k = 0; k < operands(v); ++k) {
        const std::uint32_t child = operand[static_cast<std::size_t>(k)];
        last[child] = std::max(last[child], block_[v]);
      }
    }
    // A place is free again for blocks after that of its last use; the lowest free place is taken.
    place_.assign(size_, kNone);
    std::vector<std::vector<std::uint32_t>> expiring(blocks_ + 1);
    std::priority_queue<std::uint32_t, std::vector<std::uint32_t>, std::greater<>> free_places;
    std::uint32_t current = 0;
    for (std::uint32_t v = 0; v < size_; ++v) {
      if (!live(v) || !named_[v]) continue;
      for (; current < block_[v]; ++current)
        for (const std::uint32_t place : expiring[current]) free_places.push(place);
      if (last[v] <= block_[v]) continue;
      if (free_places.empty()) free_places.push(static_cast<std::uint32_t>(crossing_++));
      place_[v] = free_places.top();
      free_places.pop();
      expiring[last[v]].push_back(place_[v]);
    }
  }

  const Program& program_;
  std::size_t size_;
  std::vector<std::uint32_t> uses_, number_, block_, place_;
  std::vector<bool> named_;
  std::vector<std::vector<std::pair<std::uint32_t, std::uint32_t>>> results_;
  std::uint32_t blocks_ = 1;
  std::size_t crossing_ = 0;
};

/// Writes the statements of a layout.
class Writer {
 public:
  Writer(const Program& program, const FunctionSignature& signature)
      : program_(program), signature_(signature), layout_(program) {}

  FunctionBody write() {
    const std::size_t size = program_.code.size();
    text_.resize(size);
    binding_.assign(size, Binding::primary);
    loaded_in_.assign(size, kNone);
    body_.blocks.resize(layout_.blocks());
    states_.resize(layout_.blocks());
    for (std::uint32_t v = 0; v < size; ++v)
      if (layout_.live(v)) write_value(v);
    // Results that are inputs or constants.
    const std::uint32_t last = layout_.blocks() - 1;
    for (std::uint32_t v = 0; v < size; ++v)
      if (layout_.live(v) && !layout_.named(v) && !layout_.results(v).empty()) {
        const std::string value = operand(v, last, Binding::sum);
        for (const auto& [array, index] : layout_.results(v)) store(last, array, index, value);
      }
    for (std::size_t b = 0; b < body_.blocks.size(); ++b) finish(b);
    body_.crossing = layout_.crossing();
    return std::move(body_);
  }

 private:
  struct BlockState {
    std::set<std::uint32_t> inputs;  ///< indices into program.inputs
    std::set<std::string> calls;
    std::string lines;
  };

  void line(std::uint32_t block, std::string_view text) {
    states_[block].lines += text;
    states_[block].lines += '\n';
    ++body_.blocks[block].statements;
  }

  void store(std::uint32_t block, std::uint32_t array, std::uint32_t index, std::string_view value) {
    line(block, fmt::format("{}[{}] = {};", signature_.results[array].name, index, value));
  }

  /// Text of value v for use in `block`, in parentheses if it binds less than `least`. Texts of unnamed
  /// values are used once and then dropped.
  std::string operand(std::uint32_t v, std::uint32_t block, Binding least) {
    const Instruction& instruction = program_.code[v];
    if (instruction.op == Operation::constant)
      return fmt::format("S({})", number_literal(program_.constants[instruction.a]));
    if (instruction.op == Operation::input) {
      states_[block].inputs.insert(instruction.a);
      return input_local(program_.inputs[instruction.a]);
    }
    if (layout_.named(v)) {
      if (layout_.block(v) != block && loaded_in_[v] != block) {
        loaded_in_[v] = block;
        line(block, fmt::format("const S t{} = w[{}];", layout_.number(v), layout_.place(v)));
      }
      return fmt::format("t{}", layout_.number(v));
    }
    std::string text = std::move(text_[v]);
    text_[v].clear();
    return binding_[v] < least ? fmt::format("({})", text) : text;
  }

  std::string binary(const Instruction& c, std::uint32_t block, std::string_view sign, Binding left,
                     Binding right) {
    const std::string a = operand(c.a, block, left);
    const std::string b = operand(c.b, block, right);
    return fmt::format("{} {} {}", a, sign, b);
  }

  std::string call(const Instruction& c, std::uint32_t block) {
    const std::string_view name = call_name(c.op);
    states_[block].calls.emplace(name);
    const std::string a = operand(c.a, block, Binding::sum);
    if (operand_count(c.op) == 1) return fmt::format("{}({})", name, a);
    const std::string b = operand(c.b, block, Binding::sum);
    return fmt::format("{}({}, {})", name, a, b);
  }

  void write_value(std::uint32_t v) {
    const Instruction& c = program_.code[v];
    const std::uint32_t block = layout_.block(v);
    std::string text;
    Binding binding = Binding::primary;
    switch (c.op) {
      case Operation::constant:
      case Operation::input:
        return;
      // Operators of equal rank associate to the left, as the text on the right of one is put in parentheses.
      case Operation::add:
        text = binary(c, block, "+", Binding::sum, Binding::product);
        binding = Binding::sum;
        break;
      case Operation::sub:
        text = binary(c, block, "-", Binding::sum, Binding::product);
        binding = Binding::sum;
        break;
      case Operation::mul:
        text = binary(c, block, "*", Binding::product, Binding::sign);
        binding = Binding::product;
        break;
      case Operation::div:
        text = binary(c, block, "/", Binding::product, Binding::sign);
        binding = Binding::product;
        break;
      case Operation::neg:
        text = fmt::format("-{}", operand(c.a, block, Binding::primary));
        binding = Binding::sign;
        break;
      case Operation::sqrt:
      case Operation::sin:
      case Operation::cos:
      case Operation::tan:
      case Operation::asin:
      case Operation::acos:
      case Operation::atan:
      case Operation::atan2:
      case Operation::exp:
      case Operation::log:
      case Operation::abs:
      case Operation::sign:
      case Operation::sinh:
      case Operation::cosh:
      case Operation::tanh:
      case Operation::pow:
        text = call(c, block);
        break;
    }
    if (!layout_.named(v)) {
      text_[v] = std::move(text);
      binding_[v] = binding;
      return;
    }
    if (layout_.result_only(v)) {
      const auto& [array, index] = layout_.results(v).front();
      store(block, array, index, text);
      return;
    }
    const std::string name = fmt::format("t{}", layout_.number(v));
    line(block, fmt::format("const S {} = {};", name, text));
    if (layout_.place(v) != kNone) line(block, fmt::format("w[{}] = {};", layout_.place(v), name));
    for (const auto& [array, index] : layout_.results(v)) store(block, array, index, name);
  }

  void finish(std::size_t b) {
    BlockState& state = states_[b];
    CodeBlock& block = body_.blocks[b];
    for (const std::string& name : state.calls) {
      block.calls_sign |= name == "sign";
      block.using_lines += name == "sign" ? "using detail::sign;\n" : fmt::format("using ::std::{};\n", name);
    }
    // Two inputs of a program may be the same element.
    std::map<std::pair<ArgumentKind, std::uint32_t>, const InputSlot*> loaded;
    for (const std::uint32_t i : state.inputs)
      loaded.try_emplace({program_.inputs[i].kind, program_.inputs[i].index}, &program_.inputs[i]);
    for (const auto& [key, slot] : loaded) {
      block.statement_lines += fmt::format("const S {} = {};  // {}\n", input_local(*slot),
                                           input_source(*slot), comment_text(slot->name));
      ++block.statements;
    }
    block.statement_lines += state.lines;
    state.lines.clear();
  }

  const Program& program_;
  const FunctionSignature& signature_;
  Layout layout_;
  FunctionBody body_;
  std::vector<BlockState> states_;
  std::vector<std::string> text_;
  std::vector<Binding> binding_;
  std::vector<std::uint32_t> loaded_in_;
};

}  // namespace

FunctionBody function_body(const Program& program, const FunctionSignature& signature) {
  return Writer(program, signature).write();
}

}  // namespace alembert
