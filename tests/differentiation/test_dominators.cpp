// Dominators on graphs small enough to be worked out by hand, and against the definition on random ones.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>
#include <vector>

#include "differentiation/dominators.hpp"

namespace alembert {
namespace {

std::vector<Arc> arcs(std::initializer_list<std::pair<std::uint32_t, std::uint32_t>> ends) {
  std::vector<Arc> result;
  for (const auto& [top, bottom] : ends)
    result.push_back({top, bottom, static_cast<std::uint32_t>(result.size())});
  std::sort(result.begin(), result.end(), arc_before);
  return result;
}

TEST(Dominators, Diamond) {
  Dominators d(4);
  d.sweep(arcs({{3, 2}, {3, 1}, {2, 0}, {1, 0}}), 3, 0);
  EXPECT_EQ(d.idom(0), 3u);
  EXPECT_EQ(d.idom(1), 3u);
  EXPECT_EQ(d.idom(2), 3u);
  EXPECT_EQ(d.ipdom(3), 0u);
  EXPECT_EQ(d.ipdom(2), 0u);
  EXPECT_EQ(d.up_count(0), 2u);
  EXPECT_EQ(d.down_count(3), 2u);
  EXPECT_EQ(d.up_count(2), 1u);
}

TEST(Dominators, TwoDiamondsInARow) {
  Dominators d(7);
  d.sweep(arcs({{6, 5}, {6, 4}, {5, 3}, {4, 3}, {3, 2}, {3, 1}, {2, 0}, {1, 0}}), 6, 0);
  EXPECT_EQ(d.idom(3), 6u);
  EXPECT_EQ(d.idom(0), 3u);
  EXPECT_EQ(d.ipdom(6), 3u);
  EXPECT_EQ(d.ipdom(3), 0u);
}

TEST(Dominators, ParallelEdges) {
  Dominators d(3);
  d.sweep(arcs({{2, 1}, {2, 1}, {1, 0}}), 2, 0);
  EXPECT_EQ(d.idom(1), 2u);
  EXPECT_EQ(d.up_count(1), 2u);
  EXPECT_EQ(d.down_count(2), 2u);
  EXPECT_EQ(d.ipdom(2), 1u);
  EXPECT_EQ(d.idom(0), 1u);
}

TEST(Dominators, Ladder) {
  // k -> k-1 and k -> k-2: only the ends are passed by all paths.
  Dominators d(6);
  d.sweep(arcs({{5, 4}, {5, 3}, {4, 3}, {4, 2}, {3, 2}, {3, 1}, {2, 1}, {2, 0}, {1, 0}}), 5, 0);
  for (const std::uint32_t v : {0u, 1u, 2u, 3u, 4u}) EXPECT_EQ(d.idom(v), 5u) << v;
  for (const std::uint32_t v : {1u, 2u, 3u, 4u, 5u}) EXPECT_EQ(d.ipdom(v), 0u) << v;
}

TEST(Dominators, ASweepForgetsTheOneBefore) {
  Dominators d(4);
  d.sweep(arcs({{3, 2}, {3, 1}, {2, 0}, {1, 0}}), 3, 0);
  d.sweep(arcs({{3, 2}, {2, 1}, {1, 0}}), 3, 0);
  EXPECT_EQ(d.idom(0), 1u);
  EXPECT_EQ(d.ipdom(3), 2u);
  EXPECT_EQ(d.up_count(0), 1u);
  EXPECT_EQ(d.down_count(3), 1u);
}

/// Whether `to` can be reached from `from` without passing `avoided`.
bool reaches(const std::vector<Arc>& graph, std::uint32_t from, std::uint32_t to, std::uint32_t avoided) {
  std::set<std::uint32_t> seen;
  if (from != avoided) seen.insert(from);
  for (const Arc& arc : graph)
    if (seen.count(arc.top) != 0 && arc.bottom != avoided) seen.insert(arc.bottom);
  return seen.count(to) != 0;
}

TEST(Dominators, AgreeWithTheDefinition) {
  std::mt19937_64 random(11);
  constexpr std::uint32_t kVertices = 12, kNowhere = 1000;
  std::size_t compared = 0;
  for (int trial = 0; trial < 300; ++trial) {
    std::vector<Arc> all;
    const std::size_t count = 12 + random() % 16;
    for (std::size_t k = 0; k < count; ++k) {
      const auto top = static_cast<std::uint32_t>(1 + random() % (kVertices - 1));
      all.push_back({top, static_cast<std::uint32_t>(random() % top), static_cast<std::uint32_t>(k)});
    }
    std::sort(all.begin(), all.end(), arc_before);
    const std::uint32_t source = kVertices - 1, sink = 0;
    std::vector<Arc> graph;
    for (const Arc& arc : all)
      if (reaches(all, source, arc.top, kNowhere) && reaches(all, arc.bottom, sink, kNowhere))
        graph.push_back(arc);
    if (graph.empty()) continue;
    Dominators d(kVertices);
    d.sweep(graph, source, sink);
    std::set<std::uint32_t> vertices = {source, sink};
    for (const Arc& arc : graph) vertices.insert({arc.top, arc.bottom});
    for (const std::uint32_t v : vertices) {
      // The nearest of the vertices above that cut v off from the source; likewise below.
      std::uint32_t above = source, below = sink;
      for (const std::uint32_t u : vertices) {
        if (u > v && !reaches(graph, source, v, u)) above = std::min(above, u);
        if (u < v && !reaches(graph, v, sink, u)) below = std::max(below, u);
      }
      if (v != source) {
        EXPECT_EQ(d.idom(v), above) << "vertex " << v << " in trial " << trial;
      }
      if (v != sink) {
        EXPECT_EQ(d.ipdom(v), below) << "vertex " << v << " in trial " << trial;
      }
      ++compared;
    }
  }
  EXPECT_GT(compared, 1000u);
}

}  // namespace
}  // namespace alembert
