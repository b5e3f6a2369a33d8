// One sweep over the nodes of the roots, operands first.
#include "symbolic/transferred.hpp"

#include "symbolic/builder.hpp"
#include "symbolic/rebuilt.hpp"

namespace alembert {

namespace {

Ref transferred_symbol(const ExprGraph& from, std::uint32_t id, ExprGraph& to) {
  const std::uint32_t known = to.symbol_count();
  const Expr symbol = to.symbol(from.symbol_name(from.symbol_index(id)));
  if (to.symbol_count() != known) to.assume(symbol, from.bounds(Ref(id, false)));
  return symbol.ref();
}

}  // namespace

std::vector<Expr> transferred(std::span<const Expr> roots, ExprGraph& to) {
  Builder builder(to);
  std::vector<Expr> out = rebuilt(roots, [&](std::uint32_t id, Ref a, Ref b) {
    const ExprGraph& from = roots.front().graph();
    const Operation op = from.node(id).op;
    if (op == Operation::symbol) return transferred_symbol(from, id, to);
    if (op == Operation::rational) return builder.number(from.rational_value(id));
    if (op == Operation::pi_multiple) return builder.pi(from.rational_value(id));
    if (op == Operation::real) return builder.real(from.real_value(id));
    return builder.intern(op, a, b);
  });
  for (Expr& root : out) root = Expr(to, root.ref());
  return out;
}

}  // namespace alembert
