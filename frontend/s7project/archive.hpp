// Zip archives: their directory, and files out of them by zlib. Tested by tests/s7project/archive_test.cpp.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rungproof::s7project {

class Archive {
 public:
  struct Entry {
    std::string name;  ///< with / between folders
    std::uint32_t method = 0, packed = 0, size = 0, at = 0;
  };

  explicit Archive(std::string bytes);

  static bool isArchive(std::string_view bytes) { return bytes.starts_with("PK\x03\x04"); }
  const std::string& fault() const { return fault_; }
  const std::vector<Entry>& entries() const { return entries_; }
  /// The contents of an entry; nothing: it is damaged, or packed by a method other than deflate.
  std::optional<std::string> contents(const Entry& entry) const;

 private:
  std::string bytes_;
  std::string fault_;
  std::vector<Entry> entries_;
};

}  // namespace rungproof::s7project
