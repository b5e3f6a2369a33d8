// Draws states at which it shows (see the header).
#include <algorithm>
#include <cmath>

#include "oracles/nasty_mechanism.hpp"
#include "oracles/random_expressions.hpp"

namespace alembert::oracles {

std::vector<State> nasty_states(const NastyMechanism& mechanism, const Description& description,
                                std::uint64_t seed, int count) {
  RandomExpressions draw(seed + 77);
  std::mt19937_64 random(seed);
  // What gravity does in the time in which the mechanism falls its own length.
  const double fast = std::sqrt(mechanism.gravity / mechanism.length);
  std::vector<State> states;
  for (int i = 0; i < count; ++i) {
    State state = random_state(description, random);
    state.time = draw.between(0, 10);
    const double pace = i == 0 ? 0 : i % 3 == 2 ? fast : 1;
    for (const Coordinate& c : description.coordinates) {
      const auto unit = mechanism.lengths.find(c.name);
      const double by = unit == mechanism.lengths.end() ? 1 : unit->second;
      for (int k = 0; k < (c.quaternion ? 3 : 1); ++k) {
        const auto at = static_cast<std::size_t>(c.first_speed + k);
        state.speeds[at] *= pace * by;
        state.rates[at] *= (i % 3 == 1 ? 1 : fast * fast) * by;
      }
    }
    for (auto& [body, wrench] : state.wrenches) {
      const double mass = std::max(1e-9, description.bodies[0].mass);
      for (std::size_t k = 0; k < 6; ++k) wrench[k] *= mass * (k < 3 ? 1 : mechanism.length);
    }
    if (!mechanism.events.empty() && i % 2 == 1) {
      const Event& event = mechanism.events[static_cast<std::size_t>(i / 2) % mechanism.events.size()];
      const double where = event.centre + event.width * draw.between(-1.2, 1.2);
      if (event.of == "t") state.time = where;
      for (const Coordinate& c : description.coordinates)
        if (c.name == event.of) state.q[static_cast<std::size_t>(c.first_q)] = where;
    }
    states.push_back(state);
  }
  return states;
}

}  // namespace alembert::oracles
