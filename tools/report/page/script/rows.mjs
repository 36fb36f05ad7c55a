// Reads a layout's requests from a report: lists, single values, and texts with values.

import { valueText } from './format.mjs';

const own = (object, key) => (object !== null && typeof object === 'object' && Object.hasOwn(object, key) ? object[key] : undefined);

/** The value at a path such as "memory.bytes_shared": in the layout's current record, else in the report. */
export function valueAt(path, report, scope = {}) {
  const within = (object) => path.split('.').reduce(own, object);
  return within(scope) ?? within(report);
}

/** The text with "{path}" and "{path|pattern}" filled in: "at {main_fps} frames per second", "{memory.bytes_shared|:.0f} bytes". */
export function filledText(text, report, scope = {}) {
  return text.replace(/\{([\w.]+)(?:\|([^}]+))?\}/g, (_, path, pattern) =>
    valueText(valueAt(path, report, scope), pattern ? { pattern: `{${pattern}}` } : {}));
}

/** Whether a path has a value: a non-empty list, a non-empty text, or a number. */
export function isThere(path, report, scope) {
  const value = valueAt(path, report, scope);
  return Array.isArray(value) ? value.length > 0 : value !== undefined && value !== null && value !== '' && value !== false;
}

/** Records of the list `of.rows` that match `of.where` (a value or one of several) and do not match `of.not`. */
export function rowsOf(of, report, scope = {}) {
  const wanted = (value) => (typeof value === 'string' ? filledText(value, report, scope) : value);
  const has = (row, [key, value]) => [value].flat().map(wanted).some((one) => own(row, key) === one);
  const list = valueAt(of.rows, report, scope);
  if (!Array.isArray(list)) return [];
  return list.filter((row) => Object.entries(of.where ?? {}).every((one) => has(row, one)) &&
                              !Object.entries(of.not ?? {}).some((one) => has(row, one)));
}

/** The values under a key, each once, in the order in which they first occur. */
export const namesOf = (rows, key) => [...new Set(rows.map((row) => own(row, key)))];
