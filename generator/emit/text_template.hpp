// Text of the emitted files: templates from templates/, compiled into this program. A template holds text and
// @slots@.
#pragma once

#include <map>
#include <string>
#include <string_view>

namespace alembert {

using Slots = std::map<std::string, std::string, std::less<>>;

/// The template file of this name (without `.in`), or the header of the runtime, such as `alembert/pack.hpp`, of
/// those that generated code includes. InternalError if there is none.
std::string_view template_text(std::string_view name);

/// The template with its slots replaced, from `slots` or else from `common`. A slot alone on its line gives
/// each line of its value the slot's indentation; if the value is empty the line goes, and with it an empty
/// line before it. InternalError for a slot that neither gives, an entry of `slots` that the template does
/// not have, and an `@` that is no slot. Values are not searched for slots.
std::string fill_template(std::string_view name, const Slots& slots, const Slots& common = {});

/// The same for a given text; `name` is for messages.
std::string fill_text(std::string_view name, std::string_view text, const Slots& slots,
                      const Slots& common = {});

}  // namespace alembert
