// The number that an overflow is blamed on.
#include <gtest/gtest.h>

#include "mechanism/extreme_number.hpp"

namespace alembert {
namespace {

std::pair<int, int> extreme(const std::string& text) {
  const SourceLocation where =
      most_extreme_number(std::make_shared<const SourceText>(SourceText{"m.yaml", text}));
  return {where.line, where.column};
}

TEST(ExtremeNumber, IsTheLargestOrTheSmallest) {
  EXPECT_EQ(extreme("a: [1, 2e5,\n  1e200, 3e199]"), (std::pair{2, 3}));
  EXPECT_EQ(extreme("a: {b: 1e-201, c: 1e200}"), (std::pair{1, 8}));
  EXPECT_EQ(extreme("a: 'sin(q)*-1e30 + 2'"), (std::pair{1, 13}));
  EXPECT_EQ(extreme("a: [1e30, 10^40]"), (std::pair{1, 11}));
  EXPECT_EQ(extreme("a: [1e30, 10^-40, .5]"), (std::pair{1, 11}));
}

TEST(ExtremeNumber, IsNeitherInNamesNorInWords) {
  EXPECT_EQ(extreme("a: [x1e200, 30, k_1e99]"), (std::pair{1, 13}));
  EXPECT_EQ(extreme("1e200: 3\nname: 1e300\ndescription: 1e300 and more"), (std::pair{1, 8}));
  EXPECT_EQ(extreme("a: [0, 1, -1]"), (std::pair{1, 1}));
}

}  // namespace
}  // namespace alembert
