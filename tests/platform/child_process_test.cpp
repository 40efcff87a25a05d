// Work in a process of its own: its result, its end, its limit, an interrupt.
#include "engine/platform/child_process.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <new>

namespace rungproof {
namespace {

int echo(const std::string& request, const GiveBytes& give) { return give(request) && give("!") ? 3 : 1; }
int throwing(const std::string&, const GiveBytes&) { throw std::bad_alloc(); }
int endless(const std::string&, const GiveBytes& give) {
  give("begun");
  while (true) ::pause();
}
int hungry(const std::string&, const GiveBytes& give) {
  std::vector<char> room(std::size_t{600} << 20, 'x');
  return give({room.data(), 1}) ? 0 : 1;
}
int printing(const std::string&, const GiveBytes& give) {
  // Standard input and output are nobody's: nothing comes, and what is written goes nowhere.
  char c = 0;
  const bool isSilent = ::read(STDIN_FILENO, &c, 1) == 0 && ::write(STDOUT_FILENO, "lost", 4) == 4;
  return give(isSilent ? "silent" : "loud") ? 0 : 1;
}

constexpr Worker echoWorker = {"echo", echo}, throwingWorker = {"throwing", throwing},
                 endlessWorker = {"endless", endless}, hungryWorker = {"hungry", hungry},
                 printingWorker = {"printing", printing};

std::string allOf(ChildProcess& child) {
  std::string bytes;
  while (child.output().take(bytes) != ByteSource::Taken::End) continue;
  return bytes;
}

TEST(ChildProcess, GivesWhatItsWorkerGives) {
  const std::string request(300'000, 'r');  // more than a pipe holds
  ChildProcess child(echoWorker, request, ChildKind::Check);
  ASSERT_TRUE(child.hasBegun());
  EXPECT_EQ(allOf(child), request + "!");
  EXPECT_EQ(child.wait(), 3);
}

TEST(ChildProcess, AWorkerThatThrowsHasFailed) {
  ChildProcess child(throwingWorker, "", ChildKind::Check);
  EXPECT_EQ(allOf(child), "");
  EXPECT_EQ(child.wait(), 1);
}

TEST(ChildProcess, EndsWithItsObject) {
  {
    ChildProcess child(endlessWorker, "", ChildKind::Job);
    std::string bytes;
    EXPECT_EQ(child.output().take(bytes), ByteSource::Taken::Bytes);
    EXPECT_EQ(bytes, "begun");
  }
  EXPECT_EQ(::waitpid(-1, nullptr, WNOHANG), -1) << "a child is left";
}

#ifndef __SANITIZE_ADDRESS__  // it reserves more than any limit
TEST(ChildProcess, TakesNoMoreMemoryThanItMay) {
  ChildProcess child(hungryWorker, "", ChildKind::Check, std::uint64_t{512} << 20);
  EXPECT_EQ(allOf(child), "");
  EXPECT_NE(child.wait(), 0);  // std::bad_alloc, or an end by an allocator that cannot throw
  ChildProcess free(hungryWorker, "", ChildKind::Check);
  EXPECT_EQ(allOf(free), "x");
}
#endif

TEST(ChildProcess, AJobLeavesStandardInputAndOutputAlone) {
  ChildProcess child(printingWorker, "", ChildKind::Job);
  EXPECT_EQ(allOf(child), "silent");
}

TEST(ChildProcess, AnInterruptIsHandedOn) {
  std::signal(SIGINT, SIG_DFL);  // a shell that starts tests in the background ignores it, and so would the child
  ChildProcess child(endlessWorker, "", ChildKind::Run);
  std::string bytes;
  EXPECT_EQ(child.output().take(bytes), ByteSource::Taken::Bytes);
  child.interrupt(SIGINT);
  EXPECT_EQ(child.wait(), std::nullopt);  // ended from outside
}

TEST(ChildProcess, OneOfSeveralIsReady) {
  ChildProcess waiting(endlessWorker, "", ChildKind::Job), quick(echoWorker, "x", ChildKind::Job);
  std::string bytes;
  waiting.output().take(bytes);
  const std::array<const Waitable*, 2> both = {&waiting.output(), &quick.output()};
  const std::vector<bool> ready = waitForAny(both, -1);
  EXPECT_EQ(ready, (std::vector<bool>{false, true}));
  EXPECT_EQ(allOf(quick), "x!");
}

}  // namespace
}  // namespace rungproof
