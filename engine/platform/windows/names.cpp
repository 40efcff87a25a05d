// Both strokes separate folders; the identity of the executable stands in its debug directory.
#include "engine/platform/names.hpp"

#include <fmt/format.h>
#include <windows.h>

#include <algorithm>
#include <cstring>

#include "engine/platform/windows/names.hpp"
#include "engine/platform/windows/shell_pattern.hpp"

namespace rungproof {

std::wstring wideName(std::string_view text) {
  if (text.empty()) return {};
  const int count = ::MultiByteToWideChar(CP_UTF8, 0, text.data(), static_cast<int>(text.size()), nullptr, 0);
  std::wstring wide(static_cast<std::size_t>(count), L'\0');
  ::MultiByteToWideChar(CP_UTF8, 0, text.data(), static_cast<int>(text.size()), wide.data(), count);
  return wide;
}

std::string narrowName(std::wstring_view text) {
  if (text.empty()) return {};
  const int count =
      ::WideCharToMultiByte(CP_UTF8, 0, text.data(), static_cast<int>(text.size()), nullptr, 0, nullptr, nullptr);
  std::string narrow(static_cast<std::size_t>(count), '\0');
  ::WideCharToMultiByte(CP_UTF8, 0, text.data(), static_cast<int>(text.size()), narrow.data(), count, nullptr, nullptr);
  return narrow;
}

bool fitsShellPattern(const std::string& name, const std::string& pattern) {
  return fitsPortablePattern(plainName(name), pattern);
}

std::string pathName(const std::filesystem::path& path) { return path.generic_string(); }

std::string plainName(const std::string& name) {
  std::string plain = name;
  std::ranges::replace(plain, '\\', '/');
  return plain;
}

namespace {

bool beginsWithDrive(std::string_view path) {
  return path.size() >= 2 && path[1] == ':' &&
         ((path[0] >= 'A' && path[0] <= 'Z') || (path[0] >= 'a' && path[0] <= 'z'));
}

}  // namespace

std::string nameOfUriPath(std::string path) {
  if (path.starts_with('/') && beginsWithDrive(std::string_view(path).substr(1))) path.erase(0, 1);
  return path;
}

std::string uriPathOfName(const std::string& name) {
  return beginsWithDrive(name) ? "/" + plainName(name) : plainName(name);
}

std::string buildId() {
  const auto* const base = reinterpret_cast<const char*>(::GetModuleHandleW(nullptr));
  const auto& dos = *reinterpret_cast<const IMAGE_DOS_HEADER*>(base);
  const auto& headers = *reinterpret_cast<const IMAGE_NT_HEADERS*>(base + dos.e_lfanew);
  const IMAGE_DATA_DIRECTORY& place = headers.OptionalHeader.DataDirectory[IMAGE_DIRECTORY_ENTRY_DEBUG];
  for (std::uint32_t at = 0; at + sizeof(IMAGE_DEBUG_DIRECTORY) <= place.Size; at += sizeof(IMAGE_DEBUG_DIRECTORY)) {
    const auto& entry = *reinterpret_cast<const IMAGE_DEBUG_DIRECTORY*>(base + place.VirtualAddress + at);
    const char* const data = base + entry.AddressOfRawData;
    constexpr std::size_t signBytes = 4, identityBytes = 16;
    if (entry.Type != IMAGE_DEBUG_TYPE_CODEVIEW || std::memcmp(data, "RSDS", signBytes) != 0) continue;
    std::string id;
    for (std::size_t k = 0; k < identityBytes; ++k)
      id += fmt::format("{:02x}", static_cast<unsigned char>(data[signBytes + k]));
    return id;
  }
  return {};
}

}  // namespace rungproof
