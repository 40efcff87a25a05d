// Chapters and reference pages with the list of all of them beside each.
#include "frontend/guide/site.hpp"

#include <fmt/format.h>

#include "frontend/acceptance/page_style.hpp"
#include "frontend/cli/cli.hpp"
#include "frontend/guide/chapter.hpp"
#include "frontend/guide/markdown.hpp"
#include "frontend/text/safe_text.hpp"

namespace rungproof {

namespace {

constexpr std::string_view siteStyle = R"(
.site{display:grid;grid-template-columns:14rem minmax(0,1fr);gap:2.5rem}
.site nav{font-size:.93em}.site nav a{display:block;text-decoration:none;padding:.15em 0}.site nav b{display:block;margin:1em 0 .2em}
.site nav a[aria-current]{font-weight:700;color:var(--ink)}
.site main{max-width:52rem}.site main>h1:first-child{margin-top:0}
@media(max-width:820px){.site{display:block}.site nav{columns:2;border-bottom:1px solid var(--line);padding-bottom:1em;margin-bottom:1.5em}.site nav b{break-after:avoid}}
@media print{.site{display:block}.site nav{display:none}}
)";

struct SitePage {
  std::string name, title, html;
};

std::string navigation(const std::vector<SitePage>& pages, std::size_t chapterCount, const SitePage& current) {
  std::string text = "<nav aria-label=\"pages of the guide\">\n<b>Guide</b>\n";
  for (std::size_t i = 0; i < pages.size(); ++i) {
    if (i == chapterCount) text += "<b>Reference</b>\n";
    text += fmt::format("<a href=\"{}.html\"{}>{}</a>\n", pages[i].name,
                        &pages[i] == &current ? " aria-current=\"page\"" : "", xmlText(pages[i].title));
  }
  return text + "</nav>\n";
}

}  // namespace

std::vector<GuideFile> guidePages() {
  std::vector<SitePage> pages;
  const auto inserted = [](std::string_view word) { return word == "patterns" ? patternSection() : std::string(); };
  for (const Chapter& chapter : chapters())
    pages.push_back({std::string(chapter.name), titleOf(chapter.text), htmlOf(chapter.text, inserted)});
  const std::size_t chapterCount = pages.size();
  for (ReferencePage& page : referencePages())
    pages.push_back({std::move(page.name), page.title, fmt::format("<h1>{}</h1>\n{}", xmlText(page.title), page.html)});
  std::vector<GuideFile> files;
  for (const SitePage& page : pages) {
    files.push_back(
        {page.name + ".html",
         fmt::format(
             "<!DOCTYPE html>\n<html lang=\"en\" xmlns=\"http://www.w3.org/1999/xhtml\"><head><meta "
             "charset=\"utf-8\"/><meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n"
             "<title>{} - rungproof</title>\n<style>{}{}</style></head><body>\n<div class=\"site\">\n{}<main>\n{}"
             "</main>\n</div>\n<footer><p class=\"quiet\">rungproof {}</p></footer>\n</body></html>\n",
             xmlText(page.title), pageStyle(), siteStyle, navigation(pages, chapterCount, page), page.html,
             programVersion())});
  }
  return files;
}

}  // namespace rungproof
