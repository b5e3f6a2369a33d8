#include "mechanism/names.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "mechanism/section.hpp"

namespace alembert {
namespace {

using namespace std::string_view_literals;

// Keywords and alternative tokens of C++98 to C++20; sorted.
constexpr std::array kKeywords = {"alignas"sv,
                                  "alignof"sv,
                                  "and"sv,
                                  "and_eq"sv,
                                  "asm"sv,
                                  "auto"sv,
                                  "bitand"sv,
                                  "bitor"sv,
                                  "bool"sv,
                                  "break"sv,
                                  "case"sv,
                                  "catch"sv,
                                  "char"sv,
                                  "char16_t"sv,
                                  "char32_t"sv,
                                  "char8_t"sv,
                                  "class"sv,
                                  "co_await"sv,
                                  "co_return"sv,
                                  "co_yield"sv,
                                  "compl"sv,
                                  "concept"sv,
                                  "const"sv,
                                  "const_cast"sv,
                                  "consteval"sv,
                                  "constexpr"sv,
                                  "constinit"sv,
                                  "continue"sv,
                                  "decltype"sv,
                                  "default"sv,
                                  "delete"sv,
                                  "do"sv,
                                  "double"sv,
                                  "dynamic_cast"sv,
                                  "else"sv,
                                  "enum"sv,
                                  "explicit"sv,
                                  "export"sv,
                                  "extern"sv,
                                  "false"sv,
                                  "float"sv,
                                  "for"sv,
                                  "friend"sv,
                                  "goto"sv,
                                  "if"sv,
                                  "inline"sv,
                                  "int"sv,
                                  "long"sv,
                                  "mutable"sv,
                                  "namespace"sv,
                                  "new"sv,
                                  "noexcept"sv,
                                  "not"sv,
                                  "not_eq"sv,
                                  "nullptr"sv,
                                  "operator"sv,
                                  "or"sv,
                                  "or_eq"sv,
                                  "private"sv,
                                  "protected"sv,
                                  "public"sv,
                                  "register"sv,
                                  "reinterpret_cast"sv,
                                  "requires"sv,
                                  "restrict"sv,
                                  "return"sv,
                                  "short"sv,
                                  "signed"sv,
                                  "sizeof"sv,
                                  "static"sv,
                                  "static_assert"sv,
                                  "static_cast"sv,
                                  "struct"sv,
                                  "switch"sv,
                                  "template"sv,
                                  "this"sv,
                                  "thread_local"sv,
                                  "throw"sv,
                                  "true"sv,
                                  "try"sv,
                                  "typedef"sv,
                                  "typeid"sv,
                                  "typename"sv,
                                  "union"sv,
                                  "unsigned"sv,
                                  "using"sv,
                                  "virtual"sv,
                                  "void"sv,
                                  "volatile"sv,
                                  "wchar_t"sv,
                                  "while"sv,
                                  "xor"sv,
                                  "xor_eq"sv};
static_assert(std::is_sorted(kKeywords.begin(), kKeywords.end()));

// Macros that common headers and compilers define without a leading underscore; sorted.
constexpr std::array kMacros = {"EOF"sv,   "HUGE_VAL"sv, "INFINITY"sv, "NAN"sv,   "NULL"sv,   "assert"sv,
                                "errno"sv, "linux"sv,    "stderr"sv,   "stdin"sv, "stdout"sv, "unix"sv};
static_assert(std::is_sorted(kMacros.begin(), kMacros.end()));

constexpr std::array kTakenNamespaces = {"Eigen"sv, "alembert"sv, "main"sv, "posix"sv, "std"sv};

}  // namespace

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}
bool is_word_character(char c) {
  return is_digit(c) || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}

std::string objection_to_name(std::string_view name) {
  const bool characters =
      !name.empty() && !is_digit(name[0]) && std::all_of(name.begin(), name.end(), is_word_character);
  if (!characters)
    return "is not a name; a name has letters, digits and underscores, and does not begin with a digit";
  if (name.size() > kMaximumName)
    return fmt::format("has {} characters; the limit for a name is {}", name.size(), kMaximumName);
  if (std::binary_search(kKeywords.begin(), kKeywords.end(), name)) return "is a C++ keyword";
  if (std::binary_search(kMacros.begin(), kMacros.end(), name)) return "is a macro of the C++ library";
  if (name.find("__") != std::string_view::npos) return "has two underscores in a row, which C++ reserves";
  if (name.size() > 1 && name[0] == '_' && name[1] >= 'A' && name[1] <= 'Z')
    return "begins with an underscore and a capital, which C++ reserves";
  return {};
}

bool is_taken_namespace(std::string_view name) {
  return std::find(kTakenNamespaces.begin(), kTakenNamespaces.end(), name) != kTakenNamespaces.end();
}

const std::string& expect_name(const Document& document, const YamlNode& node, std::string_view what) {
  const std::string& name = expect_text(document, node, fmt::format("a name for {}", what));
  if (const std::string objection = objection_to_name(name); !objection.empty())
    throw InputError(document.where(node), fmt::format("'{}' {}", printable(name), objection));
  return name;
}

const std::string& expect_mechanism_name(const Document& document, const YamlNode& node) {
  const std::string& name = expect_name(document, node, "the mechanism");
  if (is_taken_namespace(name))
    throw InputError(document.where(node),
                     fmt::format("'{}' is taken; the mechanism's name becomes a C++ namespace", name));
  return name;
}

}  // namespace alembert
