// Plays rows in front of the scans they belong to.
#include "engine/stimulus.hpp"

namespace rungproof {

ScanRequest StimulusPlayer::next() {
  ScanRequest request;
  const std::uint64_t scan = simulator_.scanCount() + 1;
  const std::uint64_t start = simulator_.timeUs();
  const auto isDue = [&](const StimulusRow& row) { return stimulus_.isByTime ? row.timeUs <= start : row.scan <= scan; };
  while (!isDone() && isDue(stimulus_.rows[row_])) apply(stimulus_.rows[row_++], request);
  request.lengthUs = scanUs_;
  return request;
}

void StimulusPlayer::apply(const StimulusRow& row, ScanRequest& request) {
  if (row.scanUs) scanUs_ = *row.scanUs;
  request.events.insert(request.events.end(), row.events.begin(), row.events.end());
  for (std::size_t i = 0; i < stimulus_.columns.size(); ++i) {
    const StimulusColumn& column = stimulus_.columns[i];
    if (!row.values[i]) continue;
    const std::uint64_t value = valueOf(*row.values[i], column.signal.type, column.signal.width());
    if (column.target == StimulusTarget::Memory) simulator_.write(column.signal.operand, value);
    if (column.target == StimulusTarget::LibraryOutput) simulator_.devices().setLibraryOutput(column.block, column.position, value);
  }
}

}  // namespace rungproof
