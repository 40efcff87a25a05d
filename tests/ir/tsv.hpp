// Reads the tables of tests/data: tab-separated, names of the columns in the first line.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "ir/s7200/cpu.hpp"

namespace rungproof::tables {

inline std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::istringstream in(text);
  for (std::string part; std::getline(in, part, separator);) parts.push_back(part);
  if (!text.empty() && text.back() == separator) parts.emplace_back();
  return parts;
}

using Row = std::map<std::string, std::string>;

inline std::vector<Row> read(const std::string& file) {
  std::ifstream in(std::string(RUNGPROOF_SOURCE_DIR) + "/tests/data/" + file);
  EXPECT_TRUE(in.good()) << file;
  std::vector<Row> rows;
  std::string line;
  std::getline(in, line);
  const std::vector<std::string> names = split(line, '\t');
  while (std::getline(in, line)) {
    const std::vector<std::string> cells = split(line, '\t');
    Row row;
    for (std::size_t i = 0; i < names.size(); ++i) row[names[i]] = i < cells.size() ? cells[i] : std::string();
    rows.push_back(std::move(row));
  }
  return rows;
}

/// "CPU224XP" -> the model.
inline Cpu cpuOf(const std::string& cell) {
  const std::optional<Cpu> cpu = cpuNamed(cell.substr(3));
  EXPECT_TRUE(cpu.has_value()) << cell;
  return cpu.value_or(s7200Cpu("226"));
}
inline Target targetOf(const Row& row) {
  return {cpuOf(row.at("cpu")), row.at("edition") == "2003" ? Edition::Edition2003 : Edition::Edition2004};
}
/// "0-12,19-23" as a set of numbers; "T0,T64" and "HC0" likewise, letters dropped.
inline bool listed(const std::string& list, int number) {
  for (std::string part : split(list, ',')) {
    part.erase(std::remove_if(part.begin(), part.end(), [](char c) { return c >= 'A' && c <= 'Z'; }), part.end());
    const std::vector<std::string> ends = split(part, '-');
    if (number >= std::stoi(ends.front()) && number <= std::stoi(ends.back())) return true;
  }
  return false;
}

}  // namespace rungproof::tables
