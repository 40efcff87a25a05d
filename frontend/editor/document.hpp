// A text as the client of the editor server holds it: where it is, its version, and the changes that are typed. Places
// of the protocol are lines and UTF-16 units, both from 0; everywhere else a place is an offset in UTF-8. Tested by
// tests/editor/document_test.cpp.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "frontend/files/json.hpp"
#include "ir/source.hpp"

namespace rungproof {

/// Line and UTF-16 unit, from 0.
struct ClientPlace {
  std::uint32_t line = 0;
  std::uint32_t character = 0;

  friend auto operator<=>(const ClientPlace&, const ClientPlace&) = default;
};

/// A place behind the end of a line or of the text means that end; one inside of a character means its beginning.
std::size_t offsetOf(std::string_view text, ClientPlace place);
ClientPlace placeOf(const SourceFile& file, std::uint32_t offset);
/// The range of a span: {"start": {...}, "end": {...}}.
Json rangeJson(const SourceFile& file, Span span);
Json rangeJson(ClientPlace begin, ClientPlace end);
/// Nothing if the member is missing or is no place.
std::optional<ClientPlace> placeFrom(const Json* json);

struct Document {
  std::string uri;
  std::string path;  ///< of the file; of a text that is no file yet, where it would lie
  std::int64_t version = 0;
  std::string text;
};

/// Applies one item of contentChanges: a range and its new text, or the whole text. False: it is none.
bool applyChange(Document& document, const Json& change);

/// "/a/b c.awl" of "file:///a/b%20c.awl"; of other schemes the part behind the last slash or colon, in `folder`.
std::string pathOfUri(std::string_view uri, const std::string& folder);
std::string uriOfPath(const std::string& path);

}  // namespace rungproof
