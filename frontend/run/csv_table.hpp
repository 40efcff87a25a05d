// A table of comma-separated values with the place of every cell (RFC 4180: quotes, doubled quotes, CRLF; a byte order
// mark and empty lines are passed over; ';' separates if the heading has no ','). Tested by tests/trace/csv_test.cpp.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "frontend/failure.hpp"

namespace rungproof {

struct CsvCell {
  std::string text;  ///< without surrounding blanks and quotes
  std::uint32_t line = 1;
  std::uint32_t column = 1;  ///< of its first character, from 1
};

struct CsvTable {
  std::string name;  ///< of the file, for messages
  std::vector<CsvCell> heading;
  std::vector<std::vector<CsvCell>> rows;  ///< each as wide as the heading

  Failure at(const CsvCell& cell, std::string message, std::string help = {}) const;
};

/// Reads a whole file. Rows of another width than the heading, open quotes and a missing heading are failures.
CsvTable readCsv(std::string name, std::string_view text, std::vector<Failure>& failures);

}  // namespace rungproof
