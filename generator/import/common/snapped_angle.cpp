#include "import/common/snapped_angle.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <numeric>

namespace alembert {
namespace {

constexpr double kNearlyRight = 2e-3;
constexpr int kTwoTurns = 48;

}  // namespace

std::string number_text(double x) {
  return x == 0 ? "0" : fmt::format("{}", x);
}

SnappedAngle::SnappedAngle(double radians, double tolerance) : value_(radians) {
  const double k = std::round(radians * 12 / std::numbers::pi);
  if (std::abs(k) > kTwoTurns || std::abs(radians - k * std::numbers::pi / 12) > tolerance) return;
  twelfths_ = static_cast<int>(k);
  value_ = k * std::numbers::pi / 12;
  exact_ = true;
}

bool SnappedAngle::nearly_right() const {
  const double quarters = value_ * 2 / std::numbers::pi, k = std::round(quarters);
  return !exact_ && k != 0 && std::abs(quarters - k) * std::numbers::pi / 2 < kNearlyRight;
}

std::string SnappedAngle::text() const {
  if (!exact_) return number_text(value_);
  if (twelfths_ == 0) return "0";
  const int common = std::gcd(twelfths_, 12), over = twelfths_ / common, under = 12 / common;
  const std::string pi = over == 1 ? "pi" : over == -1 ? "-pi" : fmt::format("{}*pi", over);
  return under == 1 ? pi : fmt::format("{}/{}", pi, under);
}

std::array<double, 2> SnappedAngle::cosine_and_sine() const {
  if (!exact_ || twelfths_ % 6 != 0) return {std::cos(value_), std::sin(value_)};
  constexpr std::array<double, 4> kCosine = {1, 0, -1, 0};
  const auto quarter = static_cast<std::size_t>(((twelfths_ / 6) % 4 + 4) % 4);
  return {kCosine[quarter], kCosine[(quarter + 3) % 4]};
}

}  // namespace alembert
