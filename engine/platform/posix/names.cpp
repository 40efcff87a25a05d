// Names are bytes, as the C library reads patterns; the identity of the executable stands in a note of ELF.
#include "engine/platform/names.hpp"

#include <elf.h>
#include <fmt/format.h>
#include <fnmatch.h>
#include <link.h>

#include <cstring>

namespace rungproof {

bool fitsShellPattern(const std::string& name, const std::string& pattern) {
  return ::fnmatch(pattern.c_str(), name.c_str(), 0) == 0;
}

std::string pathName(const std::filesystem::path& path) { return path.string(); }

std::string plainName(const std::string& name) { return name; }

std::string nameOfUriPath(std::string path) { return path; }

std::string uriPathOfName(const std::string& name) { return name; }

std::string buildId() {
  std::string id;
  dl_iterate_phdr(
      [](dl_phdr_info* info, std::size_t, void* data) {
        auto& result = *static_cast<std::string*>(data);
        for (int i = 0; i < info->dlpi_phnum; ++i) {
          const ElfW(Phdr)& segment = info->dlpi_phdr[i];
          if (segment.p_type != PT_NOTE) continue;
          const char* at = reinterpret_cast<const char*>(info->dlpi_addr + segment.p_vaddr);
          const char* const end = at + segment.p_memsz;
          while (at + sizeof(ElfW(Nhdr)) <= end) {
            const auto& note = *reinterpret_cast<const ElfW(Nhdr)*>(at);
            const char* const name = at + sizeof(note);
            const char* const content = name + (note.n_namesz + 3U) / 4 * 4;
            if (note.n_type == NT_GNU_BUILD_ID && note.n_namesz == 4 && std::memcmp(name, "GNU", 4) == 0) {
              for (std::uint32_t k = 0; k < note.n_descsz; ++k)
                result += fmt::format("{:02x}", static_cast<unsigned char>(content[k]));
            }
            at = content + (note.n_descsz + 3U) / 4 * 4;
          }
        }
        return 1;  // the first object is the executable itself
      },
      &id);
  return id;
}

}  // namespace rungproof
