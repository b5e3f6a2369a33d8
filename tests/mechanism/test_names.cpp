#include <gtest/gtest.h>
#include <stdio.h>

#include <array>
#include <memory>
#include <sstream>
#include <string>

#include "mechanism/names.hpp"

namespace alembert {
namespace {

TEST(Names, AcceptsIdentifiers) {
  for (const char* name : {"a", "A", "_a", "arm_2", "x1", "a_", "Double", "q"})
    EXPECT_EQ(objection_to_name(name), "") << name;
}

TEST(Names, RefusesKeywordsAndAlternativeTokens) {
  for (const char* name : {"alignas", "and", "bitor", "char8_t", "class", "compl", "concept", "double",
                           "not_eq", "xor_eq", "while"})
    EXPECT_EQ(objection_to_name(name), "is a C++ keyword") << name;
}

TEST(Names, RefusesReservedForms) {
  EXPECT_NE(objection_to_name("__a"), "");
  EXPECT_NE(objection_to_name("a__b"), "");
  EXPECT_NE(objection_to_name("_A"), "");
}

TEST(Names, OfMechanismsAreNoMacrosOfTheLibrary) {
  for (const char* name : {"M_PI",    "M_PIf",           "M_SQRT1_2", "HUGE_VAL",     "HUGE_VALF", "INT_MAX",
                           "INT64_C", "UINT_LEAST8_MAX", "EOF",       "NAN",          "NULL",      "errno",
                           "ERANGE",  "FE_INVALID",      "FP_NAN",    "DBL_EPSILON",  "PRId64",    "SCNuMAX",
                           "SIGINT",  "SIG_DFL",         "LC_ALL",    "EXIT_SUCCESS", "SEEK_SET",  "CHAR_BIT",
                           "BUFSIZ",  "RAND_MAX",        "assert",    "offsetof",     "va_arg",    "stdin",
                           "linux",   "math_errhandling"})
    EXPECT_EQ(objection_to_mechanism_name(name), "is a macro of the C++ library") << name;
  EXPECT_EQ(objection_to_mechanism_name("std"), "is taken");
  // Robots have such names.
  for (const char* name :
       {"UR5", "KR5", "M_10IA", "M_20", "IRB_120", "EC66", "LBR_IIWA", "NAO", "ARM_C", "SIGMA"})
    EXPECT_EQ(objection_to_mechanism_name(name), "") << name;
  // Coordinates and bodies are text in generated code.
  EXPECT_EQ(objection_to_name("M_PI"), "");
}

/// What a compiler prints of itself.
std::string output_of(const std::string& command) {
  const std::unique_ptr<FILE, int (*)(FILE*)> pipe(popen(command.c_str(), "r"), pclose);
  std::string text;
  std::array<char, 4096> part;
  while (const std::size_t n = std::fread(part.data(), 1, part.size(), pipe.get()))
    text.append(part.data(), n);
  return text;
}

TEST(Names, OfMechanismsAreNoMacrosOfWhatGeneratedCodeIncludes) {
  const std::string source =
      "'#include <Eigen/Dense>\n#include <algorithm>\n#include <array>\n#include <cmath>\n"
      "#include <cstdint>\n#include <cstdio>\n#include <cstring>\n#include <random>\n"
      "#include <string_view>\n#include <thread>\n#include <vector>\n'";
  std::istringstream lines(output_of("printf " + source +
                                     " | " ALEMBERT_HOST_CXX
                                     " -std=c++17 -x c++ -dM -E -isystem " ALEMBERT_EIGEN " -"));
  int macros = 0;
  for (std::string define, name; lines >> define >> name; lines.ignore(1 << 20, '\n')) {
    name = name.substr(0, name.find('('));
    if (name[0] == '_' || name.find("__") != std::string::npos) continue;  // reserved
    ++macros;
    EXPECT_NE(objection_to_mechanism_name(name), "") << name;
  }
  EXPECT_GT(macros, 500);
}

TEST(Names, OfNamespacesAreNotReserved) {
  for (const char* fit : {"a", "a::b", "alembert::mechanisms", "acme::_b", "my::std2", "stdrobots"})
    EXPECT_EQ(objection_to_outer_namespace(fit), "") << fit;
  const auto expect = [](const char* text, const char* part) {
    EXPECT_EQ(objection_to_outer_namespace(text).substr(0, std::string_view(part).size()), part) << text;
  };
  expect("std", "'std' is a namespace of others");
  expect("a::std", "'std' is a namespace of others");
  expect("std::a", "'std' is a namespace of others");
  expect("std2::a", "'std2' is reserved");
  expect("posix", "'posix' is");
  expect("Eigen", "'Eigen' is");
  expect("__a", "'__a' has two underscores");
  expect("x::a__b", "'a__b' has two underscores");
  expect("a::_B", "'_B' begins with an underscore and a capital");
  expect("_a", "'_a' begins with an underscore");
  expect("a::M_PI", "'M_PI' is a macro");
  expect("a::", "'' is not a name");
  expect("a:::b", "':b' is not a name");
}

TEST(Names, RefusesOtherCharacters) {
  for (const char* name : {"", "1a", "a-b", "a b", "a\"b", "a\nb", "a*/b", "a.b", "\xC3\xA9", "a/b", "../a"})
    EXPECT_NE(objection_to_name(name).find("is not a name"), std::string::npos) << name;
}

TEST(Names, RefusesLongOnes) {
  EXPECT_EQ(objection_to_name(std::string(64, 'a')), "");
  EXPECT_NE(objection_to_name(std::string(65, 'a')), "");
}

}  // namespace
}  // namespace alembert
