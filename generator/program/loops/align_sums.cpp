// Orders sums and products like those one step further along, see similar_values.hpp.
#include "program/loops/align_sums.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "program/loops/similar_values.hpp"
#include "support/no_index.hpp"
#include "support/operation.hpp"

namespace alembert {
namespace {

/// Operands of a flattened value and how they are put together: operands and operations in postfix notation.
struct Tree {
  std::vector<UnsignedProgram::Operand> leaves;
  std::vector<bool> is_leaf;
};

class Alignment {
 public:
  Alignment(const Program& program, Shift shift, std::span<const int> depths)
      : given_(program),
        binary_(program),
        flat_(program, UnsignedProgram::Form::flattened),
        map_(corresponding_values(flat_, shift, depths)) {}

  Program run() {
    std::vector<std::optional<Tree>> changed(binary_.size());
    for (std::uint32_t v = 0; v < binary_.size(); ++v)
      if (map_.previous[v] == kNoIndex && map_.next[v] != kNoIndex && flat_.commutes(v))
        align_row(v, changed);
    return rewritten(changed);
  }

 private:
  Tree tree(std::uint32_t v) const {
    Tree out;
    const auto operands = flat_.operands(v);
    out.leaves.assign(operands.begin(), operands.end());
    std::vector<std::pair<std::uint32_t, std::size_t>> stack{{v, 0}};  // and the operand to visit next
    while (!stack.empty()) {
      auto& [x, next] = stack.back();
      const auto parts = binary_.operands(x);
      if (next == parts.size()) {
        out.is_leaf.push_back(false);
        stack.pop_back();
      } else if (const std::uint32_t y = parts[next++].value; flat_.absorbed(y)) {
        stack.emplace_back(y, 0);
      } else {
        out.is_leaf.push_back(true);
      }
    }
    return out;
  }

  /// From the middle of the row on both ways: at its ends a sum may be of another shape, which need not be
  /// good.
  void align_row(std::uint32_t first, std::vector<std::optional<Tree>>& changed) {
    std::vector<std::uint32_t> row;
    for (std::uint32_t v = first; v != kNoIndex; v = map_.next[v]) row.push_back(v);
    const std::size_t middle = row.size() / 2;
    Tree model = tree(row[middle]);
    for (std::size_t k = middle + 1; k < row.size(); ++k) align(row[k], map_.next, model, changed);
    model = tree(row[middle]);
    for (std::size_t k = middle; k-- > 0;) align(row[k], map_.previous, model, changed);
  }

  /// Puts a value together as the model, if its operands are what `across` leads to from those of the model,
  /// and makes it the model.
  void align(std::uint32_t v, const std::vector<std::uint32_t>& across, Tree& model,
             std::vector<std::optional<Tree>>& changed) const {
    Tree own = tree(v);
    if (std::optional<Tree> like = in_order_of(model, across, own)) {
      if (!same(*like, own)) changed[v] = like;
      model = std::move(*like);
    } else {
      model = std::move(own);
    }
  }

  static bool same(const Tree& x, const Tree& y) {
    return x.is_leaf == y.is_leaf &&
           std::ranges::equal(x.leaves, y.leaves, {}, &UnsignedProgram::Operand::value,
                              &UnsignedProgram::Operand::value);
  }

  /// The operands of a tree in the order of another whose operands correspond to them, or nothing.
  std::optional<Tree> in_order_of(const Tree& model, const std::vector<std::uint32_t>& across,
                                  const Tree& own) const {
    if (model.leaves.size() != own.leaves.size()) return std::nullopt;
    Tree out{{}, model.is_leaf};
    std::vector<UnsignedProgram::Operand> rest = own.leaves;
    for (const UnsignedProgram::Operand& operand : model.leaves) {
      const std::uint32_t x = operand.value;
      const auto found =
          std::ranges::find_if(rest, [&](const auto& y) { return binary_.pair(across, x, y.value); });
      if (found == rest.end()) return std::nullopt;
      out.leaves.push_back(*found);
      rest.erase(found);
    }
    return out;
  }

  /// The program with some trees in place of what they were.
  Program rewritten(const std::vector<std::optional<Tree>>& changed) {
    std::vector<bool> dropped(binary_.size(), false);
    for (std::uint32_t v = 0; v < binary_.size(); ++v)
      if (changed[v]) drop_inner(v, dropped);
    for (std::uint32_t v = 0; v < binary_.size(); ++v)
      if (binary_.op(v) == Operation::neg) dropped[v] = dropped[binary_.plain(v).value];
    out_ = given_;
    out_.code.clear();
    place_.assign(given_.code.size(), 0);
    for (std::uint32_t v = 0; v < given_.code.size(); ++v) {
      if (v < binary_.size() && dropped[v]) continue;
      if (v < binary_.size() && changed[v]) {
        place_[v] = write(*changed[v], binary_.op(v));
        continue;
      }
      Instruction c = given_.code[v];
      const int operands = operand_count(c.op);
      if (operands > 0) c.a = place_[c.a];
      if (operands > 1) c.b = place_[c.b];
      place_[v] = append(c.op, c.a, c.b);
    }
    const auto move = [&](std::vector<std::uint32_t>& values) {
      for (std::uint32_t& v : values) v = place_[v];
    };
    for (OutputArray& output : out_.outputs) move(output.values);
    for (DotProducts& products : out_.dot_products) {
      move(products.left);
      move(products.right);
    }
    return std::move(out_);
  }

  void drop_inner(std::uint32_t root, std::vector<bool>& dropped) const {
    std::vector<std::uint32_t> stack{root};
    while (!stack.empty()) {
      const std::uint32_t v = stack.back();
      stack.pop_back();
      for (const auto& o : binary_.operands(v))
        if (flat_.absorbed(o.value)) {
          dropped[o.value] = true;
          stack.push_back(o.value);
        }
    }
  }

  std::uint32_t append(Operation op, std::uint32_t a, std::uint32_t b) {
    out_.code.push_back({op, a, b});
    return static_cast<std::uint32_t>(out_.code.size() - 1);
  }

  std::uint32_t write(const Tree& tree, Operation op) {
    std::vector<UnsignedProgram::Operand> stack;
    auto leaf = tree.leaves.begin();
    for (const bool is_leaf : tree.is_leaf) {
      if (is_leaf) {
        stack.push_back({place_[leaf->value], leaf->negative});
        ++leaf;
        continue;
      }
      const UnsignedProgram::Operand b = stack.back();
      stack.pop_back();
      UnsignedProgram::Operand& a = stack.back();
      if (op == Operation::mul)
        a = {append(op, a.value, b.value), a.negative != b.negative};
      else if (a.negative == b.negative)
        a = {append(Operation::add, a.value, b.value), a.negative};
      else
        a = {a.negative ? append(Operation::sub, b.value, a.value) : append(Operation::sub, a.value, b.value),
             false};
    }
    return stack[0].negative ? append(Operation::neg, stack[0].value, 0) : stack[0].value;
  }

  const Program& given_;
  UnsignedProgram binary_, flat_;
  Correspondence map_;
  Program out_;
  std::vector<std::uint32_t> place_;
};

}  // namespace

Program align_sums(const Program& program, Shift shift, std::span<const int> depths) {
  return Alignment(program, shift, depths).run();
}

}  // namespace alembert
