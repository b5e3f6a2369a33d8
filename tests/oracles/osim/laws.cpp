#include "oracles/osim/laws.hpp"

#include <Eigen/LU>
#include <cmath>
#include <numeric>
#include <sstream>
#include <stdexcept>

namespace alembert::oracles {
namespace {

/// A cubic spline by its second derivatives at the knots; straight beyond its ends.
Law cubic(const std::vector<double>& x, const std::vector<double>& y, bool simm) {
  const auto n = static_cast<Eigen::Index>(x.size());
  const auto at = [](const std::vector<double>& of, Eigen::Index i) {
    return of[static_cast<std::size_t>(i)];
  };
  const auto step = [&](Eigen::Index i) { return at(x, i + 1) - at(x, i); };
  const auto slope = [&](Eigen::Index i) { return (at(y, i + 1) - at(y, i)) / step(i); };
  Eigen::MatrixXd A = Eigen::MatrixXd::Identity(n, n);
  Eigen::VectorXd b = Eigen::VectorXd::Zero(n);
  for (Eigen::Index i = 1; i + 1 < n; ++i) {
    A(i, i - 1) = step(i - 1) / 6;
    A(i, i) = (step(i - 1) + step(i)) / 3;
    A(i, i + 1) = step(i) / 6;
    b(i) = slope(i) - slope(i - 1);
  }
  if (simm && n > 2) {
    // The third derivative of the cubic through the four points at an end; of three points, none.
    const auto third = [&](Eigen::Index i) {
      if (n == 3) return 0.0;
      const auto d2 = [&](Eigen::Index k) { return (slope(k + 1) - slope(k)) / (at(x, k + 2) - at(x, k)); };
      return 6 * (d2(i + 1) - d2(i)) / (at(x, i + 3) - at(x, i));
    };
    A(0, 0) = -1 / step(0);
    A(0, 1) = 1 / step(0);
    b(0) = third(0);
    A(n - 1, n - 2) = -1 / step(n - 2);
    A(n - 1, n - 1) = 1 / step(n - 2);
    b(n - 1) = third(n == 3 ? 0 : n - 4);
  }
  const Eigen::VectorXd m = A.fullPivLu().solve(b);
  Law law;
  law.curve = [x, y, m, n](double q) -> std::array<double, 3> {
    Eigen::Index i = 0;
    while (i + 2 < n && q > x[static_cast<std::size_t>(i + 1)]) ++i;
    const auto k = static_cast<std::size_t>(i);
    const double h = x[k + 1] - x[k];
    const auto inside = [&](double p) -> std::array<double, 3> {
      const double s = p - x[k], bend = (m(i + 1) - m(i)) / h;
      const double first = (y[k + 1] - y[k]) / h - h * (2 * m(i) + m(i + 1)) / 6;
      return {y[k] + s * (first + s * (m(i) / 2 + s * bend / 6)), first + s * (m(i) + s * bend / 2),
              m(i) + s * bend};
    };
    if (q >= x.front() && q <= x.back()) return inside(q);
    const double end = q < x.front() ? x.front() : x.back();
    const auto [value, first, second] = inside(end);
    return {value + first * (q - end), first, 0};
  };
  return law;
}

/// Straight between its points and beyond its ends.
Law straight(const std::vector<double>& x, const std::vector<double>& y) {
  Law law;
  law.curve = [x, y](double q) -> std::array<double, 3> {
    std::size_t i = 0;
    while (i + 2 < x.size() && q > x[i + 1]) ++i;
    const double slope = (y[i + 1] - y[i]) / (x[i + 1] - x[i]);
    return {y[i] + slope * (q - x[i]), slope, 0};
  };
  return law;
}

Law polynomial_law(const std::vector<double>& c) {
  Law law;
  law.curve = [c](double x) {
    double value = 0, first = 0, second = 0;
    for (const double coefficient : c) {
      second = second * x + 2 * first;
      first = first * x + value;
      value = value * x + coefficient;
    }
    return std::array<double, 3>{value, first, second};
  };
  return law;
}

/// The next number of these digits, each up to `most`; after the last one, the first digit is beyond it.
void step(std::vector<int>& digits, int most) {
  for (std::size_t i = digits.size(); i-- > 0;) {
    if (++digits[i] <= most || i == 0) return;
    digits[i] = 0;
  }
}

/// A product of powers, differentiated so many times by each variable.
double product(const std::vector<double>& x, const std::vector<int>& powers, const std::vector<int>& times) {
  double out = 1;
  for (std::size_t i = 0; i < x.size(); ++i) {
    for (int k = 0; k < times[i]; ++k) out *= powers[i] - k;
    if (powers[i] >= times[i]) out *= std::pow(x[i], powers[i] - times[i]);
  }
  return out;
}

}  // namespace

std::vector<double> numbers_in(pugi::xml_node element) {
  std::istringstream text(element.child_value());
  std::vector<double> out;
  for (double value = 0; text >> value;) out.push_back(value);
  return out;
}

pugi::xml_node law_element(pugi::xml_node owner, const char* property) {
  if (const pugi::xml_node inside = owner.child(property))
    return inside.find_child([](pugi::xml_node child) { return child.type() == pugi::node_element; });
  return owner.find_child_by_attribute("name", property);
}

Law read_law(pugi::xml_node element, std::size_t variables) {
  const std::string type = element.name();
  Law law;
  law.weights.assign(variables, 0);
  if (type == "Constant") {
    law.offset = element.child("value").text().as_double();
  } else if (type == "LinearFunction") {
    law.weights = numbers_in(element.child("coefficients"));
    law.offset = law.weights.back();
    law.weights.pop_back();
  } else if (type == "PolynomialFunction") {
    return polynomial_law(numbers_in(element.child("coefficients")));
  } else if (type == "SimmSpline" || type == "NaturalCubicSpline") {
    return cubic(numbers_in(element.child("x")), numbers_in(element.child("y")), type == "SimmSpline");
  } else if (type == "PiecewiseLinearFunction") {
    return straight(numbers_in(element.child("x")), numbers_in(element.child("y")));
  } else if (type == "Sine") {
    const double a = element.child("amplitude").text().as_double(1),
                 w = element.child("omega").text().as_double(1),
                 p = element.child("phase").text().as_double(),
                 o = element.child("offset").text().as_double();
    law.curve = [=](double x) {
      return std::array<double, 3>{a * std::sin(w * x + p) + o, a * w * std::cos(w * x + p),
                                   -a * w * w * std::sin(w * x + p)};
    };
  } else if (type == "MultivariatePolynomialFunction") {
    // Exponents counted upwards as digits, the first variable's being the highest; sums above the order are none.
    const int order = element.child("order").text().as_int();
    std::vector<int> digits(variables, 0);
    for (const double c : numbers_in(element.child("coefficients"))) {
      while (std::accumulate(digits.begin(), digits.end(), 0) > order) step(digits, order);
      law.products.emplace_back(c, digits);
      step(digits, order);
    }
  } else if (type == "MultiplierFunction") {
    return read_law(law_element(element, "function"), variables)
        .times(element.child("scale").text().as_double(1));
  } else {
    throw std::runtime_error("the oracle knows no function " + type);
  }
  return law;
}

double Law::value(const std::vector<double>& x) const {
  if (curve) return curve(x[0])[0];
  double out = offset;
  for (std::size_t i = 0; i < x.size(); ++i) out += weights[i] * x[i];
  for (const auto& [c, powers] : products) out += c * product(x, powers, std::vector<int>(x.size(), 0));
  return out;
}
double Law::first(const std::vector<double>& x, std::size_t i) const {
  if (curve) return curve(x[0])[1];
  double out = weights[i];
  std::vector<int> times(x.size(), 0);
  times[i] = 1;
  for (const auto& [c, powers] : products) out += c * product(x, powers, times);
  return out;
}
double Law::second(const std::vector<double>& x, std::size_t i, std::size_t j) const {
  if (curve) return curve(x[0])[2];
  double out = 0;
  std::vector<int> times(x.size(), 0);
  ++times[i];
  ++times[j];
  for (const auto& [c, powers] : products) out += c * product(x, powers, times);
  return out;
}

Law Law::times(double factor) const {
  Law out = *this;
  for (double& weight : out.weights) weight *= factor;
  for (auto& [c, powers] : out.products) c *= factor;
  out.offset *= factor;
  if (curve)
    out.curve = [inner = curve, factor](double x) {
      std::array<double, 3> y = inner(x);
      for (double& entry : y) entry *= factor;
      return y;
    };
  return out;
}

}  // namespace alembert::oracles
