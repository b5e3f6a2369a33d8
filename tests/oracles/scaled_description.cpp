// YAML in, YAML out, factor by factor (see the header).
#include "oracles/scaled_description.hpp"

#include <yaml-cpp/yaml.h>

#include <cctype>
#include <cmath>
#include <cstdlib>
#include <regex>
#include <set>
#include <stdexcept>

namespace alembert::oracles {

namespace {

std::string power_of_two(int exponent) {
  const std::string power = "2^" + std::to_string(std::abs(exponent));
  return exponent < 0 ? "1/" + power : power;
}

class Scaler {
 public:
  Scaler(YAML::Node root, const Scale& scale) : root_(std::move(root)), scale_(scale) {}

  ScaledDescription scaled() {
    for (const auto& entry : root_["parameters"]) {
      if (entry.second.IsMap() && entry.second["runtime"] && entry.second["runtime"].as<bool>())
        throw std::runtime_error("runtime parameter");
    }
    root_.remove("constraints");
    for (const char* section : {"bodies", "frames"})
      for (YAML::Node node : root_[section]) find_lengths(node["transform"]);
    if (!root_["gravity"]) root_["gravity"] = YAML::Load("[0, 0, -9.81]");
    wrap_all(root_["gravity"], scale_.length);
    for (auto entry : root_["definitions"]) entry.second = inside(entry.second.as<std::string>());
    for (YAML::Node coordinate : root_["coordinates"]) {
      if (!coordinate.IsMap()) continue;
      const bool is_length = result_.lengths.count(coordinate["name"].as<std::string>()) != 0;
      if (coordinate["armature"])
        wrap(coordinate["armature"], scale_.mass + (is_length ? 0 : 2 * scale_.length));
      if (!is_length) continue;
      for (const char* key : {"initial", "initial_speed"})
        if (coordinate[key]) wrap(coordinate[key], scale_.length);
      if (coordinate["limits"]) wrap_all(coordinate["limits"], scale_.length);
    }
    for (YAML::Node body : root_["bodies"]) {
      body.remove("geometry");
      if (body["mass"]) wrap(body["mass"], scale_.mass);
      if (body["com"]) wrap_all(body["com"], scale_.length);
      for (auto entry : body["inertia"]) wrap(entry.second, scale_.mass + 2 * scale_.length);
      scale_transform(body["transform"]);
    }
    for (YAML::Node frame : root_["frames"]) scale_transform(frame["transform"]);
    YAML::Emitter out;
    out << root_;
    result_.text = out.c_str();
    return result_;
  }

 private:
  void find_lengths(YAML::Node transform) {
    for (YAML::Node factor : transform) {
      if (factor["inverse"]) find_lengths(factor["inverse"]);
      if (factor["translate"]) {
        for (const YAML::Node& entry : factor["translate"])
          if (is_coordinate(entry.as<std::string>())) result_.lengths.insert(entry.as<std::string>());
      }
      const YAML::Node joint = factor["joint"];
      if (!joint) continue;
      const std::string type = joint["type"].as<std::string>();
      const YAML::Node names = joint["coordinates"];
      const auto mark = [&](std::size_t first, std::size_t end) {
        for (std::size_t i = first; i < end; ++i) result_.lengths.insert(names[i].as<std::string>());
      };
      if (type == "prismatic") mark(0, 1);
      if (type == "cylindrical") mark(1, 2);
      if (type == "planar") mark(0, 2);
      if (type == "free") mark(0, 3);
    }
  }
  bool is_coordinate(const std::string& text) const {
    for (const YAML::Node& node : root_["coordinates"])
      if ((node.IsMap() ? node["name"].as<std::string>() : node.as<std::string>()) == text) return true;
    return false;
  }

  /// An expression of what was: lengths go in as they were before.
  std::string inside(std::string text) const {
    for (const std::string& name : result_.lengths) {
      text = std::regex_replace(text, std::regex("\\b" + name + "\\b"),
                                "(" + name + "*" + power_of_two(-scale_.length) + ")");
    }
    return text;
  }
  void wrap(YAML::Node node, int exponent) const {
    const std::string text = node.as<std::string>();
    if (result_.lengths.count(text) != 0 && exponent == scale_.length) return;
    const std::string old = inside(text);
    node = exponent == 0 || text == "0" ? old : power_of_two(exponent) + "*(" + old + ")";
  }
  void wrap_all(YAML::Node list, int exponent) const {
    for (YAML::Node entry : list) wrap(entry, exponent);
  }

  void scale_transform(YAML::Node transform) const {
    for (YAML::Node factor : transform) {
      if (factor["translate"]) wrap_all(factor["translate"], scale_.length);
      if (factor["rotate"] && factor["rotate"]["angle"]) wrap(factor["rotate"]["angle"], 0);
      for (YAML::Node row : factor["matrix"]) {
        for (std::size_t i = 0; i < 4; ++i) wrap(row[i], i < 3 ? 0 : scale_.length);
      }
      if (factor["joint"] && factor["joint"]["pitch"]) wrap(factor["joint"]["pitch"], scale_.length);
      for (const char* kind : {"curve", "surface"})
        if (factor[kind]) wrap_all(factor[kind]["point"], scale_.length);
      for (YAML::Node side : factor["mate"]) wrap_all(side["surface"]["point"], scale_.length);
      if (factor["spin"]) wrap(factor["spin"], 0);
      if (factor["inverse"]) scale_transform(factor["inverse"]);
    }
  }

  YAML::Node root_;
  Scale scale_;
  ScaledDescription result_;
};

}  // namespace

std::string with_short_numbers(const std::string& yaml) {
  constexpr int kBits = 8;
  std::string out;
  for (std::size_t at = 0; at < yaml.size();) {
    const auto is_word = [](char c) {
      return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '.';
    };
    if (!is_word(yaml[at])) {
      out += yaml[at++];
      continue;
    }
    std::size_t end = at;
    while (end < yaml.size() && (is_word(yaml[end]) || ((yaml[end] == '-' || yaml[end] == '+') &&
                                                        (yaml[end - 1] == 'e' || yaml[end - 1] == 'E'))))
      ++end;
    const std::string word = yaml.substr(at, end - at);
    at = end;
    char* rest = nullptr;
    const double value = std::strtod(word.c_str(), &rest);
    const bool decimal = (std::isdigit(static_cast<unsigned char>(word[0])) != 0 || word[0] == '.') &&
                         *rest == '\0' && word.find_first_of(".eE") != std::string::npos;
    if (!decimal || value == 0) {
      out += word;
      continue;
    }
    int exponent = 0;
    const long mantissa = std::lround(std::ldexp(std::frexp(value, &exponent), kBits));
    out += std::to_string(mantissa) + (exponent < kBits ? "/2^" : "*2^") +
           std::to_string(std::abs(exponent - kBits));
  }
  return out;
}

ScaledDescription scaled_description(const std::string& yaml, const Scale& scale) {
  return Scaler(YAML::Load(yaml), scale).scaled();
}

std::vector<int> speed_exponents(const Description& description, const std::set<std::string>& lengths,
                                 const Scale& scale) {
  std::vector<int> exponents;
  for (const Coordinate& c : description.coordinates)
    exponents.resize(exponents.size() + (c.quaternion ? 3 : 1),
                     lengths.count(c.name) != 0 ? scale.length : 0);
  return exponents;
}

State scaled_state(const Description& description, const std::set<std::string>& lengths, const Scale& scale,
                   const State& given) {
  State state = given;
  const std::vector<int> exponents = speed_exponents(description, lengths, scale);
  for (const Coordinate& c : description.coordinates) {
    if (c.quaternion) continue;
    const auto q = static_cast<std::size_t>(c.first_q), u = static_cast<std::size_t>(c.first_speed);
    state.q[q] = std::ldexp(state.q[q], exponents[u]);
    state.speeds[u] = std::ldexp(state.speeds[u], exponents[u]);
    state.rates[u] = std::ldexp(state.rates[u], exponents[u]);
  }
  for (auto& [body, wrench] : state.wrenches) {
    for (std::size_t i = 0; i < 6; ++i)
      wrench[i] = std::ldexp(wrench[i], scale.mass + (i < 3 ? 1 : 2) * scale.length);
  }
  return state;
}

Eigen::MatrixXd scaled_array(const std::string& function, const std::string& name,
                             const Eigen::MatrixXd& values, const std::vector<int>& speeds,
                             const Scale& scale) {
  const int energy = scale.mass + 2 * scale.length;
  const auto of_speed = [&](Eigen::Index i) { return speeds[static_cast<std::size_t>(i)]; };
  const auto exponent = [&](Eigen::Index r, Eigen::Index c) {
    if (function == "energy") return energy;
    if (function == "forward_dynamics") return of_speed(r);
    if (function == "body_poses" || function == "frame_poses") return c % 4 == 3 ? scale.length : 0;
    if (name == "Minv" || name == "qdd_tau") return of_speed(r) + of_speed(c) - energy;
    if (name == "qdd_q" || name == "qdd_qd") return of_speed(r) - of_speed(c);
    if (function == "joint_reactions") return c < 3 ? energy : energy - scale.length;
    if (is_six_a_row(function)) return c < 3 ? 0 : scale.length;
    if (function == "centroidal_momentum") {
      if (name == "com") return scale.length;
      return (r < 3 ? energy : scale.mass + scale.length) - (name == "A" ? of_speed(c) : 0);
    }
    if (function == "body_jacobians" || function == "frame_jacobians" || function == "frame_jacobian_rates")
      return (r % 6 < 3 ? 0 : scale.length) - of_speed(c);
    if (name == "Y") {
      const int parameter = c % 10 == 0 ? scale.mass : c % 10 < 4 ? scale.mass + scale.length : energy;
      return energy - parameter - (function == "energy_regressor" ? 0 : of_speed(r));
    }
    if (function == "body_inertias") return c == 0 ? scale.mass : c < 4 ? scale.length : energy;
    return energy - of_speed(r) - (values.cols() > 1 ? of_speed(c) : 0);
  };
  Eigen::MatrixXd result = values;
  for (Eigen::Index r = 0; r < values.rows(); ++r)
    for (Eigen::Index c = 0; c < values.cols(); ++c) result(r, c) = std::ldexp(values(r, c), exponent(r, c));
  return result;
}

}  // namespace alembert::oracles
