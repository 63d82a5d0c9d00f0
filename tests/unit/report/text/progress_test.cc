#include "report/text/progress.h"

#include <algorithm>
#include <chrono>
#include <sstream>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

namespace clevis::report {
namespace {

using namespace std::chrono_literals;

class FakeTime {
 public:
  Progress::Clock clock() {
    return [this] {
      return now_;
    };
  }
  void pass(std::chrono::milliseconds time) { now_ += time; }

 private:
  std::chrono::steady_clock::time_point now_{};
};

TEST(Progress, LogIsSilentForTenSecondsThenGetsALineEachTen) {
  FakeTime time;
  std::ostringstream out;
  Progress progress(out, Progress::Stream::kLog, time.clock());
  for (int tenth = 0; tenth < 99; ++tenth) {
    progress.update(0, 5, "DCE");
    time.pass(100ms);
  }
  EXPECT_EQ(out.str(), "");
  for (int tenth = 99; tenth <= 300; ++tenth) {
    progress.update(2, 5, "solving\nBC");
    time.pass(100ms);
  }
  EXPECT_EQ(out.str(),
            "10 s: 2/5 solving?BC\n20 s: 2/5 solving?BC\n"
            "30 s: 2/5 solving?BC\n");
}

TEST(Progress, TerminalShowsABarThatFillsAndIsWiped) {
  FakeTime time;
  std::ostringstream out;
  {
    Progress progress(out, Progress::Stream::kTerminal, time.clock());
    progress.update(0, 4, "DCE");
    EXPECT_EQ(out.str(), "\r\033[K[          ] 0/4   0.0 s  DCE");
    out.str("");
    time.pass(1500ms);
    progress.update(2, 4, "BC");
    EXPECT_EQ(out.str(), "\r\033[K[#####     ] 2/4   1.5 s  BC");
    out.str("");
  }
  EXPECT_EQ(out.str(), "\r\033[K");
}

TEST(Progress, TerminalIsNotRedrawnFasterThanTheEye) {
  FakeTime time;
  std::ostringstream out;
  Progress progress(out, Progress::Stream::kTerminal, time.clock());
  for (int i = 0; i < 1000; ++i) {
    progress.update(1, 4, "DCE");
    time.pass(1ms);
  }
  // The first update draws; then one redraw per 100 ms in 999 ms.
  const std::string text = out.str();
  EXPECT_EQ(std::count(text.begin(), text.end(), '\r'), 10);
}

TEST(Progress, LongTextStaysOnOneLineAndWholeInItsCharacters) {
  FakeTime time;
  std::ostringstream out;
  Progress progress(out, Progress::Stream::kTerminal, time.clock());
  progress.update(100, 100, std::string(48, 'x') + "µµµ");
  const std::string text = out.str().substr(4);  // behind the wipe
  EXPECT_EQ(text.size(), 78u);  // half of a µ would fill the 79th place
  EXPECT_EQ(text.substr(text.size() - 3), "xxx");
}

TEST(Progress, WhatAPartIsAtFitsBesideTheBar) {
  FakeTime time;
  std::ostringstream out;
  Progress progress(out, Progress::Stream::kTerminal, time.clock());
  const std::string stage = "crank: degree 3, 12 480 cells, 214 k unknowns";
  time.pass(1234500ms);
  progress.update(0, 1, stage);
  EXPECT_TRUE(out.str().ends_with(stage)) << out.str();
}

TEST(Progress, ThreadsDoNotTearLines) {
  std::ostringstream out;
  {
    Progress progress(out, Progress::Stream::kTerminal);
    std::vector<std::thread> threads;
    for (int thread = 0; thread < 4; ++thread) {
      threads.emplace_back([&progress, thread] {
        for (int i = 0; i < 200; ++i) {
          progress.update(i, 200,
                          std::string(8, static_cast<char>('a' + thread)));
        }
      });
    }
    for (std::thread& thread : threads) thread.join();
  }
  std::istringstream lines(out.str());
  std::string line;
  int drawn = 0;
  std::getline(lines, line, '\r');  // before the first bar
  while (std::getline(lines, line, '\r') && line != "\033[K") {
    ++drawn;
    ASSERT_GT(line.size(), 8u);
    const std::string name = line.substr(line.size() - 8);
    EXPECT_EQ(name, std::string(8, name[0])) << line;
  }
  EXPECT_EQ(drawn, 800) << "a change is always drawn";
}

}  // namespace
}  // namespace clevis::report
