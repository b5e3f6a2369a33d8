#include "simulation/input_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <span>
#include <string_view>

#include "mechanism/document.hpp"
#include "mechanism/parameter_places.hpp"

namespace alembert {
namespace {

/// A piece of a line between commas, without the blanks around it.
struct Cell {
  std::string_view text;
  int column;
};

std::vector<Cell> cells_of(std::string_view line) {
  std::vector<Cell> cells;
  for (std::size_t begin = 0; begin <= line.size();) {
    const std::size_t end = std::min(line.find(',', begin), line.size());
    std::size_t first = begin, last = end;
    while (first < last && is_space(line[first])) ++first;
    while (last > first && is_space(line[last - 1])) --last;
    cells.push_back({line.substr(first, last - first), static_cast<int>(first) + 1});
    begin = end + 1;
  }
  return cells;
}

class TableReader {
 public:
  TableReader(std::shared_ptr<const SourceText> source, const Mechanism& mechanism)
      : source_(std::move(source)), mechanism_(mechanism) {}

  void read(std::vector<std::size_t>& places, std::vector<double>& times, std::vector<double>& values) {
    check_characters(source_);
    std::string_view rest = source_->text;
    while (!rest.empty()) {
      const std::size_t end = std::min(rest.find('\n'), rest.size());
      const std::vector<Cell> cells = cells_of(rest.substr(0, end));
      rest.remove_prefix(std::min(end + 1, rest.size()));
      ++line_;
      if (cells.size() == 1 && cells[0].text.empty()) continue;
      if (places.empty())
        read_header(cells, places);
      else
        read_row(cells, times, values);
    }
    if (times.empty()) throw InputError({source_, line_, 1}, "no rows of numbers");
  }

 private:
  SourceLocation where(const Cell& cell) const { return {source_, line_, cell.column}; }

  void read_header(const std::vector<Cell>& cells, std::vector<std::size_t>& places) {
    if (cells[0].text != "t")
      throw InputError(where(cells[0]),
                       fmt::format("expected t as the first column, found '{}'", printable(cells[0].text)),
                       "the first line is t and names of inputs, with commas between them");
    if (cells.size() == 1) throw InputError(where(cells[0]), "no column but the time");
    const std::vector<PlacedParameter> placed = placed_parameters(mechanism_, ParameterRole::input);
    std::vector<std::string> inputs;
    for (const PlacedParameter& input : placed) inputs.push_back(input.parameter.name);
    for (const Cell& cell : std::span(cells).subspan(1)) {
      const auto found = std::ranges::find(inputs, cell.text);
      if (found == inputs.end())
        throw InputError(where(cell), fmt::format("there is no input '{}'{}", printable(cell.text),
                                                  did_you_mean(cell.text, inputs)));
      const std::size_t place = placed[static_cast<std::size_t>(found - inputs.begin())].place;
      if (std::ranges::find(places, place) != places.end())
        throw InputError(where(cell), fmt::format("a second column '{}'", cell.text));
      places.push_back(place);
    }
    columns_ = cells.size();
  }

  double number(const Cell& cell) const {
    double value = 0;
    const auto [end, status] = std::from_chars(cell.text.data(), cell.text.data() + cell.text.size(), value);
    if (status != std::errc() || end != cell.text.data() + cell.text.size() || !std::isfinite(value))
      throw InputError(where(cell), fmt::format("expected a number, found '{}'", printable(cell.text)));
    return value;
  }

  void read_row(const std::vector<Cell>& cells, std::vector<double>& times, std::vector<double>& values) {
    if (cells.size() != columns_)
      throw InputError(where(cells.back()),
                       fmt::format("expected {} numbers, found {}", columns_, cells.size()));
    const double t = number(cells[0]);
    if (!times.empty() && !(t > times.back()))
      throw InputError(where(cells[0]), fmt::format("the time {} does not follow {}", t, times.back()));
    times.push_back(t);
    for (const Cell& cell : std::span(cells).subspan(1)) values.push_back(number(cell));
  }

  std::shared_ptr<const SourceText> source_;
  const Mechanism& mechanism_;
  int line_ = 0;
  std::size_t columns_ = 0;
};

}  // namespace

InputTable::InputTable(std::shared_ptr<const SourceText> source, const Mechanism& mechanism) {
  TableReader(std::move(source), mechanism).read(places_, times_, values_);
}

void InputTable::apply(EvaluationState& state) const {
  if (times_.empty()) return;
  const auto above = static_cast<std::size_t>(std::ranges::upper_bound(times_, state.t) - times_.begin());
  const std::size_t from = above == 0 ? 0 : above - 1, to = std::min(above, times_.size() - 1);
  const double part = from == to ? 0 : (state.t - times_[from]) / (times_[to] - times_[from]);
  for (std::size_t i = 0; i < places_.size(); ++i) {
    const double a = values_[from * places_.size() + i], b = values_[to * places_.size() + i];
    state.parameters[places_[i]] = a + part * (b - a);
  }
}

}  // namespace alembert
