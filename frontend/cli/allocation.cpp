// Memory for objects comes from mimalloc, and where there is none std::bad_alloc is thrown. Its own operators, which
// are written in C, end the program there: a proof that needs too much would take all verdicts with it.
#include <mimalloc.h>

#include <new>

namespace {

void* allocated(std::size_t size) {
  if (void* const place = mi_malloc(size == 0 ? 1 : size)) return place;
  throw std::bad_alloc();
}

void* allocatedAt(std::size_t size, std::align_val_t alignment) {
  void* place = nullptr;
  if (mi_posix_memalign(&place, static_cast<std::size_t>(alignment), size) == 0) return place;
  throw std::bad_alloc();
}

}  // namespace

void* operator new(std::size_t size) { return allocated(size); }
void* operator new[](std::size_t size) { return allocated(size); }
void* operator new(std::size_t size, const std::nothrow_t&) noexcept { return mi_malloc(size == 0 ? 1 : size); }
void* operator new[](std::size_t size, const std::nothrow_t&) noexcept { return mi_malloc(size == 0 ? 1 : size); }
void operator delete(void* place) noexcept { mi_free(place); }
void operator delete[](void* place) noexcept { mi_free(place); }
void operator delete(void* place, std::size_t) noexcept { mi_free(place); }
void operator delete[](void* place, std::size_t) noexcept { mi_free(place); }
void operator delete(void* place, const std::nothrow_t&) noexcept { mi_free(place); }
void operator delete[](void* place, const std::nothrow_t&) noexcept { mi_free(place); }

void* operator new(std::size_t size, std::align_val_t alignment) { return allocatedAt(size, alignment); }
void* operator new[](std::size_t size, std::align_val_t alignment) { return allocatedAt(size, alignment); }
void operator delete(void* place, std::align_val_t) noexcept { mi_free(place); }
void operator delete[](void* place, std::align_val_t) noexcept { mi_free(place); }
void operator delete(void* place, std::size_t, std::align_val_t) noexcept { mi_free(place); }
void operator delete[](void* place, std::size_t, std::align_val_t) noexcept { mi_free(place); }
