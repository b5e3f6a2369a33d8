// Truncated Taylor arithmetic: a value with its first and second derivative along one parameter. Jets nest:
// Jet<Jet<double>> carries derivatives along two parameters, up to the second order in each. No differences
// are taken anywhere, so that derivatives are exact to rounding. The innermost scalar is double or long
// double.
#pragma once

#include <cmath>

namespace alembert::oracles {

template <class T>
struct Jet {
  T value{}, first{}, second{};  ///< x, dx/ds, d^2x/ds^2

  Jet() = default;
  explicit Jet(double constant) : value(constant), first(0.0), second(0.0) {}
  Jet(T x, T dx, T ddx) : value(x), first(dx), second(ddx) {}
};

inline double leading(double x) {
  return x;
}
inline double leading(long double x) {
  return static_cast<double>(x);
}
/// The plain number a jet is about.
template <class T>
double leading(const Jet<T>& x) {
  return leading(x.value);
}

/// Whether it is the constant 0, along all parameters.
inline bool vanishes(double x) {
  return x == 0;
}
inline bool vanishes(long double x) {
  return x == 0;
}
template <class T>
bool vanishes(const Jet<T>& x) {
  return vanishes(x.value) && vanishes(x.first) && vanishes(x.second);
}

template <class T>
Jet<T> operator+(const Jet<T>& a, const Jet<T>& b) {
  return {a.value + b.value, a.first + b.first, a.second + b.second};
}
template <class T>
Jet<T> operator-(const Jet<T>& a, const Jet<T>& b) {
  return {a.value - b.value, a.first - b.first, a.second - b.second};
}
template <class T>
Jet<T> operator-(const Jet<T>& a) {
  return {-a.value, -a.first, -a.second};
}
template <class T>
Jet<T> operator*(const Jet<T>& a, const Jet<T>& b) {
  const T cross = a.first * b.first;
  return {a.value * b.value, a.first * b.value + a.value * b.first,
          a.second * b.value + cross + cross + a.value * b.second};
}

/// f(x) from f, f' and f'' at x.value: Faa di Bruno's formula.
template <class T>
Jet<T> composed(const Jet<T>& x, const T& f, const T& f1, const T& f2) {
  return {f, f1 * x.first, f2 * x.first * x.first + f1 * x.second};
}

template <class T>
Jet<T> reciprocal(const Jet<T>& x) {
  const T f = T(1.0) / x.value;
  const T square = f * f;
  return composed(x, f, -square, T(2.0) * square * f);
}
template <class T>
Jet<T> operator/(const Jet<T>& a, const Jet<T>& b) {
  return a * reciprocal(b);
}

template <class T>
Jet<T> sin(const Jet<T>& x) {
  using std::cos, std::sin;
  const T s = sin(x.value);
  return composed(x, s, T(cos(x.value)), T(-s));
}
template <class T>
Jet<T> cos(const Jet<T>& x) {
  using std::cos, std::sin;
  const T c = cos(x.value);
  return composed(x, c, T(-sin(x.value)), T(-c));
}
template <class T>
Jet<T> tan(const Jet<T>& x) {
  using std::tan;
  const T f = tan(x.value);
  const T f1 = T(1.0) + f * f;
  return composed(x, f, f1, T(T(2.0) * f * f1));
}
template <class T>
Jet<T> asin(const Jet<T>& x) {
  using std::asin, std::sqrt;
  const T f1 = T(1.0) / sqrt(T(1.0) - x.value * x.value);
  return composed(x, T(asin(x.value)), f1, T(x.value * f1 * f1 * f1));
}
template <class T>
Jet<T> acos(const Jet<T>& x) {
  using std::acos;
  const Jet<T> a = asin(x);
  return {acos(x.value), -a.first, -a.second};
}
template <class T>
Jet<T> atan(const Jet<T>& x) {
  using std::atan;
  const T f1 = T(1.0) / (T(1.0) + x.value * x.value);
  return composed(x, T(atan(x.value)), f1, T(T(-2.0) * x.value * f1 * f1));
}
/// The angle of (x, y), by the rate of the angle: (x y' - y x') / (x^2 + y^2).
template <class T>
Jet<T> atan2(const Jet<T>& y, const Jet<T>& x) {
  using std::atan2;
  const T square = x.value * x.value + y.value * y.value;
  const T momentum = x.value * y.first - y.value * x.first;
  const T momentum_rate = x.value * y.second - y.value * x.second;
  const T half_square_rate = x.value * x.first + y.value * y.first;
  const T rate = momentum / square;
  return {atan2(y.value, x.value), rate, (momentum_rate - T(2.0) * rate * half_square_rate) / square};
}
template <class T>
Jet<T> sqrt(const Jet<T>& x) {
  using std::sqrt;
  const T f = sqrt(x.value);
  const T f1 = T(0.5) / f;
  return composed(x, f, f1, T(T(-0.5) * f1 / x.value));
}
template <class T>
Jet<T> exp(const Jet<T>& x) {
  using std::exp;
  const T f = exp(x.value);
  return composed(x, f, f, f);
}
template <class T>
Jet<T> log(const Jet<T>& x) {
  using std::log;
  const T f1 = T(1.0) / x.value;
  return composed(x, T(log(x.value)), f1, T(-(f1 * f1)));
}
template <class T>
Jet<T> abs(const Jet<T>& x) {
  return leading(x) < 0 ? -x : x;
}
template <class T>
Jet<T> sinh(const Jet<T>& x) {
  using std::cosh, std::sinh;
  const T f = sinh(x.value);
  return composed(x, f, T(cosh(x.value)), f);
}
template <class T>
Jet<T> cosh(const Jet<T>& x) {
  using std::cosh, std::sinh;
  const T f = cosh(x.value);
  return composed(x, f, T(sinh(x.value)), f);
}
template <class T>
Jet<T> tanh(const Jet<T>& x) {
  using std::tanh;
  const T f = tanh(x.value);
  const T f1 = T(1.0) - f * f;
  return composed(x, f, f1, T(T(-2.0) * f * f1));
}
/// x^p for a constant p; a whole p also for x <= 0.
template <class T>
Jet<T> pow(const Jet<T>& x, double p) {
  using std::pow;
  if (p == 0.0) return Jet<T>(1.0);
  if (p == 1.0) return x;
  if (p == 2.0) return x * x;
  return composed(x, T(pow(x.value, p)), T(T(p) * pow(x.value, p - 1)),
                  T(T(p * (p - 1)) * pow(x.value, p - 2)));
}

}  // namespace alembert::oracles
