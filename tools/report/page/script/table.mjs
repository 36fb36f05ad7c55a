// Tables of a report: a row for each record, or (pivot) a row for each value of one key and a column for each of another.

import { lookOf, valueText } from './format.mjs';
import { namesOf, rowsOf } from './rows.mjs';

/** An element with this text and these children; text never becomes markup. */
export function element(tag, attributes = {}, ...children) {
  const made = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (value !== '' && value !== undefined) made.setAttribute(name, value);
  }
  made.append(...children);
  return made;
}

export const pictureOf = (png, alt) => element('img', { alt, src: `data:image/png;base64,${png}` });

const kindClass = (column) => ({ number: 'number', prose: 'prose' })[column.kind] ?? '';

function cellOf(parts, kind) {
  const cell = element('td', { class: [kind, ...parts.map((part) => part.look)].filter(Boolean).join(' ') });
  parts.filter((part) => part.text !== '').forEach((part, i) => {
    if (i > 0) cell.append(document.createElement('br'));
    cell.append(part.text);
  });
  return cell;
}

function cellOfRow(row, column) {
  const value = row[column.key] ?? null;
  if (column.kind === 'picture') return element('td', {}, ...(value ? [pictureOf(value, '')] : []));
  const look = lookOf(value, column);
  const lines = Array.isArray(value) && value.every((one) => typeof one === 'string') ? value : [valueText(value, column)];
  return cellOf(lines.map((text) => ({ text, look })), kindClass(column));
}

function tableOf(titles, bodyRows) {
  const head = element('tr', {}, ...titles.map(({ title, kind }) => element('th', { scope: 'col', class: kind }, title)));
  const table = element('table', {}, element('thead', {}, head), element('tbody', {}, ...bodyRows));
  return element('div', { class: 'table', role: 'region', 'aria-label': 'table', tabindex: 0 }, table);
}

/** `of`: "rows" with "where" and "not", and "columns" if the report has none for that list. */
export function drawTable(of, report, scope) {
  const columns = of.columns ?? report.columns[of.rows];
  const rows = rowsOf(of, report, scope).map((row) => element('tr', {}, ...columns.map((column) => cellOfRow(row, column))));
  return tableOf(columns.map((column) => ({ title: column.title, kind: kindClass(column) })), rows);
}

/** `of`: "rows", the keys "down" and "across", "cells" (columns of the list whose values stand one below the other), and "notes". */
export function drawPivot(of, report, scope) {
  const rows = rowsOf(of, report, scope);
  const across = namesOf(rows, of.across);
  const noteOf = (name) => rowsOf({ rows: of.notes.rows, where: { [of.down]: name } }, report)[0]?.[of.notes.key] ?? '';
  const cells = of.cells.map((cell) => ({ ...report.columns[of.rows].find((column) => column.key === cell.key), ...cell }));
  const partsOf = (row) => cells.map((cell) => ({ text: valueText(row[cell.key], cell), look: lookOf(row[cell.key], cell) }));
  const body = namesOf(rows, of.down).map((name) => {
    const values = across.map((column) => {
      const row = rows.find((one) => one[of.down] === name && one[of.across] === column);
      return cellOf(row ? partsOf(row) : [{ text: '-' }], of.kind ?? '');
    });
    const notes = of.notes ? [cellOf([{ text: noteOf(name) }], 'prose')] : [];
    return element('tr', {}, element('td', {}, name), ...notes, ...values);
  });
  const notes = of.notes ? [{ title: of.notes.title, kind: 'prose' }] : [];
  return tableOf([{ title: of.title }, ...notes, ...across.map((title) => ({ title, kind: of.kind }))], body);
}
