// Infix text of expressions. In: an expression and a limit. Out: text with as few parentheses as precedence
// allows, cut at the limit: work is bounded by it, whatever the depth and the sharing of the expression.
#include "symbolic/to_string.hpp"

#include <fmt/format.h>

namespace alembert {
namespace {

enum Precedence { kSum = 1, kProduct = 2, kSign = 3, kPower = 4, kAtom = 5 };

const char* function_name(Op op) {
  switch (op) {
    case Op::sqrt:
      return "sqrt";
    case Op::sin:
      return "sin";
    case Op::cos:
      return "cos";
    case Op::tan:
      return "tan";
    case Op::asin:
      return "asin";
    case Op::acos:
      return "acos";
    case Op::atan:
      return "atan";
    case Op::atan2:
      return "atan2";
    case Op::exp:
      return "exp";
    case Op::log:
      return "log";
    case Op::abs:
      return "abs";
    case Op::sign:
      return "sign";
    case Op::sinh:
      return "sinh";
    case Op::cosh:
      return "cosh";
    case Op::tanh:
      return "tanh";
    case Op::pow:
      return "pow";
    case Op::rational:
    case Op::pi_multiple:
    case Op::real:
    case Op::symbol:
    case Op::add:
    case Op::mul:
    case Op::div:
      break;
  }
  return "?";
}

// Text that is ready, or an expression still to be written at a place of the given precedence.
struct Piece {
  const char* text = nullptr;
  Ref ref;
  int precedence = 0;
};

}  // namespace

std::string to_string(Expr x, std::size_t limit) {
  if (!x.valid()) return "<none>";
  const ExprGraph& graph = x.graph();
  std::string out;
  std::vector<Piece> open{{nullptr, x.ref(), 0}};
  const auto text = [](const char* t) { return Piece{t, Ref(), 0}; };
  const auto write = [&](Ref ref, int precedence) { return Piece{nullptr, ref, precedence}; };
  // Pieces go onto the stack in reverse.
  const auto push = [&](std::initializer_list<Piece> pieces) {
    for (auto p = std::rbegin(pieces); p != std::rend(pieces); ++p) open.push_back(*p);
  };
  while (!open.empty()) {
    if (out.size() > limit) return out.substr(0, limit) + "...";
    const Piece piece = open.back();
    open.pop_back();
    if (piece.text != nullptr) {
      out += piece.text;
      continue;
    }
    const Ref ref = piece.ref;
    const Node& node = graph.node(ref.node());
    const auto wrap = [&](int own, std::initializer_list<Piece> pieces) {
      if (own < piece.precedence) open.push_back(text(")"));
      push(pieces);
      if (own < piece.precedence) out += '(';
    };
    if (node.op == Op::add) {
      // -(a - b) is b - a, and -(a + b) keeps its sign outside.
      if (!ref.negative()) {
        const Ref b(node.b.node(), false);
        wrap(kSum, {write(node.a, kSum), text(node.b.negative() ? " - " : " + "),
                    write(b, node.b.negative() ? kProduct : kSum)});
      } else if (node.b.negative()) {
        wrap(kSum, {write(-node.b, kSum), text(" - "), write(node.a, kProduct)});
      } else {
        wrap(kSum, {text("-"), write(node.a, kProduct), text(" - "), write(node.b, kProduct)});
      }
      continue;
    }
    if (ref.negative()) {
      const bool fraction = node.op == Op::rational || node.op == Op::pi_multiple;
      wrap(kSum, {text("-"), write(-ref, fraction ? kSum : kProduct)});
      continue;
    }
    switch (node.op) {
      case Op::rational:
      case Op::pi_multiple: {
        const Rational value = graph.rational_value(ref.node());
        std::string number;
        if (node.op == Op::rational) {
          number = fmt::format("{}", value.numerator);
        } else if (value.numerator == 1) {
          number = "pi";
        } else {
          number = fmt::format("{}*pi", value.numerator);
        }
        if (value.denominator != 1) number += fmt::format("/{}", value.denominator);
        const bool atom = value.denominator == 1 && (node.op == Op::rational || value.numerator == 1);
        out += !atom && piece.precedence > kProduct ? "(" + number + ")" : number;
        break;
      }
      case Op::real:
        out += fmt::format("{}", graph.real_value(ref.node()));
        break;
      case Op::symbol:
        out += graph.symbol_name(graph.symbol_index(ref.node()));
        break;
      case Op::mul:
        wrap(kProduct, {write(node.a, kProduct), text("*"), write(node.b, kProduct)});
        break;
      case Op::div:
        wrap(kProduct, {write(node.a, kProduct), text("/"), write(node.b, kSign)});
        break;
      case Op::atan2:
      case Op::pow:
        out += function_name(node.op);
        push({text("("), write(node.a, 0), text(", "), write(node.b, 0), text(")")});
        break;
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
        out += function_name(node.op);
        push({text("("), write(node.a, 0), text(")")});
        break;
      case Op::add:
        break;
    }
  }
  return out.size() > limit ? out.substr(0, limit) + "..." : out;
}

}  // namespace alembert
