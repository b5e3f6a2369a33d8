// Reads what `simulate` writes.
#pragma once

#include <algorithm>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace alembert::test {

/// A header and rows of numbers.
struct Csv {
  explicit Csv(const std::string& text) {
    std::istringstream lines(text);
    std::getline(lines, header);
    for (std::string line; std::getline(lines, line);) {
      std::vector<double> row;
      std::istringstream cells(line);
      for (std::string cell; std::getline(cells, cell, ',');) row.push_back(std::stod(cell));
      rows.push_back(row);
    }
  }
  std::size_t column(const std::string& name) const {
    std::istringstream cells(header);
    std::size_t index = 0;
    for (std::string cell; std::getline(cells, cell, ','); ++index)
      if (cell == name) return index;
    throw std::out_of_range("no column " + name);
  }

  std::string header;
  std::vector<std::vector<double>> rows;
};

}  // namespace alembert::test
