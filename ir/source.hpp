// Source texts and places in them. A place is a byte range of one file; line and column are computed on
// demand from the file's table, so that a token costs twelve bytes and nothing else. The table has a mark at every
// fourth line and inside long lines, because some exports write megabytes in one line: what lies between two marks is
// found in the text.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace rungproof {

/// A byte range [offset, offset + length) of the file with index `file` in its SourceSet.
struct Span {
  std::uint32_t file = 0;
  std::uint32_t offset = 0;
  std::uint32_t length = 0;

  /// Whether its first byte lies within another span.
  bool beginsIn(Span outer) const {
    return file == outer.file && offset >= outer.offset && offset < outer.offset + outer.length;
  }

  friend bool operator==(const Span&, const Span&) = default;
};

/// Line and column, both from 1; the column counts characters (UTF-8 code points), as editors do.
struct Position {
  std::uint32_t line = 1;
  std::uint32_t column = 1;
};

/// One file after conversion to UTF-8.
class SourceFile {
 public:
  SourceFile(std::string name, std::string text);

  const std::string& name() const { return name_; }
  std::string_view text() const { return text_; }
  /// Text of a range; ranges beyond the end are cut.
  std::string_view text(Span span) const;
  Position position(std::uint32_t offset) const;
  /// The line with that number (from 1) without its line end; empty beyond the last line.
  std::string_view line(std::uint32_t number) const;
  std::uint32_t lineCount() const { return lineCount_; }
  std::uint32_t lineStart(std::uint32_t number) const;

 private:
  /// A place of the text with its line and column.
  struct Mark {
    std::uint32_t offset, line, lineStart, column;
  };
  /// Start of the line behind the one that holds this place; beyond the text if that is the last one.
  std::uint32_t nextLine(std::uint32_t offset) const;
  /// The characters that begin in this range.
  std::uint32_t charactersIn(std::uint32_t begin, std::uint32_t end) const;

  std::string name_;
  std::string text_;
  std::uint32_t lineCount_ = 0;
  std::vector<Mark> marks_;  ///< in the order of the text, the first at its beginning
};

/// All files of one run; spans index into it. Files are never removed, so references stay valid.
class SourceSet {
 public:
  std::uint32_t add(std::string name, std::string text);
  const SourceFile& file(std::uint32_t index) const { return *files_[index]; }
  std::size_t size() const { return files_.size(); }
  Position position(Span span) const { return file(span.file).position(span.offset); }
  std::string_view text(Span span) const { return file(span.file).text(span); }

 private:
  std::vector<std::unique_ptr<SourceFile>> files_;
};

}  // namespace rungproof
