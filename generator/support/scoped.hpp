// A value for as long as a scope lasts. In: a variable and what it is meanwhile. Out: the variable as it was.
#pragma once

#include <utility>

namespace alembert {

template <class T>
class [[nodiscard]] Scoped {
 public:
  Scoped(T& variable, T value) : variable_(variable), before_(std::exchange(variable, std::move(value))) {}
  ~Scoped() { variable_ = std::move(before_); }
  Scoped(const Scoped&) = delete;
  Scoped& operator=(const Scoped&) = delete;

 private:
  T& variable_;
  T before_;
};

}  // namespace alembert
