// Counters of the system.
#include "engine/platform/memory.hpp"

#include <malloc.h>
#include <windows.h>
// behind windows.h
#include <psapi.h>

namespace rungproof {

std::uint64_t residentBytes() {
  PROCESS_MEMORY_COUNTERS counters{};
  return ::GetProcessMemoryInfo(::GetCurrentProcess(), &counters, sizeof counters) != 0 ? counters.WorkingSetSize : 0;
}

void returnUnusedMemory() { ::_heapmin(); }

std::uint64_t usualMemoryLimit() {
  MEMORYSTATUSEX status{};
  status.dwLength = sizeof status;
  return ::GlobalMemoryStatusEx(&status) != 0 ? status.ullTotalPhys / 4 * 3 : 0;
}

}  // namespace rungproof
