// Signs of values (see the header).
//
// p(n) is +1 if node n is to be computed and -1 if its negative is. Each node and each root puts a
// condition on the signs around it; a broken condition costs one negation. Two kinds of sweep lower the
// number of broken conditions: from the roots down, where a negation also moves to an operand at equal cost
// (it may vanish in a difference or a constant below), and from the leaves up, where only gains count.
#include "program/sign_placement.hpp"

#include <utility>

#include "support/operation.hpp"

namespace alembert {
namespace {

constexpr int kSweeps = 4;

class Placement {
 public:
  Placement(std::span<const Expr> roots, const Postorder& order)
      : graph_(roots.front().graph()),
        order_(order),
        size_(static_cast<std::uint32_t>(order.ids.size())),
        negative_(size_, 0),
        root_uses_(2 * std::size_t{size_}, 0),
        broken_(size_, 0),
        broken_above_(size_, 0) {
    for (const Expr& root : roots) ++root_uses_[order.local(root.ref())];
    collect_users();
    find_absorbing();
    for (std::uint32_t id = 0; id < size_; ++id)
      broken_above_[id] = static_cast<int>(root_uses_[id << 1 | 1]);
    for (std::uint32_t id = 0; id < size_; ++id) set_broken(id, breaks(id));
  }

  /// Whether each node is computed with its sign reversed.
  std::vector<std::uint8_t> run() {
    for (int sweep = 0; sweep < kSweeps; ++sweep) {
      bool changed = false;
      for (std::uint32_t id = size_; id-- > 0;) changed |= try_flip(id, true);
      for (std::uint32_t id = 0; id < size_; ++id) changed |= try_flip(id, false);
      if (!changed) break;
    }
    return std::move(negative_);
  }

 private:
  void collect_users() {
    user_begin_.assign(size_ + 1, 0);
    const auto each_operand = [this](auto&& action) {
      for (std::uint32_t id = 0; id < size_; ++id) {
        const LocalOperands n = order_.operands[id];
        if (arity(id) > 0) action(id, n.a >> 1);
        if (arity(id) > 1 && n.b >> 1 != n.a >> 1) action(id, n.b >> 1);
      }
    };
    each_operand([this](std::uint32_t, std::uint32_t operand) { ++user_begin_[operand + 1]; });
    for (std::size_t i = 1; i < user_begin_.size(); ++i) user_begin_[i] += user_begin_[i - 1];
    users_.resize(user_begin_.back());
    std::vector<std::uint32_t> fill(user_begin_.begin(), user_begin_.end() - 1);
    each_operand(
        [this, &fill](std::uint32_t user, std::uint32_t operand) { users_[fill[operand]++] = user; });
  }

  // Nodes whose negative costs nothing, if nothing else needs what is below them: differences, constant
  // factors, and what passes a sign on to one of these.
  void find_absorbing() {
    absorbing_.assign(size_, 0);
    const auto passes_on = [this](std::uint32_t v) { return is_constant(v) || absorbing_[v >> 1] != 0; };
    for (std::uint32_t id = 0; id < size_; ++id) {
      if (arity(id) == 0) continue;
      const LocalOperands n = order_.operands[id];
      const Operation kind = op(id);
      if (kind == Operation::add)
        absorbing_[id] = (n.b & 1) != 0 || passes_on(n.a) || passes_on(n.b);
      else if (kind == Operation::mul || kind == Operation::div)
        absorbing_[id] = passes_on(n.a) || passes_on(n.b);
      else if (parity(kind) == Parity::odd)
        absorbing_[id] = passes_on(n.a);
    }
  }

  // Sign of the computed value of v relative to v.
  bool minus(std::uint32_t v) const { return ((v & 1) != 0) != (negative_[v >> 1] != 0); }
  int mismatch(std::uint32_t v) const { return !is_constant(v) && minus(v) ? 1 : 0; }

  int breaks(std::uint32_t id) const {
    const bool flip = negative_[id] != 0;
    if (arity(id) == 0) return 0;
    const LocalOperands n = order_.operands[id];
    const Operation kind = op(id);
    const bool any_constant = is_constant(n.a) || (arity(id) == 2 && is_constant(n.b));
    if (kind == Operation::add) return !any_constant && flip != minus(n.a) && flip != minus(n.b) ? 1 : 0;
    if (kind == Operation::mul || kind == Operation::div)
      return !any_constant && (flip != minus(n.a)) != minus(n.b) ? 1 : 0;
    switch (parity(kind)) {
      case Parity::odd:
        return flip != minus(n.a) ? 1 : 0;
      case Parity::even:
        return flip ? 1 : 0;
      case Parity::none:
        break;
    }
    return (flip ? 1 : 0) + mismatch(n.a) + (arity(id) == 2 ? mismatch(n.b) : 0);
  }

  // Of a node's condition as it is found to be now; what is broken above its operands follows.
  void set_broken(std::uint32_t id, int now) {
    const int more = now - broken_[id];
    if (more == 0) return;
    broken_[id] = static_cast<std::uint8_t>(now);
    const LocalOperands n = order_.operands[id];
    if (arity(id) > 0) broken_above_[n.a >> 1] += more;
    if (arity(id) > 1 && n.b >> 1 != n.a >> 1) broken_above_[n.b >> 1] += more;
  }

  bool try_flip(std::uint32_t id, bool move_down) {
    const int above = broken_above_[id], here = broken_[id];
    if (above + here == 0) return false;
    if (arity(id) == 0) return false;
    negative_[id] ^= 1;
    const std::span users(users_.data() + user_begin_[id], user_begin_[id + 1] - user_begin_[id]);
    int new_above = static_cast<int>(root_uses_[id << 1 | (negative_[id] != 0 ? 0u : 1u)]);
    for (const std::uint32_t user : users) new_above += breaks(user);
    const int new_here = breaks(id);
    const bool fewer = new_above + new_here < above + here;
    const bool moved =
        move_down && absorbing_[id] != 0 && new_above + new_here == above + here && new_above < above;
    if (!fewer && !moved) {
      negative_[id] ^= 1;
      return false;
    }
    set_broken(id, new_here);
    for (const std::uint32_t user : users) set_broken(user, breaks(user));
    broken_above_[id] = new_above;
    return true;
  }

  Operation op(std::uint32_t id) const { return graph_.node(order_.ids[id]).op; }
  bool is_constant(std::uint32_t local) const { return graph_.node(order_.ids[local >> 1]).constant; }
  // Constants are leaves here.
  int arity(std::uint32_t id) const { return is_constant(id << 1) ? 0 : operand_count(op(id)); }

  const ExprGraph& graph_;
  const Postorder& order_;
  std::uint32_t size_;
  std::vector<std::uint8_t> negative_;
  std::vector<std::uint32_t> root_uses_;  ///< by position and sign
  std::vector<std::uint32_t> user_begin_, users_;
  std::vector<std::uint8_t> absorbing_;
  std::vector<std::uint8_t> broken_;  ///< conditions of each node; a function of two operands may break three
  std::vector<int> broken_above_;     ///< of its users and of roots
};

}  // namespace

std::vector<std::uint8_t> place_signs(std::span<const Expr> roots, const Postorder& order) {
  return Placement(roots, order).run();
}

}  // namespace alembert
