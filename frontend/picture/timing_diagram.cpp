// Draws lanes. Units are SVG user units, about a pixel.
#include "frontend/picture/timing_diagram.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "frontend/text/excerpt.hpp"
#include "frontend/text/safe_text.hpp"
#include "frontend/trace_format.hpp"

namespace rungproof {

namespace {

constexpr int laneHeight = 34, levelHeight = 18, belowTitle = 46, withoutTitle = 14, labelGap = 10, charWidth = 7,
              belowScans = 30;

/// A stretch of rows with the same values, as wide as it is drawn.
struct DrawnStretch {
  std::size_t row;
  std::size_t count;
  double x;
  double width;
  bool isCut = false;  ///< drawn shorter than it lasts
};

bool sameValues(const TraceRow& a, const TraceRow& b) { return a.values == b.values; }

std::vector<DrawnStretch> stretches(const Trace& trace, std::size_t maxScans, double left) {
  std::vector<DrawnStretch> list;
  const bool mayCompress = trace.rows.size() > maxScans;
  const double unit = std::clamp(900.0 / static_cast<double>(std::max<std::size_t>(trace.rows.size(), 1)), 6.0, 40.0);
  double x = left;
  for (std::size_t r = 0; r < trace.rows.size(); ++r) {
    if (!list.empty() && sameValues(trace.rows[list.back().row], trace.rows[r])) {
      ++list.back().count;
      const double grown = mayCompress ? std::min(list.back().width + unit, 4 * unit) : list.back().width + unit;
      x += grown - list.back().width;
      list.back().isCut = list.back().isCut || grown < list.back().width + unit;
      list.back().width = grown;
      continue;
    }
    if (list.size() >= maxScans) break;
    list.push_back({r, 1, x, unit, false});
    x += unit;
  }
  return list;
}

std::string label(const TraceSignal& signal) {
  return signal.symbol.empty() ? signal.name : signal.name + " " + signal.symbol;
}

std::string bitLane(const Trace& trace, std::size_t column, const std::vector<DrawnStretch>& list, double y) {
  std::string path;
  std::string unknown;
  bool isDown = false;  // pen is on the paper
  double level = 0;
  for (const DrawnStretch& s : list) {
    const std::optional<TraceNumber> value = trace.rows[s.row].values[column];
    if (!value) {
      unknown += fmt::format("<rect class=\"x\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{}\"/>", s.x, y,
                             s.width, levelHeight);
      isDown = false;
      continue;
    }
    const double now = *value != 0 ? y : y + levelHeight;
    if (!isDown) path += fmt::format("M{:.1f} {:.1f}", s.x, now);
    if (isDown && now != level) path += fmt::format("V{:.1f}", now);
    path += fmt::format("H{:.1f}", s.x + s.width);
    isDown = true;
    level = now;
  }
  return fmt::format("{}<path class=\"w\" d=\"{}\"/>\n", unknown, path);
}

std::string numberLane(const Trace& trace, std::size_t column, const std::vector<DrawnStretch>& list, double y) {
  std::string text;
  for (std::size_t i = 0; i < list.size();) {
    const std::optional<TraceNumber> value = trace.rows[list[i].row].values[column];
    std::size_t j = i + 1;
    while (j < list.size() && trace.rows[list[j].row].values[column] == value) ++j;
    const double x = list[i].x, end = list[j - 1].x + list[j - 1].width, slope = std::min(3.0, (end - x) / 3);
    const double middle = y + levelHeight / 2.0;
    text += fmt::format(
        "<path class=\"{}\" d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}H{:.1f}L{:.1f} {:.1f}L{:.1f} {:.1f}H{:.1f}Z\"/>",
        value ? "b" : "x", x, middle, x + slope, y, end - slope, end, middle, end - slope, y + levelHeight, x + slope);
    const std::string number = value ? numberText(*value, trace.signals[column].type) : "";
    if (static_cast<double>(number.size()) * charWidth < end - x + 2) {
      text += fmt::format("<text class=\"n\" x=\"{:.1f}\" y=\"{:.1f}\">{}</text>", (x + end) / 2, middle + 4, number);
    }
    i = j;
  }
  return text + "\n";
}

/// When a row begins: at the end of the one before.
std::uint64_t beginOf(const Trace& trace, std::size_t row) {
  if (row > 0) return trace.rows[row - 1].timeUs;
  return trace.rows[row].timeUs - std::min(trace.rows[row].timeUs, std::uint64_t{trace.rows[row].scanUs});
}

/// Scan numbers along the bottom, as many as there is room for, and below them the time at which each begins; a broken
/// stretch shows how long it is. Of a recording by time: the times alone.
std::string axis(const Trace& trace, const std::vector<DrawnStretch>& list, double y) {
  std::string text;
  double free = -1;
  const auto timeAt = [&](double x, std::uint64_t us) {
    text +=
        fmt::format("<text class=\"a\" x=\"{:.1f}\" y=\"{:.1f}\">{}</text>", x, y + belowScans, millisecondsText(us));
  };
  for (const DrawnStretch& s : list) {
    const TraceRow& row = trace.rows[s.row];
    const std::uint64_t begin = beginOf(trace, s.row);
    const std::string number = trace.isByTime ? millisecondsText(row.timeUs) : fmt::format("{}", row.scan);
    const std::size_t letters =
        trace.isByTime ? number.size() : std::max(number.size(), millisecondsText(begin).size());
    text += fmt::format("<path class=\"t\" d=\"M{:.1f} {:.1f}v4\"/>", s.x, y);
    if (s.isCut)
      text += fmt::format("<path class=\"t\" d=\"M{0:.1f} {1:.1f}l4 -8m3 0l-4 8\"/>", s.x + s.width - 9, y + 4);
    if (s.x < free) continue;
    text += fmt::format("<text class=\"a\" x=\"{:.1f}\" y=\"{:.1f}\">{}</text>", s.x, y + 16, number);
    if (!trace.isByTime) timeAt(s.x, begin);
    free = s.x + static_cast<double>(letters * charWidth) + 6;
  }
  const double right = list.empty() ? 0 : list.back().x + list.back().width;
  if (!trace.isByTime && !list.empty() && right >= free)
    timeAt(right, trace.rows[list.back().row + list.back().count - 1].timeUs);
  return text + "\n";
}

}  // namespace

std::string timingDiagram(const Trace& trace, std::string_view title, std::size_t maxScans) {
  int longest = 4;
  for (const TraceSignal& signal : trace.signals) longest = std::max(longest, displayWidth(label(signal)));
  const double left = longest * charWidth + 2 * labelGap;
  const std::vector<DrawnStretch> list = stretches(trace, maxScans, left);
  const double right = list.empty() ? left : list.back().x + list.back().width;
  const int topMargin = title.empty() ? withoutTitle : belowTitle;
  const double bottom = topMargin + laneHeight * static_cast<double>(trace.signals.size());
  const std::size_t drawn = list.empty() ? 0 : list.back().row + list.back().count;

  std::string svg = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.0f}\" height=\"{1:.0f}\" viewBox=\"0 0 {0:.0f} {1:.0f}\" "
      "font-family=\"sans-serif\" font-size=\"12\">\n"
      "<style>.w{{fill:none;stroke:#000;stroke-width:1.5}}.b{{fill:#fff;stroke:#000}}.x{{fill:#ddd;stroke:#999}}.t{{"
      "fill:none;stroke:#000}}.g{{stroke:#ccc;stroke-dasharray:2 3}}"
      ".n{{text-anchor:middle;font-size:11px}}.a{{text-anchor:middle;font-size:10px;fill:#444}}</style>\n"
      "<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n",
      right + 30, bottom + (trace.isByTime ? 40 : 54));
  if (!title.empty())
    svg += fmt::format("<text x=\"{}\" y=\"22\" font-weight=\"bold\">{}</text>\n", labelGap, xmlText(title));
  for (const DrawnStretch& s : list)
    svg += fmt::format("<path class=\"g\" d=\"M{:.1f} {}V{:.1f}\"/>", s.x, topMargin - 8, bottom);
  svg += "\n";
  for (std::size_t i = 0; i < trace.signals.size(); ++i) {
    const double y = topMargin + laneHeight * static_cast<double>(i);
    svg += fmt::format("<text x=\"{}\" y=\"{:.1f}\">{}</text>", labelGap, y + levelHeight - 4,
                       xmlText(label(trace.signals[i])));
    svg += trace.signals[i].width() == 1 ? bitLane(trace, i, list, y) : numberLane(trace, i, list, y);
  }
  svg += axis(trace, list, bottom);
  const std::string rest = drawn < trace.rows.size() ? fmt::format(" (first {} of {})", drawn, trace.rows.size()) : "";
  svg += fmt::format("<text x=\"{}\" y=\"{:.1f}\">{}{}</text>\n", labelGap, bottom + 16, trace.isByTime ? "ms" : "scan",
                     rest);
  if (!trace.isByTime) svg += fmt::format("<text x=\"{}\" y=\"{:.1f}\">ms</text>\n", labelGap, bottom + belowScans);
  svg += "</svg>\n";
  return svg;
}

}  // namespace rungproof
