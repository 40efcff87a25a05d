// A table of separated values with the place of every cell (RFC 4180: quotes, doubled quotes, CRLF; a byte order
// mark, empty lines and lines of '#' before the heading are passed over). Of comma, semicolon, tab and bar the one
// that the heading has most of separates; a line "sep=;" in front says it. Tested by tests/trace/csv_test.cpp.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "frontend/files/failure.hpp"

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
  char separator = ',';
  bool isRecording = false;  ///< of a logger or simulator: it holds what a program drives as well

  Failure at(const CsvCell& cell, std::string message, std::string help = {}) const;
};

struct CsvForm {
  char separator = 0;        ///< 0: recognised
  std::string headingHas{};  ///< the first line with that cell is the heading, if there is one; what stands before it
                             ///< is passed over
  std::string helpIfEmpty = "begin with a heading: 'scan' or 'time_ms' and the names of the signals";
};

/// Reads a whole file. Rows of another width than the heading, open quotes and a missing heading are failures.
CsvTable readCsv(std::string name, std::string_view text, std::vector<Failure>& failures, const CsvForm& form = {});

}  // namespace rungproof
