// The page's stylesheet. Each rule that sets a colour of text names its background too, unless that is white: a test
// computes the contrast of every pair.
#include "report/page.h"

namespace ups::report {

std::string page_style() {
  return R"(* { box-sizing: border-box; }
html { -webkit-text-size-adjust: 100%; }
body { margin: 0; background: #fff; color: #1b1f24; line-height: 1.5; font-size: 16px;
  font-family: system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Liberation Sans", sans-serif;
  print-color-adjust: exact; -webkit-print-color-adjust: exact; }
main, header, footer { max-width: 1080px; margin: 0 auto; padding: 0 1.5rem; }
header { padding-top: 2.5rem; }
header .kind { color: #57606a; font-size: .85em; letter-spacing: .08em; text-transform: uppercase; margin: 0; }
h1 { font-size: 2.1rem; line-height: 1.15; margin: .2rem 0 .5rem; overflow-wrap: anywhere; letter-spacing: -.01em; }
h2 { font-size: 1.4rem; line-height: 1.25; margin: 3rem 0 .8rem; padding-top: .9rem; border-top: 2px solid #1b1f24; }
h3 { font-size: 1.08rem; line-height: 1.3; margin: 1.8rem 0 .5rem; overflow-wrap: anywhere; }
p, ul { max-width: 46rem; margin: .5rem 0 .9rem; }
ul { padding-left: 1.2rem; }
li { margin: .2rem 0; overflow-wrap: anywhere; }
a { color: #0b5688; }
.soft, figcaption { color: #57606a; }

nav { margin: 1.2rem 0 0; font-size: .92em; }
nav ul { list-style: none; padding: 0; margin: 0; max-width: none; display: flex; flex-wrap: wrap; gap: .2rem 1.1rem; }

dl.facts { display: grid; grid-template-columns: repeat(auto-fill, minmax(min(100%, 15rem), 1fr)); gap: .2rem 2rem;
  margin: .8rem 0 1.4rem; }
dl.facts > div { padding: .35rem 0; border-bottom: 1px solid #d0d7de; }
dt { color: #57606a; font-size: .85em; }
dd { margin: 0; overflow-wrap: anywhere; }

.scroll { overflow-x: auto; margin: .8rem 0 1.4rem; }
table { border-collapse: collapse; font-size: .9em; font-variant-numeric: tabular-nums; width: 100%; }
caption { text-align: left; padding: 0 0 .5rem; font-weight: 600; caption-side: top; }
caption .soft { font-weight: 400; }
th, td { text-align: left; vertical-align: top; padding: .4rem .7rem .4rem 0; border-bottom: 1px solid #d0d7de; }
thead th { border-bottom: 2px solid #1b1f24; font-weight: 600; vertical-align: bottom; }
tbody th { font-weight: 500; }
.n { text-align: right; padding: .4rem 0 .4rem .7rem; white-space: nowrap; }
.i { display: block; color: #57606a; font-size: .9em; font-weight: 400; }

figure { margin: 1rem 0 1.4rem; max-width: 100%; }
figure svg, figure img { display: block; max-width: 100%; height: auto; }
figure > .scroll { margin: 0; }
figcaption { font-size: .9em; margin-top: .45rem; max-width: 46rem; }
.cards { display: grid; grid-template-columns: repeat(auto-fill, minmax(min(100%, 300px), 1fr)); gap: .5rem 2rem; }
.cards figure { margin: .5rem 0; }
.maps { grid-template-columns: repeat(auto-fill, minmax(min(100%, 430px), 1fr)); }

.verdict { display: inline-block; padding: .05rem .5rem; border-radius: 3px; font-weight: 600; font-size: .95em;
  white-space: nowrap; }
.met { color: #0f5a2a; background: #e1f3e6; }
.not_met { color: #8c1a1a; background: #fce8e8; }
.not_sure { color: #664500; background: #fff1cc; }
.answer { color: #1b1f24; background: #f3f6f9; border-left: 4px solid #0b5688; padding: .6rem 1.1rem;
  margin: 1.2rem 0; }
.answer p { margin: .3rem 0; }
.answer a { color: #0b5688; background: #f3f6f9; }

code { font: .88em/1.45 ui-monospace, "DejaVu Sans Mono", Menlo, Consolas, monospace; overflow-wrap: anywhere; }
pre { color: #1b1f24; background: #f3f6f9; padding: .7rem .9rem; white-space: pre-wrap; overflow-wrap: anywhere; }
footer { color: #57606a; font-size: .85em; padding-top: 2rem; padding-bottom: 3rem; }
:focus-visible { outline: 3px solid #0b5688; outline-offset: 2px; }

@media screen and (max-width: 640px) {
  main, header, footer { padding-left: 1rem; padding-right: 1rem; }
  header { padding-top: 1.5rem; }
  h1 { font-size: 1.6rem; }
  h2 { font-size: 1.25rem; margin-top: 2.2rem; }
  table { width: auto; min-width: 100%; }
  .wide svg { width: 560px; max-width: none; }
  .map svg { width: 480px; max-width: none; }
}

@page { size: A4; margin: 17mm 16mm 19mm;
  @bottom-left { content: "Lighting report"; font: 8pt sans-serif; }
  @bottom-right { content: counter(page) " / " counter(pages); font: 8pt sans-serif; } }
@media print {
  html, body { font-size: 9.5pt; }
  body, a { color: #000; }
  a { text-decoration: none; }
  main, header, footer { max-width: none; padding: 0; }
  nav { display: none; }
  h1 { font-size: 21pt; }
  h2 { font-size: 14pt; margin-top: 8mm; }
  h3 { font-size: 11pt; }
  h2, h3, caption { break-after: avoid; }
  p, ul { orphans: 3; widows: 3; }
  .scroll { overflow: visible; break-inside: avoid; }
  figure, tr, .answer, dl.facts > div, li { break-inside: avoid; }
  thead { display: table-header-group; }
  .page { break-before: page; }
  .page > h2 { margin-top: 0; }
  .wide svg { width: auto; max-height: 104mm; }
  .low svg { max-height: 62mm; }
  dl.facts { grid-template-columns: repeat(3, 1fr); }
  .cards { grid-template-columns: repeat(2, 1fr); }
  .maps { grid-template-columns: 1fr; }
  .map svg { width: 125mm; }
}
)";
}

}  // namespace ups::report
