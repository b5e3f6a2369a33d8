// Scenes for tests. In: a description and values that all its coordinates take, one after the other. Out: the
// scene, its poses from the expressions themselves.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "viewer/scene.hpp"

namespace alembert::test {

struct SmallScene {
  SmallScene(const std::string& description, const std::vector<double>& values, const Acting& acting = {}) {
    add(description, values, acting);
  }
  /// A frame each 0.1 s; kinetic energy is the value, potential minus it.
  void add(const std::string& description, const std::vector<double>& values, const Acting& acting = {});
  Scene scene;
};

}  // namespace alembert::test
