// Names and paths in, the frames and coordinates that they mean out.
#pragma once

#include <optional>
#include <string>

#include "import/opensim/osim_model.hpp"

namespace alembert {

/// The frame that a socket of an element with this path names, by its path or its name; `what` names the
/// element in messages. Throws InputError at an unknown one.
std::size_t resolve_osim_frame(const OsimModel& model, const std::string& socket, const std::string& owner,
                               const SourceLocation& where, const std::string& what);

/// The same, or none.
std::optional<std::size_t> find_osim_frame(const OsimModel& model, const std::string& socket,
                                           const std::string& owner);

/// The coordinate of a name or path. Throws InputError at an unknown one.
std::size_t resolve_osim_coordinate(const OsimModel& model, const std::string& socket,
                                    const SourceLocation& where, const std::string& what);

}  // namespace alembert
