// A file on its way: it takes the place of another once it is whole, and is removed where that does not come about.
// Tested by tests/faults and tests/cli/output_file_test.cpp.
#pragma once

#include <atomic>
#include <filesystem>
#include <string>
#include <string_view>

#include "engine/platform/file.hpp"

namespace rungproof {

/// The name of the file that becomes `target` when it is whole.
std::string partOf(const std::string& target);

class PartFile {
 public:
  /// Beside the target, held while it lives: removeStaleParts() sees that somebody writes.
  PartFile(const std::filesystem::path& target, Readers readers);
  ~PartFile();
  PartFile(const PartFile&) = delete;
  PartFile& operator=(const PartFile&) = delete;

  /// False: it could not be made, and errno tells why. So do the calls below.
  bool isOpen() const { return descriptor_ >= 0; }
  int descriptor() const { return descriptor_; }
  const std::filesystem::path& name() const { return name_; }
  bool close();
  /// Closes it if it is open, and puts it in the target's place.
  bool replaceTarget();

 private:
  void remove();
  const std::filesystem::path target_, name_;
  std::atomic<const std::filesystem::path*>* known_;
  int descriptor_ = -1;
  bool isThere_ = false;
};

/// Removes the parts of this process, for an end in which no destructor runs. Allocates nothing.
void removeOpenParts();

}  // namespace rungproof
