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

// The others that no pattern below fits: of the C library as C++ has it, and of what the headers of libstdc++ include.
constexpr std::string_view kOtherMacros =
    " AIO_PRIO_DELTA_MAX BIG_ENDIAN BUFSIZ BYTE_ORDER CHARCLASS_NAME_MAX CHAR_BIT CLOCKS_PER_SEC CSIGNAL "
    "DECIMAL_DIG DELAYTIMER_MAX E2BIG EACCES EADDRINUSE EADDRNOTAVAIL EADV EAFNOSUPPORT EAGAIN EALREADY "
    "EBADE EBADF EBADFD EBADMSG EBADR EBADRQC EBADSLT EBFONT EBUSY ECANCELED ECHILD ECHRNG ECOMM "
    "ECONNABORTED ECONNREFUSED ECONNRESET EDEADLK EDEADLOCK EDESTADDRREQ EDOM EDOTDOT EDQUOT EEXIST "
    "EFAULT EFBIG EHOSTDOWN EHOSTUNREACH EHWPOISON EIDRM EILSEQ EINPROGRESS EINTR EINVAL EIO EISCONN "
    "EISDIR EISNAM EKEYEXPIRED EKEYREJECTED EKEYREVOKED EL2HLT EL2NSYNC EL3HLT EL3RST ELIBACC ELIBBAD "
    "ELIBEXEC ELIBMAX ELIBSCN ELNRNG ELOOP EMEDIUMTYPE EMFILE EMLINK EMSGSIZE EMULTIHOP ENAMETOOLONG "
    "ENAVAIL ENETDOWN ENETRESET ENETUNREACH ENFILE ENOANO ENOBUFS ENOCSI ENODATA ENODEV ENOENT ENOEXEC "
    "ENOKEY ENOLCK ENOLINK ENOMEDIUM ENOMEM ENOMSG ENONET ENOPKG ENOPROTOOPT ENOSPC ENOSR ENOSTR ENOSYS "
    "ENOTBLK ENOTCONN ENOTDIR ENOTEMPTY ENOTNAM ENOTRECOVERABLE ENOTSOCK ENOTSUP ENOTTY ENOTUNIQ ENXIO "
    "EOPNOTSUPP EOVERFLOW EOWNERDEAD EPERM EPFNOSUPPORT EPIPE EPROTO EPROTONOSUPPORT EPROTOTYPE ERANGE "
    "EREMCHG EREMOTE EREMOTEIO ERESTART ERFKILL EROFS ESHUTDOWN ESOCKTNOSUPPORT ESPIPE ESRCH ESRMNT "
    "ESTALE ESTRPIPE ETIME ETIMEDOUT ETOOMANYREFS ETXTBSY EUCLEAN EUNATCH EUSERS EWOULDBLOCK EXDEV "
    "EXFULL EXPR_NEST_MAX FD_CLR FD_ISSET FD_SET FD_SETSIZE FD_ZERO HOST_NAME_MAX IOV_MAX LINE_MAX "
    "LITTLE_ENDIAN LONG_BIT LONG_LONG_MAX LONG_LONG_MIN L_ctermid L_cuserid L_tmpnam MATH_ERREXCEPT "
    "MATH_ERRNO MAXFLOAT MAX_CANON MAX_INPUT MB_CUR_MAX MB_LEN_MAX MOD_CLKA MOD_CLKB MOD_ESTERROR "
    "MOD_FREQUENCY MOD_MAXERROR MOD_MICRO MOD_NANO MOD_OFFSET MOD_STATUS MOD_TAI MOD_TIMECONST "
    "MQ_PRIO_MAX NAME_MAX NFDBITS NGROUPS_MAX NZERO PATH_MAX PDP_ENDIAN PIPE_BUF P_tmpdir RE_DUP_MAX "
    "RTSIG_MAX SEM_VALUE_MAX SSIZE_MAX STA_CLK STA_CLOCKERR STA_DEL STA_FLL STA_FREQHOLD STA_INS "
    "STA_MODE STA_NANO STA_PLL STA_PPSERROR STA_PPSFREQ STA_PPSJITTER STA_PPSSIGNAL STA_PPSTIME "
    "STA_PPSWANDER STA_RONLY STA_UNSYNC TIMER_ABSTIME TIME_UTC TTY_NAME_MAX ULONG_LONG_MAX WEOF WNOHANG "
    "WNOWAIT WORD_BIT WUNTRACED alloca assert_perror i386 issubnormal math_errhandling offsetof "
    "sched_priority setjmp strdupa strndupa va_arg va_copy va_end va_start ";

bool is_other_macro(std::string_view name) {
  return kOtherMacros.find(fmt::format(" {} ", name)) != std::string_view::npos;
}

/// Macros of the C library by their forms: of <math.h>, <fenv.h>, <locale.h>, <stdlib.h>, <stdio.h>,
/// <stdatomic.h>, <float.h>, <limits.h>, <stdint.h>, <inttypes.h>, <signal.h>; of Eigen, and of <sched.h>, <pthread.h>
/// and others that libstdc++ includes.
bool has_form_of_macro(const std::string& name) {
  static const std::regex forms(
      "M_(E|LOG2E|LOG10E|LN2|LN10|PI|PI_2|PI_4|1_PI|2_PI|2_SQRTPI|SQRT2|SQRT1_2)[a-z0-9]*|HUGE_VAL(F|L|_F[0-"
      "9X]+)?"
      "|S?NAN(F|L|F[0-9X]+)?|(FE|FP|LC|EXIT|SEEK|ATOMIC)_[A-Z0-9_]+|(DBL|FLT[0-9]*X?|LDBL)_[A-Z0-9_]+"
      "|([SU]?CHAR|U?SHRT|U?L?LONG|BOOL|U?INT[A-Z0-9_]*|SIZE|PTRDIFF|WCHAR|WINT|SIG_ATOMIC|RAND|FOPEN|"
      "FILENAME|TMP)_"
      "(MAX|MIN|WIDTH|C)|(PRI[diouxX]|SCN[dioux])(LEAST|FAST)?(8|16|32|64|MAX|PTR)|SIG(ABRT|FPE|ILL|INT|SEGV|"
      "TERM|_DFL"
      "|_ERR|_IGN)|EIGEN_\\w+|B?F16_PACKET_FUNCTION|(CLOCK|CLONE|CPU|PTHREAD|SCHED|ADJ|RENAME)_[A-Z0-9_]+"
      "|W(IF)?(EXIT|STOP|SIGNAL|TERM|CONTINU)[A-Z]+|(be|le)(16|32|64)toh|hto(be|le)(16|32|64)"
      "|(vec[24][dfi]|pthread_cleanup|ei|eigen)_\\w+|(BC|NL|XATTR|COLL|LOGIN|LINE|POSIX)_[A-Z_]+MAX");
  return std::regex_match(name, forms);
}

constexpr std::array kTakenNamespaces = {"Eigen"sv, "alembert"sv, "main"sv, "posix"sv, "std"sv};

constexpr std::string_view kIsMacro = "is a macro of the C++ library";

/// What forbids `name` as the name of a namespace, wherever that is; empty if nothing does.
std::string objection_to_namespace(std::string_view name) {
  if (std::string objection = objection_to_name(name); !objection.empty()) return objection;
  if (is_other_macro(name) || has_form_of_macro(std::string(name))) return std::string(kIsMacro);
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
