// Settings in the page's address, behind '#': names and numbers or words of the controls, "motion=turn&rate=30&beside=thesis". Whoever
// wrote the address may be anybody; nothing of it but a number within a control's range goes any further.

const MOST_NAMED = 4;
const LONGEST_NAME = 40;

/** The control's numbers, or null for what is none of them. */
function numbersOf(control, text) {
  if (control.kind === 'choice') {
    const number = control.words.split('|').indexOf(text);
    return number >= 0 ? [number] : null;
  }
  const numbers = text.split(',').map((part) => (/^[-+]?[0-9]*[.]?[0-9]+(e[-+]?[0-9]+)?$/i.test(part) ? Number(part) : NaN));
  const fits = (v) => v >= control.low && v <= control.high;  // NaN does not
  return numbers.length === control.count && numbers.every(fits) ? numbers : null;
}

/** { settings: {name: numbers}, ignored: what is unknown or out of range, as text that is fit to be shown }. */
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

/** '' where nothing was ignored. */
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

/** Sets what the address of a page that shows an asset asks for, whenever that changes. */
export function followAddress(page) {
  takeAddress(page);
  addEventListener('hashchange', () => takeAddress(page));
}
