// Visitors made of functions, one for each kind, which do not compile where a kind is missing.
#pragma once

#include <type_traits>

namespace alembert {

template <class... Functions>
struct Overloaded : Functions... {
  using Functions::operator()...;
};
template <class... Functions>
Overloaded(Functions...) -> Overloaded<Functions...>;

/// For kinds that are treated alike: `[](const OneOf<A, B> auto&) {}`.
template <class T, class... Kinds>
concept OneOf = (std::is_same_v<T, Kinds> || ...);

}  // namespace alembert
