// Other programs as judges of ours: what a shell command prints, errors included.
#pragma once

#include <array>
#include <cstdio>
#include <string>

namespace rungproof::test {

inline std::string outputOf(const std::string& command) {
  std::string text;
  FILE* pipe = popen((command + " 2>&1").c_str(), "r");
  if (pipe == nullptr) return text;
  std::array<char, 4096> buffer{};
  while (std::fgets(buffer.data(), buffer.size(), pipe) != nullptr) text += buffer.data();
  pclose(pipe);
  return text;
}

}  // namespace rungproof::test
