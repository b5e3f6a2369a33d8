// Names in expressions: parameters, coordinates, definitions and time everywhere, inputs in forces, and speeds.
#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "mechanism/expression_reader.hpp"

namespace alembert {

Quantity ExpressionReader::name(const Reading& reading, const PostfixToken& token) const {
  const std::string_view text =
      std::string_view(reading.node.text).substr(token.begin, token.end - token.begin);
  Quantity out;
  std::string kind = "the time";
  if (text == "pi") {
    out.expr = graph_.pi();
    out.initial = 3.14159265358979323846;
    return out;
  }
  for (const LocalName& local : locals_)
    if (local.name == text)
      return {local.value, std::numeric_limits<double>::quiet_NaN(), local.dependence, nullptr};
  if (text == "t") {
    out.expr = graph_.symbol("t");
    out.dependence = Dependence::time;
  } else {
    if (text == "spline")
      throw error(reading, token.begin, "'spline' needs its argument, knots and values in parentheses",
                  "spline(x; [knots]; [values])");
    NameEntry* entry = scope_.find(text);
    if (entry == nullptr && function_arity(text) > 0)
      throw error(reading, token.begin, fmt::format("function '{}' needs its argument in parentheses", text));
    if (entry == nullptr) {
      NameEntry* coordinate = coordinate_of_speed(reading, token.begin, text);
      if (coordinate == nullptr) throw unknown_name(reading, token.begin, text);
      return speed_of(reading, token.begin, *coordinate, {});
    }
    entry->used = true;
    if (entry->kind == NameKind::quaternion)
      throw error(
          reading, token.begin,
          fmt::format("'{}' is a quaternion coordinate; it cannot stand in an expression", text),
          fmt::format("use it as a factor 'rotate: {{quaternion: {}}}' or in a spherical or free joint",
                      text));
    // A coordinate that may not stand here is a better explanation than one that is read later.
    const bool coordinate_here = entry->kind == NameKind::coordinate;
    if (!entry->ready && !(coordinate_here &&
                           (reading.allowed == Allowed::constants || reading.allowed == Allowed::parameters)))
      throw error(reading, token.begin,
                  fmt::format("{} '{}' (line {}) is used before it is defined", noun(entry->kind), text,
                              entry->where.line));
    out = entry->value;
    if (coordinate_here) out.dependence = Dependence::coordinate;
    kind = a_noun(entry->kind);
    if (out.roughness != nullptr)
      out.roughness = std::make_shared<const Roughness>(Roughness{
          token.begin,
          out.roughness->in_definition
              ? out.roughness->reason
              : fmt::format("'{}' (line {}) has {}", text, entry->where.line, out.roughness->reason),
          true});
  }
  const auto refuse = [&](std::string_view why, const std::string& note = {}) {
    return error(reading, token.begin,
                 fmt::format("{} may not depend on {}: '{}' is {}", reading.what, why, text, kind), note);
  };
  if (reading.allowed == Allowed::constants || reading.allowed == Allowed::parameters) {
    if (includes(out.dependence, Dependence::coordinate)) throw refuse("coordinates");
    if (includes(out.dependence, Dependence::time)) throw refuse("time");
  }
  if (reading.allowed == Allowed::constants && includes(out.dependence, Dependence::runtime_parameter))
    throw refuse("runtime parameters");
  const bool of_forces = reading.allowed == Allowed::motion || reading.allowed == Allowed::potential ||
                         reading.allowed == Allowed::force;
  const auto check = [&](Dependence which, const char* many) {
    if (!of_forces && includes(out.dependence, which))
      throw refuse(many, fmt::format("{} stand in forces, outputs and rates of states only", many));
  };
  check(Dependence::input, "inputs");
  check(Dependence::state, "states");
  return out;
}

InputError ExpressionReader::unknown_name(const Reading& reading, std::size_t offset,
                                          std::string_view name) const {
  std::vector<std::string> candidates = scope_.names();
  candidates.insert(candidates.end(), {"pi", "t"});
  for (const LocalName& local : locals_) candidates.push_back(local.name);
  if (reading.allowed == Allowed::pfaffian || reading.allowed == Allowed::force)
    for (const std::string& coordinate : scope_.coordinate_names()) candidates.push_back("qd_" + coordinate);
  std::string note;
  if (name == "nan" || name == "inf" || name == "infinity" || name == "NaN")
    note = "infinity and NaN are not values here";
  return error(reading, offset,
               fmt::format("unknown name '{}'{}", printable(name), did_you_mean(name, candidates)), note);
}

NameEntry* ExpressionReader::coordinate_of_speed(const Reading& reading, std::size_t offset,
                                                 std::string_view name) const {
  const auto coordinate = [&](const std::string& called) {
    NameEntry* entry = scope_.find(called);
    return entry != nullptr && entry->index >= 0 ? entry : nullptr;
  };
  if (!name.starts_with("qd")) return nullptr;
  NameEntry* named = name.starts_with("qd_") ? coordinate(std::string(name.substr(3))) : nullptr;
  NameEntry* numbered = coordinate("q" + std::string(name.substr(2)));
  if (named != nullptr && numbered != nullptr)
    throw error(reading, offset,
                fmt::format("'{0}' may be the speed of '{1}' or of 'q{2}'; write d({1}) or d(q{2})", name,
                            name.substr(3), name.substr(2)));
  return named != nullptr ? named : numbered;
}

Quantity ExpressionReader::speed(const Reading& reading, const PostfixToken& token) const {
  const std::string_view text = reading.node.text;
  const std::string_view name = text.substr(token.referent, token.referent_end - token.referent);
  const std::string_view part =
      token.part == 0 ? std::string_view() : text.substr(token.part, token.close - token.part);
  NameEntry* entry = scope_.find(name);
  if (entry == nullptr)
    throw error(reading, token.referent,
                fmt::format("unknown coordinate '{}'{}", printable(name),
                            did_you_mean(name, scope_.coordinate_names())));
  if (entry->index < 0)
    throw error(reading, token.referent,
                fmt::format("'{}' is {}; d() is the speed of a coordinate", name, a_noun(entry->kind)));
  return speed_of(reading, token.begin, *entry, part);
}

Quantity ExpressionReader::speed_of(const Reading& reading, std::size_t offset, NameEntry& entry,
                                    std::string_view part) const {
  const Coordinate& coordinate = mechanism_.coordinates[static_cast<std::size_t>(entry.index)];
  const std::string& name = coordinate.name;
  if (reading.allowed != Allowed::pfaffian && reading.allowed != Allowed::force)
    throw error(reading, offset,
                fmt::format("{} may not depend on speeds: this is the speed of '{}'", reading.what, name),
                "speeds stand in rows of pfaffian constraints, forces, outputs and rates of states only");
  std::size_t index = 0;
  switch (coordinate.type) {
    case CoordinateType::real:
      if (!part.empty())
        throw error(reading, offset, fmt::format("coordinate '{0}' has one speed: d({0})", name));
      break;
    case CoordinateType::quaternion:
      index = std::string_view("xyz").find(part);
      if (part.size() != 1 || index == std::string_view::npos)
        throw error(
            reading, offset,
            fmt::format("quaternion coordinate '{0}' has the speeds d({0}).x, d({0}).y and d({0}).z", name));
      break;
  }
  entry.used = true;
  Quantity out;
  out.expr = coordinate.speed_symbols[index];
  out.initial = coordinate.initial_speed[index];
  out.dependence = Dependence::speed;
  return out;
}

}  // namespace alembert
