#include <gtest/gtest.h>

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
