// The part of the page that talks to a cooking server: it shows each new asset, and sends slider values to the server.

import { RecipeKeys } from './recipe_keys.js';

const PAUSE = 120;  // milliseconds without a change, after which a slider counts as set
const isObject = (value) => value !== null && typeof value === 'object' && !Array.isArray(value);

/** `changes` laid over `recipe`, section by section. */
export function merged(recipe, changes) {
  const all = { ...recipe };
  for (const [key, value] of Object.entries(changes)) all[key] = isObject(value) && isObject(all[key]) ? merged(all[key], value) : value;
  return all;
}

/** The colour of a recipe's file. */
const ownColor = (recipeFile) => (Array.isArray(recipeFile.material?.base_color) ? recipeFile.material.base_color : [1, 1, 1, 1]);

/** The page's recipe for the server, where the tint is a factor of the file's colour. */
export function forFile(tuned, recipeFile) {
  const factor = tuned.material?.base_color;
  if (!factor) return tuned;
  const color = factor.map((v, i) => Number((v * ownColor(recipeFile)[i]).toPrecision(6)));
  return { ...tuned, material: { ...tuned.material, base_color: color } };
}

/** The whole recipe of the shown hair: the file's, with the sliders' values. */
export const wholeRecipe = (recipeFile, tuned) => withoutNulls(merged(recipeFile, forFile(tuned, recipeFile)));

/** For the server, null removes a key. */
function withoutNulls(recipe) {
  const kept = Object.entries(recipe).filter(([, value]) => value !== null);
  return Object.fromEntries(kept.map(([key, value]) => [key, isObject(value) ? withoutNulls(value) : value]));
}

export class Live {
  /** `title`: the element for the name of the shown asset. */
  constructor(page, title) {
    this.page = page;
    this.line = document.createElement('span');
    this.line.id = 'cooked';
    this.line.setAttribute('role', 'status');
    title.append(this.line);
    document.getElementById('file').accept = '';
    document.querySelector('#recipe p').textContent = "All of the recipe, the file's and what you changed. In place of the file, it cooks what you see.";
    this.news = Promise.resolve();
    this.revision = 0;
    this.sent = '{}';
    this.recipeFile = {};
    this.timer = 0;
  }

  /** Resolves when an asset is shown or cannot be shown. */
  async begin() {
    this.keys = new RecipeKeys(await (await fetch('keys')).json(), () => { this.page.wake(); this.changed(); });
    return new Promise((shown) => {
      this.events = new EventSource('events');
      this.events.addEventListener('message', (event) => {
        this.news = this.news.then(() => this.take(JSON.parse(event.data))).then((ended) => { if (ended) shown(); });
      });
      this.events.addEventListener('error', () => {
        this.tell('coif view has ended. Start it again, and open the address that it prints.', true);
        shown();
      });
    });
  }

  tell(text, isProblem = false) {
    this.line.textContent = text;
    this.line.classList.toggle('problem', isProblem);
  }

  /** Handles a state of the server. False while the first cook runs. */
  async take(state) {
    this.state = state;
    this.keys.isDraft = state.quality === 'draft';
    try {
      if (state.revision > this.revision) await this.replace(state);
      this.tell(state.problem || this.told(state), state.problem !== '');
    } catch (error) {
      this.tell(error.message, true);
    }
    return this.revision > 0 || state.problem !== '';
  }

  told(state) {
    if (state.cooking || state.revision === 0) return 'Cooking ...';
    const warnings = state.warnings.map(({ message, code }) => `\nWarning: ${message} [${code}]`).join('');
    return `Cooked as ${state.quality === 'draft' ? 'a draft' : 'games get it'} in ${state.seconds.toFixed(2)} s.${warnings}`;
  }

  async replace(state) {
    const response = await fetch('asset');
    const revision = Number(response.headers.get('Coif-Revision'));
    if (!response.ok || revision !== state.revision) return;  // there is a newer one, which the server will announce
    const bytes = new Uint8Array(await response.arrayBuffer());
    this.revision = revision;
    this.recipeFile = state.recipe_file;
    const keys = new Set(Object.entries(state.changes).flatMap(([section, of]) => Object.keys(of).map((key) => `${section}.${key}`)));
    if (state.name === this.page.name) this.page.replace(bytes, state.name, keys);
    else this.page.open(bytes, state.name);
    this.keys.takeFile(state.recipe_file);
    const cooked = state.changes.material?.base_color, own = ownColor(state.recipe_file);
    this.page.set('cooked_color', [0, 1, 2].map((i) => (cooked && own[i] > 0 && state.name === this.shown ? cooked[i] / own[i] : 1)));
    this.shown = state.name;
  }

  /** A slider was moved. */
  changed() {
    clearTimeout(this.timer);
    this.timer = setTimeout(() => this.send(), PAUSE);
  }

  async send() {
    const text = JSON.stringify(forFile(this.page.recipe(), this.recipeFile));
    if (text === this.sent) return;
    this.sent = text;
    await this.post('recipe', text);
  }

  /** The server cooks models; assets are shown directly. */
  takes(file) { return !file.name.endsWith('.coif'); }

  /** Cooks a model that was dropped on the page, in place of the shown one and with the defaults. */
  async drop(file) {
    const format = file.name.split('.').pop().toLowerCase();
    this.sent = '{}';
    await this.post(`model?${new URLSearchParams({ format, name: file.name })}`, file);
  }

  async post(place, body) {
    try {
      const response = await fetch(place, { method: 'POST', body, headers: { 'Content-Type': 'application/octet-stream' } });
      const { problem } = await response.json();
      if (problem) this.tell(problem, true);
    } catch (error) {
      this.tell(`coif view did not take it: ${error.message}`, true);
    }
  }
}
