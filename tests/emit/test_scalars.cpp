// The template for scalar types that it was not compiled for: dual numbers give derivatives, packs give
// several states.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <sample_all/sample_all_impl.hpp>

namespace numbers {

/// Value and derivative. Has only what the generated code asks of a scalar; its functions are found by
/// argument.
struct Dual {
  double v = 0, d = 0;
  Dual() = default;
  explicit Dual(double value) : v(value) {}
  Dual(double value, double derivative) : v(value), d(derivative) {}
  friend Dual operator+(Dual a, Dual b) { return {a.v + b.v, a.d + b.d}; }
  friend Dual operator-(Dual a, Dual b) { return {a.v - b.v, a.d - b.d}; }
  friend Dual operator-(Dual a) { return {-a.v, -a.d}; }
  friend Dual operator*(Dual a, Dual b) { return {a.v * b.v, a.d * b.v + a.v * b.d}; }
  friend Dual operator/(Dual a, Dual b) { return {a.v / b.v, (a.d - a.v / b.v * b.d) / b.v}; }
  friend Dual sqrt(Dual a) { return {std::sqrt(a.v), a.d / (2 * std::sqrt(a.v))}; }
  friend Dual sin(Dual a) { return {std::sin(a.v), a.d * std::cos(a.v)}; }
  friend Dual cos(Dual a) { return {std::cos(a.v), -a.d * std::sin(a.v)}; }
  friend Dual tan(Dual a) { return {std::tan(a.v), a.d * (1 + std::tan(a.v) * std::tan(a.v))}; }
  friend Dual asin(Dual a) { return {std::asin(a.v), a.d / std::sqrt(1 - a.v * a.v)}; }
  friend Dual acos(Dual a) { return {std::acos(a.v), -a.d / std::sqrt(1 - a.v * a.v)}; }
  friend Dual atan(Dual a) { return {std::atan(a.v), a.d / (1 + a.v * a.v)}; }
  friend Dual atan2(Dual a, Dual b) {
    return {std::atan2(a.v, b.v), (a.d * b.v - a.v * b.d) / (a.v * a.v + b.v * b.v)};
  }
  friend Dual exp(Dual a) { return {std::exp(a.v), a.d * std::exp(a.v)}; }
  friend Dual log(Dual a) { return {std::log(a.v), a.d / a.v}; }
  friend Dual abs(Dual a) { return a.v < 0 ? -a : a; }
  friend Dual sign(Dual a) { return Dual((a.v > 0) - (a.v < 0)); }
  friend Dual if_positive(Dual a, Dual b) { return a.v > 0 ? b : Dual(0); }
  friend Dual unless_positive(Dual a, Dual b) { return a.v > 0 ? Dual(0) : b; }
  friend Dual sinh(Dual a) { return {std::sinh(a.v), a.d * std::cosh(a.v)}; }
  friend Dual cosh(Dual a) { return {std::cosh(a.v), a.d * std::sinh(a.v)}; }
  friend Dual tanh(Dual a) { return {std::tanh(a.v), a.d * (1 - std::tanh(a.v) * std::tanh(a.v))}; }
  friend Dual pow(Dual a, Dual b) {
    const double p = std::pow(a.v, b.v);
    return {p, p * (b.d * std::log(a.v) + b.v * a.d / a.v)};
  }
};

/// Four numbers at a time. No comparison yields a bool.
struct Pack {
  std::array<double, 4> lanes{};
  Pack() = default;
  explicit Pack(double value) { lanes.fill(value); }
  template <class F>
  static Pack each(F f, const Pack& a, const Pack& b) {
    Pack out;
    for (std::size_t i = 0; i < 4; ++i) out.lanes[i] = f(a.lanes[i], b.lanes[i]);
    return out;
  }
  friend Pack operator+(const Pack& a, const Pack& b) {
    return each([](double x, double y) { return x + y; }, a, b);
  }
  friend Pack operator-(const Pack& a, const Pack& b) {
    return each([](double x, double y) { return x - y; }, a, b);
  }
  friend Pack operator*(const Pack& a, const Pack& b) {
    return each([](double x, double y) { return x * y; }, a, b);
  }
  friend Pack operator/(const Pack& a, const Pack& b) {
    return each([](double x, double y) { return x / y; }, a, b);
  }
  friend Pack operator-(const Pack& a) {
    return each([](double x, double) { return -x; }, a, a);
  }
  friend Pack sqrt(const Pack& a) {
    return each([](double x, double) { return std::sqrt(x); }, a, a);
  }
  friend Pack sin(const Pack& a) {
    return each([](double x, double) { return std::sin(x); }, a, a);
  }
  friend Pack cos(const Pack& a) {
    return each([](double x, double) { return std::cos(x); }, a, a);
  }
  friend Pack tan(const Pack& a) {
    return each([](double x, double) { return std::tan(x); }, a, a);
  }
  friend Pack asin(const Pack& a) {
    return each([](double x, double) { return std::asin(x); }, a, a);
  }
  friend Pack acos(const Pack& a) {
    return each([](double x, double) { return std::acos(x); }, a, a);
  }
  friend Pack atan(const Pack& a) {
    return each([](double x, double) { return std::atan(x); }, a, a);
  }
  friend Pack exp(const Pack& a) {
    return each([](double x, double) { return std::exp(x); }, a, a);
  }
  friend Pack log(const Pack& a) {
    return each([](double x, double) { return std::log(x); }, a, a);
  }
  friend Pack abs(const Pack& a) {
    return each([](double x, double) { return std::abs(x); }, a, a);
  }
  friend Pack sign(const Pack& a) {
    return each([](double x, double) { return (x > 0) - (x < 0); }, a, a);
  }
  friend Pack if_positive(const Pack& a, const Pack& b) {
    return each([](double c, double x) { return c > 0 ? x : 0; }, a, b);
  }
  friend Pack unless_positive(const Pack& a, const Pack& b) {
    return each([](double c, double x) { return c > 0 ? 0 : x; }, a, b);
  }
  friend Pack sinh(const Pack& a) {
    return each([](double x, double) { return std::sinh(x); }, a, a);
  }
  friend Pack cosh(const Pack& a) {
    return each([](double x, double) { return std::cosh(x); }, a, a);
  }
  friend Pack tanh(const Pack& a) {
    return each([](double x, double) { return std::tanh(x); }, a, a);
  }
  friend Pack atan2(const Pack& a, const Pack& b) {
    return each([](double x, double y) { return std::atan2(x, y); }, a, b);
  }
  friend Pack pow(const Pack& a, const Pack& b) {
    return each([](double x, double y) { return std::pow(x, y); }, a, b);
  }
};

}  // namespace numbers

namespace {

namespace all = alembert::mechanisms::sample_all;
using numbers::Dual;
using numbers::Pack;

TEST(Scalars, PackGivesEachLaneItsState) {
  std::array<Pack, all::kNq> q;
  std::array<std::array<double, all::kNq>, 4> lanes;
  for (std::size_t lane = 0; lane < 4; ++lane)
    for (std::size_t i = 0; i < q.size(); ++i)
      q[i].lanes[lane] = lanes[lane][i] = 0.1 * static_cast<double>(1 + i) + 0.3 * static_cast<double>(lane);
  std::array<Pack, 6> u, c;
  for (std::size_t i = 0; i < u.size(); ++i) u[i] = Pack(0.5 - 0.2 * static_cast<double>(i));
  all::bias(q.data(), u.data(), all::Inputs<Pack>(), c.data());
  int finite = 0;
  for (std::size_t lane = 0; lane < 4; ++lane) {
    std::array<double, 6> speeds, expected;
    for (std::size_t i = 0; i < u.size(); ++i) speeds[i] = u[i].lanes[lane];
    all::bias(lanes[lane].data(), speeds.data(), all::Inputs<double>(), expected.data());
    for (std::size_t i = 0; i < 6; ++i) {
      finite += std::isfinite(expected[i]) ? 1 : 0;
      if (std::isnan(expected[i]))
        EXPECT_TRUE(std::isnan(c[i].lanes[lane]));
      else
        EXPECT_DOUBLE_EQ(c[i].lanes[lane], expected[i]) << i << " in lane " << lane;
    }
  }
  EXPECT_GE(finite, 6);
}

TEST(Scalars, DualGivesTheDerivative) {
  const std::array<double, all::kNq> at{0.3, 0.1, -0.2, 0.4, 0.9, 0.7, -0.5};
  constexpr std::size_t kEntries = 12 * all::kBodyCount;
  const auto poses = [&](double step) {
    std::array<double, all::kNq> q = at;
    for (double& x : q) x += step;
    std::array<double, kEntries> W;
    all::body_poses(q.data(), all::Inputs<double>(), W.data());
    return W;
  };
  std::array<Dual, all::kNq> q;
  for (std::size_t i = 0; i < at.size(); ++i) q[i] = Dual(at[i], 1.0);
  std::array<Dual, kEntries> W;
  all::body_poses(q.data(), all::Inputs<Dual>(), W.data());
  const double h = 1e-6;
  const auto plus = poses(h), minus = poses(-h), here = poses(0);
  double largest = 0;
  for (std::size_t k = 0; k < kEntries; ++k) {
    const double difference = (plus[k] - minus[k]) / (2 * h);
    // The random program divides by 0 and takes powers of 0 here and there.
    if (!std::isfinite(difference) || !std::isfinite(W[k].d)) continue;
    EXPECT_DOUBLE_EQ(W[k].v, here[k]);
    EXPECT_NEAR(W[k].d, difference, 1e-6 * (1 + std::abs(difference))) << k;
    largest = std::max(largest, std::abs(difference));
  }
  EXPECT_GT(largest, 1e-3) << "the sample does not depend on q";
}

TEST(Scalars, EveryFunctionOfTheDualIsFound) {
  std::array<Dual, all::kNq> q;
  std::array<Dual, all::kNv> u, tau;
  std::array<double, all::kNq> q_value;
  std::array<double, all::kNv> u_value, expected;
  for (std::size_t i = 0; i < q.size(); ++i)
    q[i] = Dual(q_value[i] = 0.2 * static_cast<double>(i) - 0.3, 1.0);
  for (std::size_t i = 0; i < u.size(); ++i) u[i] = Dual(u_value[i] = 0.1 * static_cast<double>(i), 1.0);
  all::inverse_dynamics(q.data(), u.data(), u.data(), all::Inputs<Dual>(), tau.data());
  all::inverse_dynamics(q_value.data(), u_value.data(), u_value.data(), all::Inputs<double>(),
                        expected.data());
  for (std::size_t i = 0; i < tau.size(); ++i)
    EXPECT_TRUE(tau[i].v == expected[i] || (std::isnan(tau[i].v) && std::isnan(expected[i]))) << i;
}

}  // namespace
