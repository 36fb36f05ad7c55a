// Values as text, by the patterns of report_format.h; with numbers as in base/text.h, so that terminal and page agree.

export function numberText(number) {
  if (!Number.isFinite(number)) return '-';
  const size = Math.abs(number);
  if (size === 0) return '0';
  if (size < 1e-4) return '<0.0001';
  if (size >= 1e6 || size < 1e-3) return number.toExponential(1).replace(/e([+-])(\d)$/, 'e$10$2');
  const digits = size >= 100 ? 0 : size >= 10 ? 1 : size >= 1 ? 2 : size >= 0.1 ? 3 : 4;
  return number.toFixed(digits);
}

const percentText = (number) => (Number.isFinite(number) ? `${numberText(number)} %` : numberText(number));

/** Units; 1000 of one are one of the next. */
function scaledText(number, units) {
  let unit = 0;
  for (; number >= 1000 && unit + 1 < units.length; ++unit) number /= 1000;
  return `${numberText(number)} ${units[unit]}`;
}

function fixedText(number, place) {
  const [, sign, digits] = /^\{:(\+?)\.(\d+)f\}$/.exec(place) ?? [];
  if (digits === undefined) return String(number);
  return (sign && number >= 0 ? '+' : '') + number.toFixed(Number(digits));
}

function numberAs(place, number) {
  switch (place) {
    case '{number}': return numberText(number);
    case '{percent}': return percentText(number);
    case '{time}': return scaledText(number, ['ns', 'us', 'ms', 's']);
    case '{bytes}': return scaledText(number, ['bytes', 'kB', 'MB', 'GB']);
    default: return fixedText(number, place);
  }
}

/** `format`: a column or another object with "pattern", "missing" and "scale". */
export function valueText(value, format = {}) {
  if (value === null || value === undefined) return format.missing ?? '-';
  const pattern = format.pattern ?? (typeof value === 'boolean' ? 'yes|no' : '{}');
  if (typeof value === 'boolean') return pattern.split('|')[value ? 0 : 1];
  const [before, place, after] = /^([^{]*)(\{[^}]*\})(.*)$/s.exec(pattern)?.slice(1) ?? ['', '{}', ''];
  const one = (part) => (typeof part === 'number' ? numberAs(place, part * (format.scale ?? 1)) : String(part));
  return before + (Array.isArray(value) ? value.map(one).join(' ') : one(value)) + after;
}

/** The first of a column's rules that fits: "good", "neutral", "warning", "bad", or nothing. A list counts as its length. */
export function lookOf(value, column) {
  const number = Array.isArray(value) ? value.length : value ?? NaN;
  const fits = (rule) => {
    if ('is' in rule) return value === rule.is;
    if ('least' in rule && !(number >= rule.least)) return false;
    return !('most' in rule) || number <= rule.most;
  };
  return (column.looks ?? []).find(fits)?.look ?? '';
}
