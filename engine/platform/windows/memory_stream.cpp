// Windows has no streams in memory: a temporary file, read as far as it is written.
#include "engine/platform/memory_stream.hpp"

#include <new>
#include <vector>

namespace rungproof {

class MemoryStream::Impl {
 public:
  Impl() : file(std::tmpfile()) {
    if (file == nullptr) throw std::bad_alloc();
  }
  ~Impl() { std::fclose(file); }

  void readOn() {
    std::fflush(file);
    std::fseek(file, static_cast<long>(read.size()), SEEK_SET);
    unsigned char part[65536];
    for (std::size_t n = 0; (n = std::fread(part, 1, sizeof part, file)) > 0;) read.insert(read.end(), part, part + n);
    std::fseek(file, 0, SEEK_END);
  }

  std::FILE* file;
  std::vector<unsigned char> read;
};

MemoryStream::MemoryStream() : impl_(std::make_unique<Impl>()) {}
MemoryStream::~MemoryStream() = default;

std::FILE* MemoryStream::file() const { return impl_->file; }

std::span<const unsigned char> MemoryStream::bytes() const {
  impl_->readOn();
  return impl_->read;
}

}  // namespace rungproof
