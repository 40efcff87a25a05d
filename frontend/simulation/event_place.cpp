// Instructions are found by file and line, and counted where several share a line.
#include "frontend/simulation/event_place.hpp"

#include <fmt/format.h>

#include <charconv>
#include <utility>
#include <vector>

namespace rungproof {

namespace {

struct SourceLine {
  std::string_view file;
  std::uint32_t line;
  friend bool operator==(const SourceLine&, const SourceLine&) = default;
};

SourceLine lineOf(const Program& program, const Instruction& instruction) {
  const std::string_view name = program.sources->file(instruction.span.file).name();
  const std::size_t slash = name.find_last_of("/\\");
  return {slash == std::string_view::npos ? name : name.substr(slash + 1),
          static_cast<std::uint32_t>(program.sources->position(instruction.span).line)};
}

template <class Visit>
void forEachInstruction(const Program& program, Visit&& visit) {
  for (const Pou& pou : program.pous) {
    for (const Network& network : pou.networks) {
      for (const Instruction& instruction : network.instructions) visit(instruction);
    }
  }
}

std::vector<const Instruction*> instructionsIn(const Program& program, const SourceLine& line) {
  std::vector<const Instruction*> found;
  forEachInstruction(program, [&](const Instruction& instruction) {
    if (lineOf(program, instruction) == line) found.push_back(&instruction);
  });
  return found;
}

std::string_view firstFile(const Program& program) {
  std::string_view file;
  forEachInstruction(program, [&](const Instruction& instruction) {
    if (file.empty()) file = lineOf(program, instruction).file;
  });
  return file;
}

/// A number from 1 behind `mark`, taken off the end of the text; 1 if the mark is not there, nothing if what follows is
/// no number.
std::optional<std::uint32_t> countBehind(std::string_view& text, char mark) {
  const std::size_t at = text.rfind(mark);
  if (at == std::string_view::npos) return 1;
  std::uint32_t number = 0;
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data() + at + 1, end, number);
  if (error != std::errc() || stop != end || number == 0) return std::nullopt;
  text = text.substr(0, at);
  return number;
}

}  // namespace

std::string placeText(const Program& program, const ScanPlace& place) {
  if (place.instruction == ScanPlace::startOfScan) return "";
  if (place.instruction == ScanPlace::afterProgram) return "@end";
  std::string text;
  forEachInstruction(program, [&](const Instruction& instruction) {
    if (instruction.id != place.instruction) return;
    const SourceLine line = lineOf(program, instruction);
    text = fmt::format("@{}{}{}", line.file == firstFile(program) ? "" : line.file,
                       line.file == firstFile(program) ? "" : ":", line.line);
    const std::vector<const Instruction*> beside = instructionsIn(program, line);
    for (std::size_t i = 0; i < beside.size() && beside.size() > 1; ++i) {
      if (beside[i] == &instruction) text += fmt::format("/{}", i + 1);
    }
    if (place.visit > 0) text += fmt::format("*{}", place.visit + 1);
  });
  return text;
}

std::string eventsText(const Program& program, const std::vector<ScanScript::Event>& events, bool withQueue) {
  std::string text;
  std::size_t together = 1;
  for (std::size_t i = 0; i < events.size(); ++i) {
    const ScanScript::Event& event = events[i];
    if (event.isFromQueue && !withQueue) continue;
    const bool isSame = i + 1 < events.size() && events[i + 1].event == event.event &&
                        events[i + 1].place == event.place && events[i + 1].isFromQueue == event.isFromQueue;
    if (event.isWithNext && isSame) {
      ++together;
      continue;
    }
    if (!text.empty()) text += ' ';
    if (together > 1) text += fmt::format("{}x", std::exchange(together, 1));
    if (withQueue && event.isFromQueue) text += 'q';
    if (withQueue && event.isWithNext) text += '&';
    text += fmt::format("{}{}", shownEvent(event.event), placeText(program, event.place));
  }
  return text;
}

std::string writeText(const Program& program, const ScanScript::Write& write) {
  return fmt::format("{}={}{}", toString(write.operand), write.value, placeText(program, write.place));
}

std::optional<ScanPlace> scanPlaceNamed(const Program& program, std::string_view text) {
  if (text == "end") return ScanPlace{};
  const auto visit = countBehind(text, '*'), index = countBehind(text, '/');
  SourceLine line{firstFile(program), 0};
  if (const std::size_t colon = text.rfind(':'); colon != std::string_view::npos) {
    line.file = text.substr(0, colon);
    text = text.substr(colon + 1);
  }
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), line.line);
  if (!visit || !index || error != std::errc() || stop != text.data() + text.size()) return std::nullopt;
  const std::vector<const Instruction*> there = instructionsIn(program, line);
  if (*index > there.size()) return std::nullopt;
  return ScanPlace{there[*index - 1]->id, *visit - 1};
}

}  // namespace rungproof
