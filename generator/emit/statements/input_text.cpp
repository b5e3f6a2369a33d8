// Names inputs, see the header.
#include "emit/statements/input_text.hpp"

#include <fmt/format.h>

#include "support/error.hpp"

namespace alembert {

std::string input_local(const InputSlot& slot) {
  switch (slot.kind) {
    case ArgumentKind::q:
    case ArgumentKind::qd:
    case ArgumentKind::qdd:
    case ArgumentKind::tau:
    case ArgumentKind::mu:
      return fmt::format("{}{}", argument_name(slot.kind), slot.index);
    case ArgumentKind::time:
      return "time";
    case ArgumentKind::parameter:
      return fmt::format("p{}", slot.index);
    case ArgumentKind::wrench:
      return fmt::format("f{}", slot.index);
  }
  throw InternalError("emit: input of unknown kind");
}

std::string input_source(const InputSlot& slot, const Syntax& syntax) {
  switch (slot.kind) {
    case ArgumentKind::q:
    case ArgumentKind::qd:
    case ArgumentKind::qdd:
    case ArgumentKind::tau:
    case ArgumentKind::mu:
      return fmt::format("{}[{}]", argument_name(slot.kind), slot.index);
    case ArgumentKind::time:
      return syntax.inputs + "t";
    case ArgumentKind::parameter:
      return fmt::format("{}parameters[{}]", syntax.inputs, slot.index);
    case ArgumentKind::wrench:
      return fmt::format("{}wrenches[{}]", syntax.inputs, slot.index);
  }
  throw InternalError("emit: input of unknown kind");
}

}  // namespace alembert
