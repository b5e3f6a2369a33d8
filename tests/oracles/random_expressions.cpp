// Draws numbers, names and expressions (see the header).
#include "oracles/random_expressions.hpp"

#include <algorithm>
#include <cstdio>
#include <regex>

namespace alembert::oracles {

namespace {

constexpr int kMaximumSpeeds = 11;
constexpr int kMaximumSpeedsOfTransform = 6;

}  // namespace

std::string decimal(double value) {
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%.4g", value);
  return buffer;
}

std::string list(const std::vector<std::string>& items) {
  std::string text = "[";
  for (std::size_t i = 0; i < items.size(); ++i) text += (i > 0 ? ", \"" : "\"") + items[i] + "\"";
  return text + "]";
}

std::string RandomExpressions::parameters_in(const std::string& text) const {
  std::string declarations;
  for (const auto& [name, line] : parameters_) {
    if (std::regex_search(text, std::regex("\\b" + name + "\\b"))) declarations += line;
  }
  return declarations.empty() ? "" : "parameters:\n" + declarations;
}

double RandomExpressions::between(double low, double high) {
  return low + (high - low) * static_cast<double>(random_() >> 11) * 0x1p-53;
}

int RandomExpressions::below(int n) {
  return static_cast<int>(random_() % static_cast<std::uint64_t>(n));
}
bool RandomExpressions::chance(double p) {
  return between(0, 1) < p;
}
std::string RandomExpressions::constant(double low, double high) {
  const std::string value = decimal(between(low, high));
  if (!chance(0.25)) return value;
  const std::string name = "p" + std::to_string(parameter_count_++);
  if (chance(0.5))
    declare_parameter(name, value);
  else
    parameters_[name] = "  " + name + ": " + value + "\n";
  return name;
}
void RandomExpressions::declare_parameter(const std::string& name, const std::string& usual) {
  parameters_[name] = "  " + name + ": {value: " + usual + ", runtime: true}\n";
}

void RandomExpressions::begin_transform() {
  used_.clear();
  used_speeds_of_quaternions_ = 0;
}

bool RandomExpressions::has_room(int speeds) const {
  return speeds_ + speeds <= kMaximumSpeeds &&
         static_cast<int>(used_.size()) + used_speeds_of_quaternions_ + speeds <= kMaximumSpeedsOfTransform;
}

std::string RandomExpressions::new_coordinate(double low, double high) {
  const std::string name = "q" + std::to_string(reals_.size());
  const std::string initial = decimal(between(low / 2, high / 2));
  coordinates_ += "  - {name: " + name + ", initial: " + initial + ", limits: [" + decimal(low) + ", " +
                  decimal(high) + "]}\n";
  reals_.push_back(name);
  used_.push_back(name);
  ++speeds_;
  return name;
}

std::string RandomExpressions::new_quaternion() {
  const std::string name = "r" + std::to_string(quaternions_++);
  coordinates_ += "  - {name: " + name + ", type: quaternion}\n";
  speeds_ += 3;
  used_speeds_of_quaternions_ += 3;
  return name;
}

std::string RandomExpressions::old_coordinate() {
  if (reals_.empty()) return decimal(between(-1, 1));
  const std::string name = reals_[static_cast<std::size_t>(below(static_cast<int>(reals_.size())))];
  if (std::find(used_.begin(), used_.end(), name) == used_.end()) {
    if (static_cast<int>(used_.size()) + used_speeds_of_quaternions_ + reserved_ >= kMaximumSpeedsOfTransform)
      return "0.3";
    used_.push_back(name);
  }
  return name;
}

std::string RandomExpressions::any_coordinate() {
  if (reals_.empty()) return decimal(between(-1, 1));
  return reals_[static_cast<std::size_t>(below(static_cast<int>(reals_.size())))];
}

std::string RandomExpressions::any_speed() {
  const int reals = static_cast<int>(reals_.size());
  const int which = below(reals + 3 * quaternions_);
  if (which < reals) return "d(" + reals_[static_cast<std::size_t>(which)] + ")";
  const int speed = which - reals;
  return "d(r" + std::to_string(speed / 3) + ")." + "xyz"[speed % 3];
}

std::string RandomExpressions::curved(const std::string& x) {
  const std::string a = constant(0.3, 1.2), b = constant(0.1, 0.4);
  switch (below(17)) {
    case 0:
      return a + "*" + x + " + " + b;
    case 1:
      return a + "*" + x + " + " + b + "*sin(" + x + ")";
    case 2:
      return x + " + " + b + "*" + x + "^2";
    case 3:
      return "atan(" + x + ") - " + a;
    case 4:
      return "sinh(" + b + "*" + x + ")/" + b;
    case 5:
      return a + "*tanh(" + x + ")";
    case 6:
      return "sqrt(1.2 + (" + x + " - 2)^2)";
    case 7:
      return "log(3 + " + x + ")*" + a;
    case 8:
      return "exp(" + b + "*" + x + ")";
    case 9:
      return "atan2(sin(" + x + ") + " + b + ", 2 + cos(" + x + "))*2";
    case 10:
      return "asin(0.6*sin(" + x + "/2))*2";
    case 11:
      return "acos(0.5*sin(" + x + "/2 + 0.1))";
    case 12:
      return "-" + x + "^3/6 - " + x;
    case 13:
      return a + "/(2.5 + " + x + ")";
    case 14:
      return "tan(" + b + "*" + x + ")*2";
    case 15:
      return "cosh(" + x + "/2 - 1)";
    default:
      return "(2 + sin(" + x + "))^1.5/2";
  }
}

std::string RandomExpressions::function(const std::string& x) {
  std::string f = chance(0.35) ? x : curved(x);
  // One draw a statement: operands of + are evaluated in any order.
  if (chance(0.3)) {
    const std::string size = decimal(between(0.1, 0.4));
    f += " + " + size + "*sin(" + old_coordinate() + ")";
  }
  if (chance(0.15)) f = "(" + f + ")*(1 + 0.2*cos(" + old_coordinate() + "))";
  if (chance(0.2)) {
    const std::string size = decimal(between(0.1, 0.5));
    f += " + " + size + "*sin(" + decimal(between(0.5, 2)) + "*t)";
  }
  if (!chance(0.2)) return f;
  const std::string name = "d" + std::to_string(definition_count_++);
  definitions_ += "  " + name + ": \"" + f + "\"\n";
  return name;
}

std::string RandomExpressions::axis() {
  switch (below(5)) {
    case 0:
      return "x";
    case 1:
      return "y";
    case 2:
      return "z";
    default: {
      const std::string x = decimal(between(-1, 1)), y = decimal(between(-1, 1)),
                        z = decimal(between(0.2, 1));
      return "[" + x + ", " + y + ", " + z + "]";
    }
  }
}

}  // namespace alembert::oracles
