// Inputs for all keys of a recipe that have no control of their own, from the cook's table of keys. Only if a server cooks.

import { element } from './controls.js';

const KINDS = ['number', 'whole', 'choice', 'switch'];
const CROWDED = 0.1;  // share of the range; a default below it gets a slider with more room for small numbers

const rangeOf = (key) => (key.low < key.high ? `${key.low} to ${key.high}${key.unit ? ` ${key.unit}` : ''}` : '');

/** null: the cook chooses. */
const told = (value) => (value === null ? 'chosen by the cook' : String(value));

export class RecipeKeys {
  /** `table`: from the server. `changed()` is called after each change. */
  constructor(table, changed) {
    this.table = table;
    this.changed = changed;
    this.values = new Map();  // the visitor's changes, by path
    this.file = {};
    this.rows = [];
    this.isDraft = false;  // the shown draft ignores some of them
  }

  /** [section, [key, value]...] as a recipe. */
  recipe() {
    const recipe = {};
    for (const [path, value] of this.values) {
      const [section, key] = path.split('.');
      (recipe[section] ??= {})[key] = value;
    }
    return recipe;
  }

  /** Takes the values of the recipe's file, to which keys are reset. */
  takeFile(file) {
    this.file = file;
    this.rows.forEach((row) => this.show(row));
  }

  own(key) { return this.file[key.section]?.[key.name] ?? key.default; }
  value(key) { return this.values.has(key.path) ? this.values.get(key.path) : this.own(key); }

  set(row, value) {
    if (value === this.own(row.key)) this.values.delete(row.key.path);
    else this.values.set(row.key.path, value);
    this.show(row);
    this.changed();
  }

  /** Adds the inputs to the panel, behind its groups, except those that `controls` already has. */
  enter(panel, controls) {
    const taken = new Set(controls.map((c) => c.recipe));
    this.rows = [];
    this.values.clear();
    const search = element('input', { type: 'search', placeholder: 'Search keys', 'aria-label': 'Search keys of the recipe', id: 'search-keys' });
    const none = element('p', { class: 'help', hidden: 'hidden' }, 'No key is called so.');
    const draft = element('p', { class: 'help' }, 'This is a draft: one level of detail, small textures, no occlusion, drawn by distance. What else is set of those shows with --quality full.');
    const body = element('div', { class: 'keys' }, search, ...(this.isDraft ? [draft] : []), none);
    const sections = new Map();
    for (const key of this.table.filter((k) => KINDS.includes(k.kind) && !taken.has(k.path))) {
      if (!sections.has(key.section)) {
        const rows = element('div', { class: 'rows' });
        sections.set(key.section, element('details', {}, element('summary', {}, key.section), rows));
        body.append(sections.get(key.section));
      }
      sections.get(key.section).lastChild.append(this.addRow(key));
    }
    search.addEventListener('input', () => this.filter(search.value, [...sections.values()], none));
    panel.append(element('details', { id: 'recipe-keys' }, element('summary', {}, 'Everything else in a recipe'), body));
    this.rows.forEach((row) => this.show(row));
  }

  addRow(key) {
    const id = `key-${key.section}-${key.name}`;
    const row = { key };
    const { nodes, show } = this.inputs(row, id);
    const reset = element('button', { type: 'button', class: 'reset', title: "As the recipe's file has it", 'aria-label': `${key.path}: as the file has it` }, '↺');
    reset.addEventListener('click', () => this.set(row, this.own(key)));
    const range = rangeOf(key);
    const facts = `${range ? `${range}; ` : ''}default ${told(key.default)}`;
    row.node = element('div', { class: 'key' },
                       element('div', { class: `row ${nodes.length > 1 ? 'number' : 'short'}` }, element('label', { for: id, title: key.path }, key.name), ...nodes, reset),
                       element('p', { class: 'help', id: `${id}-help` }, `${key.meaning} (${facts})`));
    nodes[nodes.length - 1].setAttribute('aria-describedby', `${id}-help`);
    row.shows = show;
    row.words = `${key.path} ${key.path.replaceAll('_', ' ')} ${key.meaning} ${key.choices ?? ''}`.toLowerCase();
    this.rows.push(row);
    return row.node;
  }

  inputs(row, id) {
    const { key } = row;
    if (key.kind === 'switch') {
      const box = element('input', { type: 'checkbox', id });
      box.addEventListener('change', () => this.set(row, box.checked));
      return { nodes: [box], show: (value) => { box.checked = value; } };
    }
    if (key.kind === 'choice') {
      const select = element('select', { id }, ...key.choices.split('|').map((word) => element('option', { value: word }, word)));
      select.addEventListener('change', () => this.set(row, select.value));
      return { nodes: [select], show: (value) => { select.value = value; } };
    }
    return this.numberInputs(row, id);
  }

  numberInputs(row, id) {
    const { key } = row;
    const isWhole = key.kind === 'whole';
    const step = isWhole ? 1 : 'any';
    const box = element('input', { type: 'number', id, step, min: String(key.low), max: String(key.high), placeholder: key.default === null ? 'auto' : undefined });
    const take = (text) => {
      const value = text === '' ? null : Number(text);
      if (value === null ? key.default !== null : !Number.isFinite(value)) return this.show(row);
      this.set(row, value !== null && isWhole ? Math.round(value) : value);
    };
    box.addEventListener('change', () => take(box.value));
    if (key.default === null) return { nodes: [box], show: (value) => { box.value = value ?? ''; } };  // no place on a slider
    const span = key.high - key.low;
    const power = (key.default - key.low) / span < CROWDED ? 3 : 1;
    const slider = element('input', { type: 'range', min: '0', max: '1', step: '0.001', 'aria-label': key.path });
    slider.addEventListener('input', () => take(String(Math.min(Number((key.low + span * slider.value ** power).toPrecision(3)), key.high))));
    const show = (value) => {
      box.value = value;
      if (document.activeElement !== slider) slider.value = ((value - key.low) / span) ** (1 / power);
      slider.setAttribute('aria-valuetext', `${value} ${key.unit}`);
    };
    return { nodes: [slider, box], show };
  }

  show(row) {
    row.shows(this.value(row.key));
    row.node.classList.toggle('changed', this.values.has(row.key.path));
    row.node.firstChild.classList.toggle('changed', this.values.has(row.key.path));
  }

  filter(text, sections, none) {
    const words = text.toLowerCase().split(/\s+/).filter((word) => word !== '');
    let found = 0;
    for (const row of this.rows) {
      const fits = words.every((word) => row.words.includes(word));
      row.node.hidden = !fits;
      found += fits ? 1 : 0;
    }
    for (const section of sections) {
      section.hidden = [...section.querySelectorAll('.key')].every((node) => node.hidden);
      section.open = words.length > 0 && !section.hidden;
    }
    none.hidden = found > 0;
  }
}
