// `identify`: the base parameters of a mechanism as a table, and an example in Python that finds them from forces.
#include "commands/run_identify.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <system_error>

#include "commands/run_import.hpp"
#include "commands/warnings.hpp"
#include "dynamics/choice/base_parameters.hpp"
#include "dynamics/equations.hpp"
#include "dynamics/recursions/regressor.hpp"
#include "emit/files/write_files.hpp"
#include "emit/text_template.hpp"
#include "mechanism/load.hpp"

namespace alembert {
namespace {

std::string parameter_name(const Mechanism& mechanism, std::size_t parameter) {
  constexpr std::array<const char*, kStandardParameters> kNames{"m",   "m cx", "m cy", "m cz", "Ixx",
                                                                "Iyy", "Izz",  "Ixy",  "Ixz",  "Iyz"};
  return fmt::format("{}({})", kNames[parameter % kStandardParameters],
                     mechanism.bodies[parameter / kStandardParameters].name);
}

/// 0.04 of 0.04000000000000001.
double rounded(double x) {
  return std::stod(fmt::format("{:.12g}", x));
}

std::string sum_of(const Mechanism& mechanism, const BaseParameter& base) {
  std::string sum = parameter_name(mechanism, base.parameter);
  for (const auto& [parameter, coefficient] : base.joined) {
    const double size = std::abs(rounded(coefficient));
    sum += coefficient < 0 ? " - " : " + ";
    if (size != 1) sum += fmt::format("{:.6g} ", size);
    sum += parameter_name(mechanism, parameter);
  }
  return sum;
}

/// A sum in lines of at most 110 characters, the second and later ones indented.
std::string folded(const std::string& sum) {
  constexpr std::size_t kWidth = 104;
  std::string out, left = sum;
  while (left.size() > kWidth) {
    std::size_t end = kWidth;
    while (end > 0 && left.compare(end, 3, " + ") != 0 && left.compare(end, 3, " - ") != 0) --end;
    if (end == 0) break;
    out += left.substr(0, end) + "\n       ";
    left = left.substr(end);
  }
  return out + left;
}

/// `first` and the items, in lines of at most 110 characters.
std::string wrapped(const std::string& first, const std::vector<std::string>& items) {
  std::string out = first;
  std::size_t length = first.size();
  for (std::size_t i = 0; i < items.size(); ++i) {
    const std::string item = items[i] + (i + 1 < items.size() ? "," : "");
    if (length + 1 + item.size() > 110) {
      out += "\n   ";
      length = 3;
    }
    out += " " + item;
    length += 1 + item.size();
  }
  return out + "\n";
}

std::string table(const Mechanism& mechanism, const BaseParameters& found) {
  std::size_t all = 0;
  for (const Body& body : mechanism.bodies) all += parameters_of(body);
  std::string out = fmt::format("{}: {} base parameters of {} bodies with {} standard parameters\n\n",
                                mechanism.name, found.base.size(), mechanism.bodies.size(), all);
  for (std::size_t k = 0; k < found.base.size(); ++k)
    out += fmt::format("{:>4}  {}\n", k, folded(sum_of(mechanism, found.base[k])));
  if (!found.without_effect.empty()) {
    std::vector<std::string> names;
    for (const std::size_t parameter : found.without_effect)
      names.push_back(parameter_name(mechanism, parameter));
    out += "\n" + wrapped("without effect on forces:", names);
  }
  out +=
      "\nm mass, m c mass times centre of mass, I inertia about the origin of the body's frame, in its axes. "
      "Forces\n"
      "tell nothing else of the bodies.";
  if (std::ranges::any_of(mechanism.parameters, &Parameter::runtime))
    out += " Coefficients are those at the default values of runtime parameters.";
  return out + "\n";
}

std::string json_of(const Mechanism& mechanism, const BaseParameters& found) {
  nlohmann::ordered_json out;
  out["mechanism"] = mechanism.name;
  out["base_parameters"] = nlohmann::ordered_json::array();
  for (const BaseParameter& base : found.base) {
    nlohmann::ordered_json one{{"column", base.parameter},
                               {"name", parameter_name(mechanism, base.parameter)},
                               {"joined", nlohmann::ordered_json::array()}};
    for (const auto& [parameter, coefficient] : base.joined)
      one["joined"].push_back({{"column", parameter},
                               {"name", parameter_name(mechanism, parameter)},
                               {"coefficient", rounded(coefficient)}});
    out["base_parameters"].push_back(one);
  }
  out["without_effect"] = nlohmann::ordered_json::array();
  for (const std::size_t parameter : found.without_effect)
    out["without_effect"].push_back(parameter_name(mechanism, parameter));
  return out.dump(2) + "\n";
}

std::string example(const Mechanism& mechanism, const BaseParameters& found, const std::string& file) {
  std::string rows;
  for (const BaseParameter& base : found.base) {
    std::string joined;
    for (const auto& [parameter, coefficient] : base.joined)
      joined += fmt::format("{}{}: {}", joined.empty() ? "" : ", ", parameter, rounded(coefficient));
    rows += fmt::format("({}, {{{}}}),  # {}\n", base.parameter, joined, sum_of(mechanism, base));
  }
  return fill_template("identify.py",
                       {{"name", mechanism.name}, {"file", nlohmann::json(file).dump()}, {"base", rows}});
}

}  // namespace

int run_identify(const CommonOptions& common, const IdentifyOptions& options) {
  if (common.file == "-" && !options.example.empty())
    throw InputError({std::make_shared<const SourceText>(SourceText{"<stdin>", ""}), 1, 1},
                     "the example loads the description, which must be a file");
  ExprGraph graph;
  const Mechanism mechanism = load_mechanism(description_of(common), graph);
  report_warnings(mechanism.warnings, common.strict);
  const BaseParameters found = base_parameters(symbolic_kinematics(mechanism, graph));
  fmt::print("{}", options.json ? json_of(mechanism, found) : table(mechanism, found));
  if (!options.example.empty()) {
    std::error_code ignored;  // what could not be made is not written to, which is told
    std::filesystem::create_directories(options.example, ignored);
    write_file(std::filesystem::path(options.example) / ("identify_" + mechanism.name + ".py"),
               example(mechanism, found, common.file));
  }
  return 0;
}

}  // namespace alembert
