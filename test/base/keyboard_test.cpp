// A terminal from which single keys are read.

#include "base/keyboard.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <stdlib.h>
#include <termios.h>
#include <unistd.h>

#include <atomic>

#include "eventually.h"

namespace place_recognition {
namespace {

TEST(Keyboard, HandsOverEachKeyAtOnceAndLeavesTheTerminalAsItWas) {
  const int person = posix_openpt(O_RDWR | O_NOCTTY);
  ASSERT_GE(person, 0);
  ASSERT_EQ(grantpt(person) | unlockpt(person), 0);
  const int terminal = open(ptsname(person), O_RDWR | O_NOCTTY);
  ASSERT_GE(terminal, 0);
  ASSERT_TRUE(Keyboard::isUsable(terminal));
  termios before{}, during{}, after{};
  tcgetattr(terminal, &before);
  std::atomic<char> last{0};
  {
    const Keyboard keyboard(terminal, [&last](char key) { last = key; });
    tcgetattr(terminal, &during);
    for (const char key : {'1', '2', '0'}) {
      ASSERT_EQ(write(person, &key, 1), 1);
      EXPECT_TRUE(eventually([&] { return last == key; })) << key;
    }
  }
  tcgetattr(terminal, &after);
  EXPECT_FALSE(during.c_lflag & ICANON);
  EXPECT_TRUE(during.c_lflag & ISIG);  // Ctrl-C
  EXPECT_EQ(after.c_lflag, before.c_lflag);
  close(terminal);
  close(person);
}

TEST(Keyboard, NeedsATerminal) {
  int ends[2];
  ASSERT_EQ(pipe(ends), 0);
  EXPECT_FALSE(Keyboard::isUsable(ends[0]));
  close(ends[0]);
  close(ends[1]);
}

}  // namespace
}  // namespace place_recognition
