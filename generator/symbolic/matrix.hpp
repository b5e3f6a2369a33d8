// Small dense matrices of expressions.
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "symbolic/expr.hpp"

namespace alembert {

/// R x C matrix, row major. Products skip exact zeros because construction folds them.
template <std::size_t R, std::size_t C>
struct Matrix {
  std::array<Expr, R * C> entries;
  Expr& operator()(std::size_t r, std::size_t c) { return entries[r * C + c]; }
  const Expr& operator()(std::size_t r, std::size_t c) const { return entries[r * C + c]; }
  Expr& operator[](std::size_t i) { return entries[i]; }
  const Expr& operator[](std::size_t i) const { return entries[i]; }
  friend bool operator==(const Matrix&, const Matrix&) = default;
};
using Vec3 = Matrix<3, 1>;
using Mat3 = Matrix<3, 3>;
using Mat4 = Matrix<4, 4>;

template <std::size_t R, std::size_t K, std::size_t C>
Matrix<R, C> operator*(const Matrix<R, K>& x, const Matrix<K, C>& y) {
  Matrix<R, C> out;
  for (std::size_t r = 0; r < R; ++r)
    for (std::size_t c = 0; c < C; ++c) {
      Expr sum = x(r, 0) * y(0, c);
      for (std::size_t k = 1; k < K; ++k) sum += x(r, k) * y(k, c);
      out(r, c) = sum;
    }
  return out;
}
template <std::size_t R, std::size_t C>
Matrix<R, C> operator+(Matrix<R, C> x, const Matrix<R, C>& y) {
  for (std::size_t i = 0; i < R * C; ++i) x[i] += y[i];
  return x;
}
template <std::size_t R, std::size_t C>
Matrix<R, C> operator-(Matrix<R, C> x, const Matrix<R, C>& y) {
  for (std::size_t i = 0; i < R * C; ++i) x[i] -= y[i];
  return x;
}
template <std::size_t R, std::size_t C>
Matrix<R, C> operator*(Expr s, Matrix<R, C> x) {
  for (auto& e : x.entries) e = s * e;
  return x;
}
template <std::size_t R, std::size_t C>
Matrix<C, R> transpose(const Matrix<R, C>& x) {
  Matrix<C, R> out;
  for (std::size_t r = 0; r < R; ++r)
    for (std::size_t c = 0; c < C; ++c) out(c, r) = x(r, c);
  return out;
}
inline Vec3 vec3(std::span<const Expr> values) {
  return {{values[0], values[1], values[2]}};
}
inline Vec3 cross(const Vec3& x, const Vec3& y) {
  Vec3 out;
  out[0] = x[1] * y[2] - x[2] * y[1];
  out[1] = x[2] * y[0] - x[0] * y[2];
  out[2] = x[0] * y[1] - x[1] * y[0];
  return out;
}
inline Expr dot(const Vec3& x, const Vec3& y) {
  Expr sum = x[0] * y[0];
  sum += x[1] * y[1];
  sum += x[2] * y[2];
  return sum;
}
/// All entries zero, in the given graph.
template <std::size_t R, std::size_t C>
Matrix<R, C> zeros(ExprGraph& g) {
  Matrix<R, C> out;
  for (auto& e : out.entries) e = g.zero();
  return out;
}
inline Mat3 identity3(ExprGraph& g) {
  Mat3 out = zeros<3, 3>(g);
  for (std::size_t i = 0; i < 3; ++i) out(i, i) = g.one();
  return out;
}

}  // namespace alembert
