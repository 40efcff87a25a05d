// Changes of files, folder by folder, and interrupts that are taken like bytes. Tested by tests/platform and
// tests/cli/watch_test.cpp.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "engine/platform/waitable.hpp"

namespace rungproof {

class FolderWatch final : public Waitable {
 public:
  FolderWatch();
  ~FolderWatch();
  /// From now on; a folder that is not there is left out.
  void add(const std::string& folder);
  /// The files that have been written, have come or gone since the last call, each with its folder as it was added.
  std::vector<std::string> take();

 private:
  struct State;
  std::shared_ptr<State> state_;
};

/// Ctrl-C and requests to end do nothing to this process while it lives, but are noted here.
class InterruptWatch final : public Waitable {
 public:
  InterruptWatch();
  ~InterruptWatch();
  /// Which one has come, for ChildProcess::interrupt().
  int take();
};

}  // namespace rungproof
