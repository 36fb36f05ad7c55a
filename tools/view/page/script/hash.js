// Settings in the page's address, behind '#': names and numbers or words of the controls, "motion=turn&rate=30&beside=thesis". The
// address is untrusted: only numbers within a control's range are used.

const MOST_NAMED = 4;
const LONGEST_NAME = 40;

/** The control's numbers, or null for an invalid text. */
function numbersOf(control, text) {
  if (control.kind === 'choice') {
    const number = control.words.split('|').indexOf(text);
    return number >= 0 ? [number] : null;
  }
  const numbers = text.split(',').map((part) => (/^[-+]?[0-9]*[.]?[0-9]+(e[-+]?[0-9]+)?$/i.test(part) ? Number(part) : NaN));
  const fits = (v) => v >= control.low && v <= control.high;  // NaN does not
  return numbers.length === control.count && numbers.every(fits) ? numbers : null;
}

/** { settings: {name: numbers}, ignored: unknown or invalid settings, as harmless text }. */
function settingsOfHash(hash, table) {
  const settings = {};
  const ignored = [];
  for (const [name, text] of new URLSearchParams(hash.replace(/^#/, ''))) {
    const control = table.find((row) => row.name === name);
    const numbers = control ? numbersOf(control, text) : null;
    if (numbers) settings[control.name] = numbers;
    else ignored.push(`${name}=${text}`.slice(0, LONGEST_NAME));
  }
  return { settings, ignored };
}

/** The message about ignored settings; '' if there are none. */
function noteOfHash(ignored) {
  if (ignored.length === 0) return '';
  const more = ignored.length > MOST_NAMED ? ` and ${ignored.length - MOST_NAMED} more` : '';
  return `Left out of this page's address, which it does not know or which is out of range: ${ignored.slice(0, MOST_NAMED).join(', ')}${more}.`;
}

function takeAddress(page) {
  const { settings, ignored } = settingsOfHash(location.hash, page.table);
  document.getElementById('address-note').textContent = noteOfHash(ignored);
  for (const [name, numbers] of Object.entries(settings)) page.set(name, numbers);
  if (settings.motion && !settings.plays) page.set('plays', 1);
  page.controls.show();
  page.changed('beside');
}

/** Applies the settings of the page's address, whenever it changes. */
export function followAddress(page) {
  takeAddress(page);
  addEventListener('hashchange', () => takeAddress(page));
}
