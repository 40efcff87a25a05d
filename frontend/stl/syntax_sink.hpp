// Where the readers put what they have to say: fills in file, block and network of a finding. After ten thousand
// findings of one file the rest is only counted, in one finding (SYN008), so that a damaged file of any size fits.
#pragma once

#include <optional>
#include <string>

#include "frontend/stl/syntax_message.hpp"
#include "ir/program.hpp"

namespace rungproof {

class SyntaxSink {
 public:
  SyntaxSink(Program& program, std::uint32_t file) : program_(program), file_(file) {}

  /// Block and network of the findings that follow.
  void setPlace(std::string pou, int network) {
    pou_ = std::move(pou);
    network_ = network;
  }
  void setNetwork(int network) { network_ = network; }

  Span span(std::size_t begin, std::size_t end) const {
    return {file_, static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end - begin)};
  }
  void report(Syntax code, Span span, std::string message, std::optional<Fix> fix = std::nullopt);
  /// Rule STY004: `written` was read as `meant` because characters look alike.
  void lookAlike(Span span, std::string_view written, std::string meant);
  /// Note that `written` is accepted although the editor would not take it.
  void lenient(Span span, std::string_view written, std::string meant);

  Program& program() { return program_; }
  std::uint32_t file() const { return file_; }

 private:
  static constexpr std::size_t limit = 10000;
  /// The new finding, or nullptr beyond the limit.
  Finding* add(std::string_view rule, Severity severity, Span span, std::string message);
  void countOnly(Span span);

  Program& program_;
  std::uint32_t file_;
  std::string pou_;
  int network_ = 0;
  std::size_t count_ = 0;
  std::size_t uncounted_ = 0;     ///< findings beyond the limit
  std::size_t limitFinding_ = 0;  ///< index of the SYN008 that counts them
};

/// "abc" shortened for a message: at most 40 bytes, control characters as blanks.
std::string excerpt(std::string_view text);

}  // namespace rungproof
