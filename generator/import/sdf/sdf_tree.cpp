#include "import/sdf/sdf_tree.hpp"

#include <algorithm>
#include <utility>
#include <vector>

namespace alembert {
namespace {

class TreeSpanner {
 public:
  explicit TreeSpanner(const SdfModel& model)
      : model_(model),
        part_(model.links.size() + 1),
        at_(model.links.size() + 1),
        placed_(model.links.size(), false) {
    tree_.places.resize(model.links.size());
    for (std::size_t link = 0; link < part_.size(); ++link) part_[link] = link;
  }

  SdfTree span() {
    choose();
    for (std::size_t link = 0; link < model_.links.size(); ++link)
      if (model_.links[link].fixed) placed_[link] = true;
    grow(kSdfWorld);
    std::vector<bool> is_child(model_.links.size(), false);
    for (const SdfJoint& joint : model_.joints)
      if (joint.child != kSdfWorld) is_child[joint.child] = true;
    for (const bool only_roots : {true, false}) {
      for (std::size_t link = 0; link < model_.links.size(); ++link) {
        if (placed_[link] || (only_roots && is_child[link])) continue;
        tree_.places[link].free = placed_[link] = true;
        grow(link);
      }
    }
    return std::move(tree_);
  }

 private:
  std::size_t slot(std::size_t link) const { return link == kSdfWorld ? model_.links.size() : link; }

  /// What is taken first: 0, 1 and so on.
  int rank(std::size_t j, const std::vector<bool>& followed) const {
    const SdfJoint& joint = model_.joints[j];
    if (joint.cut_first) return 3;
    const auto any = [&](auto is) { return std::ranges::any_of(joint.axes, is); };
    if (joint.type == SdfJointType::screw || followed[j] ||
        any([](const SdfAxis& axis) { return axis.mimic || axis.stiffness != 0; }))
      return 0;
    return any([](const SdfAxis& axis) { return axis.damping != 0 || axis.friction != 0; }) ? 1 : 2;
  }

  std::size_t part_of(std::size_t link) {
    while (part_[link] != link) link = part_[link] = part_[part_[link]];
    return link;
  }

  /// Each joint in turn that joins two parts.
  void choose() {
    std::vector<bool> followed(model_.joints.size(), false);
    for (const SdfJoint& joint : model_.joints)
      for (const SdfAxis& axis : joint.axes)
        if (axis.mimic) followed[axis.mimic->joint] = true;
    std::vector<std::pair<int, std::size_t>> order;
    for (std::size_t j = 0; j < model_.joints.size(); ++j) order.emplace_back(rank(j, followed), j);
    std::ranges::sort(order);
    for (const auto& each : order) {
      const SdfJoint& joint = model_.joints[each.second];
      const std::size_t parent = slot(joint.parent), child = slot(joint.child);
      if (part_of(parent) != part_of(child)) {
        part_[part_of(parent)] = part_of(child);
        at_[parent].push_back(each.second);
        at_[child].push_back(each.second);
      } else if (parent != child) {  // not of what stands still
        tree_.cuts.push_back(each.second);
      }
    }
    std::ranges::sort(tree_.cuts);
  }

  void grow(std::size_t from) {
    std::vector<std::size_t> open{from};
    while (!open.empty()) {
      const std::size_t link = open.back();
      open.pop_back();
      for (const std::size_t j : at_[slot(link)]) {
        const bool reversed = model_.joints[j].parent != link;
        const std::size_t other = reversed ? model_.joints[j].parent : model_.joints[j].child;
        if (other == kSdfWorld || placed_[other]) continue;
        placed_[other] = true;
        tree_.places[other] = {j, reversed, false};
        open.push_back(other);
      }
    }
  }

  const SdfModel& model_;
  std::vector<std::size_t> part_;             ///< by link, the world last: another of its part
  std::vector<std::vector<std::size_t>> at_;  ///< by link: joints of the tree
  std::vector<bool> placed_;
  SdfTree tree_;
};

}  // namespace

SdfTree span_tree(const SdfModel& model) {
  return TreeSpanner(model).span();
}

}  // namespace alembert
