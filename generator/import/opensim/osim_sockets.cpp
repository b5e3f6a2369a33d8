#include "import/opensim/osim_sockets.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace alembert {
namespace {

/// A path without `.`, `..` and empty parts.
std::string plain_path(const std::string& path) {
  std::vector<std::string> parts;
  for (std::size_t at = 0; at <= path.size();) {
    const std::size_t end = std::min(path.find('/', at), path.size());
    const std::string part = path.substr(at, end - at);
    at = end + 1;
    if (part == "..") {
      if (!parts.empty()) parts.pop_back();
    } else if (!part.empty() && part != ".") {
      parts.push_back(part);
    }
  }
  std::string out;
  for (const std::string& part : parts) out += "/" + part;
  return out;
}

std::string last_part(const std::string& path) {
  return path.substr(path.find_last_of('/') + 1);
}

}  // namespace

std::optional<std::size_t> find_osim_frame(const OsimModel& model, const std::string& socket,
                                           const std::string& owner) {
  const auto& by_path = model.frame_of_path;
  const std::string absolute = plain_path(socket.starts_with('/') ? socket : owner + "/" + socket);
  auto found = by_path.find(absolute);
  // Paths of some versions begin with the name of the model.
  if (found == by_path.end() && socket.starts_with('/') && absolute.find('/', 1) != std::string::npos)
    found = by_path.find(absolute.substr(absolute.find('/', 1)));
  if (found != by_path.end()) return found->second;
  const auto named = model.frames_of_name.find(last_part(socket));
  if (named == model.frames_of_name.end()) return std::nullopt;
  const auto own = std::ranges::find_if(
      named->second, [&](std::size_t frame) { return model.frames[frame].path.starts_with(owner + "/"); });
  return own != named->second.end() ? *own : named->second.front();
}

std::size_t resolve_osim_frame(const OsimModel& model, const std::string& socket, const std::string& owner,
                               const SourceLocation& where, const std::string& what) {
  if (socket.empty()) throw InputError(where, what + " names no frame");
  if (const std::optional<std::size_t> found = find_osim_frame(model, socket, owner)) return *found;
  std::vector<std::string> names;
  for (const OsimFrame& frame : model.frames) names.push_back(frame.name);
  throw InputError(where, fmt::format("{} names an unknown frame '{}'{}", what, printable(socket),
                                      did_you_mean(last_part(socket), names)));
}

std::size_t resolve_osim_coordinate(const OsimModel& model, const std::string& socket,
                                    const SourceLocation& where, const std::string& what) {
  const std::string name = last_part(socket);
  const auto& all = model.coordinates;
  // Of a path, the joint tells coordinates of one name apart.
  const std::string joint = socket == name ? "" : last_part(socket.substr(0, socket.find_last_of('/')));
  auto found = std::ranges::find_if(all, [&](const OsimCoordinate& c) {
    return c.name == name && (joint.empty() || model.joints[c.joint].name == joint);
  });
  if (found == all.end()) found = std::ranges::find(all, name, &OsimCoordinate::name);
  if (found == all.end()) {
    std::vector<std::string> names;
    for (const OsimCoordinate& coordinate : all) names.push_back(coordinate.name);
    throw InputError(where, fmt::format("{} names an unknown coordinate '{}'{}", what, printable(socket),
                                        did_you_mean(name, names)));
  }
  return static_cast<std::size_t>(found - all.begin());
}

}  // namespace alembert
