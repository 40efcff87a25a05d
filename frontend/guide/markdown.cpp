// Line by line: each line belongs to a block; inside blocks of text the marks of words are replaced.
#include "frontend/guide/markdown.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "frontend/acceptance/page_text.hpp"
#include "frontend/text/safe_text.hpp"

namespace rungproof {

namespace {

std::vector<std::string_view> linesIn(std::string_view text) {
  std::vector<std::string_view> lines;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    lines.push_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return lines;
}

std::string_view withoutMargin(std::string_view text) {
  const std::size_t first = text.find_first_not_of(' ');
  return first == std::string_view::npos ? std::string_view()
                                         : text.substr(first, text.find_last_not_of(' ') - first + 1);
}

/// Text with its marks: `code`, **bold**, [text](place).
std::string inlineHtml(std::string_view text) {
  std::string html;
  while (!text.empty()) {
    const auto closed = [&](std::string_view open, std::string_view close) {
      return text.starts_with(open) ? text.find(close, open.size()) : std::string_view::npos;
    };
    if (const std::size_t end = closed("`", "`"); end != std::string_view::npos) {
      html += fmt::format("<code>{}</code>", xmlText(text.substr(1, end - 1)));
      text.remove_prefix(end + 1);
    } else if (const std::size_t bold = closed("**", "**"); bold != std::string_view::npos) {
      html += fmt::format("<b>{}</b>", inlineHtml(text.substr(2, bold - 2)));
      text.remove_prefix(bold + 2);
    } else if (const std::size_t middle = closed("[", "]("); middle != std::string_view::npos) {
      const std::size_t end = std::min(text.find(')', middle), text.size() - 1);
      html += fmt::format("<a href=\"{}\">{}</a>", xmlText(text.substr(middle + 2, end - middle - 2)),
                          inlineHtml(text.substr(1, middle - 1)));
      text.remove_prefix(end + 1);
    } else {
      const std::size_t next = std::min(text.find_first_of("`*[", 1), text.size());
      html += xmlText(text.substr(0, next));
      text.remove_prefix(next);
    }
  }
  return html;
}

std::vector<std::string_view> cellsIn(std::string_view line) {
  std::vector<std::string_view> cells;
  line.remove_prefix(1);
  while (!line.empty()) {
    const std::size_t end = std::min(line.find('|'), line.size());
    cells.push_back(withoutMargin(line.substr(0, end)));
    line.remove_prefix(std::min(end + 1, line.size()));
  }
  return cells;
}

bool isItem(std::string_view line) { return line.starts_with("- "); }
bool isStep(std::string_view line) {
  const std::size_t digits = std::min(line.find_first_not_of("0123456789"), line.size());
  return digits > 0 && line.substr(digits).starts_with(". ");
}
bool beginsBlock(std::string_view line) {
  return line.empty() || line.starts_with("#") || line.starts_with("```") || line.starts_with("|") ||
         line.starts_with("{{") || isItem(line) || isStep(line);
}

class ChapterConverter {
 public:
  ChapterConverter(std::string_view text, const Insertion& inserted) : lines_(linesIn(text)), inserted_(inserted) {}

  std::string html() {
    while (at_ < lines_.size()) block();
    return std::move(html_);
  }

 private:
  std::string_view line() const { return lines_[at_]; }
  bool isMore() const { return at_ < lines_.size(); }

  void block() {
    if (line().empty())
      ++at_;
    else if (line().starts_with("#"))
      heading();
    else if (line().starts_with("```"))
      code();
    else if (line().starts_with("|"))
      table();
    else if (isItem(line()))
      list("ul", isItem);
    else if (isStep(line()))
      list("ol", isStep);
    else if (line().starts_with("{{"))
      html_ += inserted_(line().substr(2, line().size() - 4)), ++at_;
    else
      html_ += fmt::format("<p>{}</p>\n", inlineHtml(joined()));
  }

  /// The line and those that go on from it.
  std::string joined() {
    std::string text(withoutMargin(line()));
    for (++at_; isMore() && !beginsBlock(line()); ++at_) text += " " + std::string(withoutMargin(line()));
    return text;
  }

  void heading() {
    const std::size_t level = std::min<std::size_t>(line().find_first_not_of('#'), 4);
    const std::string_view title = withoutMargin(line().substr(level));
    const std::string id = places_.of(title);
    html_ += fmt::format(
        "<h{0} id=\"{1}\">{2}<a class=\"anchor\" href=\"#{1}\" aria-label=\"link to this part\">#</a></h{0}>\n", level,
        xmlText(id), inlineHtml(title));
    ++at_;
  }

  void code() {
    const std::string_view kind = withoutMargin(line().substr(3));
    std::string text;
    for (++at_; isMore() && !line().starts_with("```"); ++at_) text += xmlText(line()) + "\n";
    if (isMore()) ++at_;
    if (kind.starts_with("file ")) html_ += fmt::format("<p class=\"quiet\">{}</p>\n", xmlText(kind.substr(5)));
    html_ += fmt::format("<pre>{}</pre>\n", text);
  }

  void table() {
    html_ += "<div class=\"scroll\"><table>";
    for (bool isFirst = true; isMore() && line().starts_with("|"); ++at_, isFirst = false) {
      if (line().starts_with("|--")) continue;
      html_ += "<tr>";
      for (const std::string_view cell : cellsIn(line()))
        html_ += fmt::format("<{0}>{1}</{0}>", isFirst ? "th" : "td", inlineHtml(cell));
      html_ += "</tr>\n";
    }
    html_ += "</table></div>\n";
  }

  void list(std::string_view kind, bool (*isNext)(std::string_view)) {
    html_ += fmt::format("<{}>\n", kind);
    while (isMore() && isNext(line())) {
      lines_[at_].remove_prefix(line().find(' ') + 1);
      html_ += fmt::format("<li>{}</li>\n", inlineHtml(joined()));
    }
    html_ += fmt::format("</{}>\n", kind);
  }

  std::vector<std::string_view> lines_;
  const Insertion& inserted_;
  std::size_t at_ = 0;
  std::string html_;
  PlaceNames places_;
};

}  // namespace

std::string htmlOf(std::string_view markdown, const Insertion& inserted) {
  return ChapterConverter(markdown, inserted).html();
}

std::string titleOf(std::string_view markdown) {
  for (const std::string_view line : linesIn(markdown)) {
    if (line.starts_with("# ")) return std::string(withoutMargin(line.substr(2)));
  }
  return {};
}

std::vector<CodeBlock> codeBlocksOf(std::string_view markdown) {
  std::vector<CodeBlock> blocks;
  bool isInside = false;
  for (const std::string_view line : linesIn(markdown)) {
    if (line.starts_with("```")) {
      isInside = !isInside;
      if (isInside) blocks.push_back({std::string(withoutMargin(line.substr(3))), {}});
    } else if (isInside) {
      blocks.back().text += std::string(line) + "\n";
    }
  }
  return blocks;
}

}  // namespace rungproof
