// The table of derivatives of the elementary operations.
#include "differentiation/partials.hpp"

#include "support/error.hpp"

namespace alembert {

namespace {

/// f'(x) for v = f(x).
Expr unary_partial(ExprGraph& graph, Op op, Expr v, Expr x) {
  const Expr one = graph.one();
  switch (op) {
    case Op::sqrt:
      return one / (graph.integer(2) * v);
    case Op::sin:
      return cos(x);
    case Op::cos:
      return -sin(x);
    case Op::tan:
      return one + v * v;
    case Op::asin:
      return one / sqrt(one - x * x);
    case Op::acos:
      return -(one / sqrt(one - x * x));
    case Op::atan:
      return one / (one + x * x);
    case Op::exp:
      return v;
    case Op::log:
      return one / x;
    case Op::abs:
      return sign(x);
    case Op::sign:
      return graph.zero();
    case Op::sinh:
      return cosh(x);
    case Op::cosh:
      return sinh(x);
    case Op::tanh:
      return one - v * v;
    case Op::rational:
    case Op::pi_multiple:
    case Op::real:
    case Op::symbol:
    case Op::add:
    case Op::mul:
    case Op::div:
    case Op::atan2:
    case Op::pow:
      break;
  }
  throw InternalError("local_partial: not a function of one operand");
}

/// d v / d x (slot 0) or d v / d y (slot 1) for v = x op y.
Expr binary_partial(ExprGraph& graph, Op op, Expr v, Expr x, Expr y, int slot) {
  const Expr one = graph.one();
  switch (op) {
    case Op::add:
      return one;
    case Op::mul:
      return slot == 0 ? y : x;
    case Op::div: {
      // One reciprocal serves both slots, and v is there already.
      const Expr reciprocal = one / y;
      return slot == 0 ? reciprocal : -(v * reciprocal);
    }
    case Op::atan2: {
      const Expr x_squared = x * x;
      const Expr y_squared = y * y;
      const Expr squared_radius = x_squared + y_squared;
      return slot == 0 ? y / squared_radius : -(x / squared_radius);
    }
    case Op::pow:
      // y x^(y-1) rather than y v / x: right at x = 0 too.
      if (slot == 0) return y * pow(x, y - one);
      return v * log(x);
    case Op::rational:
    case Op::pi_multiple:
    case Op::real:
    case Op::symbol:
    case Op::sqrt:
    case Op::sin:
    case Op::cos:
    case Op::tan:
    case Op::asin:
    case Op::acos:
    case Op::atan:
    case Op::exp:
    case Op::log:
    case Op::abs:
    case Op::sign:
    case Op::sinh:
    case Op::cosh:
    case Op::tanh:
      break;
  }
  throw InternalError("local_partial: not a function of two operands");
}

}  // namespace

Ref local_partial(ExprGraph& graph, std::uint32_t id, int slot) {
  const Node node = graph.node(id);  // a copy: making nodes may move the arena
  const int operands = node.arity();
  if (slot < 0 || slot >= operands) throw InternalError("local_partial: no such operand");
  const Expr v(graph, Ref(id, false));
  const Expr a(graph, node.a);
  if (operands == 1) {
    const Expr derivative = unary_partial(graph, node.op, v, a);
    return node.a.negative() ? -derivative.ref() : derivative.ref();
  }
  const Expr b(graph, node.b);
  const Expr derivative = binary_partial(graph, node.op, v, a, b, slot);
  return (slot == 0 ? node.a : node.b).negative() ? -derivative.ref() : derivative.ref();
}

}  // namespace alembert
