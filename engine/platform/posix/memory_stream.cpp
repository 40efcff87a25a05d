// open_memstream() of POSIX.
#include "engine/platform/memory_stream.hpp"

#include <stdio.h>

#include <cstdlib>
#include <new>

namespace rungproof {

class MemoryStream::Impl {
 public:
  Impl() : file(open_memstream(&text, &size)) {
    if (file == nullptr) throw std::bad_alloc();
  }
  ~Impl() {
    std::fclose(file);
    std::free(text);
  }
  char* text = nullptr;
  std::size_t size = 0;
  std::FILE* file;
};

MemoryStream::MemoryStream() : impl_(std::make_unique<Impl>()) {}
MemoryStream::~MemoryStream() = default;

std::FILE* MemoryStream::file() const { return impl_->file; }

std::span<const unsigned char> MemoryStream::bytes() const {
  std::fflush(impl_->file);
  return {reinterpret_cast<const unsigned char*>(impl_->text), impl_->size};
}

}  // namespace rungproof
