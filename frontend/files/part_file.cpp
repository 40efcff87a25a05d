// Parts that are there stand in a row of fixed length, so that they are found when there is no memory left.
#include "frontend/files/part_file.hpp"

#include <fmt/core.h>

#include <array>

#include "engine/platform/names.hpp"

namespace rungproof {

namespace {

namespace fs = std::filesystem;

std::array<std::atomic<const fs::path*>, 64> openParts;

/// nullptr where so many are open already.
std::atomic<const fs::path*>* openPlaceOf(const fs::path& part) {
  for (std::atomic<const fs::path*>& place : openParts) {
    const fs::path* none = nullptr;
    if (place.compare_exchange_strong(none, &part)) return &place;
  }
  return nullptr;
}

}  // namespace

std::string partOf(const std::string& target) { return target + fmt::format(".{}.part", processNumber()); }

PartFile::PartFile(const fs::path& target, Readers readers)
    : target_(target),
      name_(partOf(pathName(target))),
      known_(openPlaceOf(name_)),
      descriptor_(openNew(name_, readers)) {
  isThere_ = isOpen();
}

PartFile::~PartFile() {
  close();
  remove();
  if (known_ != nullptr) known_->store(nullptr);
}

void PartFile::remove() {
  if (isThere_) removeFile(name_);
  isThere_ = false;
}

bool PartFile::close() {
  if (!isOpen()) return true;
  const bool isClosed = closeFile(descriptor_);
  descriptor_ = -1;
  return isClosed;
}

bool PartFile::replaceTarget() {
  if (!close() || !replaceFile(name_, target_)) return false;
  isThere_ = false;
  return true;
}

void removeOpenParts() {
  for (const std::atomic<const fs::path*>& place : openParts) {
    if (const fs::path* part = place.load()) removeFile(*part);
  }
}

}  // namespace rungproof
