#include "import/sdf/sdf_scopes.hpp"

#include <fmt/format.h>

namespace alembert {
namespace {

constexpr int kMaximumSdfChain = 500;
constexpr std::string_view kModelFrame = "__model__";
constexpr std::string_view kWorldFrame = "world";

/// Counts how deep frames lie in each other.
class Depth {
 public:
  Depth(int& depth, const SourceLocation& where) : depth_(depth) {
    if (++depth_ > kMaximumSdfChain) {
      --depth_;
      throw InputError(where, fmt::format("frames lie in each other more than {} deep, or round in a circle",
                                          kMaximumSdfChain));
    }
  }
  ~Depth() { --depth_; }
  Depth(const Depth&) = delete;
  Depth& operator=(const Depth&) = delete;

 private:
  int& depth_;
};

}  // namespace

std::size_t SdfScopes::add(std::size_t scope, SdfNamed named) {
  SdfScope& of = all[scope];
  const std::size_t index = of.named.size();
  if (!of.by_name.emplace(named.name, index).second)
    throw InputError(named.where,
                     fmt::format("a second '{}' in {}", printable(named.name),
                                 scope == 0 ? "the world" : "model '" + printable(of.name) + "'"));
  of.named.push_back(std::move(named));
  return index;
}

SdfScopes::Found SdfScopes::find(std::size_t scope, std::string_view name,
                                 const SourceLocation& where) const {
  const SdfScope& of = all[scope];
  if (const auto found = of.by_name.find(name); found != of.by_name.end()) return {scope, found->second};
  if (const std::size_t colons = name.find("::"); colons != std::string_view::npos) {
    const auto outer = of.by_name.find(name.substr(0, colons));
    if (outer != of.by_name.end() && of.named[outer->second].kind == SdfKind::model) {
      const std::size_t inner = of.named[outer->second].index;
      const std::string_view rest = name.substr(colons + 2);
      if (rest == kModelFrame) return {inner, kNoSdf};
      return find(inner, rest, where);
    }
  }
  std::vector<std::string> known;
  for (const auto& [each, index] : of.by_name) known.push_back(each);
  throw InputError(where, fmt::format("nothing is called '{}' in {}{}", printable(name),
                                      scope == 0 ? "the world" : "model '" + printable(of.name) + "'",
                                      did_you_mean(name, known)));
}

bool SdfScopes::is_world(std::size_t scope, std::string_view name) const {
  if (name != kWorldFrame) return false;
  const SdfScope& of = all[scope];
  const auto found = of.by_name.find(name);
  return found == of.by_name.end() || of.named[found->second].kind == SdfKind::joint;
}

RigidPose SdfScopes::pose(std::size_t scope, std::size_t base, std::string_view name,
                          const SourceLocation& where) {
  if (name == kModelFrame) return base == kNoSdf ? RigidPose{} : pose(scope, base);
  if (is_world(scope, name)) {
    if (scope == 0) return {};
    return inverse(in_world(scope));
  }
  const Found found = find(scope, name, where);
  RigidPose out = found.named == kNoSdf ? RigidPose{} : pose(found.scope, found.named);
  for (std::size_t at = found.scope; at != scope; at = all[at].parent)
    out = pose(all[at].parent, all[at].as_named) * out;
  return out;
}

RigidPose SdfScopes::pose(std::size_t scope, std::size_t index) {
  const SdfNamed named = all[scope].named[index];
  const auto [entry, fresh] = poses_.try_emplace({scope, index}, std::nullopt);
  if (!fresh) {
    if (entry->second) return *entry->second;
    throw InputError(named.relative_where,
                     fmt::format("the pose of '{}' follows from itself", printable(named.name)));
  }
  const Depth depth(depth_, named.where);
  RigidPose in;
  if (!named.relative_to.empty()) {
    in = pose(scope, named.base, named.relative_to, named.relative_where);
  } else if ((named.kind == SdfKind::joint || named.kind == SdfKind::frame) && !named.attached_to.empty()) {
    in = pose(scope, named.base, named.attached_to, named.attached_where);
  } else if (named.base != kNoSdf) {
    in = pose(scope, named.base);
  }
  RigidPose out = in * named.pose;
  if (named.kind == SdfKind::model) {
    const SdfScope& inner = all[named.index];
    if (!inner.placement.empty())
      out = out * inverse(pose(named.index, kNoSdf, inner.placement, inner.where));
  }
  poses_[{scope, index}] = out;
  return out;
}

RigidPose SdfScopes::in_world(std::size_t scope) {
  RigidPose out;
  for (; scope != 0; scope = all[scope].parent) out = pose(all[scope].parent, all[scope].as_named) * out;
  return out;
}

std::size_t SdfScopes::canonical_link(std::size_t scope, const SourceLocation& where) {
  const Depth depth(depth_, where);
  const SdfScope& of = all[scope];
  if (scope == 0 || of.fixed) return kNoSdf;
  if (!of.canonical.empty()) return link(scope, kNoSdf, of.canonical, of.where);
  for (const SdfNamed& named : of.named)
    if (named.kind == SdfKind::link) return named.index;
  for (const SdfNamed& named : of.named)
    if (named.kind == SdfKind::model) return canonical_link(named.index, where);
  throw InputError(where, fmt::format("model '{}' has no link", printable(of.name)));
}

/// The link that moves with the frame of a model, or of one that was merged into it.
std::size_t SdfScopes::base_link(std::size_t scope, std::size_t base, const SourceLocation& where) {
  if (base == kNoSdf || all[scope].named[base].carrier.empty()) return canonical_link(scope, where);
  return link(scope, base, all[scope].named[base].carrier, where);
}

std::size_t SdfScopes::link(std::size_t scope, std::size_t base, std::string_view name,
                            const SourceLocation& where) {
  const Depth depth(depth_, where);
  if (name == kModelFrame) return base_link(scope, base, where);
  if (is_world(scope, name)) return kNoSdf;
  const Found found = find(scope, name, where);
  if (found.named == kNoSdf) return canonical_link(found.scope, where);
  const SdfNamed named = at(found);
  switch (named.kind) {
    case SdfKind::link:
      return named.index;
    case SdfKind::model:
      return canonical_link(named.index, where);
    case SdfKind::joint:
    case SdfKind::frame:
      break;
  }
  if (!named.carrier.empty()) return base_link(found.scope, found.named, where);
  if (named.attached_to.empty()) return base_link(found.scope, named.base, where);
  return link(found.scope, named.base, named.attached_to, named.attached_where);
}

std::size_t SdfScopes::joint(std::size_t scope, std::string_view name, const SourceLocation& where) const {
  const Found found = find(scope, name, where);
  if (found.named == kNoSdf || at(found).kind != SdfKind::joint)
    throw InputError(where, fmt::format("'{}' is no joint", printable(name)));
  return at(found).index;
}

}  // namespace alembert
