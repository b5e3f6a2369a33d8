// A name as written in; a name that is fit for C++ and for files out.
#pragma once

#include <string>
#include <string_view>

#include "mechanism/document.hpp"

namespace alembert {

inline constexpr std::size_t kMaximumName = 64;

/// 0 to 9.
bool is_digit(char c);
/// What names are made of: letters of ASCII, digits, underscores.
bool is_word_character(char c);

/// What forbids `name` as an identifier of generated C++ (keyword, reserved form, macro, characters, length),
/// as the rest of a sentence (`is a C++ keyword`), or nothing if it is fit.
std::string objection_to_name(std::string_view name);

/// The same for a mechanism's name, which names a namespace, files and functions of C: no macro of the C
/// library.
std::string objection_to_mechanism_name(std::string_view name);

/// What forbids `text`, identifiers joined by `::`, as the namespace of generated C++, as a sentence that
/// names the identifier at fault (`'std' is a namespace of others`), or nothing if it is fit.
std::string objection_to_outer_namespace(std::string_view text);

/// The text of a scalar that is to be a name. `what` says of what (`a body`). Throws InputError.
const std::string& expect_name(const Document& document, const YamlNode& node, std::string_view what);

/// expect_name for the mechanism itself, which becomes a namespace and file names.
const std::string& expect_mechanism_name(const Document& document, const YamlNode& node);

}  // namespace alembert
