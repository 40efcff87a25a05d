// Style sheet and script of pages.
#include "frontend/acceptance/page_style.hpp"

namespace rungproof {

// Drawings stay dark on white, as on paper, whatever the colours of the screen are.
std::string_view pageStyle() {
  return R"(
:root{--ink:#1a1f26;--soft:#57606a;--line:#d0d7de;--back:#fff;--pale:#f6f8fa;--good:#1b7f37;--bad:#b3261e;--open:#955800;--link:#0b57b0}
@media screen and (prefers-color-scheme:dark){:root{--ink:#e6edf3;--soft:#9198a1;--line:#30363d;--back:#0d1117;--pale:#161b22;--good:#4ac26b;--bad:#ff7b72;--open:#d29922;--link:#79b8ff}}
*{box-sizing:border-box}
body{font:15px/1.5 system-ui,"Segoe UI","Liberation Sans",Arial,sans-serif;max-width:72rem;margin:0 auto;padding:1.5rem 1.25rem 3rem;color:var(--ink);background:var(--back);overflow-wrap:break-word}
h1{font-size:1.6rem;line-height:1.25;margin:.1em 0 .3em}
h2{font-size:1.2rem;margin:2.2em 0 .7em;padding-bottom:.2em;border-bottom:1px solid var(--line)}
h3{font-size:1.05rem;margin:1.8em 0 .4em}h4{font-size:.95rem;margin:1em 0 .3em}
p{margin:.4em 0}a{color:var(--link)}
a.anchor{visibility:hidden;text-decoration:none;padding-left:.3em;font-weight:normal}h2:hover a.anchor,h3:hover a.anchor,a.anchor:focus{visibility:visible}
code,pre,.mono{font-family:"DejaVu Sans Mono",Consolas,Menlo,"Liberation Mono",monospace;font-size:.9em}
pre{background:var(--pale);padding:.6em .8em;overflow-x:auto;margin:.4em 0}
code.statement{display:block;white-space:pre-wrap;background:var(--pale);padding:.4em .7em;margin:.3em 0}
table{border-collapse:collapse;margin:.5em 0}
td,th{padding:.3em .7em;border:1px solid var(--line);text-align:left;vertical-align:top}
th{background:var(--pale);font-weight:600}
.wide{width:100%}.number{text-align:right;font-variant-numeric:tabular-nums}
.kind{color:var(--soft);text-transform:uppercase;letter-spacing:.08em;font-size:.8rem;margin:0}
.summary{font-size:1.05rem;margin:.2em 0 1em}
.place,.quiet{color:var(--soft)}.good{color:var(--good)}.bad{color:var(--bad)}.open{color:var(--open)}
.word{font-weight:700;white-space:nowrap}
.also{color:var(--soft);font-style:italic}.also::before{content:"\28"}.also::after{content:"\29"}
.hash{font-size:.82em;word-break:break-all}
dl.facts{display:grid;grid-template-columns:max-content 1fr;gap:.15em 1.2em;margin:.5em 0}dl.facts dt{color:var(--soft)}dl.facts dd{margin:0;min-width:0}
article.finding{margin:1em 0;padding-left:.8em;border-left:4px solid var(--soft)}article.error{border-color:var(--bad)}article.warning{border-color:var(--open)}article.note{border-color:var(--link)}
mark{background:#ffd6d6;color:#1a1f26}
figure{margin:.5em 0;overflow-x:auto;background:#fff;color:#1a1f26}figcaption{font-weight:600;font-size:.9em;padding:.2em 0}
figure svg{display:block}
.run{border:1px solid var(--line);border-radius:4px;margin:.8em 0;padding:.5em .9em;background:#fff;color:#1a1f26}.run:focus{outline:2px solid #0b62d6}
.run .quiet,.run .also,.run th{color:#57606a}.run th{background:#f6f8fa}.run td,.run th{border-color:#d0d7de}.run a{color:#0b57b0}
.scroll{overflow-x:auto}.steps button{font:inherit;padding:.15em .7em;margin:0 .2em .2em 0}
.sign td{height:3.2em;min-width:7em}.sign .role{height:auto;white-space:nowrap}
@media screen{[hidden]{display:none!important}}
@media screen and (max-width:640px){
body{font-size:14px;padding:1rem .7rem 2rem}h1{font-size:1.3rem}
dl.facts{grid-template-columns:1fr;gap:0}dl.facts dd{margin:0 0 .5em}
table.cards,table.cards tbody,table.cards tr,table.cards td{display:block;width:auto}table.cards thead{display:none}
table.cards tr{border:1px solid var(--line);margin:.6em 0;padding:.3em .5em}table.cards td{border:0;padding:.1em .2em;text-align:left}
table.cards td:empty{display:none}table.cards td[data-label]::before{content:attr(data-label) ": ";color:var(--soft)}
.sign td{min-width:0}
}
@page{size:A4;margin:16mm 14mm 18mm;@bottom-right{content:"page " counter(page) " of " counter(pages);font:8pt sans-serif;color:#57606a}}
@media print{
:root{--ink:#000;--soft:#444;--line:#999;--pale:#f3f3f3;--good:#155d29;--bad:#9b1c15;--open:#7a4800;--link:#000}
body{font-size:9.5pt;max-width:none;padding:0;margin:0}
h1{font-size:16pt}h2{font-size:12.5pt;margin-top:1.4em}h3{font-size:11pt;margin-top:1.1em}
h2,h3,h4,figcaption,code.statement,.property>p{break-after:avoid}tr,figure,article.finding,.sign,dl.facts{break-inside:avoid}thead{display:table-header-group}
a{text-decoration:none}a.anchor,.steps,.screen{display:none!important}
.run{border:0;padding:0;margin:.4em 0}.scan[hidden],figure[hidden]{display:block!important}figure.again{display:none!important}
figure{overflow:visible;margin:.3em 0}figure svg,.scroll svg{max-width:100%;height:auto}.scroll{overflow:visible}pre{white-space:pre-wrap;overflow:visible}
td,th{padding:.2em .45em}.hash{font-size:7pt}
}
@media screen{.paper{display:none}}
)";
}

std::string_view pageScript() {
  return R"(
(() => {
"use strict";
for (const run of document.querySelectorAll(".run")) {
  const scans = [...run.querySelectorAll(".scan")], where = run.querySelector(".where");
  if (scans.length === 0) continue;
  let at = scans.length - 1;
  const show = to => {
    at = Math.max(0, Math.min(scans.length - 1, to));
    scans.forEach((scan, i) => { scan.hidden = i !== at; });
    where.textContent = `${at + 1} of ${scans.length}`;
  };
  const steps = {first: () => 0, back: () => at - 1, forward: () => at + 1, last: () => scans.length - 1};
  for (const name in steps) run.querySelector("." + name).onclick = () => show(steps[name]());
  const keys = {ArrowLeft: "back", ArrowRight: "forward", Home: "first", End: "last"};
  run.onkeydown = e => { if (keys[e.key]) { show(steps[keys[e.key]]()); e.preventDefault(); } };
  run.querySelector(".steps").hidden = false;
  show(at);
}
})();
)";
}

}  // namespace rungproof
