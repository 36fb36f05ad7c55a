// The page: its layout, filled with its report. It contains both as JSON.

import { drawAgain, drawChart } from './chart.mjs';
import { filledText, isThere, namesOf, rowsOf } from './rows.mjs';
import { drawPivot, drawTable, element, pictureOf } from './table.mjs';

const dataOf = (id) => JSON.parse(document.getElementById(id).textContent);

function linksOf(of, report, scope) {
  const links = rowsOf(of, report, scope);
  if (links.length === 0) return [];
  const anchors = links.flatMap((link, i) => [...(i > 0 ? [', '] : []), element('a', { href: link.url }, link.text)]);
  return [element('p', {}, filledText(of.lead, report, scope), ...anchors)];
}

const figureOf = ({ png, caption }) => element('figure', {}, pictureOf(png, caption), element('figcaption', {}, caption));

/** Repeats the inner parts for each record of a list, or with "by" for each value. */
function partsOfEach(of, report, scope) {
  const rows = rowsOf({ ...of, rows: of.each }, report, scope);
  const scopes = of.by ? namesOf(rows, of.by).map((name) => ({ [of.by]: name })) : rows;
  return scopes.flatMap((inner) => of.parts.flatMap((part) => partOf(part, report, { ...scope, ...inner })));
}

const kinds = {
  heading: (part, report, scope) => [element('h2', {}, filledText(part.heading, report, scope))],
  summary: (part, report, scope) => [element('p', { class: 'summary' }, filledText(part.summary, report, scope))],
  text: (part, report, scope) => [element('p', {}, filledText(part.text, report, scope))],
  table: (part, report, scope) => [drawTable(part.table, report, scope)],
  pivot: (part, report, scope) => [drawPivot(part.pivot, report, scope)],
  chart: (part, report, scope) => [drawChart(part.chart, report, scope)],
  links: (part, report, scope) => linksOf(part.links, report, scope),
  pictures: (part, report, scope) => rowsOf({ rows: part.pictures }, report, scope).filter((one) => one.png).map(figureOf),
  each: partsOfEach,
};

function partOf(part, report, scope) {
  if (part.if !== undefined && ![part.if].flat().every((path) => isThere(path, report, scope))) return [];
  const kind = Object.keys(kinds).find((name) => name in part);
  return kinds[kind](part, report, scope);
}

function drawPage() {
  const report = dataOf('report');
  const place = document.getElementById('page');
  for (const part of dataOf('layout')) place.append(...partOf(part, report, {}));
}

drawPage();
matchMedia('(prefers-color-scheme: dark)').addEventListener('change', drawAgain);
for (const [event, isPaper] of [['beforeprint', true], ['afterprint', false]]) {
  addEventListener(event, () => {
    document.documentElement.classList.toggle('paper', isPaper);
    drawAgain();
  });
}
