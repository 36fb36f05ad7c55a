#pragma once

namespace coif {

/// Style sheet of every page. Wide tables scroll in their own frame so that their header can stay in sight; on paper
/// they run on, the header repeats on every sheet and the colours are printed.
inline constexpr char kPageStyle[] = R"(:root {
  color-scheme: light dark;
  --text: #1d2228; --ground: #ffffff; --raised: #f1f3f5; --line: #cfd4da;
  --good: #cdeccf; --neutral: #e2e5e9; --warning: #fbe3ad; --bad: #f7c4c0;
}
@media (prefers-color-scheme: dark) {
  :root {
    --text: #e3e6ea; --ground: #16191d; --raised: #22272d; --line: #3d444c;
    --good: #1f4d2a; --neutral: #363c44; --warning: #5f4a12; --bad: #6b2723;
  }
}
body { color: var(--text); background: var(--ground); font: 15px/1.5 system-ui, sans-serif;
  max-width: 82rem; margin: 2rem auto; padding: 0 1.5rem; }
h1 { font-size: 1.6rem; }
h2 { font-size: 1.2rem; margin-top: 2.2rem; break-after: avoid; border-bottom: 1px solid var(--line); }
p { max-width: 52rem; }
.summary { font-size: 1.1rem; background: var(--raised); border-left: 4px solid #2f8fd8; padding: 0.7rem 1rem; }
.table { overflow: auto; max-height: 90vh; margin: 1rem 0; }
table { border-collapse: collapse; }
th, td { padding: 0.2rem 0.7rem; border-bottom: 1px solid var(--line); text-align: left; vertical-align: top;
  white-space: nowrap; }
th { position: sticky; top: 0; background: var(--raised); }
.prose { white-space: normal; min-width: 11rem; }
.number { text-align: right; font-variant-numeric: tabular-nums; }
.good { background: var(--good); }
.neutral { background: var(--neutral); }
.warning { background: var(--warning); }
.bad { background: var(--bad); }
figure { margin: 1.5rem 0; break-inside: avoid; }
figure svg { width: 100%; max-width: 60rem; height: auto; }
figure img { max-width: 100%; }
figcaption { font-size: 0.9rem; max-width: 52rem; }
@media print {
  :root { --text: #000000; --ground: #ffffff; --raised: #f1f3f5; --line: #cfd4da;
    --good: #cdeccf; --neutral: #e2e5e9; --warning: #fbe3ad; --bad: #f7c4c0; }
  body { max-width: none; margin: 0; font-size: 10pt; }
  .table { overflow: visible; max-height: none; }
  th { position: static; }
  thead { display: table-header-group; }
  tr { break-inside: avoid; }
  table { font-size: 8pt; }
  th { white-space: normal; }
  th, td { padding: 0.1rem 0.4rem; print-color-adjust: exact; }
  .prose { min-width: 6rem; }
}
)";

}  // namespace coif
