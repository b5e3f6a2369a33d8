#include "mechanism/names.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <regex>

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

// The others of the C library as C++ has it that no pattern below fits; sorted.
constexpr std::array kOtherMacros = {"BUFSIZ"sv,
                                     "CHAR_BIT"sv,
                                     "CLOCKS_PER_SEC"sv,
                                     "DECIMAL_DIG"sv,
                                     "E2BIG"sv,
                                     "EACCES"sv,
                                     "EADDRINUSE"sv,
                                     "EADDRNOTAVAIL"sv,
                                     "EAFNOSUPPORT"sv,
                                     "EAGAIN"sv,
                                     "EALREADY"sv,
                                     "EBADF"sv,
                                     "EBADMSG"sv,
                                     "EBUSY"sv,
                                     "ECANCELED"sv,
                                     "ECHILD"sv,
                                     "ECONNABORTED"sv,
                                     "ECONNREFUSED"sv,
                                     "ECONNRESET"sv,
                                     "EDEADLK"sv,
                                     "EDESTADDRREQ"sv,
                                     "EDOM"sv,
                                     "EEXIST"sv,
                                     "EFAULT"sv,
                                     "EFBIG"sv,
                                     "EHOSTUNREACH"sv,
                                     "EIDRM"sv,
                                     "EILSEQ"sv,
                                     "EINPROGRESS"sv,
                                     "EINTR"sv,
                                     "EINVAL"sv,
                                     "EIO"sv,
                                     "EISCONN"sv,
                                     "EISDIR"sv,
                                     "ELOOP"sv,
                                     "EMFILE"sv,
                                     "EMLINK"sv,
                                     "EMSGSIZE"sv,
                                     "ENAMETOOLONG"sv,
                                     "ENETDOWN"sv,
                                     "ENETRESET"sv,
                                     "ENETUNREACH"sv,
                                     "ENFILE"sv,
                                     "ENOBUFS"sv,
                                     "ENODATA"sv,
                                     "ENODEV"sv,
                                     "ENOENT"sv,
                                     "ENOEXEC"sv,
                                     "ENOLCK"sv,
                                     "ENOLINK"sv,
                                     "ENOMEM"sv,
                                     "ENOMSG"sv,
                                     "ENOPROTOOPT"sv,
                                     "ENOSPC"sv,
                                     "ENOSR"sv,
                                     "ENOSTR"sv,
                                     "ENOSYS"sv,
                                     "ENOTCONN"sv,
                                     "ENOTDIR"sv,
                                     "ENOTEMPTY"sv,
                                     "ENOTRECOVERABLE"sv,
                                     "ENOTSOCK"sv,
                                     "ENOTSUP"sv,
                                     "ENOTTY"sv,
                                     "ENXIO"sv,
                                     "EOPNOTSUPP"sv,
                                     "EOVERFLOW"sv,
                                     "EOWNERDEAD"sv,
                                     "EPERM"sv,
                                     "EPIPE"sv,
                                     "EPROTO"sv,
                                     "EPROTONOSUPPORT"sv,
                                     "EPROTOTYPE"sv,
                                     "ERANGE"sv,
                                     "EROFS"sv,
                                     "ESPIPE"sv,
                                     "ESRCH"sv,
                                     "ETIME"sv,
                                     "ETIMEDOUT"sv,
                                     "ETXTBSY"sv,
                                     "EWOULDBLOCK"sv,
                                     "EXDEV"sv,
                                     "L_tmpnam"sv,
                                     "MATH_ERREXCEPT"sv,
                                     "MATH_ERRNO"sv,
                                     "MB_CUR_MAX"sv,
                                     "MB_LEN_MAX"sv,
                                     "TIME_UTC"sv,
                                     "WEOF"sv,
                                     "i386"sv,
                                     "math_errhandling"sv,
                                     "offsetof"sv,
                                     "setjmp"sv,
                                     "va_arg"sv,
                                     "va_copy"sv,
                                     "va_end"sv,
                                     "va_start"sv};
static_assert(std::is_sorted(kOtherMacros.begin(), kOtherMacros.end()));

/// Macros of the C library by their forms: of <math.h>, <fenv.h>, <locale.h>, <stdlib.h>, <stdio.h>,
/// <stdatomic.h>, <float.h>, <limits.h>, <stdint.h>, <inttypes.h>, <signal.h>.
bool has_form_of_macro(const std::string& name) {
  static const std::regex forms(
      "M_(E|LOG2E|LOG10E|LN2|LN10|PI|PI_2|PI_4|1_PI|2_PI|2_SQRTPI|SQRT2|SQRT1_2)[a-z0-9]*|HUGE_VAL(F|L|_F[0-"
      "9X]+)?"
      "|S?NAN(F|L|F[0-9X]+)?|(FE|FP|LC|EXIT|SEEK|ATOMIC)_[A-Z0-9_]+|(DBL|FLT[0-9]*X?|LDBL)_[A-Z0-9_]+"
      "|([SU]?CHAR|U?SHRT|U?L?LONG|BOOL|U?INT[A-Z0-9_]*|SIZE|PTRDIFF|WCHAR|WINT|SIG_ATOMIC|RAND|FOPEN|"
      "FILENAME|TMP)_"
      "(MAX|MIN|WIDTH|C)|(PRI[diouxX]|SCN[dioux])(LEAST|FAST)?(8|16|32|64|MAX|PTR)|SIG(ABRT|FPE|ILL|INT|SEGV|"
      "TERM|_DFL"
      "|_ERR|_IGN)");
  return std::regex_match(name, forms);
}

constexpr std::array kTakenNamespaces = {"Eigen"sv, "alembert"sv, "main"sv, "posix"sv, "std"sv};

constexpr std::string_view kIsMacro = "is a macro of the C++ library";

/// What forbids `name` as the name of a namespace, wherever that is; empty if nothing does.
std::string objection_to_namespace(std::string_view name) {
  if (std::string objection = objection_to_name(name); !objection.empty()) return objection;
  if (std::binary_search(kOtherMacros.begin(), kOtherMacros.end(), name) ||
      has_form_of_macro(std::string(name)))
    return std::string(kIsMacro);
  return {};
}

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
  if (std::binary_search(kMacros.begin(), kMacros.end(), name)) return std::string(kIsMacro);
  if (name.find("__") != std::string_view::npos) return "has two underscores in a row, which C++ reserves";
  if (name.size() > 1 && name[0] == '_' && name[1] >= 'A' && name[1] <= 'Z')
    return "begins with an underscore and a capital, which C++ reserves";
  return {};
}

std::string objection_to_mechanism_name(std::string_view name) {
  if (std::find(kTakenNamespaces.begin(), kTakenNamespaces.end(), name) != kTakenNamespaces.end())
    return "is taken";
  return objection_to_namespace(name);
}

std::string objection_to_outer_namespace(std::string_view text) {
  const std::string_view first = text.substr(0, text.find("::"));
  for (std::string_view rest = text;;) {
    const std::size_t end = rest.find("::");
    const std::string_view part = rest.substr(0, end);
    std::string objection = objection_to_namespace(part);
    const bool begins_outermost = part.data() == first.data();
    if (objection.empty() && (part == "std" || part == "posix" || part == "Eigen"))
      objection = "is a namespace of others";
    if (objection.empty() && begins_outermost && part.starts_with("std") &&
        std::all_of(part.begin() + 3, part.end(), is_digit))
      objection = "is reserved for C++ libraries to come";
    if (objection.empty() && begins_outermost && part[0] == '_')
      objection = "begins with an underscore, which C++ reserves outside of namespaces";
    if (!objection.empty()) return fmt::format("'{}' {}", printable(part), objection);
    if (end == std::string_view::npos) return {};
    rest.remove_prefix(end + 2);
  }
}

const std::string& expect_name(const Document& document, const YamlNode& node, std::string_view what) {
  const std::string& name = expect_text(document, node, fmt::format("a name for {}", what));
  if (const std::string objection = objection_to_name(name); !objection.empty())
    throw InputError(document.where(node), fmt::format("'{}' {}", printable(name), objection));
  return name;
}

const std::string& expect_mechanism_name(const Document& document, const YamlNode& node) {
  const std::string& name = expect_name(document, node, "the mechanism");
  if (const std::string objection = objection_to_mechanism_name(name); !objection.empty())
    throw InputError(document.where(node),
                     fmt::format("'{}' {}; the mechanism's name becomes a C++ namespace", name, objection));
  return name;
}

}  // namespace alembert
