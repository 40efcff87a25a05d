// STY004: characters that only look right. Spoken by the readers (frontend/stl/syntax_sink), which know what they took
// the characters for; tested by tests/reader/statement_test.cpp.
#include "analysis/rule.hpp"

namespace rungproof {

extern constexpr Rule sty004_look_alike_characters = {
    .id = "STY004",
    .title = "Look-alike characters",
    .severity = Severity::Error,
    .needs = Needs::Text,
    .detects = "letter O for zero, l for one, Cyrillic or full-width letters in a mnemonic or address",
    .why =
        "printed and scanned listings carry them (\"IO.0\"); the text is read as it was meant, but Micro/WIN would not "
        "take it",
    .manual = "001:4924, 001:5745, 001:6809",
    .bad = "Network 1\nLD IO.0\n= Q0.0\n",
    .good = "Network 1\nLD I0.0\n= Q0.0\n",
    .fix = FixClass::Safe,
    .standsAlone = true,
};

}  // namespace rungproof
