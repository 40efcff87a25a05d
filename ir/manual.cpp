// The documents with the first lines of their chapters and sections.
#include "ir/manual.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <iterator>
#include <span>

namespace rungproof {

namespace {

/// A section begins at `line` and ends where the next begins; an empty chapter: outside the chapters.
struct ManualSection {
  int line = 0;
  std::string_view chapter;
  std::string_view section = {};
};

// S7-200 Programmable Controller, System Manual, edition 06/2004.
constexpr ManualSection manual2004[] = {
    {1, ""},
    {495, "chapter 1", "Product overview"},
    {648, "chapter 2", "Getting started"},
    {901, "chapter 3", "Installing the S7-200"},
    {1171, "chapter 4", "PLC concepts"},
    {1186, "chapter 4", "Execution of the control logic"},
    {1256, "chapter 4", "Access to the data"},
    {1530, "chapter 4", "Saving and restoring data"},
    {1681, "chapter 4", "Operating modes"},
    {1705, "chapter 4", "Features of the S7-200"},
    {1980, "chapter 5", "Programming concepts"},
    {2045, "chapter 5", "Elements of a program"},
    {2106, "chapter 5", "Entering a program"},
    {2222, "chapter 5", "Conventions of the editors"},
    {2316, "chapter 5", "Handling errors"},
    {2370, "chapter 5", "Data block"},
    {2387, "chapter 5", "Symbol table"},
    {2418, "chapter 5", "Local variables"},
    {2435, "chapter 5", "Status chart"},
    {2474, "chapter 5", "Instruction libraries"},
    {2499, "chapter 5", "Testing a program"},
    {2509, "chapter 6", "Instruction set"},
    {2582, "chapter 6", "Conventions of the descriptions"},
    {2638, "chapter 6", "Memory ranges and features"},
    {2719, "chapter 6", "Bit logic"},
    {2721, "chapter 6", "Contacts"},
    {2775, "chapter 6", "Coils"},
    {2825, "chapter 6", "Logic stack"},
    {2876, "chapter 6", "Set and reset dominant bistables"},
    {2910, "chapter 6", "Clock"},
    {3020, "chapter 6", "Communication"},
    {3135, "chapter 6", "Transmit and receive (freeport)"},
    {3344, "chapter 6", "Port address"},
    {3362, "chapter 6", "Compare"},
    {3405, "chapter 6", "Compare strings"},
    {3433, "chapter 6", "Conversion"},
    {3579, "chapter 6", "ASCII conversion"},
    {3762, "chapter 6", "String conversion"},
    {3941, "chapter 6", "Encode and decode"},
    {3984, "chapter 6", "Counters"},
    {4090, "chapter 6", "IEC counters"},
    {4121, "chapter 6", "High-speed counters"},
    {4510, "chapter 6", "Pulse output"},
    {4784, "chapter 6", "Math"},
    {4938, "chapter 6", "Numeric functions"},
    {4997, "chapter 6", "Increment and decrement"},
    {5056, "chapter 6", "PID loop"},
    {5327, "chapter 6", "Interrupts"},
    {5551, "chapter 6", "Logical operations"},
    {5601, "chapter 6", "Move"},
    {5648, "chapter 6", "Block move"},
    {5685, "chapter 6", "Program control"},
    {5750, "chapter 6", "For-Next loop"},
    {5782, "chapter 6", "Jump"},
    {5803, "chapter 6", "Sequence control relay"},
    {5886, "chapter 6", "Diagnostic LED"},
    {5915, "chapter 6", "Shift and rotate"},
    {5980, "chapter 6", "Shift register bit"},
    {6031, "chapter 6", "Swap bytes"},
    {6066, "chapter 6", "Strings"},
    {6256, "chapter 6", "Tables"},
    {6517, "chapter 6", "Timers"},
    {6665, "chapter 6", "IEC timers"},
    {6710, "chapter 6", "Interval timers"},
    {6731, "chapter 6", "Subroutines"},
    {6840, "chapter 7", "Communicating over a network"},
    {7799, "chapter 8", "Hardware troubleshooting and testing"},
    {7954, "chapter 8", "Forcing values"},
    {7970, "chapter 8", "Hardware troubleshooting and testing"},
    {8000, "chapter 9", "Open-loop motion control"},
    {9332, "chapter 10", "Modem module"},
    {10005, "chapter 11", "USS protocol library"},
    {10594, "chapter 12", "Modbus protocol library"},
    {10836, "chapter 13", "Recipes"},
    {11060, "chapter 14", "Data logs"},
    {11270, "chapter 15", "PID auto-tune"},
    {11487, "appendix A", "Technical specifications"},
    {13804, "appendix B", "Power budget"},
    {13890, "appendix C", "Error codes"},
    {14011, "appendix D", "Special memory bits"},
    {14399, "appendix E", "Order numbers"},
    {14506, "appendix F", "Execution times"},
    {14670, "appendix G", "Quick reference"},
};

// The same manual, edition 2003: of its chapter 6 only.
constexpr ManualSection manual2003[] = {
    {1, "chapter 6", "Conventions of the descriptions"},
    {150, "chapter 6", "Memory ranges and features"},
    {389, "chapter 6", "Bit logic"},
    {602, "chapter 6"},
    {2107, "chapter 6", "Compare"},
    {2271, "chapter 6", "Conversion"},
    {3329, "chapter 6", "Counters"},
    {3634, "chapter 6", "High-speed counters"},
    {4695, "chapter 6", "Pulse output"},
    {5200, "chapter 6"},
    {7380, "chapter 6", "Logical operations"},
    {7480, "chapter 6"},
    {7707, "chapter 6", "Program control"},
    {7876, "chapter 6", "Jump and sequence control relay"},
    {8204, "chapter 6", "Shift and rotate"},
    {8500, "chapter 6"},
    {8807, "chapter 6", "Tables"},
    {9360, "chapter 6", "Timers"},
};

constexpr ManualSection examples[] = {{1, ""}};

struct ManualDocument {
  std::string_view number;
  std::string_view title;
  std::span<const ManualSection> sections;
};
constexpr ManualDocument documents[] = {
    {"000", "System Manual 2003", manual2003},
    {"001", "System Manual 2004", manual2004},
    {"004", "Application Examples", examples},
};

}  // namespace

std::string manualPlace(std::string_view reference) {
  const auto document = std::ranges::find_if(documents, [&](const ManualDocument& d) {
    return reference.starts_with(d.number) && reference.substr(3, 1) == ":";
  });
  int line = 0;
  const std::string_view digits = reference.substr(std::min<std::size_t>(4, reference.size()));
  if (document == std::end(documents) ||
      std::from_chars(digits.data(), digits.data() + digits.size(), line).ec != std::errc() || line < 1)
    return std::string(reference);
  const auto next = std::ranges::upper_bound(document->sections, line, {}, &ManualSection::line);
  const ManualSection& at = *std::prev(next);
  std::string place(document->title);
  for (const std::string_view part : {at.chapter, at.section}) {
    if (!part.empty()) place += fmt::format(", {}", part);
  }
  return fmt::format("{} ({})", place, reference);
}

std::string withManualTitles(std::string_view text) {
  const auto isDigit = [](char c) { return c >= '0' && c <= '9'; };
  const auto isWordByte = [&](char c) {
    return isDigit(c) || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || c == '_' || (c & 0x80) != 0;
  };
  std::string result, before;  // `before`: the place that stands in front, which a second reference need not repeat
  for (std::size_t i = 0; i < text.size();) {
    const bool isReference = text.size() - i > 4 && text[i] == '0' && isDigit(text[i + 1]) && isDigit(text[i + 2]) &&
                             text[i + 3] == ':' && isDigit(text[i + 4]) && (i == 0 || !isWordByte(text[i - 1]));
    if (!isReference) {
      result += text[i++];
      continue;
    }
    std::size_t end = i + 4;
    while (end < text.size() &&
           (isDigit(text[end]) || (text[end] == '-' && end + 1 < text.size() && isDigit(text[end + 1]))))
      ++end;
    std::string place = manualPlace(text.substr(i, end - i));
    place = place.substr(0, place.rfind(" ("));
    const bool isInList = !before.empty() && result.ends_with(before + ", ");
    if (isInList) result.resize(result.size() - 2);
    if (!isInList || place != before) result += (isInList ? "; " : "") + place;
    before = std::move(place);
    i = end;
  }
  return result;
}

}  // namespace rungproof
