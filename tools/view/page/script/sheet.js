// Galleries as tiles, each of which opens as the whole page. All are drawn in one WebGL context, one after the other.

import { Tile } from './tile.js';

const kMostDrawing = 20;  // milliseconds of a frame
const kLongestRound = 0.25;  // seconds that motions catch up with
const kColumns = [6, 3, 2, 1];
const kGap = 10;  // pixels, as in sheet.css

const of_page = (id) => document.getElementById(id);

export class Sheet {
  /** `page` shows the asset; `plan` is as sheet_json.cpp writes it. */
  constructor(page, plan) {
    this.page = page;
    this.plan = plan;
    this.is_shown = true;
    this.opened = null;
    this.waiting = 0;
    this.clock = 0;  // seconds that motions have played
    this.round = [];  // tiles that are still to be drawn
    this.begun = 0;  // milliseconds, of the round; 0: none
    this.seconds = 0;  // that the round takes motions on
    this.tiles = [];
    of_page('sheet-name').textContent = page.name;
    of_page('sheet-note').textContent = plan.note;
    for (const gallery of plan.galleries) this.add(gallery);
    this.listen();
    document.body.classList.add('sheet');
    of_page('sheet').hidden = false;
    this.lay_out();
    this.play_all(!this.calm.matches);
  }

  add({ title, tiles }) {
    const section = document.createElement('section');
    section.className = 'gallery';
    const heading = document.createElement('h2');
    heading.textContent = title;
    section.append(heading);
    for (const plan of tiles) {
      const figure = of_page('tile-template').content.firstElementChild.cloneNode(true);
      section.append(figure);
      if (plan.caption === title) figure.classList.add('titled');
      this.tiles.push(new Tile(this, plan, figure));
    }
    section.dataset.tiles = tiles.length;
    of_page('galleries').append(section);
  }

  listen() {
    const tile_of = new Map(this.tiles.map((tile) => [tile.figure, tile]));
    const seen = new IntersectionObserver((entries) => entries.forEach((e) => tile_of.get(e.target).see(e.isIntersecting)));
    for (const { figure } of this.tiles) seen.observe(figure);
    new ResizeObserver(() => this.lay_out()).observe(of_page('galleries'));
    this.calm = matchMedia('(prefers-reduced-motion: reduce)');
    this.calm.addEventListener('change', () => { if (this.calm.matches) this.play_all(false); });
    of_page('sheet-play').addEventListener('click', () => this.play_all(!this.tiles.some((tile) => tile.plays)));
    of_page('sheet-face').addEventListener('click', () => this.tiles.forEach((tile) => tile.face()));
    of_page('leave-tile').addEventListener('click', () => this.close());
    document.addEventListener('keydown', (event) => {
      if (event.key === 'Escape' && !document.querySelector('dialog[open]')) this.close();
    });
  }

  /** As many tiles beside each other as there is room for, so that a gallery's six fill their rows. */
  lay_out() {
    const { width, height } = this.plan;
    const room = of_page('galleries').clientWidth;
    const columns = kColumns.find((n) => (room - kGap * (n - 1)) / n >= width / 2) ?? 1;
    const { style } = of_page('galleries');
    style.setProperty('--columns', columns);
    style.setProperty('--tile', `${width}px`);
    style.setProperty('--shape', `${width} / ${height}`);
    for (const section of of_page('galleries').children) {
      section.style.setProperty('--span', Math.min(section.dataset.tiles, columns));
      section.classList.toggle('in-a-row', section.dataset.tiles <= columns);  // whose titles and tiles begin where those beside it do
    }
    for (const tile of this.tiles) tile.is_stale = true;
    this.wake();
  }

  /** All from their beginnings, or at a moment that tells them apart from hair at rest. */
  play_all(on) {
    this.clock = 0;
    for (const tile of this.tiles.filter((t) => t.moves())) {
      if (on) tile.play(true);
      else tile.hold(tile.drawn > 0 ? tile.time : tile.plan.moments[tile.plan.moments.length >> 1].seconds);
    }
    this.show_state();
  }

  show_state() {
    of_page('sheet-play').textContent = this.tiles.some((tile) => tile.plays) ? 'Pause all' : 'Play all';
    of_page('sheet-play').hidden = !this.tiles.some((tile) => tile.moves());
  }

  turn(tile, around, above) {
    const all = of_page('sheet-together').checked ? this.tiles : [tile];
    for (const one of all) one.turn(around, above);
  }

  say(problem) {
    of_page('sheet-problem').textContent = problem;
    of_page('sheet-problem').hidden = problem === '';
  }

  wake() {
    if (this.waiting || !this.is_shown || this.page.is_lost) return;
    this.waiting = requestAnimationFrame((now) => this.tick(now));
  }

  tick(now) {
    this.waiting = 0;
    if (!this.is_shown || this.page.is_lost) return;
    try {
      this.draw_some(now);
    } catch (error) {
      this.say(error.message);
      return;
    }
    if (this.round.length > 0 || this.tiles.some((tile) => tile.wants_drawing())) this.wake();
    else this.begun = 0;
  }

  /** As many tiles of a round as a frame has time for. In a round all motions go on by the same time, so that they stay beside each other. */
  draw_some(now) {
    if (this.round.length === 0) {
      this.seconds = this.begun ? Math.min((now - this.begun) / 1000, kLongestRound) : 0;
      this.begun = now;
      this.clock += this.seconds;
      this.round = this.tiles.filter((tile) => tile.wants_drawing());
    }
    const end = performance.now() + kMostDrawing;
    do {
      const tile = this.round.shift();
      if (tile?.is_seen) tile.draw(this.seconds);
    } while (this.round.length > 0 && performance.now() < end);
  }

  /** The tile as the whole page, with all controls. */
  open(tile) {
    const { page } = this;
    if (page.is_lost) return;
    const samples = page.get('samples');
    this.opened = tile;
    this.is_shown = false;
    this.scrolled = of_page('sheet').scrollTop;
    page.wasm.settings().set(tile.settings());
    page.set('samples', samples);
    page.wasm.seek(tile.time);
    page.wasm.redraw();
    if (!tile.plays) page.set('plays', 0);
    this.show_page(true);
    page.controls.show();
    for (const group of document.querySelectorAll('#controls details')) group.open ||= group.querySelector('.changed') !== null;
    page.changed('beside');
    of_page('name').textContent = `${page.name}: ${tile.plan.caption}`;
    page.canvas.focus();
  }

  close() {
    if (!this.opened) return;
    this.is_shown = true;
    this.show_page(false);
    of_page('sheet').scrollTop = this.scrolled;
    this.opened.opener.focus({ preventScroll: true });
    this.opened = null;
    this.round = [];
    this.begun = 0;
    this.wake();
  }

  show_page(on) {
    document.body.classList.toggle('opened', on);
    of_page('sheet').hidden = on;
    of_page('leave-tile').hidden = !on;
  }

  /** When another asset is shown, of which there is no sheet. */
  leave() {
    this.is_shown = false;
    this.opened = null;
    this.show_page(true);
    of_page('leave-tile').hidden = true;
  }
}

/** What the page was filled in with; null: no sheet. */
export function sheet_plan() {
  const text = of_page('sheet-plan').textContent.trim();
  return text.startsWith('{') ? JSON.parse(text) : null;
}
