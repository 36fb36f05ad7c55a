// Galleries as tiles, each of which opens as the whole page. All are drawn in one WebGL context, one after the other.

import { Tile } from './tile.js';

const MOST_DRAWING = 20;  // milliseconds of a frame
const LONGEST_ROUND = 0.25;  // seconds that motions catch up with
const COLUMNS = [6, 3, 2, 1];
const GAP = 10;  // pixels, as in sheet.css

const ofPage = (id) => document.getElementById(id);

export class Sheet {
  /** `page` shows the asset; `plan` is the JSON of sheet_json.cpp. */
  constructor(page, plan) {
    this.page = page;
    this.plan = plan;
    this.isShown = true;
    this.opened = null;
    this.waiting = 0;
    this.clock = 0;  // seconds that motions have played
    this.round = [];  // tiles that are still to be drawn
    this.begun = 0;  // when the round began, milliseconds; 0: there is none
    this.seconds = 0;  // seconds by which the round advances motions
    this.tiles = [];
    ofPage('sheet-name').textContent = page.name;
    ofPage('sheet-note').textContent = plan.note;
    for (const gallery of plan.galleries) this.add(gallery);
    this.listen();
    document.body.classList.add('sheet');
    ofPage('sheet').hidden = false;
    this.layOut();
    this.playAll(!this.calm.matches);
  }

  add({ title, tiles }) {
    const section = document.createElement('section');
    section.className = 'gallery';
    const heading = document.createElement('h2');
    heading.textContent = title;
    section.append(heading);
    for (const plan of tiles) {
      const figure = ofPage('tile-template').content.firstElementChild.cloneNode(true);
      section.append(figure);
      if (plan.caption === title) figure.classList.add('titled');
      this.tiles.push(new Tile(this, plan, figure));
    }
    section.dataset.tiles = tiles.length;
    ofPage('galleries').append(section);
  }

  listen() {
    const tileOf = new Map(this.tiles.map((tile) => [tile.figure, tile]));
    const seen = new IntersectionObserver((entries) => entries.forEach((e) => tileOf.get(e.target).see(e.isIntersecting)));
    for (const { figure } of this.tiles) seen.observe(figure);
    new ResizeObserver(() => this.layOut()).observe(ofPage('galleries'));
    this.calm = matchMedia('(prefers-reduced-motion: reduce)');
    this.calm.addEventListener('change', () => { if (this.calm.matches) this.playAll(false); });
    ofPage('sheet-play').addEventListener('click', () => this.playAll(!this.tiles.some((tile) => tile.plays)));
    ofPage('sheet-face').addEventListener('click', () => this.tiles.forEach((tile) => tile.face()));
    ofPage('leave-tile').addEventListener('click', () => this.close());
    document.addEventListener('keydown', (event) => {
      if (event.key === 'Escape' && !document.querySelector('dialog[open]')) this.close();
    });
  }

  /** Puts as many tiles side by side as fit, so that a gallery of six fills its rows. */
  layOut() {
    const { width, height } = this.plan;
    const room = ofPage('galleries').clientWidth;
    const columns = COLUMNS.find((n) => (room - GAP * (n - 1)) / n >= width / 2) ?? 1;
    const { style } = ofPage('galleries');
    style.setProperty('--columns', columns);
    style.setProperty('--tile', `${width}px`);
    style.setProperty('--shape', `${width} / ${height}`);
    for (const section of ofPage('galleries').children) {
      section.style.setProperty('--span', Math.min(section.dataset.tiles, columns));
      section.classList.toggle('in-a-row', section.dataset.tiles <= columns);  // a gallery in a single row: its titles and tiles align with those beside it
    }
    for (const tile of this.tiles) tile.isStale = true;
    this.wake();
  }

  /** `on`: starts all motions at their beginnings. Else stops them, at a moment at which hair is not at rest. */
  playAll(on) {
    this.clock = 0;
    for (const tile of this.tiles.filter((t) => t.moves())) {
      if (on) tile.play(true);
      else tile.hold(tile.drawn > 0 ? tile.time : tile.plan.moments[tile.plan.moments.length >> 1].seconds);
    }
    this.showState();
  }

  showState() {
    ofPage('sheet-play').textContent = this.tiles.some((tile) => tile.plays) ? 'Pause all' : 'Play all';
    ofPage('sheet-play').hidden = !this.tiles.some((tile) => tile.moves());
  }

  turn(tile, around, above) {
    const all = ofPage('sheet-together').checked ? this.tiles : [tile];
    for (const one of all) one.turn(around, above);
  }

  say(problem) {
    ofPage('sheet-problem').textContent = problem;
    ofPage('sheet-problem').hidden = problem === '';
  }

  wake() {
    if (this.waiting || !this.isShown || this.page.isLost) return;
    this.waiting = requestAnimationFrame((now) => this.tick(now));
  }

  tick(now) {
    this.waiting = 0;
    if (!this.isShown || this.page.isLost) return;
    try {
      this.drawSome(now);
    } catch (error) {
      this.say(error.message);
      return;
    }
    if (this.round.length > 0 || this.tiles.some((tile) => tile.wantsDrawing())) this.wake();
    else this.begun = 0;
  }

  /** Draws as many tiles of the round as a frame has time for. A round advances all motions by the same time, so that they stay in step. */
  drawSome(now) {
    if (this.round.length === 0) {
      this.seconds = this.begun ? Math.min((now - this.begun) / 1000, LONGEST_ROUND) : 0;
      this.begun = now;
      this.clock += this.seconds;
      this.round = this.tiles.filter((tile) => tile.wantsDrawing());
    }
    const end = performance.now() + MOST_DRAWING;
    do {
      const tile = this.round.shift();
      if (tile?.isSeen) tile.draw(this.seconds);
    } while (this.round.length > 0 && performance.now() < end);
  }

  /** Opens the tile as the whole page, with all controls. */
  open(tile) {
    const { page } = this;
    if (page.isLost) return;
    const samples = page.get('samples');
    this.opened = tile;
    this.isShown = false;
    this.scrolled = ofPage('sheet').scrollTop;
    page.wasm.settings().set(tile.settings());
    page.set('samples', samples);
    page.wasm.seek(tile.time);
    page.wasm.redraw();
    if (!tile.plays) page.set('plays', 0);
    this.showPage(true);
    page.controls.show();
    for (const group of document.querySelectorAll('#controls details')) group.open ||= group.querySelector('.changed') !== null;
    page.changed('beside');
    ofPage('name').textContent = `${page.name}: ${tile.plan.caption}`;
    page.canvas.focus();
  }

  close() {
    if (!this.opened) return;
    this.isShown = true;
    this.showPage(false);
    ofPage('sheet').scrollTop = this.scrolled;
    this.opened.opener.focus({ preventScroll: true });
    this.opened = null;
    this.round = [];
    this.begun = 0;
    this.wake();
  }

  showPage(on) {
    document.body.classList.toggle('opened', on);
    ofPage('sheet').hidden = on;
    ofPage('leave-tile').hidden = !on;
  }

  /** Leaves the sheet when another asset is shown, which has none. */
  leave() {
    this.isShown = false;
    this.opened = null;
    this.showPage(true);
    ofPage('leave-tile').hidden = true;
  }
}

/** The plan that the page contains; null: no sheet. */
export function sheetPlan() {
  const text = ofPage('sheet-plan').textContent.trim();
  return text.startsWith('{') ? JSON.parse(text) : null;
}
