// A stream of C whose bytes are kept: what libraries write that know only FILE.
#pragma once

#include <cstdio>
#include <memory>
#include <span>

namespace rungproof {

class MemoryStream {
 public:
  MemoryStream();  ///< std::bad_alloc where the system has no room for it
  ~MemoryStream();
  MemoryStream(const MemoryStream&) = delete;
  MemoryStream& operator=(const MemoryStream&) = delete;
  std::FILE* file() const;
  /// All bytes written until now; valid until the next call.
  std::span<const unsigned char> bytes() const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace rungproof
