// The page: opens its asset, draws while something moves, and has functions for other scripts.

import { takeBody } from './body.js';
import { Controls } from './controls.js';
import { Hands } from './hands.js';
import { followAddress } from './hash.js';
import { showLegend } from './legend.js';
import { Live, merged } from './live.js';
import { beginMotion, takeMotion } from './motion.js';
import { showNumbers } from './numbers.js';
import { recipeOf } from './recipe.js';
import { offerRecipe } from './recipe_dialog.js';
import { Sheet, sheetPlan } from './sheet.js';
import { MOTION_KEYS, Tuning } from './tuning.js';
import { WasmPage } from './wasm_page.js';

const at = (id) => document.getElementById(id);
const MOST_PIXELS = 2;  // canvas pixels per pixel of the page, each way

class Page {
  constructor(wasm) {
    this.wasm = wasm;
    this.canvas = at('picture');
    this.last = 0;
    this.waiting = 0;
    this.rate = 0;
    this.isLost = false;
  }

  /** Opens an asset's bytes; `name` is the file's name. */
  open(bytes, name) {
    this.wasm.open(bytes);
    this.sheet?.leave();
    this.name = name;
    this.table = this.wasm.controls();
    this.original = this.wasm.settings().slice();
    this.set('zoom', 0.9);  // room for hair that swings
    if (devicePixelRatio >= 1.5) this.set('samples', 1);
    beginMotion(this);
    this.controls = new Controls(at('controls'), this.wasm, this.table, this.wasm.settings().slice(), (name) => this.changed(name));
    this.tuning = new Tuning(this);
    this.tuning.enter(this.controls);
    this.live?.keys.enter(at('controls'), this.table);
    at('name').textContent = name;
    document.title = `${name} - coif view`;
    this.say('');
    this.wake();
  }

  /** Shows another cook of the same hair: camera, motion and tuned values stay. `cooked`: the recipe's keys that came from this page. */
  replace(bytes, name, cooked) {
    const before = this.wasm.settings().slice();
    this.wasm.replace(bytes);
    const table = this.wasm.controls();
    if (JSON.stringify(table) !== JSON.stringify(this.table)) return this.open(bytes, name);
    const settings = this.wasm.settings();
    const saysMotion = MOTION_KEYS.some((key) => cooked.has(key));
    if (saysMotion) MOTION_KEYS.forEach((key) => cooked.add(key));  // the server gets them together
    for (const { at: place, count, recipe } of table) {
      for (let i = place; i < place + count; ++i) {
        const isTuned = before[i] !== this.original[i];
        if (recipe && !cooked.has(recipe)) this.controls.original[i] = this.original[i] = settings[i];
        settings[i] = recipe && !isTuned ? this.original[i] : before[i];
      }
    }
    this.wasm.accept(saysMotion);
    this.tuning.takeOwn();
    this.controls.show();
    this.wake();
  }

  control(name) {
    const found = this.table.find((c) => c.name === name);
    if (!found) throw new Error(`there is no setting "${name}"`);
    return found;
  }
  get(name) { return this.table ? this.wasm.settings()[this.control(name).at] : 0; }
  set(name, value) {
    if (!this.table) return;  // nothing is open yet
    const { at: place, words } = this.control(name);
    const values = [value].flat().map((v) => (typeof v === 'string' ? words.split('|').indexOf(v) : Number(v)));
    this.wasm.settings().set(values, place);
    this.wake();
  }
  reset(name) {
    const { at: place, count } = this.control(name);
    this.wasm.settings().set(this.original.subarray(place, place + count), place);
    this.controls.show();
  }
  look(yaw, pitch, zoom) {
    this.set('yaw', yaw);
    this.set('pitch', pitch);
    if (zoom !== undefined) this.set('zoom', zoom);
  }
  play() { this.set('plays', this.get('plays') ? 0 : 1); }
  restart() { this.wasm.restart(); this.wake(); }

  word(name) { return this.control(name).words.split('|')[this.get(name)]; }

  /** Handles a change by the visitor. */
  changed(name) {
    if (name === 'motion' && this.word('motion') !== 'still') {
      this.set('plays', 1);
      this.controls.show();
    }
    this.tuning.changed(name);
    const beside = this.word('beside');
    at('compared').textContent = beside === 'none' ? '' : `Left: ${this.word('solver')}. Right: ${beside}.`;
    this.wake();
    this.live?.changed();
  }

  /** The changes as {section: {key: value}}. */
  recipe() {
    const recipe = recipeOf(this.table.filter((c) => !MOTION_KEYS.includes(c.recipe)), this.wasm.settings(), this.original);
    const dynamics = { ...this.wasm.dynamics(), ...recipe.dynamics };
    if (Object.keys(dynamics).length > 0) recipe.dynamics = dynamics;
    return this.live ? merged(recipe, this.live.keys.recipe()) : recipe;
  }

  /** Shows a red line of text; '': hides it. */
  say(problem) {
    at('problem').textContent = problem;
    at('problem').hidden = problem === '';
    this.sheet?.say(problem);
  }

  wake() {
    if (this.sheet?.isShown) return this.sheet.wake();
    if (this.waiting || this.isLost || !this.table) return;
    this.waiting = requestAnimationFrame((now) => this.tick(now));
  }

  tick(now) {
    this.waiting = 0;
    if (this.sheet?.isShown) return;
    const seconds = this.last ? (now - this.last) / 1000 : 0;
    this.last = now;
    const scale = Math.min(devicePixelRatio, MOST_PIXELS);
    const box = this.canvas.parentElement.getBoundingClientRect();
    if (this.draw(Math.round(box.width * scale), Math.round(box.height * scale), seconds)) {
      if (seconds > 0) this.rate += 0.1 * (1 / seconds - this.rate);
      this.wake();
    } else {
      this.last = 0;
    }
    this.showNumbers();
  }

  /** Returns true if something new was drawn. */
  draw(width, height, seconds) {
    if (this.canvas.width !== width) this.canvas.width = width;
    if (this.canvas.height !== height) this.canvas.height = height;
    try {
      return this.wasm.frame(Math.max(width, 16), Math.max(height, 16), seconds);
    } catch (error) {
      this.say(error.message);
      return false;
    }
  }

  showNumbers() {
    showNumbers(at('numbers'), this.wasm.numbers(), this.rate);
    showLegend(at('legend'), this.wasm.legend());
  }

  /** Pixels of a picture of this size, RGBA, rows top to bottom; time stands still. */
  take(width, height) {
    if (!this.draw(width, height, 0)) this.draw(width, height, 0);
    const gl = this.canvas.getContext('webgl2');
    const upsideDown = new Uint8Array(4 * width * height);
    gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, upsideDown);
    const pixels = new Uint8Array(upsideDown.length);
    const row = 4 * width;
    for (let y = 0; y < height; ++y) pixels.set(upsideDown.subarray(y * row, (y + 1) * row), (height - 1 - y) * row);
    this.wake();
    return pixels;
  }

  /** The browser may take the WebGL context away and give it back. */
  watchContext() {
    this.canvas.addEventListener('webglcontextlost', (event) => {
      event.preventDefault();
      this.isLost = true;
      this.wasm.lose();
      this.say('The graphics card is gone for a moment.');
    });
    this.canvas.addEventListener('webglcontextrestored', () => {
      const gl = this.canvas.getContext('webgl2');
      for (const name of gl.getSupportedExtensions()) gl.getExtension(name);
      this.isLost = false;
      this.tryTo(() => { this.wasm.restore(); this.say(''); this.wake(); });
    });
  }

  tryTo(act) {
    try {
      act();
    } catch (error) {
      this.say(error.message);
    }
  }

  async openFile(file) {
    this.wasm.body(new Uint8Array());  // it is another hair's
    if (this.live?.takes(file)) return this.live.drop(file);
    const bytes = new Uint8Array(await file.arrayBuffer());
    try {
      this.open(bytes, file.name);
    } catch (error) {
      const cure = file.name.endsWith('.coif') ? '' : ` (an artist's file or a recipe has to be cooked first: coif cook ${file.name} -o hair.coif)`;
      this.say(`${file.name}: ${error.message}${cure}`);
    }
  }
}

function acceptFiles(page) {
  const whole = document.body;
  whole.addEventListener('dragover', (event) => { event.preventDefault(); whole.classList.add('dropping'); });
  whole.addEventListener('dragleave', () => whole.classList.remove('dropping'));
  whole.addEventListener('drop', (event) => {
    event.preventDefault();
    whole.classList.remove('dropping');
    if (event.dataTransfer.files.length > 0) page.openFile(event.dataTransfer.files[0]);
  });
  at('file').addEventListener('change', (event) => {
    if (event.target.files.length > 0) page.openFile(event.target.files[0]);
    event.target.value = '';
  });
}

function wire(page) {
  new Hands(page.canvas, page);
  acceptFiles(page);
  offerRecipe(page);
  page.watchContext();
  at('restart').addEventListener('click', () => page.tryTo(() => page.restart()));
  at('save').addEventListener('click', () => page.table && page.canvas.toBlob((blob) => {
    const link = document.createElement('a');
    link.href = URL.createObjectURL(blob);
    link.download = `${page.name.replace(/\.coif$/, '')}.png`;
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 1000);
  }));
  at('fold').addEventListener('click', () => {
    const folded = document.body.classList.toggle('folded');
    at('fold').setAttribute('aria-expanded', String(!folded));
    page.wake();
  });
  for (const [id, yaw] of [['front', 0], ['side', 90], ['back', 180], ['slanted', 30]]) {
    at(id).addEventListener('click', () => page.look(yaw, 5));
  }
  new ResizeObserver(() => page.wake()).observe(page.canvas.parentElement);
}

function embeddedAsset() {
  const holder = at('asset');
  const text = atob(holder.textContent.trim());
  const bytes = Uint8Array.from(text, (c) => c.charCodeAt(0));
  holder.textContent = '';  // the memory is needed once
  return bytes;
}

async function begin() {
  const wasm = new WasmPage(await loadCoifView());
  const page = new Page(wasm);
  wasm.start();
  wire(page);
  page.motion = takeMotion(wasm, at('motion').textContent);
  await takeBody(wasm, at('body').textContent);
  if ('live' in document.documentElement.dataset) {
    page.live = new Live(page, at('title'));
    await page.live.begin();
    return page;
  }
  const name = at('asset').dataset.name;
  if (name === '@' + 'NAME@') {  // the page has not been filled in
    page.say('Drop a .coif file here.');
    return page;
  }
  page.open(embeddedAsset(), name);
  const plan = sheetPlan();
  if (plan) page.sheet = new Sheet(page, plan);
  else followAddress(page);
  return page;
}

/** For other scripts: resolves to the Page when it is ready. */
window.coif = begin();
window.coif.catch((error) => {
  at('problem').textContent = error.message;
  at('problem').hidden = false;
});
