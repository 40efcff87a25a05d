// /proc and sysconf().
#include "engine/platform/memory.hpp"

#include <malloc.h>
#include <unistd.h>

#include <fstream>

/// Of mimalloc, where that is linked.
extern "C" [[gnu::weak]] void mi_collect(bool isForced) noexcept;

namespace rungproof {

std::uint64_t residentBytes() {
  std::ifstream stream("/proc/self/statm");
  std::uint64_t size = 0, resident = 0;
  stream >> size >> resident;
  return stream ? resident * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE)) : 0;
}

void returnUnusedMemory() {
  if (mi_collect != nullptr)
    mi_collect(true);
  else
    malloc_trim(0);
}

std::uint64_t usualMemoryLimit() {
  const long pages = sysconf(_SC_PHYS_PAGES), size = sysconf(_SC_PAGESIZE);
  return pages > 0 && size > 0 ? static_cast<std::uint64_t>(pages) * static_cast<std::uint64_t>(size) / 4 * 3 : 0;
}

}  // namespace rungproof
