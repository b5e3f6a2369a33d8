// Names and poses of a file of SDF: worlds and models are scopes, within which links, joints, frames and other models
// have names and lie in each other.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "import/sdf/sdf_files.hpp"

namespace alembert {

inline constexpr std::size_t kNoSdf = static_cast<std::size_t>(-1);

enum class SdfKind { link, joint, frame, model };

/// What has a pose and a name in a scope.
struct SdfNamed {
  std::string name;
  SdfKind kind = SdfKind::link;
  pugi::xml_node node;
  std::size_t index = kNoSdf;  ///< of the link, the joint or the scope that it is
  RigidPose pose;              ///< as the file gives it
  std::string relative_to;     ///< where; empty: the default of its kind
  std::string attached_to;     ///< a frame's; a joint's child
  int minor = 11;              ///< version 1.N of the text that it stands in
  std::size_t base = kNoSdf;   ///< the frame that stands for the model's, of what was merged into it
  std::string carrier;         ///< of such a frame: the link that it moves with
  SourceLocation where, relative_where, attached_where;
};

struct SdfScope {
  std::string name;               ///< `outer::inner`, empty for the world
  std::string prefix;             ///< of names in descriptions
  std::size_t parent = kNoSdf;    ///< scope; the world's is none
  std::size_t as_named = kNoSdf;  ///< in the parent
  bool fixed = false;             ///< static
  std::string placement, canonical;
  SourceLocation where;
  std::vector<SdfNamed> named;
  std::map<std::string, std::size_t, std::less<>> by_name;
};

class SdfScopes {
 public:
  std::vector<SdfScope> all;  ///< the first is the world

  /// Throws InputError at a name that is taken.
  std::size_t add(std::size_t scope, SdfNamed named);

  /// Where a name's frame lies in the scope where it is used. Throws InputError at `where` for names that are unknown,
  /// and where frames lie in each other round in a circle.
  RigidPose pose(std::size_t scope, std::size_t base, std::string_view name, const SourceLocation& where);
  /// Where something lies in its scope.
  RigidPose pose(std::size_t scope, std::size_t named);
  /// Where a scope lies in the world.
  RigidPose in_world(std::size_t scope);
  /// The link that a name's frame moves with; kNoSdf: the world.
  std::size_t link(std::size_t scope, std::size_t base, std::string_view name, const SourceLocation& where);
  /// The link that the frame of a scope moves with.
  std::size_t canonical_link(std::size_t scope, const SourceLocation& where);
  /// The joint of a name.
  std::size_t joint(std::size_t scope, std::string_view name, const SourceLocation& where) const;

 private:
  std::size_t base_link(std::size_t scope, std::size_t base, const SourceLocation& where);
  /// Something in a scope, or (kNoSdf) the scope itself.
  struct Found {
    std::size_t scope, named;
  };
  Found find(std::size_t scope, std::string_view name, const SourceLocation& where) const;
  /// Whether the world is meant: a link of that name comes first, a joint does not.
  bool is_world(std::size_t scope, std::string_view name) const;
  const SdfNamed& at(const Found& found) const { return all[found.scope].named[found.named]; }

  std::map<std::pair<std::size_t, std::size_t>, std::optional<RigidPose>> poses_;  ///< none: being worked out
  int depth_ = 0;
};

}  // namespace alembert
