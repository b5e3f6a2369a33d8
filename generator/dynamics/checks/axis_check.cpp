#include "dynamics/checks/axis_check.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

#include "alembert/axis_tree.hpp"
#include "dynamics/choice/axis_form.hpp"
#include "functions/function_table.hpp"
#include "program/interpret.hpp"
#include "support/error.hpp"

namespace alembert {
namespace {

using AxisNumbers = detail::AxisTables<double, kMostAxes>;
using AxisTreeOfNumbers = detail::AxisTree<double, kMostAxes>;

/// By the names that generated code has.
struct NamedNumbers {
  explicit NamedNumbers(const AxisTable& table)
      : kParents(table.parents),
        kDirections(table.directions),
        kTurns(table.turns),
        kMasses(table.masses),
        kCenters(table.centers),
        kInertias(table.inertias),
        kArmatures(table.armatures),
        kFirstOfThree(table.first_of_three),
        kGravity(table.gravity) {}
  const std::vector<int>& kParents;
  const std::array<std::vector<double>, 3>& kDirections;
  const std::vector<bool>& kTurns;
  const std::vector<double>& kMasses;
  const std::array<std::vector<double>, 3>& kCenters;
  const std::array<std::vector<double>, 6>& kInertias;
  const std::vector<double>& kArmatures;
  const std::vector<bool>& kFirstOfThree;
  const std::array<double, 3>& kGravity;
};

OutputArray array_of_size(std::string name, std::size_t rows, std::size_t columns) {
  return {std::move(name), static_cast<std::uint32_t>(rows), static_cast<std::uint32_t>(columns),
          std::vector<std::uint32_t>(rows * columns)};
}

/// The functions of a tree of axes at one state after another.
class AxisFunctions {
 public:
  AxisFunctions(const AxisPrograms& axes, const std::vector<SymbolBinding>& bindings)
      : axes_(axes),
        bindings_(bindings),
        n_(axes.table.speeds.size()),
        numbers_(std::make_unique<AxisNumbers>(NamedNumbers(axes.table), static_cast<int>(n_))),
        tree_(std::make_unique<AxisTreeOfNumbers>(*numbers_)),
        frames_(12 * n_ + kMore),
        applied_(axes.forces ? n_ + axes.table.force_entries.size() : 0),
        rows_(n_ * n_ + kMore),
        more_rows_(n_ * n_ + kMore) {}

  /// M, then c, by speeds.
  void mass_matrix_and_bias(std::span<const double> inputs, std::span<double> found) {
    set_state(inputs);
    tree_->mass_matrix(rows_.data());
    for (std::size_t i = 0; i < n_; ++i)
      for (std::size_t j = 0; j <= i; ++j) found[at(i, j)] = found[at(j, i)] = rows_[i * n_ + j];
    tree_->set_accelerations(speeds_.data(), nullptr);
    tree_->forces(rows_.data());
    for (std::size_t i = 0; i < n_; ++i)
      found[n_ * n_ + speed(i)] = rows_[i] - (applied_.empty() ? 0 : applied_[i]);
  }

  /// tau_q, then tau_qd.
  void derivatives(std::span<const double> inputs, std::span<double> found) {
    set_state(inputs);
    const std::vector<double> rates = by_rows(inputs, ArgumentKind::qdd);
    tree_->set_accelerations(speeds_.data(), rates.data());
    tree_->derivatives(rows_.data(), more_rows_.data());
    for (std::size_t k = 0; k < axes_.table.force_entries.size(); ++k) {
      const auto entry = static_cast<std::size_t>(axes_.table.force_entries[k]);
      (entry < n_ * n_ ? rows_[entry] : more_rows_[entry - n_ * n_]) -= applied_[n_ + k];
    }
    for (std::size_t i = 0; i < n_; ++i)
      for (std::size_t j = 0; j < n_; ++j) {
        found[at(i, j)] = rows_[i * n_ + j];
        found[n_ * n_ + at(i, j)] = more_rows_[i * n_ + j];
      }
  }

  std::size_t size() const { return n_; }

 private:
  static constexpr std::size_t kMore = AxisNumbers::kLanes;

  std::size_t speed(std::size_t row) const { return static_cast<std::size_t>(axes_.table.speeds[row]); }
  std::size_t at(std::size_t i, std::size_t j) const { return speed(i) * n_ + speed(j); }

  std::vector<double> by_rows(std::span<const double> inputs, ArgumentKind kind) const {
    std::vector<double> by_speeds(n_), out(n_ + kMore);
    for (std::size_t b = 0; b < bindings_.size(); ++b)
      if (bindings_[b].slot.kind == kind) by_speeds[bindings_[b].slot.index] = inputs[b];
    for (std::size_t row = 0; row < n_; ++row) out[row] = by_speeds[speed(row)];
    return out;
  }

  void set_state(std::span<const double> inputs) {
    interpret(axes_.frames, inputs, std::span(frames_).first(12 * n_), scratch_, rounded_correctly);
    if (axes_.forces) interpret(*axes_.forces, inputs, applied_, scratch_, rounded_correctly);
    speeds_ = by_rows(inputs, ArgumentKind::qd);
    tree_->set_state(frames_.data(), speeds_.data());
  }

  const AxisPrograms& axes_;
  const std::vector<SymbolBinding>& bindings_;
  std::size_t n_;
  std::unique_ptr<AxisNumbers> numbers_;
  std::unique_ptr<AxisTreeOfNumbers> tree_;
  std::vector<double> frames_, applied_, speeds_, rows_, more_rows_, scratch_;
};

}  // namespace

std::optional<double> axis_error(const Certificate& certificate, const std::vector<SymbolBinding>& bindings,
                                 const AxisPrograms& axes) {
  AxisFunctions functions(axes, bindings);
  const std::size_t n = functions.size();
  const MeasuredError first = certificate.measure(
      std::array{array_of_size("M", n, n), array_of_size("c", n, 1)}, FunctionKind("mass_matrix_and_bias"),
      [&](auto inputs, auto found) { functions.mass_matrix_and_bias(inputs, found); });
  const MeasuredError second =
      certificate.measure(std::array{array_of_size("tau_q", n, n), array_of_size("tau_qd", n, n)},
                          FunctionKind("inverse_dynamics_derivatives"),
                          [&](auto inputs, auto found) { functions.derivatives(inputs, found); });
  for (const MeasuredError& error : {first, second})
    if (error.states == 0 || !Certificate::is_small(error)) return std::nullopt;
  return std::max(first.relative, second.relative);
}

}  // namespace alembert
