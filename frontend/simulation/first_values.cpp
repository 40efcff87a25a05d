// One more row and its columns.
#include "frontend/simulation/first_values.hpp"

#include <fmt/format.h>

#include "frontend/logger/trace_cell.hpp"
#include "frontend/simulation/stimulus_column.hpp"

namespace rungproof {

void setFirst(Stimulus& stimulus, std::span<const std::string> given, const Program& program,
              std::vector<Failure>& failures) {
  StimulusRow first;
  first.scan = 1;
  first.values.resize(stimulus.columns.size());
  for (const std::string& text : given) {
    const std::size_t equals = text.rfind('=');
    if (equals == std::string::npos || equals == 0) {
      failures.push_back({fmt::format("'{}' sets nothing", text), {}, "write --set ADDRESS=VALUE, such as I0.0=1"});
      continue;
    }
    Failure failure;
    const std::optional<StimulusColumn> column =
        stimulusColumn(program, text.substr(0, equals), /*isRecorded=*/false, failure);
    if (!column || column->target == StimulusTarget::Characters) {
      if (column) failure.message = fmt::format("'{}' receives characters in a stimulus only", text.substr(0, equals));
      failures.push_back(failure);
      continue;
    }
    std::string reason;
    const std::optional<TraceNumber> value = valueIn(text.substr(equals + 1), column->signal, reason);
    if (!value) {
      failures.push_back({fmt::format("{} cannot be set: {}", text.substr(0, equals), reason)});
      continue;
    }
    stimulus.columns.push_back(*column);
    first.values.push_back(value);
  }
  for (StimulusRow& row : stimulus.rows) row.values.resize(stimulus.columns.size());
  if (!given.empty()) stimulus.rows.insert(stimulus.rows.begin(), std::move(first));
}

}  // namespace rungproof
