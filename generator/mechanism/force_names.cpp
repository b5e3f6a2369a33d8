#include "mechanism/force_names.hpp"

#include <algorithm>

namespace alembert {

std::vector<std::string> force_names(const Mechanism& mechanism) {
  std::vector<std::string> names;
  for (const Force& force : mechanism.forces)
    if (std::ranges::find(names, force.name) == names.end()) names.push_back(force.name);
  return names;
}

}  // namespace alembert
