// Writes programs as statements, see the header.
#include "emit/statements/statements.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string_view>
#include <utility>

#include "emit/statements/input_text.hpp"
#include "emit/statements/literals.hpp"
#include "registers/register_plan.hpp"
#include "support/error.hpp"
#include "support/no_index.hpp"
#include "support/operation.hpp"

namespace alembert {
namespace {

// Equal results at even distances are written one by one if there are fewer.
constexpr std::size_t kFewestInRun = 32;

// For the second of such a run, so many results are tried: what lies between may be another run.
constexpr std::size_t kTries = 4;

/// How strongly the text of a value binds.
enum class Binding : std::uint8_t { sum, product, sign, primary };

/// Writes the statements of a layout.
class Writer {
 public:
  Writer(const Program& program, const OutputFunction& signature, const BlockSizes& sizes,
         Registers registers, const Syntax& syntax)
      : program_(program),
        signature_(signature),
        syntax_(syntax),
        longest_(sizes.longest),
        layout_(program, sizes, grain_of(program, registers)) {
    if (grain_of(program, registers) == Grain::operations) plan_.emplace(program_, layout_);
  }

  /// Whether the values of loops, if there are loops, can be arranged.
  bool possible() const { return !layout_.loops() || layout_.loops()->possible(); }

  FunctionBody write() {
    const std::size_t size = program_.code.size();
    text_.resize(size);
    binding_.assign(size, Binding::primary);
    body_.blocks.resize(layout_.blocks());
    states_.resize(layout_.blocks());
    std::size_t loop = 0;
    // Loops read them.
    if (layout_.loops()) write_leaves(0);
    for (std::uint32_t v = 0; v < size; ++v) {
      if (loop < program_.loops.size() && v == program_.loops[loop].first) {
        write_loop(loop);
        v += program_.loops[loop].length * program_.loops[loop].count - 1;
        ++loop;
      } else if (layout_.live(v)) {
        write_value(v);
      }
    }
    const std::uint32_t last = layout_.blocks() - 1;
    layout_.loops() ? write_late(last) : write_leaves(cuts_leaves() ? add_block() : last);
    // Behind the entries of their tables, wherever these are.
    const auto end = static_cast<std::uint32_t>(body_.blocks.size() - 1);
    for (std::size_t i = 0; i < program_.dot_products.size(); ++i)
      write_dot_products(end, program_.dot_products[i], layout_.tables()[i]);
    if (body_.blocks.size() == 1 && layout_.crossing() > 0 && !plan_ &&
        syntax_.dialect != Dialect::javascript)
      states_[0].lines.insert(0, fmt::format("{} kept[{}];\n", syntax_.number, layout_.crossing()));
    for (std::size_t b = 0; b < body_.blocks.size(); ++b) finish(b);
    body_.crossing = plan_ ? plan_->crossing() : layout_.crossing();
    return std::move(body_);
  }

 private:
  static Grain grain_of(const Program& program, Registers registers) {
    return registers == Registers::planned ? grain_over_packs(program) : Grain::expressions;
  }

  struct BlockState {
    std::set<std::pair<ArgumentKind, std::uint32_t>> inputs;  ///< loaded so far
    std::set<std::uint32_t> loaded;                           ///< values of earlier blocks
    std::map<std::string, std::string> elements;              ///< what a loop has read, with its name
    std::set<std::string> calls;
    std::set<std::string> touched;  ///< elements that the compiler may take for known
    std::string lines;
  };

  void line(std::uint32_t block, std::string_view text) {
    states_[block].lines += prefix_lines(text, indent_);
    states_[block].lines += '\n';
    ++body_.blocks[block].statements;
  }

  void define(std::uint32_t block, std::string_view name, std::string_view value,
              std::string_view comment = "") {
    line(block, syntax_.definition(name, value) + std::string(comment));
  }
  /// The same of what the calls for sines and cosines may take from elsewhere.
  void define_angle(std::uint32_t block, std::string_view name, std::string_view value,
                    std::string_view comment) {
    line(block, fmt::format("[[maybe_unused]] const {} {} = {};{}", syntax_.number, name, value, comment));
  }

  void store(std::uint32_t block, std::uint32_t array, std::uint32_t index, std::string_view value) {
    line(block, fmt::format("{}[{}] = {};", signature_.results[array].name, index, value));
  }

  void keep(std::uint32_t block, std::uint32_t place, std::string_view value) {
    std::string element = fmt::format("kept[{}]", place);
    line(block, fmt::format("{} = {};", element, value));
    if (plan_) states_[block].touched.insert(std::move(element));
  }

  /// Where memory has a value, as the plan reads it.
  std::string element_of(std::uint32_t v, std::uint32_t block) const {
    if (program_.code[v].op == Operation::input)
      return input_source(program_.inputs[program_.code[v].a], syntax_);
    if (layout_.angle(v) != kNoIndex && layout_.block(v) == block) return from_trig_call(v);
    const std::uint32_t place = !layout_.table_places(v).empty() ? layout_.table_places(v).front()
                                : layout_.place(v) != kNoIndex   ? layout_.place(v)
                                                                 : plan_->slot(v);
    return fmt::format("kept[{}]", place);
  }

  /// Says so if the compiler could take one of these elements for known.
  void read_again(std::uint32_t block, const std::vector<std::string>& elements) {
    std::set<std::string>& touched = states_[block].touched;
    if (std::ranges::any_of(elements, [&](const std::string& e) { return touched.contains(e); })) {
      line(block, "ALEMBERT_FROM_MEMORY;");
      touched.clear();
    }
    touched.insert(elements.begin(), elements.end());
  }

  /// Brings the operands of a statement to where the plan wants them.
  void begin_planned(std::uint32_t statement, std::uint32_t block) {
    if (statement == planned_) return;
    planned_ = statement;
    std::vector<std::string> elements;
    for (const auto& [v, from] : plan_->reads(statement)) {
      if (from == OperandFrom::a_register) continue;
      elements.push_back(element_of(v, block));
      if (from == OperandFrom::memory) text_in_plan_[v] = elements.back();
    }
    read_again(block, elements);
    for (const auto& [v, from] : plan_->reads(statement)) {
      if (from != OperandFrom::memory_into_register) continue;
      const Instruction& c = program_.code[v];
      const bool input = c.op == Operation::input;
      std::string name = input ? input_local(program_.inputs[c.a]) : fmt::format("t{}", layout_.number(v));
      // Two inputs of a program may be the same element.
      const int again = times_named_[name]++;
      if (again > 0) name += fmt::format("_{}", again + 1);
      const std::string comment = input ? "  // " + comment_text(program_.inputs[c.a].name) : "";
      const bool angle =
          input && layout_.trig_call() != kNoIndex && statement == layout_.statement(layout_.trig_call());
      if (angle)
        define_angle(block, name, element_of(v, block), comment);
      else
        define(block, name, element_of(v, block), comment);
      text_in_plan_[v] = std::move(name);
    }
  }

  /// Whether there are blocks, and what they may hold is a matter of speed.
  bool cuts_leaves() const { return syntax_.dialect == Dialect::javascript && layout_.blocks() > 1; }
  std::uint32_t add_block() {
    body_.blocks.emplace_back();
    states_.emplace_back();
    return static_cast<std::uint32_t>(body_.blocks.size() - 1);
  }

  /// Results and entries of tables that are inputs or constants.
  void write_leaves(std::uint32_t block) {
    for (std::uint32_t v = 0; v < program_.code.size(); ++v)
      if (layout_.live(v) && is_leaf(program_.code[v].op) &&
          !(layout_.results(v).empty() && layout_.table_places(v).empty())) {
        const bool again = plan_ && program_.code[v].op == Operation::input;
        if (again) read_again(block, {element_of(v, block)});
        std::span<const std::pair<std::uint32_t, std::uint32_t>> results = layout_.results(v);
        for (; cuts_leaves() && !layout_.loops() && results.size() > longest_; block = add_block()) {
          store_all(block, results.first(longest_), operand(v, block, Binding::sum));
          results = results.subspan(longest_);
        }
        const std::string value = again ? element_of(v, block) : operand(v, block, Binding::sum);
        store_all(block, results, value);
        for (const std::uint32_t place : layout_.table_places(v)) keep(block, place, value);
      }
  }

  /// Results that are the same at even distances are a loop, as the zeros of Jacobians are and the angular
  /// velocity that all bodies behind a joint have from it.
  void store_all(std::uint32_t block, std::span<const std::pair<std::uint32_t, std::uint32_t>> results,
                 std::string_view value) {
    std::vector<bool> stored(results.size(), false);
    // Those at even distances from two on, as far as they go.
    const auto run_of = [&](std::size_t i, std::size_t second) {
      const auto [array, first] = results[i];
      const std::uint32_t step = results[second].second - first;
      std::vector<std::size_t> run{i};
      for (std::size_t next = second; next < results.size() && !stored[next];) {
        const std::pair<std::uint32_t, std::uint32_t> wanted(
            array, first + static_cast<std::uint32_t>(run.size()) * step);
        if (results[next] != wanted) break;
        run.push_back(next);
        const auto after = std::ranges::lower_bound(results, std::pair(array, wanted.second + step));
        next = static_cast<std::size_t>(after - results.begin());
      }
      return run;
    };
    for (std::size_t i = 0; i < results.size(); ++i) {
      if (stored[i]) continue;
      std::vector<std::size_t> found;
      for (std::size_t k = i + 1; k < results.size() && k <= i + kTries && found.size() < kFewestInRun; ++k)
        found = run_of(i, k);
      const auto [array, first] = results[i];
      if (found.size() < kFewestInRun) {
        store(block, array, first, value);
        continue;
      }
      for (const std::size_t k : found) stored[k] = true;
      const std::uint32_t step = results[found[1]].second - first;
      const std::string next = step == 1 ? "++i" : fmt::format("i += {}", step);
      line(block, fmt::format("for ({} i = {}; i <= {}; {}) {}[i] = {};", syntax_.counter(), first,
                              results[found.back()].second, next, signature_.results[array].name, value));
    }
  }

  /// What loops leave for straight code to put in its place.
  void write_late(std::uint32_t block) {
    for (std::uint32_t v = 0; v < program_.code.size(); ++v)
      if (layout_.loops()->loop(v) != kNoIndex && !layout_.results(v).empty())
        store_all(block, layout_.results(v), fmt::format("kept[{}]", layout_.place(v)));
    for (const auto& [v, place] : layout_.loops()->late())
      keep(block, place, fmt::format("kept[{}]", layout_.place(v)));
  }

  void write_loop(std::size_t number) {
    const Loop& loop = program_.loops[number];
    const LoopBody& body = layout_.loops()->bodies()[number];
    const std::uint32_t block = layout_.block(loop.first);
    if (body.columns > 0) {
      std::string numbers;
      for (const double c : body.constants) numbers += syntax_.table_constant(c) + ", ";
      numbers.resize(numbers.size() - 2);
      line(block, syntax_.table_definition(wrap_list(numbers, 4, 4)));
    }
    // What an iteration hands to the next, by value and element.
    std::map<std::pair<std::uint32_t, std::int64_t>, std::string> carried;
    for (const auto& pair : body.operands)
      for (const LoopOperand& o : pair)
        if (o.kind == LoopOperand::Kind::carried)
          carried.try_emplace({o.index, o.element.first}, read_carried(block, o, true));
    line(block, fmt::format("for ({} k = 0; k < {}; ++k) {{", syntax_.counter(), loop.count));
    indent_ = "  ";
    if (body.columns > 0) line(block, syntax_.table_row(body.columns));
    for (std::uint32_t v = loop.first; v < loop.first + loop.length; ++v) write_value(v);
    for (const auto& [from, name] : carried)
      line(block, fmt::format("{} = t{};", name, layout_.number(loop.first + from.first)));
    indent_ = "";
    line(block, "}");
  }

  static std::string index_text(const Element& e) {
    if (e.step == 0) return std::to_string(e.first);
    const std::int64_t size = e.step < 0 ? -e.step : e.step;
    const std::string moving = size == 1 ? "k" : fmt::format("{} * k", size);
    if (e.first == 0 && e.step > 0) return moving;
    return fmt::format("{} {} {}", e.first, e.step < 0 ? '-' : '+', moving);
  }

  std::string array_text(ArgumentKind kind, const Element& e) const {
    InputSlot slot{kind, 0, ""};
    std::string text = input_source(slot, syntax_);
    const std::size_t index = text.rfind("[0]");
    return index == std::string::npos ? text : text.substr(0, index + 1) + index_text(e) + "]";
  }

  /// Operand k of value v for use in `block`.
  std::string operand_of(std::uint32_t v, std::size_t k, std::uint32_t block, Binding least) {
    const Instruction& c = program_.code[v];
    const std::uint32_t value = k == 0 ? c.a : c.b;
    if (!layout_.loops() || layout_.loops()->loop(v) == kNoIndex) return operand(value, block, least);
    const LoopOperand& o =
        layout_.loops()->bodies()[layout_.loops()->loop(v)].operands[v - layout_.first_of_loop(v)][k];
    switch (o.kind) {
      case LoopOperand::Kind::inside:
      case LoopOperand::Kind::literal:
        return operand(value, block, least);
      case LoopOperand::Kind::constant:
        return syntax_.row_entry(o.index);
      case LoopOperand::Kind::input:
        return read_once(block, array_text(o.array, o.element));
      case LoopOperand::Kind::memory:
        return read_once(block, fmt::format("kept[{}]", index_text(o.element)));
      case LoopOperand::Kind::carried:
        return read_carried(block, o, false);
    }
    throw InternalError("emit: operand of unknown kind");
  }

  /// The name of an element that a loop reads.
  std::string read_once(std::uint32_t block, const std::string& element) {
    return named_element(block, element, element, false);
  }
  /// The name of what iterations hand over, which begins as an element of kept.
  std::string read_carried(std::uint32_t block, const LoopOperand& o, bool varies) {
    return named_element(block, fmt::format("{} {}", o.index, o.element.first),
                         fmt::format("kept[{}]", o.element.first), varies);
  }
  std::string named_element(std::uint32_t block, const std::string& key, const std::string& element,
                            bool varies) {
    auto& names = states_[block].elements;
    const auto [entry, fresh] = names.try_emplace(key, fmt::format("x{}", names.size()));
    if (fresh) line(block, syntax_.definition(entry->second, element, varies));
    return entry->second;
  }

  /// Whether results of the second run lie below those of the first, and of their mirror to the right, up to
  /// the same end.
  static bool is_row_below(const DotProducts::Run& one, const DotProducts::Run& next) {
    const std::uint32_t head = next.right - one.right;
    return one.mirrored() && next.left == one.left + 1 && next.right >= one.right && next.step == one.step &&
           head + next.count == one.count && next.first == one.first + head + one.step &&
           next.mirror == one.mirror + head * one.step + 1 && next.mirrored();
  }

  void write_dot_products(std::uint32_t block, const DotProducts& products,
                          const StatementLayout::TablePlace& tables) {
    const std::string_view result = signature_.results[products.output].name;
    const std::size_t rows = products.right.size() / products.terms;
    for (std::size_t i = 0; i < products.runs.size(); ++i) {
      const DotProducts::Run& run = products.runs[i];
      if (syntax_.dialect == Dialect::javascript) {
        line(block,
             fmt::format("{}({}, {}, {}, {}, {}, {}, {}, {}, {}, {});", syntax_.function("dot_products"),
                         products.terms, tables.left + products.terms * run.left, tables.right + run.right,
                         rows, run.count, result, run.first, run.stride, run.mirror, run.step));
        continue;
      }
      if (syntax_.dialect == Dialect::c) {
        line(block, fmt::format("{}({}, kept + {}, kept + {}, {}, {}, {} + {}, {}, {} + {}, {});",
                                syntax_.function("dot_products"), products.terms,
                                tables.left + products.terms * run.left, tables.right + run.right, rows,
                                run.count, result, run.first, run.stride, result, run.mirror, run.step));
        continue;
      }
      const bool two = i + 1 < products.runs.size() && is_row_below(run, products.runs[i + 1]);
      const std::string head = two ? fmt::format("{}, ", products.runs[i + 1].right - run.right) : "";
      const std::string first = run.mirrored() ? fmt::format("{} + {}, ", result, run.first) : "";
      line(block,
           fmt::format("dot_products<{}>(kept + {}, kept + {}, {}, {}{}, {}{} + {}, {});", products.terms,
                       tables.left + products.terms * run.left, tables.right + run.right, rows, head,
                       run.count, first, result, run.mirror, run.step));
      if (two) ++i;
    }
    states_[block].calls.emplace("dot_products");
  }

  /// Text of value v for use in `block`, in parentheses if it binds less than `least`. Texts of unnamed
  /// values are used once and then dropped.
  std::string operand(std::uint32_t v, std::uint32_t block, Binding least) {
    const Instruction& instruction = program_.code[v];
    if (instruction.op == Operation::constant) return syntax_.constant(program_.constants[instruction.a]);
    if (const auto planned = text_in_plan_.find(v); plan_ && planned != text_in_plan_.end())
      return planned->second;
    if (instruction.op == Operation::input) {
      const InputSlot& slot = program_.inputs[instruction.a];
      // Two inputs of a program may be the same element.
      if (states_[block].inputs.emplace(slot.kind, slot.index).second)
        define(block, input_local(slot), input_source(slot, syntax_), "  // " + comment_text(slot.name));
      return input_local(slot);
    }
    if (layout_.named(v)) {
      // Not only the last block is written to: what is written into a user belongs to the user's block.
      if (layout_.block(v) != block && states_[block].loaded.insert(v).second) {
        define(block, fmt::format("t{}", layout_.number(v)), fmt::format("kept[{}]", layout_.place(v)));
      }
      const std::string name = fmt::format("t{}", layout_.number(v));
      if (layout_.angle(v) != kNoIndex && layout_.block(v) == block && states_[block].loaded.insert(v).second)
        define(block, name, from_trig_call(v));
      return name;
    }
    std::string text = std::move(text_[v]);
    text_[v].clear();
    return binding_[v] < least ? fmt::format("({})", text) : text;
  }

  std::string binary(std::uint32_t v, std::uint32_t block, std::string_view sign, Binding left,
                     Binding right) {
    const std::string a = operand_of(v, 0, block, left);
    const std::string b = operand_of(v, 1, block, right);
    return fmt::format("{} {} {}", a, sign, b);
  }

  /// Sines and cosines of all angles of the layout's call, into arrays. Coordinates that follow each other in
  /// q are taken from there.
  void write_trig_call(std::uint32_t block) {
    const std::vector<std::uint32_t>& angles = layout_.angles();
    std::string list;
    const InputSlot* first = nullptr;
    bool consecutive = true;
    for (std::uint32_t i = 0; i < angles.size(); ++i) {
      const Instruction& c = program_.code[angles[i]];
      const InputSlot* slot = c.op == Operation::input ? &program_.inputs[c.a] : nullptr;
      if (i == 0) first = slot;
      consecutive &= slot != nullptr && first != nullptr && slot->kind == ArgumentKind::q &&
                     first->kind == ArgumentKind::q && slot->index == first->index + i;
    }
    std::string source = "angle";
    // JavaScript reads coordinates by name anyway.
    if (consecutive && syntax_.dialect != Dialect::javascript) {
      source = first->index == 0 ? "q" : fmt::format("q + {}", first->index);
    } else {
      for (const std::uint32_t angle : angles)
        list += (list.empty() ? "" : ", ") + operand(angle, block, Binding::sum);
      line(block, syntax_.array("angle", list));
    }
    const std::size_t sines = layout_.trig_place();
    const std::string name = syntax_.function("sines_and_cosines");
    if (syntax_.dialect == Dialect::javascript && sines == kNoIndex) {
      line(block, "const sine = angle.map(Math.sin), cosine = angle.map(Math.cos);");
      return;
    }
    if (syntax_.dialect == Dialect::javascript) {
      line(block, fmt::format("{}(angle, {});", name, sines));
    } else if (sines != kNoIndex) {
      line(block, fmt::format("{}({}, {}, kept + {}, kept + {});", name, angles.size(), source, sines,
                              sines + angles.size()));
    } else {
      line(block, fmt::format("{0} sine[{1}], cosine[{1}];", syntax_.number, angles.size()));
      line(block, fmt::format("{}({}, {}, sine, cosine);", name, angles.size(), source));
    }
    states_[block].calls.emplace("sines_and_cosines");
  }

  std::string from_trig_call(std::uint32_t v) const {
    const bool sine = program_.code[v].op == Operation::sin;
    if (layout_.trig_place() != kNoIndex)
      return fmt::format("kept[{}]",
                         layout_.trig_place() + layout_.angle(v) + (sine ? 0 : layout_.angles().size()));
    return fmt::format("{}[{}]", sine ? "sine" : "cosine", layout_.angle(v));
  }

  std::string call(std::uint32_t v, std::uint32_t block) {
    const Instruction& c = program_.code[v];
    if (v == layout_.trig_call()) write_trig_call(block);
    if (layout_.angle(v) != kNoIndex) return from_trig_call(v);
    const std::string name = syntax_.function(operation_name(c.op));
    states_[block].calls.emplace(operation_name(c.op));
    const std::string a = operand_of(v, 0, block, Binding::sum);
    if (operand_count(c.op) == 1) return fmt::format("{}({})", name, a);
    const std::string b = operand_of(v, 1, block, Binding::sum);
    return fmt::format("{}({}, {})", name, a, b);
  }

  void write_value(std::uint32_t v) {
    const Instruction& c = program_.code[v];
    const std::uint32_t block = layout_.block(v);
    if (plan_ && !is_leaf(c.op)) begin_planned(layout_.statement(v), block);
    std::string text;
    Binding binding = Binding::primary;
    if (is_leaf(c.op)) return;
    // Operators of equal rank associate to the left, as the text on the right of one is put in parentheses.
    if (c.op == Operation::add || c.op == Operation::sub) {
      text = binary(v, block, operation_name(c.op), Binding::sum, Binding::product);
      binding = Binding::sum;
    } else if (c.op == Operation::mul || c.op == Operation::div) {
      text = binary(v, block, operation_name(c.op), Binding::product, Binding::sign);
      binding = Binding::product;
    } else if (c.op == Operation::neg) {
      text = fmt::format("-{}", operand_of(v, 0, block, Binding::primary));
      binding = Binding::sign;
    } else {
      text = call(v, block);
    }
    if (!layout_.named(v)) {
      text_[v] = std::move(text);
      binding_[v] = binding;
      return;
    }
    if (layout_.loops() && layout_.loops()->loop(v) != kNoIndex) {
      write_in_loop(v, block, text);
      return;
    }
    if (layout_.table_only(v)) {
      keep(block, layout_.table_places(v).front(), text);
      return;
    }
    if (layout_.result_only(v)) {
      const auto& [array, index] = layout_.results(v).front();
      store(block, array, index, text);
      return;
    }
    // What comes from the call for all angles gets its name where it is first used.
    const bool from_arrays = layout_.angle(v) != kNoIndex;
    const std::string name = from_arrays ? text : fmt::format("t{}", layout_.number(v));
    if (!from_arrays) define(block, name, text);
    if (plan_ && !from_arrays) {
      text_in_plan_[v] = name;
      ++times_named_[name];
      if (plan_->slot(v) != kNoIndex) keep(block, plan_->slot(v), name);
    }
    const std::vector<std::uint32_t>& in_tables = layout_.table_places(v);
    for (const std::uint32_t place : in_tables) keep(block, place, name);
    const bool there = from_arrays && layout_.trig_place() != kNoIndex;
    if (layout_.place(v) != kNoIndex && in_tables.empty() && !there) keep(block, layout_.place(v), name);
    store_all(block, layout_.results(v), name);
  }

  void write_in_loop(std::uint32_t v, std::uint32_t block, const std::string& text) {
    const LoopBody& body = layout_.loops()->bodies()[layout_.loops()->loop(v)];
    const std::uint32_t i = v - layout_.first_of_loop(v);
    std::vector<std::string> targets;
    for (const Element& e : body.stores[i]) targets.push_back(fmt::format("kept[{}]", index_text(e)));
    for (const auto& [array, e] : body.results[i])
      targets.push_back(fmt::format("{}[{}]", signature_.results[array].name, index_text(e)));
    const std::string name = fmt::format("t{}", layout_.number(v));
    define(block, name, text);
    for (const std::string& target : targets) line(block, fmt::format("{} = {};", target, name));
  }

  void finish(std::size_t b) {
    BlockState& state = states_[b];
    CodeBlock& block = body_.blocks[b];
    for (const std::string& name : state.calls) {
      if (is_helper(name)) block.helpers.insert(name);
      if (syntax_.dialect == Dialect::cpp)
        block.using_lines += fmt::format("using {}::{};\n", is_helper(name) ? "detail" : "::std", name);
    }
    block.statement_lines += state.lines;
    state.lines.clear();
  }

  const Program& program_;
  const OutputFunction& signature_;
  const Syntax& syntax_;
  std::size_t longest_;
  StatementLayout layout_;
  std::optional<RegisterPlan> plan_;
  std::uint32_t planned_ = kNoIndex;                   // the statement whose operands are in place
  std::map<std::uint32_t, std::string> text_in_plan_;  // of a value, at this statement
  std::map<std::string, int> times_named_;
  FunctionBody body_;
  std::vector<BlockState> states_;
  std::string indent_;
  std::vector<std::string> text_;
  std::vector<Binding> binding_;
};

}  // namespace

FunctionBody function_body(const Program& program, const OutputFunction& signature, const BlockSizes& sizes,
                           Registers registers, const Syntax& syntax) {
  Writer writer(program, signature, sizes, registers, syntax);
  if (writer.possible()) return writer.write();
  Program straight = program;
  straight.loops.clear();
  return Writer(straight, signature, sizes, registers, syntax).write();
}

}  // namespace alembert
