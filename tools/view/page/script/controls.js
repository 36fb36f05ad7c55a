// The panel: a control for each row of the asset's table of controls.

const toSrgb = (v) => (v <= 0.0031308 ? 12.92 * v : 1.055 * v ** (1 / 2.4) - 0.055);
const toLinear = (v) => (v <= 0.04045 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4);

export function hexOf(linear) {
  const byte = (v) => Math.round(255 * toSrgb(Math.min(Math.max(v, 0), 1))).toString(16).padStart(2, '0');
  return `#${linear.map(byte).join('')}`;
}

export function linearOf(hex) {
  return [1, 3, 5].map((at) => toLinear(parseInt(hex.slice(at, at + 2), 16) / 255));
}

/** An element of HTML; attributes that are '' or undefined are left out. */
export function element(name, attributes = {}, ...children) {
  const made = document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) {
    if (value !== '' && value !== undefined) made.setAttribute(key, value);
  }
  made.append(...children);
  return made;
}

const shown = (value) => String(Number(value.toPrecision(4)));

/** Two inputs of one number: a slider, and a box for values outside of the slider's range. */
function numberInputs(control, id, set) {
  const range = { min: control.low, max: control.high, step: control.step };
  const slider = element('input', { type: 'range', id, ...range });
  const box = element('input', { type: 'number', step: 'any', 'aria-label': `${control.label}, number` });
  const take = (text) => {
    const value = Number(text);
    if (text === '' || !Number.isFinite(value)) return;
    set(0, value);
  };
  slider.addEventListener('input', () => { take(slider.value); box.value = shown(Number(slider.value)); });
  box.addEventListener('change', () => { take(box.value); slider.value = box.value; });
  const show = (value) => { slider.value = value; box.value = shown(value); };
  return { nodes: [slider, box], show: (values) => show(values[0]) };
}

function choiceInput(control, id, set) {
  const select = element('select', { id });
  control.words.split('|').forEach((word, i) => select.append(element('option', { value: i }, word)));
  select.addEventListener('change', () => set(0, Number(select.value)));
  return { nodes: [select], show: (values) => { select.value = values[0]; } };
}

function switchInput(control, id, set) {
  const box = element('input', { type: 'checkbox', id });
  box.addEventListener('change', () => set(0, box.checked ? 1 : 0));
  return { nodes: [box], show: (values) => { box.checked = values[0] !== 0; } };
}

/** A colour and its brightness, for light that is brighter than a screen's colours. */
function colorInputs(control, id, set) {
  const color = element('input', { type: 'color', id });
  const slider = element('input', { type: 'range', min: 0, max: control.high, step: control.step, 'aria-label': `${control.label}, brightness` });
  let hue = [1, 1, 1];
  const write = () => hue.forEach((v, i) => set(i, v * Number(slider.value)));
  color.addEventListener('input', () => {
    const linear = linearOf(color.value);
    const most = Math.max(...linear);
    hue = most > 0 ? linear.map((v) => v / most) : [1, 1, 1];
    write();
  });
  slider.addEventListener('input', write);
  const show = (values) => {
    const most = Math.max(...values);
    if (most > 0) hue = values.map((v) => v / most);
    slider.value = most;
    color.value = hexOf(hue);
  };
  return { nodes: [color, slider], show };
}

const INPUTS = { number: numberInputs, choice: choiceInput, switch: switchInput, color: colorInputs };

/** Fills `panel`. `wasm` holds the settings; `original` has the asset's own settings. */
export class Controls {
  constructor(panel, wasm, controls, original, changed) {
    this.wasm = wasm;
    this.original = original;
    this.rows = [];
    panel.replaceChildren();
    const groups = new Map();
    for (const control of controls.filter((c) => c.group !== '')) {
      if (control.kind === 'number' && control.low === control.high) continue;
      const open = ['Motion', 'Simulation', 'Hair'].includes(control.group) ? '' : undefined;
      if (!groups.has(control.group)) {
        const body = element('div', { class: 'rows' });
        const group = element('details', {}, element('summary', {}, control.group), body);
        group.open = open !== undefined;
        groups.set(control.group, body);
        panel.append(group);
      }
      groups.get(control.group).append(this.addRow(control, original, changed));
    }
    this.show();
  }

  addRow(control, original, changed) {
    const id = `control-${control.name}`;
    const set = (i, value) => {
      this.wasm.settings()[control.at + i] = value;
      this.mark(row);
      changed(control.name);
    };
    const { nodes, show } = INPUTS[control.kind](control, id, set);
    const reset = element('button', { type: 'button', class: 'reset', title: 'As it came', 'aria-label': `${control.label}: as it came` }, '↺');
    reset.addEventListener('click', () => {
      this.wasm.settings().set(original.subarray(control.at, control.at + control.count), control.at);
      this.show();
      changed(control.name);
    });
    const unit = control.unit ? element('span', { class: 'unit' }, ` ${control.unit}`) : '';
    const label = element('label', { for: id, title: control.hint }, control.label, unit);
    const line = element('div', { class: `row ${control.kind}` }, label, ...nodes, reset);
    const row = { control, show, line, original };
    this.rows.push(row);
    return line;
  }

  values(control) {
    return Array.from(this.wasm.settings().subarray(control.at, control.at + control.count));
  }

  mark(row) {
    const values = this.values(row.control);
    row.line.classList.toggle('changed', values.some((v, i) => v !== row.original[row.control.at + i]));
  }

  /** Shows settings that were changed elsewhere. */
  show() {
    for (const row of this.rows) {
      row.show(this.values(row.control));
      this.mark(row);
    }
  }
}
