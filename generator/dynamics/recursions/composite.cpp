// Composite bodies (see the header).
#include "dynamics/recursions/composite.hpp"

namespace alembert {

Composite composite(const NodeMass& mass, ExprGraph& g) {
  const Mat3& J = mass.inertia;
  Expr trace = J(0, 0) + J(1, 1);
  trace += J(2, 2);
  const Expr half_trace = g.rational(Rational(1, 2)) * trace;
  Mat3 K;  // tr(J)/2 - J
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) K(i, j) = i == j ? half_trace - J(i, j) : -J(i, j);
  }
  return {mass.mass, mass.moment, K};
}

Composite plus(Composite x, const Composite& y) {
  x.mass += y.mass;
  x.h = x.h + y.h;
  x.K = plus_symmetric(x.K, y.K);
  return x;
}

Composite turned(const Composite& x, const Motion& rotation) {
  return {x.mass, rotation.to_parent(x.h), turned_symmetric(x.K, rotation)};
}

Composite shifted(const Composite& x, const Vec3& t, ExprGraph& g) {
  Composite out = x;
  const Expr half = g.rational(Rational(1, 2));
  Vec3 k;
  for (std::size_t i = 0; i < 3; ++i) {
    const Expr mt = x.mass * t[i];
    out.h[i] = x.h[i] + mt;
    k[i] = x.h[i] + half * mt;
  }
  out.K = plus_products(x.K, k, t);
  return out;
}

Vec3 times_inertia(const Mat3& K, const Vec3& d) {
  Vec3 out;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, l = (i + 2) % 3;
    Expr sum = (K(j, j) + K(l, l)) * d[i];
    sum -= K(i, j) * d[j];
    sum -= K(i, l) * d[l];
    out[i] = sum;
  }
  return out;
}

Mat3 plus_symmetric(Mat3 x, const Mat3& y) {
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = i; j < 3; ++j) {
      x(i, j) += y(i, j);
      x(j, i) = x(i, j);
    }
  }
  return x;
}

Mat3 plus_products(Mat3 x, const Vec3& a, const Vec3& b) {
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = i; j < 3; ++j) {
      const Expr ab = a[i] * b[j], ba = b[i] * a[j];
      x(i, j) = x(j, i) = x(i, j) + (ab + ba);
    }
  }
  return x;
}

InnerMotion still(const Composite& body, ExprGraph& g) {
  return {body, zeros<3, 1>(g), zeros<3, 3>(g)};
}

InnerMotion plus(const InnerMotion& x, const InnerMotion& y) {
  return {plus(x.body, y.body), x.p + y.p, x.P + y.P};
}

InnerMotion turned(const InnerMotion& x, const Motion& rotation, const Vec3& turning) {
  // Seen from before the rotation, dr/dt is turning x r more.
  Mat3 P = x.P;
  for (std::size_t r = 0; r < 3; ++r) {
    const Vec3 more = cross(turning, {{x.body.K(r, 0), x.body.K(r, 1), x.body.K(r, 2)}});
    for (std::size_t c = 0; c < 3; ++c) P(r, c) += more[c];
  }
  const Vec3 p = x.p + cross(turning, x.body.h);
  return {turned(x.body, rotation), rotation.to_parent(p), turned(P, rotation)};
}

InnerMotion shifted(const InnerMotion& x, const Vec3& t, const Vec3& velocity, ExprGraph& g) {
  InnerMotion out{shifted(x.body, t, g), x.p + x.body.mass * velocity, x.P};
  // (r + t) (dr/dt + w)^T
  for (std::size_t r = 0; r < 3; ++r) {
    for (std::size_t c = 0; c < 3; ++c) {
      const Expr hw = out.body.h[r] * velocity[c], tp = t[r] * x.p[c];
      out.P(r, c) += hw + tp;
    }
  }
  return out;
}

}  // namespace alembert
