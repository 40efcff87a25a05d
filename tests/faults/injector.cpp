// A library that is loaded in front of all others (LD_PRELOAD) and lets one call fail: the N-th of its kind that a
// process makes. What the program, Z3, the C++ library and all others ask of the system goes through it.
//   RUNGPROOF_FAULT=KIND:N       the N-th call of the kind fails, once
//   RUNGPROOF_FAULT=KIND:N+      it and all behind it
//   RUNGPROOF_FAULT_COUNT=FILE   nothing fails; the first process writes how many calls of each kind it made
// Calls count from main() on. Nothing in here allocates.
#include <dlfcn.h>
#include <fcntl.h>
#include <pthread.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <sys/uio.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <cstdarg>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <new>

namespace {

enum Kind { Memory, Open, Read, Write, Short, Interrupted, Rename, Fork, Pipe, Map, Thread, Folder, Status, kindCount };
constexpr std::array<const char*, kindCount> names = {"memory",      "open",   "read",  "write", "short",
                                                      "interrupted", "rename", "fork",  "pipe",  "map",
                                                      "thread",      "folder", "status"};

std::atomic<bool> isActive{false};
std::array<std::atomic<unsigned long>, kindCount> calls{};
int faultKind = -1;
unsigned long faultAt = 0;
bool goesOn = false;
const char* countFile = nullptr;
pid_t firstProcess = 0;

template <class Function>
Function next(Function& known, const char* name) {
  if (known == nullptr) known = reinterpret_cast<Function>(::dlsym(RTLD_NEXT, name));
  return known;
}

/// Whether this call is the one that fails.
bool fails(Kind kind) {
  if (!isActive.load(std::memory_order_relaxed)) return false;
  const unsigned long number = calls[kind].fetch_add(1, std::memory_order_relaxed) + 1;
  return kind == faultKind && (number == faultAt || (goesOn && number > faultAt));
}

bool failsWith(Kind kind, int error) {
  if (!fails(kind)) return false;
  errno = error;
  return true;
}

void readPlan() {
  firstProcess = ::getpid();
  countFile = std::getenv("RUNGPROOF_FAULT_COUNT");
  const char* const plan = std::getenv("RUNGPROOF_FAULT");
  if (plan == nullptr) return;
  const char* const colon = std::strchr(plan, ':');
  if (colon == nullptr) return;
  for (int kind = 0; kind < kindCount; ++kind) {
    const std::size_t length = static_cast<std::size_t>(colon - plan);
    if (std::strlen(names[kind]) == length && std::strncmp(plan, names[kind], length) == 0) faultKind = kind;
  }
  faultAt = std::strtoul(colon + 1, nullptr, 10);
  goesOn = plan[std::strlen(plan) - 1] == '+';
}

void writeCounts() {
  if (countFile == nullptr || ::getpid() != firstProcess) return;
  isActive = false;
  std::array<char, 1024> text{};
  std::size_t length = 0;
  for (int kind = 0; kind < kindCount; ++kind) {
    length += static_cast<std::size_t>(
        std::snprintf(text.data() + length, text.size() - length, "%s %lu\n", names[kind], calls[kind].load()));
  }
  const int file = ::open(countFile, O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0600);
  if (file < 0) return;
  static_cast<void>(!::write(file, text.data(), length));
  ::close(file);
}

using Main = int (*)(int, char**, char**);
Main programMain = nullptr;

int countedMain(int count, char** words, char** environment) {
  readPlan();
  std::atexit(writeCounts);
  isActive = true;
  const int exit = programMain(count, words, environment);
  isActive = false;
  return exit;
}

/// What dlsym() itself asks for, before the allocator's functions are known.
alignas(std::max_align_t) std::array<char, 1 << 16> early;
std::size_t earlyUsed = 0;
bool isLookingUp = false;

bool isEarly(const void* place) {
  const auto* const bytes = static_cast<const char*>(place);
  return bytes >= early.data() && bytes < early.data() + early.size();
}

void* earlyPlace(std::size_t size) {
  const std::size_t at = (earlyUsed + 15) / 16 * 16;
  if (at + size > early.size()) ::_exit(99);
  earlyUsed = at + size;
  return early.data() + at;
}

struct Allocator {
  void* (*malloc)(std::size_t) = nullptr;
  void* (*calloc)(std::size_t, std::size_t) = nullptr;
  void* (*realloc)(void*, std::size_t) = nullptr;
  void (*free)(void*) = nullptr;
  int (*posix_memalign)(void**, std::size_t, std::size_t) = nullptr;
  void* (*aligned_alloc)(std::size_t, std::size_t) = nullptr;
};
Allocator allocator;

bool isAllocatorKnown() {
  if (allocator.free != nullptr) return true;
  if (isLookingUp) return false;
  isLookingUp = true;
  next(allocator.malloc, "malloc");
  next(allocator.calloc, "calloc");
  next(allocator.realloc, "realloc");
  next(allocator.posix_memalign, "posix_memalign");
  next(allocator.aligned_alloc, "aligned_alloc");
  next(allocator.free, "free");
  isLookingUp = false;
  return true;
}

void* allocated(std::size_t size) {
  void* const place = std::malloc(size == 0 ? 1 : size);
  if (place == nullptr) throw std::bad_alloc();
  return place;
}

void* allocatedAt(std::size_t size, std::size_t alignment) {
  void* place = nullptr;
  if (::posix_memalign(&place, alignment < sizeof(void*) ? sizeof(void*) : alignment, size) != 0)
    throw std::bad_alloc();
  return place;
}

}  // namespace

extern "C" {

int __libc_start_main(Main main, int count, char** words, void (*init)(), void (*end)(), void (*ldEnd)(), void* stack) {
  using Start = int (*)(Main, int, char**, void (*)(), void (*)(), void (*)(), void*);
  static Start start = nullptr;
  programMain = main;
  return next(start, "__libc_start_main")(countedMain, count, words, init, end, ldEnd, stack);
}

void* malloc(std::size_t size) {
  if (!isAllocatorKnown()) return earlyPlace(size);
  if (failsWith(Memory, ENOMEM)) return nullptr;
  return allocator.malloc(size);
}

void* calloc(std::size_t count, std::size_t size) {
  if (!isAllocatorKnown()) return earlyPlace(count * size);
  if (failsWith(Memory, ENOMEM)) return nullptr;
  return allocator.calloc(count, size);
}

void* realloc(void* place, std::size_t size) {
  if (!isAllocatorKnown()) ::_exit(98);
  if (failsWith(Memory, ENOMEM)) return nullptr;
  if (!isEarly(place)) return allocator.realloc(place, size);
  void* const moved = allocator.malloc(size);
  if (moved != nullptr) std::memcpy(moved, place, size);
  return moved;
}

void free(void* place) {
  if (place == nullptr || isEarly(place)) return;
  if (isAllocatorKnown()) allocator.free(place);
}

int posix_memalign(void** place, std::size_t alignment, std::size_t size) {
  if (!isAllocatorKnown()) ::_exit(98);
  if (fails(Memory)) return ENOMEM;
  return allocator.posix_memalign(place, alignment, size);
}

void* aligned_alloc(std::size_t alignment, std::size_t size) {
  if (!isAllocatorKnown()) ::_exit(98);
  if (failsWith(Memory, ENOMEM)) return nullptr;
  return allocator.aligned_alloc(alignment, size);
}

// mimalloc, which the program asks for its objects.

void* mi_malloc(std::size_t size) {
  static void* (*real)(std::size_t) = nullptr;
  return failsWith(Memory, ENOMEM) ? nullptr : next(real, "mi_malloc")(size);
}

int mi_posix_memalign(void** place, std::size_t alignment, std::size_t size) {
  static int (*real)(void**, std::size_t, std::size_t) = nullptr;
  return fails(Memory) ? ENOMEM : next(real, "mi_posix_memalign")(place, alignment, size);
}

namespace {
mode_t modeOf(int flags, va_list& more) {
  return (flags & O_CREAT) != 0 || (flags & O_TMPFILE) == O_TMPFILE ? va_arg(more, mode_t) : 0;
}
}  // namespace

#define RUNGPROOF_OPENING(name)                                \
  int name(const char* path, int flags, ...) {                 \
    static int (*real)(const char*, int, ...) = nullptr;       \
    va_list more;                                              \
    va_start(more, flags);                                     \
    const mode_t mode = modeOf(flags, more);                   \
    va_end(more);                                              \
    if (failsWith(Open, EMFILE)) return -1;                    \
    return next(real, #name)(path, flags, mode);               \
  }                                                            \
  int name##at(int folder, const char* path, int flags, ...) { \
    static int (*real)(int, const char*, int, ...) = nullptr;  \
    va_list more;                                              \
    va_start(more, flags);                                     \
    const mode_t mode = modeOf(flags, more);                   \
    va_end(more);                                              \
    if (failsWith(Open, EMFILE)) return -1;                    \
    return next(real, #name "at")(folder, path, flags, mode);  \
  }
RUNGPROOF_OPENING(open)
#undef RUNGPROOF_OPENING

int open64(const char* path, int flags, ...) {
  static int (*real)(const char*, int, ...) = nullptr;
  va_list more;
  va_start(more, flags);
  const mode_t mode = modeOf(flags, more);
  va_end(more);
  if (failsWith(Open, EMFILE)) return -1;
  return next(real, "open64")(path, flags, mode);
}

FILE* fopen(const char* path, const char* mode) {
  static FILE* (*real)(const char*, const char*) = nullptr;
  return failsWith(Open, EMFILE) ? nullptr : next(real, "fopen")(path, mode);
}

FILE* fopen64(const char* path, const char* mode) {
  static FILE* (*real)(const char*, const char*) = nullptr;
  return failsWith(Open, EMFILE) ? nullptr : next(real, "fopen64")(path, mode);
}

void* opendir(const char* path) {
  static void* (*real)(const char*) = nullptr;
  return failsWith(Open, EMFILE) ? nullptr : next(real, "opendir")(path);
}

ssize_t read(int file, void* to, std::size_t most) {
  static ssize_t (*real)(int, void*, std::size_t) = nullptr;
  if (failsWith(Read, EIO)) return -1;
  if (failsWith(Interrupted, EINTR)) return -1;
  return next(real, "read")(file, to, fails(Short) && most > 1 ? most / 2 : most);
}

ssize_t write(int file, const void* from, std::size_t count) {
  static ssize_t (*real)(int, const void*, std::size_t) = nullptr;
  if (failsWith(Write, ENOSPC)) return -1;
  if (failsWith(Interrupted, EINTR)) return -1;
  return next(real, "write")(file, from, fails(Short) && count > 1 ? count / 2 : count);
}

ssize_t writev(int file, const iovec* parts, int count) {
  static ssize_t (*real)(int, const iovec*, int) = nullptr;
  if (failsWith(Write, ENOSPC)) return -1;
  if (failsWith(Interrupted, EINTR)) return -1;
  return next(real, "writev")(file, parts, fails(Short) && count > 1 ? 1 : count);
}

int rename(const char* from, const char* to) {
  static int (*real)(const char*, const char*) = nullptr;
  return failsWith(Rename, EACCES) ? -1 : next(real, "rename")(from, to);
}

int link(const char* from, const char* to) {
  static int (*real)(const char*, const char*) = nullptr;
  return failsWith(Rename, EACCES) ? -1 : next(real, "link")(from, to);
}

pid_t fork() {
  static pid_t (*real)() = nullptr;
  return failsWith(Fork, EAGAIN) ? -1 : next(real, "fork")();
}

int pipe(int* ends) {
  static int (*real)(int*) = nullptr;
  return failsWith(Pipe, EMFILE) ? -1 : next(real, "pipe")(ends);
}

int pipe2(int* ends, int flags) {
  static int (*real)(int*, int) = nullptr;
  return failsWith(Pipe, EMFILE) ? -1 : next(real, "pipe2")(ends, flags);
}

int memfd_create(const char* name, unsigned flags) {
  static int (*real)(const char*, unsigned) = nullptr;
  return failsWith(Pipe, EMFILE) ? -1 : next(real, "memfd_create")(name, flags);
}

void* mmap(void* at, std::size_t size, int protection, int flags, int file, off_t offset) {
  static void* (*real)(void*, std::size_t, int, int, int, off_t) = nullptr;
  if (failsWith(Map, ENOMEM)) return MAP_FAILED;
  return next(real, "mmap")(at, size, protection, flags, file, offset);
}

int pthread_create(pthread_t* thread, const pthread_attr_t* attributes, void* (*work)(void*), void* argument) {
  static int (*real)(pthread_t*, const pthread_attr_t*, void* (*)(void*), void*) = nullptr;
  return fails(Thread) ? EAGAIN : next(real, "pthread_create")(thread, attributes, work, argument);
}

int mkdir(const char* path, mode_t mode) {
  static int (*real)(const char*, mode_t) = nullptr;
  return failsWith(Folder, ENOSPC) ? -1 : next(real, "mkdir")(path, mode);
}

int stat(const char* path, struct stat* status) {
  static int (*real)(const char*, struct stat*) = nullptr;
  return failsWith(Status, EIO) ? -1 : next(real, "stat")(path, status);
}

int lstat(const char* path, struct stat* status) {
  static int (*real)(const char*, struct stat*) = nullptr;
  return failsWith(Status, EIO) ? -1 : next(real, "lstat")(path, status);
}

int fstat(int file, struct stat* status) {
  static int (*real)(int, struct stat*) = nullptr;
  return failsWith(Status, EIO) ? -1 : next(real, "fstat")(file, status);
}

}  // extern "C"

void* operator new(std::size_t size) { return allocated(size); }
void* operator new[](std::size_t size) { return allocated(size); }
void* operator new(std::size_t size, const std::nothrow_t&) noexcept { return std::malloc(size); }
void* operator new[](std::size_t size, const std::nothrow_t&) noexcept { return std::malloc(size); }
void* operator new(std::size_t size, std::align_val_t a) { return allocatedAt(size, static_cast<std::size_t>(a)); }
void* operator new[](std::size_t size, std::align_val_t a) { return allocatedAt(size, static_cast<std::size_t>(a)); }
void operator delete(void* place) noexcept { std::free(place); }
void operator delete[](void* place) noexcept { std::free(place); }
void operator delete(void* place, std::size_t) noexcept { std::free(place); }
void operator delete[](void* place, std::size_t) noexcept { std::free(place); }
void operator delete(void* place, std::align_val_t) noexcept { std::free(place); }
void operator delete[](void* place, std::align_val_t) noexcept { std::free(place); }
void operator delete(void* place, std::size_t, std::align_val_t) noexcept { std::free(place); }
void operator delete[](void* place, std::size_t, std::align_val_t) noexcept { std::free(place); }
