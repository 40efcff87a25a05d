// Changed networks side by side as a page for the browser, and as one picture.
#include <fmt/format.h>

#include <algorithm>

#include "frontend/picture/svg_picture.hpp"
#include "frontend/sides/difference_view.hpp"
#include "frontend/text/excerpt.hpp"
#include "frontend/text/safe_text.hpp"

namespace rungproof {

namespace {

constexpr std::string_view pageStyle =
    "body{font:15px/1.5 system-ui,sans-serif;margin:2em auto;max-width:90em;padding:0 1em;color:#1a1f26;"
    "background:#fff}h1{font-size:1.4em}h2{font-size:1.15em;margin:2em 0 .6em;border-bottom:1px solid #d8dee4}"
    ".pair{display:flex;flex-wrap:wrap;gap:1em}"
    ".pair figure{flex:1 1 26em;min-width:0;margin:0;overflow-x:auto;border:1px solid #d8dee4;padding:.4em .8em}"
    "figcaption{font-weight:bold;color:#57606a}.none{color:#57606a}"
    ".pair svg{display:block;max-width:100%;height:auto;min-width:20em}"
    "ul{margin:.6em 0;padding-left:1.4em}.good{color:#1b7f37}.bad{color:#c62828}.open{color:#b26a00}";

std::string_view classOf(const std::optional<Equality>& verdict) {
  if (!verdict) return "";
  switch (*verdict) {
    case Equality::Equal: return "good";
    case Equality::Different: return "bad";
    case Equality::Unknown: return "open";
  }
  return "open";
}

SizedSvg drawingOfSide(const Sides& sides, const NetworkChange& change, bool isOld, const DifferenceStyle& style) {
  const auto& where = isOld ? change.networks.before : change.networks.after;
  if (!where) return {};
  return sizedSvg(changedView(isOld ? *sides.runBefore : *sides.runAfter, *where, style));
}

std::string_view overall(const ProgramDifference& difference) {
  const bool isDifferent = difference.countOf(Equality::Different) > 0 || !difference.verdicts.empty();
  return isDifferent ? "bad" : difference.countOf(Equality::Unknown) > 0 ? "open" : "good";
}

std::string verdictLine(const VerdictChange& verdict) {
  return fmt::format("verdict: '{}' was {}, is {}", verdict.name, verdict.before, verdict.after);
}

/// One SVG document that grows downwards.
class PictureSheet {
 public:
  /// `left`: room for the drawings of OLD.
  explicit PictureSheet(int left) : second_(margin + std::max(left, least) + gap) {}

  void line(std::string_view text, std::string_view className, int indent = 0) {
    appendSvgText(body_, margin + indent, y_ + 14, text, className);
    y_ += 20;
    widen(margin * 2 + indent + displayWidth(text) * 10);
  }
  void pair(const SizedSvg& left, const SizedSvg& right) {
    appendSvgText(body_, margin, y_ + 14, "OLD", "rk side");
    appendSvgText(body_, second_, y_ + 14, "NEW", "rk side");
    y_ += 22;
    for (const auto& [drawing, x] : {std::pair{&left, margin}, {&right, second_}}) {
      if (drawing->element.empty())
        appendSvgText(body_, x, y_ + 14, "(not there)", "rk side");
      else
        body_ += fmt::format("<g transform=\"translate({} {})\">{}</g>\n", x, y_, drawing->element);
    }
    widen(second_ + std::max(right.width, least) + margin);
    y_ += std::max({left.height, right.height, 20});
  }
  void space(int height) { y_ += height; }
  std::string document() const {
    return fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\">\n"
        "<style>{2}.rk.bad{{fill:#c62828}}.rk.good{{fill:#1b7f37}}.rk.open{{fill:#b26a00}}.rk.plain{{fill:#1f2933}}.rk."
        "side{{fill:#57606a}}</style>\n"
        "<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n{3}</svg>\n",
        width_, y_ + margin, svgStyle(), body_);
  }

 private:
  static constexpr int margin = 16, gap = 24, least = 240;
  void widen(int width) { width_ = std::max(width_, width); }

  std::string body_;
  int second_;
  int y_ = margin, width_ = 2 * (margin + least);
};

/// The run of the first difference: its table, and what drives the output in either program, lit.
std::string firstRunOnPage(const Comparison& run) {
  std::string text = fmt::format("<h2>First difference: {}</h2>\n", xmlText(differenceText(run)));
  std::string table;
  for (const std::string& note : run.notes) table += xmlText(note) + '\n';
  text += fmt::format("<pre>{}</pre>\n<div class=pair>\n", table);
  for (const ShownScan& scan : run.scans) {
    for (const ShownNetwork& network : scan.networks)
      text += fmt::format("<figure><figcaption>{}</figcaption>{}</figure>\n", xmlText(network.heading), network.svg);
  }
  return text + "</div>\n";
}

}  // namespace

std::string differencePage(const Sides& sides, const ProgramDifference& difference, const DifferenceStyle& style) {
  std::string page = fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><meta name=\"viewport\" "
      "content=\"width=device-width\"><title>rungproof diff</title>\n<style>{}{}</style></head><body>\n"
      "<h1>rungproof diff</h1>\n<p class={}><b>{}</b></p>\n",
      pageStyle, svgStyle(), overall(difference), closingLine(difference));
  for (const VerdictChange& verdict : difference.verdicts)
    page += fmt::format("<p class=bad>{}</p>\n", xmlText(verdictLine(verdict)));
  for (const std::string& line : valueLines(difference)) page += fmt::format("<p>{}</p>\n", xmlText(line));
  for (const NetworkChange& change : difference.changes) {
    page += fmt::format("<h2>{}</h2>\n<div class=pair>\n", xmlText(changeHeading(sides, change.networks)));
    for (const bool isOld : {true, false}) {
      const SizedSvg drawing = drawingOfSide(sides, change, isOld, style);
      page += fmt::format("<figure><figcaption>{}</figcaption>{}</figure>\n",
                          xmlText(sideHeading(sides, change.networks, isOld)),
                          drawing.element.empty() ? "<span class=none>not there</span>" : drawing.element);
    }
    page += "</div>\n<ul>\n";
    for (const InfluenceLine& line : influenceLines(change))
      page += line.verdict ? fmt::format("<li class={}>{}</li>\n", classOf(line.verdict), xmlText(line.text))
                           : fmt::format("<li>{}</li>\n", xmlText(line.text));
    page += "</ul>\n";
  }
  for (const std::string& note : difference.equivalence.notes)
    page += fmt::format("<p class=open>note: {}</p>\n", xmlText(note));
  if (difference.first) page += firstRunOnPage(*difference.first);
  return page + "</body></html>\n";
}

std::string differencePicture(const Sides& sides, const ProgramDifference& difference, const DifferenceStyle& style) {
  std::vector<std::pair<SizedSvg, SizedSvg>> drawings;
  int left = 0;
  for (const NetworkChange& change : difference.changes) {
    drawings.emplace_back(drawingOfSide(sides, change, true, style), drawingOfSide(sides, change, false, style));
    left = std::max(left, drawings.back().first.width);
  }
  PictureSheet sheet(left);
  sheet.line(closingLine(difference), "rp");
  sheet.space(6);
  for (const VerdictChange& verdict : difference.verdicts) sheet.line(verdictLine(verdict), "rk bad");
  for (const std::string& line : valueLines(difference)) sheet.line(line, "rk plain");
  for (std::size_t i = 0; i < drawings.size(); ++i) {
    const NetworkChange& change = difference.changes[i];
    sheet.space(14);
    sheet.line(changeHeading(sides, change.networks), "rh");
    sheet.pair(drawings[i].first, drawings[i].second);
    for (const InfluenceLine& line : influenceLines(change))
      sheet.line(line.text, fmt::format("rk {}", line.verdict ? classOf(line.verdict) : "plain"), 8);
  }
  for (const std::string& note : difference.equivalence.notes) sheet.line("note: " + note, "rk open");
  return sheet.document();
}

}  // namespace rungproof
