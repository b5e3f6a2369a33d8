// Rows of a motion (see the header).
#include "commands/csv_writer.hpp"

#include <fmt/format.h>

#include <cstdio>

#include "mechanism/constraint_rows.hpp"

namespace alembert {

namespace {

std::string header(const Mechanism& mechanism, const std::vector<Series>& forces) {
  std::string out = "t";
  const auto names = [&](const std::string& name, int size) {
    static constexpr const char* kParts[] = {".x", ".y", ".z", ".w"};
    for (int i = 0; i < size; ++i) out += "," + name + (size == 1 ? "" : kParts[i]);
  };
  for (const Coordinate& c : mechanism.coordinates) names(c.name, c.nq());
  for (const Coordinate& c : mechanism.coordinates) names("d(" + c.name + ")", c.nv());
  for (const PlacedParameter& state : placed_parameters(mechanism, ParameterRole::state))
    out += "," + state.parameter.name;
  out += ",kinetic,potential,energy";
  for (const Output& output : mechanism.outputs) out += "," + output.name;
  for (const Series& force : forces) out += ",force(" + force.name + ")";
  const std::vector<ConstraintRow> rows = constraint_rows(mechanism);
  for (const ConstraintRow& row : rows) out += ",lambda(" + row.name + ")";
  return out + (rows.empty() ? "\n" : ",residual\n");
}

}  // namespace

CsvWriter::CsvWriter(const CompiledMechanism& compiled, const std::string& path)
    : mechanism_(*compiled.mechanism),
      states_(placed_parameters(mechanism_, ParameterRole::state)),
      readings_(compiled) {
  if (path != "-") file_.emplace(path);
  put(header(mechanism_, readings_.nothing_yet().forces));
}

void CsvWriter::write(const TrajectoryPoint& point) {
  std::string out = fmt::format("{:.17g}", point.state.t);
  for (const double x : point.state.q) out += fmt::format(",{:.17g}", x);
  for (const double x : point.state.qd) out += fmt::format(",{:.17g}", x);
  for (const PlacedParameter& state : states_)
    out += fmt::format(",{:.17g}", point.state.parameters[state.place]);
  out += fmt::format(",{:.17g},{:.17g},{:.17g}", point.kinetic, point.potential, point.energy());
  for (const double x : point.outputs) out += fmt::format(",{:.17g}", x);
  for (const double x : readings_.forces(point.state)) out += fmt::format(",{:.17g}", x);
  for (const double x : point.lambda) out += fmt::format(",{:.17g}", x);
  if (!point.lambda.empty()) out += fmt::format(",{:.17g}", point.residual);
  put(out + "\n");
}

void CsvWriter::finish() {
  if (file_) return file_->publish();
  if (std::fflush(stdout) != 0) fail();
}

void CsvWriter::put(const std::string& text) {
  if (file_) return file_->put(text);
  if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size()) fail();
}

void CsvWriter::fail() const {
  throw InputError(mechanism_.where, "cannot write to standard output");
}

}  // namespace alembert
