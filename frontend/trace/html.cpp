// Traces as one HTML page without outside references: lanes with zoom, a cursor that steps from scan to scan or from
// change to change, and the values at the cursor. The data stand in the page as JSON; a reader without scripts still
// sees the static diagram. Tested by tests/trace/drawing_test.cpp.
#include <ostream>

#include "frontend/files/json.hpp"
#include "frontend/picture/timing_diagram.hpp"
#include "frontend/text/safe_text.hpp"
#include "frontend/trace_format.hpp"
#include "frontend/trace_page.hpp"

namespace rungproof {

namespace {

/// The page's own numbers are doubles: what they would round is a text.
Json cellJson(TraceNumber value) {
  if (std::abs(value) < 0x1p53L || std::trunc(value) != value) return Json(static_cast<double>(value));
  return Json(numberText(value, SignalType::Signed));
}

constexpr std::string_view style = R"(
body{font:14px/1.4 system-ui,sans-serif;margin:1em;color:#1a1f26;background:#fff}
button{font:inherit;padding:.1em .6em}
#view{overflow-x:auto;border:1px solid #d8dee4;margin:.6em 0}
svg text{font:12px sans-serif}.w{fill:none;stroke:#000;stroke-width:1.5}.b{fill:#fff;stroke:#000}.x{fill:#ddd;stroke:#999}
.n{text-anchor:middle}.a{text-anchor:middle;fill:#57606a}.g{stroke:#e4e7eb}.c{stroke:#c62828;stroke-width:1.5}
table{border-collapse:collapse}td,th{border:1px solid #d8dee4;padding:.1em .6em;text-align:left}td.v{text-align:right}
.changed{background:#fff3cd}.wrong{background:#ffd7d5}.e .w{stroke:#1a7f37;stroke-dasharray:4 2}.e .b{stroke:#1a7f37}.d{fill:#ffd7d5}.p{fill:#1a7f37}
#below{display:flex;gap:2em;align-items:flex-start;flex-wrap:wrap}#drawings{display:flex;flex-direction:column}.drawn h3{margin:.6em 0 .2em;font-size:1em}.drawn[hidden]{display:none}.drawn svg{display:block}
)";

// In a function of its own: names such as `top` belong to the window.
constexpr std::string_view script = R"(
(() => {
"use strict";
const trace = JSON.parse(document.getElementById("data").textContent);
const pagesOf = trace.pages, rows = trace.rows, signals = trace.signals, lane = 30, level = 16, top = 10;
const labelWidth = 20 + 8 * signals.reduce((m, s) => Math.max(m, s.name.length), 4);
let unit = Math.max(4, Math.min(40, 900 / Math.max(rows.length, 1))), cursor = 0;
const shown = v => v === null ? "x" : String(v);
const escapeText = t => t.replace(/[&<>"]/g, c => ({"&": "&amp;", "<": "&lt;", ">": "&gt;", '"': "&quot;"})[c]);
function runs(i) {
  const list = [];
  for (let r = 0; r < rows.length; ++r) {
    const value = rows[r].values[i];
    if (list.length && list[list.length - 1].value === value) ++list[list.length - 1].count;
    else list.push({row: r, count: 1, value});
  }
  return list;
}
const lanes = signals.map((s, i) => runs(i));
function drawLane(i) {
  const y = top + i * lane;
  let text = "", path = "", pen = false;
  for (const r of signals[i].wrong || []) text += `<rect class="d" x="${labelWidth + r * unit}" y="${y - lane - 4}" width="${unit}" height="${lane + level + 8}"/>`;
  for (const run of lanes[i]) {
    const x = labelWidth + run.row * unit, end = x + run.count * unit;
    if (run.value === null) {
      text += `<rect class="x" x="${x}" y="${y}" width="${end - x}" height="${level}"/>`;
      pen = false;
    } else if (signals[i].bits === 1) {
      const h = run.value ? y : y + level;
      path += (pen ? `V${h}` : `M${x} ${h}`) + `H${end}`;
      pen = true;
    } else {
      text += `<rect class="b" x="${x}" y="${y}" width="${end - x}" height="${level}"/>`;
      if (shown(run.value).length * 7 < end - x) text += `<text class="n" x="${(x + end) / 2}" y="${y + level - 3}">${shown(run.value)}</text>`;
    }
  }
  return `<g${signals[i].of === undefined ? "" : ' class="e"'}>${text}<path class="w" d="${path}"/></g>`;
}
function draw() {
  const width = labelWidth + rows.length * unit + 20, bottom = top + signals.length * lane;
  let text = "", free = 0;
  for (let r = 0; r < rows.length; ++r) {
    const x = labelWidth + r * unit;
    if (x < free) continue;
    text += `<path class="g" d="M${x} ${top}V${bottom}"/><text class="a" x="${x}" y="${bottom + 14}">${rows[r].scan || rows[r].time_ms}</text>`;
    free = x + 44;
  }
  for (const late of [false, true]) for (let i = 0; i < signals.length; ++i) if ((signals[i].of === undefined) === late) text += drawLane(i);
  const at = labelWidth + (cursor + 0.5) * unit;
  text += `<path class="c" d="M${at} 0V${bottom}"/>`;
  const names = signals.map((s, i) => `<text${s.of === undefined ? "" : ' class="p"'} x="4" y="${top + i * lane + level - 3}">${escapeText(s.name)}</text>`).join("");
  document.getElementById("view").innerHTML = `<svg width="${width}" height="${bottom + 24}">${text}<g id="names"><rect width="${labelWidth - 6}" height="${bottom}" fill="#fff"/>${names}</g></svg>`;
  keepNames();
  showValues();
}
function keepNames() {
  document.getElementById("names").setAttribute("transform", `translate(${document.getElementById("view").scrollLeft})`);
}
function showValues() {
  if (!rows.length) return;
  const now = new Set(pagesOf[cursor]);
  document.querySelectorAll(".drawn").forEach((page, i) => { page.hidden = !now.has(i); });
  const row = rows[cursor], before = cursor ? rows[cursor - 1] : row;
  document.getElementById("where").textContent = (row.scan ? `scan ${row.scan}, ` : "") + `${row.time_ms} ms`;
  document.getElementById("values").innerHTML = "<tr><th>signal</th><th>value</th></tr>" + signals.map((s, i) =>
    `<tr${(s.wrong || []).includes(cursor) ? ' class="wrong"' : row.values[i] !== before.values[i] ? ' class="changed"' : ""}><td>${escapeText(s.name)}</td><td class="v">${shown(row.values[i])}</td></tr>`).join("");
}
function go(to) {
  cursor = Math.max(0, Math.min(rows.length - 1, to));
  draw();
  const view = document.getElementById("view"), at = labelWidth + cursor * unit;
  if (at < view.scrollLeft + labelWidth || at > view.scrollLeft + view.clientWidth - 40) view.scrollLeft = at - view.clientWidth / 2;
}
const differs = (a, b) => rows[a].values.some((v, i) => v !== rows[b].values[i]);
function nextChange(step) {
  let r = cursor;
  while (r + step >= 0 && r + step < rows.length) {
    r += step;
    if (differs(r, r - step)) break;
  }
  go(r);
}
function zoom(factor) { unit = Math.max(1, Math.min(200, unit * factor)); go(cursor); }
const actions = {first: () => go(0), back: () => go(cursor - 1), forward: () => go(cursor + 1), last: () => go(rows.length - 1),
  previous: () => nextChange(-1), next: () => nextChange(1), closer: () => zoom(1.5), wider: () => zoom(1 / 1.5)};
for (const id in actions) document.getElementById(id).onclick = actions[id];
const keys = {ArrowLeft: "back", ArrowRight: "forward", Home: "first", End: "last", "+": "closer", "-": "wider", n: "next", p: "previous"};
document.onkeydown = e => { if (keys[e.key]) { actions[keys[e.key]](); e.preventDefault(); } };
document.getElementById("view").onclick = e => {
  const view = document.getElementById("view");
  const x = e.clientX - view.getBoundingClientRect().left + view.scrollLeft - labelWidth;
  if (x >= 0) go(Math.floor(x / unit));
};
document.getElementById("view").onscroll = keepNames;
document.getElementById("view").onwheel = e => { if (e.ctrlKey) { zoom(e.deltaY < 0 ? 1.2 : 1 / 1.2); e.preventDefault(); } };
draw();
})();
)";

std::string dataJson(const Trace& trace, const TraceDrawings& drawings, const ExpectedLanes& expected) {
  Json json = {{"signals", Json::array()}, {"rows", Json::array()}};
  json["pages"] = Json::array();
  for (const std::vector<std::size_t>& pages : drawings.pagesOf) {
    Json row = Json::array();
    for (const std::size_t page : pages) row.push_back(page);
    json["pages"].push_back(std::move(row));
  }
  for (std::size_t i = 0; i < trace.signals.size(); ++i) {
    const TraceSignal& signal = trace.signals[i];
    json["signals"].push_back(
        {{"name", signal.symbol.empty() ? signal.name : signal.name + " " + signal.symbol}, {"bits", signal.width()}});
    if (i >= expected.of.size() || expected.of[i] < 0) continue;
    Json wrong = Json::array();
    for (const std::size_t row : expected.wrong[i]) wrong.push_back(row);
    json["signals"].back()["of"] = expected.of[i];
    json["signals"].back()["wrong"] = std::move(wrong);
  }
  for (const TraceRow& row : trace.rows) {
    Json values = Json::array();
    for (const std::optional<TraceNumber>& value : row.values) values.push_back(value ? cellJson(*value) : Json());
    json["rows"].push_back(
        {{"scan", row.scan}, {"time_ms", static_cast<double>(row.timeUs) / 1000}, {"values", values}});
  }
  std::string text = json.dump(-1, true);
  for (std::size_t at = text.find("</"); at != std::string::npos; at = text.find("</", at + 3))
    text.replace(at, 2, "<\\/");
  return text;
}

void writeHtmlTrace(const Trace& trace, std::string_view title, std::ostream& out) {
  writeTracePage(trace, title, {}, out);
}

}  // namespace

void writeTracePage(const Trace& trace, std::string_view title, const TraceDrawings& drawings, std::ostream& out,
                    const ExpectedLanes& expected) {
  const std::string heading = xmlText(title.empty() ? "trace" : title);
  out << "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>" << heading << "</title><style>"
      << style << drawings.style << "</style></head><body>\n<h1>" << heading
      << "</h1>\n<p><button id=\"first\">first</button> <button id=\"previous\">previous change</button> <button "
         "id=\"back\">scan back</button> "
         "<button id=\"forward\">scan forward</button> <button id=\"next\">next change</button> <button "
         "id=\"last\">last</button> "
         "<button id=\"wider\">zoom out</button> <button id=\"closer\">zoom in</button> <b id=\"where\"></b></p>\n<div "
         "id=\"view\">\n"
      << timingDiagram(trace, "") << "</div>\n<div id=\"below\"><table id=\"values\"></table>\n<div id=\"drawings\">\n";
  for (const std::string& page : drawings.pages) out << page;
  if (drawings.pagesOf.size() < trace.rows.size() && !drawings.pages.empty())
    out << "<p>Scans behind the first " << drawings.pagesOf.size() << " are not drawn.</p>\n";
  out << "</div></div>\n<script type=\"application/json\" id=\"data\">" << dataJson(trace, drawings, expected)
      << "</script>\n<script>" << script << "</script>\n</body></html>\n";
}

extern constexpr TraceFormat htmlTrace = {
    .ending = ".html", .summary = "page with zoom and steps", .write = writeHtmlTrace};

}  // namespace rungproof
