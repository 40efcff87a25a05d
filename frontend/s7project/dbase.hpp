// Tables of dBase III and IV with their memo files, as STEP 7 writes them: only live rows are seen.
// Tested by tests/s7project/dbase_test.cpp.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rungproof::s7project {

class DbaseTable {
 public:
  /// `faults` gets what is wrong with the file and where; what can be read is.
  DbaseTable(std::string bytes, std::optional<std::string> memoBytes, std::vector<std::string>& faults);

  /// Live rows, counted from 0; deleted ones are not among them.
  std::size_t rows() const { return live_.size(); }
  /// Number of the record in the file, counted from 1.
  std::size_t record(std::size_t row) const { return live_[row] + 1; }
  bool has(std::string_view field) const { return find(field) != nullptr; }
  /// Whether it has memos and the file that holds them is missing.
  bool lacksMemos() const;

  /// The field's bytes as they lie there; empty if there is no such field.
  std::string_view raw(std::size_t row, std::string_view field) const;
  /// Up to the first NUL, without blanks around.
  std::string_view text(std::size_t row, std::string_view field) const;
  /// A decimal number; nothing if the field is blank or holds something else.
  std::optional<std::int64_t> number(std::size_t row, std::string_view field) const;
  /// A number as digits, or as the one byte of a field of that length.
  std::int64_t numberOrByte(std::size_t row, std::string_view field) const;

  struct Memo {
    std::string bytes;
    std::string fault;  ///< why it cannot be read; empty: it can, or there is none
  };
  Memo memo(std::size_t row, std::string_view field) const;

 private:
  struct Field {
    std::string name;
    char type = 'C';
    std::size_t at = 0;
    std::size_t length = 0;
  };
  const Field* find(std::string_view name) const;

  std::string bytes_;
  std::optional<std::string> memos_;
  std::size_t header_ = 0, record_ = 0;
  std::vector<Field> fields_;
  std::vector<std::size_t> live_;
};

}  // namespace rungproof::s7project
