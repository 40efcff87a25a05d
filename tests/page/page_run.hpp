// Pages as the program writes them, for tests: made in-process, at a fixed date.
#pragma once

#include <string>
#include <vector>

namespace rungproof::test {

/// The page that `prove` (or the command that stands first) writes; `exit`: its exit code, if wanted.
std::string pageOf(std::vector<std::string> arguments, int* exit = nullptr);
std::string corpusFile(const std::string& name);
std::string contentOf(const std::string& path);
/// How often `part` stands in `text`.
std::size_t countIn(const std::string& text, const std::string& part);

}  // namespace rungproof::test
