// What comes from outside stays one harmless line in a message.
#include "io/message.hpp"

#include <gtest/gtest.h>

#include <random>

namespace vug {
namespace {

TEST(Messages, KeepWhatIsReadable) {
  EXPECT_EQ(one_line("size = [0.01, 0.02] # Größe, 大きさ, 🪨"),
            "size = [0.01, 0.02] # Größe, 大きさ, 🪨");
}

TEST(Messages, HoldNothingThatATerminalActsOn) {
  EXPECT_EQ(one_line("a\x1b[31mb\r\nc\td\x7f"), "a [31mb  c d ");
  EXPECT_EQ(one_line("a\xc2\x9b"
                     "31mb"),
            "a 31mb");                                                             // the one-character form of ESC [
  EXPECT_EQ(one_line("a\xe2\x80\xae\x62\xe2\x80\xa8\x63\xe2\x81\xa6"), "a b c ");  // turned, line separator, isolate
}

TEST(Messages, ShowBytesThatAreNoTextAsQuestionMarks) {
  EXPECT_EQ(one_line("a\xff\x80\xc3"), "a???");
  EXPECT_EQ(one_line("\xc0\xaf"), "??");            // overlong
  EXPECT_EQ(one_line("\xed\xa0\x80"), "???");       // a surrogate
  EXPECT_EQ(one_line("\xf4\x90\x80\x80"), "????");  // beyond U+10FFFF
  EXPECT_FALSE(is_utf8("\xff"));
  EXPECT_TRUE(is_utf8("ä"));
}

TEST(Messages, QuoteTheBeginningOfWhatIsLong) {
  EXPECT_EQ(excerpt("short"), "short");
  EXPECT_EQ(excerpt(std::string(1000000, 'x'), 20), std::string(16, 'x') + " ...");
  EXPECT_EQ(excerpt("aaaaaaaaaaaaaaaää", 16 + 2), "aaaaaaaaaaaaaa ...");
  EXPECT_EQ(excerpt("12345678ää", 12), "12345678ää");
  EXPECT_EQ(excerpt("1234567äää", 12), "1234567 ...");  // not half a character
}

TEST(Messages, AreTextWhateverComes) {
  std::mt19937 random(3);
  for (int i = 0; i < 20000; ++i) {
    std::string bytes(random() % 80, '\0');
    for (char& c : bytes) c = static_cast<char>(random() % 256);
    const std::string line = excerpt(bytes);
    EXPECT_TRUE(is_utf8(line));
    EXPECT_LE(line.size(), 64u);
    for (const char c : line) EXPECT_FALSE(static_cast<unsigned char>(c) < 0x20 || c == 0x7f);
  }
}

}  // namespace
}  // namespace vug
