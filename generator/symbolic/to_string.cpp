// Infix text of expressions. In: an expression and a limit. Out: text with as few parentheses as precedence
// allows, cut at the limit: work is bounded by it, whatever the depth and the sharing of the expression.
#include "symbolic/to_string.hpp"

#include <fmt/format.h>

namespace alembert {
namespace {

enum Precedence { kSum = 1, kProduct = 2, kSign = 3, kPower = 4, kAtom = 5 };

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
    if (node.op == Operation::add) {
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
      const bool fraction = node.op == Operation::rational || node.op == Operation::pi_multiple;
      wrap(kSum, {text("-"), write(-ref, fraction ? kSum : kProduct)});
      continue;
    }
    if (node.op == Operation::rational || node.op == Operation::pi_multiple) {
      const Rational value = graph.rational_value(ref.node());
      std::string number;
      if (node.op == Operation::rational) {
        number = fmt::format("{}", value.numerator);
      } else if (value.numerator == 1) {
        number = "pi";
      } else {
        number = fmt::format("{}*pi", value.numerator);
      }
      if (value.denominator != 1) number += fmt::format("/{}", value.denominator);
      const bool atom = value.denominator == 1 && (node.op == Operation::rational || value.numerator == 1);
      out += !atom && piece.precedence > kProduct ? "(" + number + ")" : number;
    } else if (node.op == Operation::real) {
      out += fmt::format("{}", graph.real_value(ref.node()));
    } else if (node.op == Operation::symbol) {
      out += graph.symbol_name(graph.symbol_index(ref.node()));
    } else if (node.op == Operation::mul) {
      wrap(kProduct, {write(node.a, kProduct), text("*"), write(node.b, kProduct)});
    } else if (node.op == Operation::div) {
      wrap(kProduct, {write(node.a, kProduct), text("/"), write(node.b, kSign)});
    } else {
      out += operation_name(node.op);
      if (node.arity() == 2) {
        push({text("("), write(node.a, 0), text(", "), write(node.b, 0), text(")")});
      } else {
        push({text("("), write(node.a, 0), text(")")});
      }
    }
  }
  return out.size() > limit ? out.substr(0, limit) + "..." : out;
}

}  // namespace alembert
