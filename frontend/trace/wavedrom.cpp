// Traces as WaveDrom JSON: one character per scan, '.' repeats, numbers as labelled segments. Inputs, outputs and the
// rest stand in groups. Tested by tests/trace/drawing_test.cpp.
#include <ostream>

#include "frontend/files/json.hpp"
#include "frontend/trace_format.hpp"

namespace rungproof {

namespace {

std::string groupName(const TraceSignal& signal) {
  if (!signal.operand.isMemory()) return "";
  switch (signal.operand.area) {
    case Area::I:
    case Area::AI: return "inputs";
    case Area::Q:
    case Area::AQ: return "outputs";
    case Area::T: return "timers";
    case Area::C: return "counters";
    default: return "memory";
  }
}

Json lane(const Trace& trace, std::size_t column) {
  const TraceSignal& signal = trace.signals[column];
  std::string wave;
  std::vector<std::string> data;
  std::optional<TraceNumber> last;
  for (std::size_t r = 0; r < trace.rows.size(); ++r) {
    const std::optional<TraceNumber> value = trace.rows[r].values[column];
    if (r > 0 && value == last) {
      wave += '.';
    } else if (!value) {
      wave += 'x';
    } else if (signal.width() == 1) {
      wave += *value != 0 ? '1' : '0';
    } else {
      wave += '=';
      data.push_back(numberText(*value, signal.type));
    }
    last = value;
  }
  Json result = {{"name", signal.symbol.empty() ? signal.name : signal.name + " " + signal.symbol}, {"wave", wave}};
  if (!data.empty()) result["data"] = data;
  return result;
}

void writeWavedromTrace(const Trace& trace, std::string_view title, std::ostream& out) {
  Json lanes = Json::array();
  for (std::size_t i = 0; i < trace.signals.size(); ++i) {
    const std::string group = groupName(trace.signals[i]);
    const bool isOpen =
        !lanes.empty() && lanes.back().kind() == Json::Kind::Array && lanes.back().items()[0].text() == group;
    if (group.empty()) {
      lanes.push_back(lane(trace, i));
    } else if (isOpen) {
      lanes.back().push_back(lane(trace, i));
    } else {
      lanes.push_back(Json::array({group, lane(trace, i)}));
    }
  }
  const std::uint64_t first = trace.rows.empty() ? 1 : std::max<std::uint64_t>(trace.rows[0].scan, 1);
  const Json json = {{"signal", lanes}, {"head", {{"text", std::string(title)}, {"tick", first}}}};
  out << json.dump(2) << '\n';
}

}  // namespace

extern constexpr TraceFormat wavedromTrace = {
    .ending = ".json", .summary = "WaveDrom timing diagram", .write = writeWavedromTrace};

}  // namespace rungproof
