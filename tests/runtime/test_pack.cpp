// Arithmetic of packs: products, which are rounded only where they are used, are operands of every operation.
#define ALEMBERT_PACK_NAMESPACE packs_of_test
#include <gtest/gtest.h>

#include "alembert/pack.hpp"

namespace alembert::packs_of_test {
namespace {

void expect_lanes(const Pack& found, double expected) {
  double lanes[Pack::kLanes];
  found.store(lanes);
  for (const double lane : lanes) EXPECT_EQ(lane, expected);
}

TEST(Pack, ProductsAreOperandsOfEveryOperation) {
  const Pack a(3), b(4), c(0.5), d(1.5);
  expect_lanes(a * b + c * d, 12.75);
  expect_lanes(a * b - c * d, 11.25);
  expect_lanes(a * b * (c * d), 9);
  expect_lanes(a * b / (c * d), 16);
  expect_lanes(a + c * d, 3.75);
  expect_lanes(a - c * d, 2.25);
  expect_lanes(a * (c * d), 2.25);
  expect_lanes(a / (c * d), 4);
  expect_lanes(a * b + c, 12.5);
  expect_lanes(a * b - c, 11.5);
  expect_lanes(a * b * c, 6);
  expect_lanes(a * b / c, 24);
  expect_lanes(-(a * b), -12);
  expect_lanes(-(a * b) / -(c * d), 16);
  expect_lanes(sqrt(b * b), 4);
  expect_lanes(abs(-(a * b)), 12);
  expect_lanes(sign(-(a * b)), -1);
  expect_lanes(pow(c * b, a * Pack(1)), 8);
}

}  // namespace
}  // namespace alembert::packs_of_test
