#include "import/sdf/sdf_tree.hpp"

#include <algorithm>
#include <functional>
#include <queue>
#include <set>
#include <tuple>

namespace alembert {
namespace {

class TreeSpanner {
 public:
  explicit TreeSpanner(const SdfModel& model)
      : model_(model), of_link_(model.links.size() + 1), placed_(model.links.size() + 1, false) {
    tree_.places.resize(model.links.size());
    followed_.assign(model.joints.size(), false);
    for (const SdfJoint& joint : model.joints)
      for (const SdfAxis& axis : joint.axes)
        if (axis.mimic) followed_[axis.mimic->joint] = true;
    for (std::size_t j = 0; j < model.joints.size(); ++j) {
      of_link_[slot(model.joints[j].parent)].push_back(j);
      of_link_[slot(model.joints[j].child)].push_back(j);
    }
  }

  SdfTree span() {
    std::vector<bool> is_child(model_.links.size(), false);
    for (const SdfJoint& joint : model_.joints)
      if (joint.child != kSdfWorld) is_child[joint.child] = true;
    for (std::size_t link = 0; link < model_.links.size(); ++link)
      if (model_.links[link].fixed) placed_[link] = true;
    place(kSdfWorld);
    grow();
    for (const bool only_roots : {true, false}) {
      for (std::size_t link = 0; link < model_.links.size(); ++link) {
        if (placed_[link] || (only_roots && is_child[link])) continue;
        tree_.places[link].free = true;
        place(link);
        grow();
      }
    }
    for (std::size_t j = 0; j < model_.joints.size(); ++j)
      if (!used_.contains(j)) tree_.cuts.push_back(j);
    // Joints of what stands still hold nothing.
    std::erase_if(tree_.cuts, [&](std::size_t j) {
      return model_.joints[j].parent == kSdfWorld && model_.joints[j].child == kSdfWorld;
    });
    return std::move(tree_);
  }

 private:
  std::size_t slot(std::size_t link) const { return link == kSdfWorld ? model_.links.size() : link; }

  /// What is taken first: 0, 1 and so on.
  int rank(std::size_t j, bool reversed) const {
    const SdfJoint& joint = model_.joints[j];
    if (joint.cut_first) return reversed ? 7 : 6;
    const auto any = [&](auto is) { return std::ranges::any_of(joint.axes, is); };
    const bool needed = joint.type == SdfJointType::screw || followed_[j] ||
                        any([](const SdfAxis& axis) { return axis.mimic || axis.stiffness != 0; });
    const bool resists = any([](const SdfAxis& axis) { return axis.damping != 0 || axis.friction != 0; });
    return (needed ? 0 : resists ? 1 : 2) + (reversed ? 3 : 0);
  }

  void place(std::size_t link) {
    placed_[slot(link)] = true;
    for (const std::size_t j : of_link_[slot(link)]) {
      const bool reversed = model_.joints[j].parent != link;
      open_.emplace(rank(j, reversed), j, reversed);
    }
  }

  void grow() {
    while (!open_.empty()) {
      const auto [rank, j, reversed] = open_.top();
      open_.pop();
      const std::size_t link = reversed ? model_.joints[j].parent : model_.joints[j].child;
      if (placed_[slot(link)]) continue;
      tree_.places[link] = {j, reversed, false};
      used_.insert(j);
      place(link);
    }
  }

  using Edge = std::tuple<int, std::size_t, bool>;

  const SdfModel& model_;
  std::vector<std::vector<std::size_t>> of_link_;
  std::vector<bool> placed_, followed_;
  std::priority_queue<Edge, std::vector<Edge>, std::greater<>> open_;
  std::set<std::size_t> used_;
  SdfTree tree_;
};

}  // namespace

SdfTree span_tree(const SdfModel& model) {
  return TreeSpanner(model).span();
}

}  // namespace alembert
