// Reading archives.
#include "frontend/s7project/archive.hpp"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>

#include "frontend/files/disk_file.hpp"

namespace rungproof::s7project {

namespace {

std::uint32_t zipNumber(std::string_view bytes, std::size_t at, std::size_t count) {
  std::uint32_t value = 0;
  for (std::size_t i = count; i-- > 0;) value = value << 8 | static_cast<std::uint8_t>(bytes[at + i]);
  return value;
}

constexpr std::size_t endBytes = 22, directoryBytes = 46, localBytes = 30;
constexpr std::uint32_t stored = 0, deflated = 8;

}  // namespace

Archive::Archive(std::string bytes) : bytes_(std::move(bytes)) {
  const std::string_view all = bytes_;
  const std::size_t end = all.rfind(std::string_view("PK\x05\x06", 4));
  if (end == std::string_view::npos || end + endBytes > all.size()) {
    fault_ = "the directory at its end is missing";
    return;
  }
  const std::size_t count = zipNumber(all, end + 10, 2);
  std::size_t at = zipNumber(all, end + 16, 4);
  for (std::size_t i = 0; i < count; ++i) {
    if (at + directoryBytes > end || !all.substr(at).starts_with(std::string_view("PK\x01\x02", 4))) {
      fault_ = fmt::format("byte {}: entry {} of its directory is damaged", at, i + 1);
      return;
    }
    const std::size_t name = zipNumber(all, at + 28, 2);
    if (at + directoryBytes + name > end) {
      fault_ = fmt::format("byte {}: entry {} of its directory is damaged", at, i + 1);
      return;
    }
    Entry entry{std::string(all.substr(at + directoryBytes, name)), zipNumber(all, at + 10, 2),
                zipNumber(all, at + 20, 4), zipNumber(all, at + 24, 4), zipNumber(all, at + 42, 4)};
    std::ranges::replace(entry.name, '\\', '/');
    entries_.push_back(std::move(entry));
    at += directoryBytes + name + zipNumber(all, at + 30, 2) + zipNumber(all, at + 32, 2);
  }
}

std::optional<std::string> Archive::contents(const Entry& entry) const {
  const std::string_view all = bytes_;
  if (std::size_t{entry.at} + localBytes > all.size() || entry.size > longestProgram) return std::nullopt;
  const std::size_t begin = entry.at + localBytes + zipNumber(all, entry.at + 26, 2) + zipNumber(all, entry.at + 28, 2);
  if (begin + entry.packed > all.size()) return std::nullopt;
  const std::string_view packed = all.substr(begin, entry.packed);
  if (entry.method == stored) return std::string(packed);
  if (entry.method != deflated) return std::nullopt;
  std::string text(entry.size, '\0');
  z_stream stream{};
  constexpr int rawDeflate = -15;
  if (inflateInit2(&stream, rawDeflate) != Z_OK) return std::nullopt;
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed.data()));
  stream.avail_in = static_cast<uInt>(packed.size());
  stream.next_out = reinterpret_cast<Bytef*>(text.data());
  stream.avail_out = static_cast<uInt>(text.size());
  const int result = inflate(&stream, Z_FINISH);
  inflateEnd(&stream);
  if (result != Z_STREAM_END || stream.avail_out != 0) return std::nullopt;
  return text;
}

}  // namespace rungproof::s7project
