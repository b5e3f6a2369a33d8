#include "mechanism/cubic_spline.hpp"

#include <algorithm>
#include <cmath>

namespace alembert {
namespace {

/// The constant as a rational or a double, so that arithmetic with it folds to one number.
Expr folded(const ConstantNumber& number) {
  const Operation op = number.expr.graph().node(number.expr.ref().node()).op;
  return op == Operation::rational ? number.expr : number.expr.graph().real(number.value);
}

double number_of(const Expr& x) {
  const ExprGraph& graph = x.graph();
  const std::uint32_t id = x.ref().node();
  const double magnitude =
      graph.node(id).op == Operation::rational ? graph.rational_value(id).to_double() : graph.real_value(id);
  return x.ref().negative() ? -magnitude : magnitude;
}

/// Third divided difference of four points: a sixth of the third derivative of the cubic through them.
Expr third_difference(std::span<const Expr> k, std::span<const Expr> slope) {
  const Expr first = (slope[1] - slope[0]) / (k[2] - k[0]), second = (slope[2] - slope[1]) / (k[3] - k[1]);
  return (second - first) / (k[3] - k[0]);
}

/// Second derivatives at the knots k. With h_i = k_(i+1) - k_i and s_i the slope of the chord,
///   h_(i-1) M_(i-1) + 2 (h_(i-1) + h_i) M_i + h_i M_(i+1) = 6 (s_i - s_(i-1)),
/// and at an end M = 0, or M_1 - M_0 = h_0 times a third derivative. Elimination needs no pivoting.
std::vector<Expr> second_derivatives(SplineEnds ends, std::span<const Expr> k, std::span<const Expr> h,
                                     std::span<const Expr> slope) {
  ExprGraph& graph = k.front().graph();
  const std::size_t last = h.size();
  std::vector<Expr> diagonal(last + 1), right(last + 1), out(last + 1, graph.zero());
  if (last < 2) return out;
  const Expr six = graph.integer(6);
  const bool fitted = ends == SplineEnds::fitted_cubic;
  const auto third_derivative = [&](std::size_t from) {
    return last < 3 ? graph.zero() : six * third_difference(k.subspan(from, 4), slope.subspan(from, 3));
  };
  // M_0 = first + M_1 where cubics are fitted.
  const Expr first = fitted ? -(h[0] * third_derivative(0)) : graph.zero();
  for (std::size_t i = 1; i < last; ++i) {
    diagonal[i] = graph.integer(2) * (h[i - 1] + h[i]);
    right[i] = six * (slope[i] - slope[i - 1]);
    if (i == 1) {
      if (fitted) {
        diagonal[i] += h[0];
        right[i] -= h[0] * first;
      }
      continue;
    }
    const Expr factor = h[i - 1] / diagonal[i - 1];
    diagonal[i] -= factor * h[i - 1];
    right[i] -= factor * right[i - 1];
  }
  if (fitted) {  // M_last = M_(last-1) + h_(last-1) times a third derivative
    const Expr more = h[last - 1] * third_derivative(last < 3 ? 0 : last - 3);
    out[last - 1] = (right[last - 1] - h[last - 1] * more) / (diagonal[last - 1] + h[last - 1]);
    out[last] = out[last - 1] + more;
  }
  for (std::size_t i = fitted ? last - 1 : last; i-- > 1;)
    out[i] = (right[i] - h[i] * out[i + 1]) / diagonal[i];
  if (fitted) out[0] = first + out[1];
  return out;
}

}  // namespace

CubicSpline::CubicSpline(SplineEnds ends, std::span<const ConstantNumber> knots,
                         std::span<const ConstantNumber> values)
    : knots_(knots.begin(), knots.end()) {
  ExprGraph& graph = knots.front().expr.graph();
  const std::size_t last = knots.size() - 1;
  std::vector<Expr> k, v, h, slope;
  for (std::size_t i = 0; i <= last; ++i) {
    k.push_back(folded(knots[i]));
    v.push_back(folded(values[i]));
  }
  for (std::size_t i = 0; i < last; ++i) {
    h.push_back(k[i + 1] - k[i]);
    slope.push_back((v[i + 1] - v[i]) / h[i]);
  }
  const std::vector<Expr> m = second_derivatives(ends, k, h, slope);
  const Expr zero = graph.zero(), two = graph.integer(2), six = graph.integer(6);
  for (std::size_t i = 0; i < last; ++i) {
    const Expr bend = two * m[i] + m[i + 1];
    const Expr start = slope[i] - h[i] * bend / six;
    if (i == 0) pieces_.push_back({0, {v[0], start, zero, zero}});
    pieces_.push_back({i, {v[i], start, m[i] / two, (m[i + 1] - m[i]) / (six * h[i])}});
  }
  const Expr end = slope[last - 1] + h[last - 1] * (m[last - 1] + two * m[last]) / six;
  pieces_.push_back({last, {v[last], end, zero, zero}});
}

std::size_t CubicSpline::piece_at(double x) const {
  const auto above = std::upper_bound(knots_.begin(), knots_.end(), x,
                                      [](double at, const ConstantNumber& knot) { return at < knot.value; });
  return static_cast<std::size_t>(above - knots_.begin());
}

double CubicSpline::operator()(double x) const {
  const Piece& piece = pieces_[piece_at(x)];
  const double y = x - knots_[piece.knot].value;
  double value = 0;
  for (std::size_t power = 4; power-- > 0;) value = value * y + number_of(piece.coefficients[power]);
  return value;
}

Expr CubicSpline::operator()(const Expr& x) const {
  ExprGraph& graph = x.graph();
  const auto polynomial = [&](const Piece& piece, const Expr& scale) {
    const Expr y = x - knots_[piece.knot].expr;
    Expr value = graph.zero();
    for (std::size_t power = 4; power-- > 0;) value = value * y + scale * piece.coefficients[power];
    return value;
  };
  std::vector<Expr> signs;
  for (const ConstantNumber& knot : knots_) signs.push_back(sign(x - knot.expr));
  const Expr half = graph.rational(Rational(1, 2));
  Expr sum = graph.zero();
  for (std::size_t i = 0; i < pieces_.size(); ++i) {
    const Expr from = i == 0 ? graph.one() : signs[i - 1];
    const Expr to = i + 1 == pieces_.size() ? -graph.one() : signs[i];
    const Expr weight = from - to;
    const Expr value = polynomial(pieces_[i], half);
    sum += weight * value;
  }
  return sum;
}

}  // namespace alembert
