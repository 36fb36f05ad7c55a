// One tile of a sheet: a view of its own of the page's asset, which is drawn on the page's canvas and copied from there.

const DEGREES_OF_TILE = 220;  // of a drag from one side to the other
const HELD_SECONDS = 1;  // from a motion's last moment until it begins again
const MOST_TILE_PIXELS = 2;  // canvas pixels per pixel of the page, each way

export class Tile {
  /** `plan`: from sheet_json.cpp; `figure`: the element, from the template. */
  constructor(sheet, plan, figure) {
    this.sheet = sheet;
    this.plan = plan;
    this.figure = figure;
    this.canvas = figure.querySelector('canvas');
    this.picture = this.canvas.getContext('2d');
    this.view = 0;  // none yet
    this.isSeen = false;
    this.isStale = true;
    this.plays = false;
    this.time = 0;  // seconds into the motion
    this.wanted = undefined;  // the same, before it is drawn
    this.held = undefined;  // the moment that it stands still at
    this.turned = [0, 0];  // degrees around and above, added to the plan's
    this.drawn = 0;
    const last = plan.moments.at(-1);
    this.length = last ? last.seconds + HELD_SECONDS : 0;
    this.label();
    this.listen();
  }

  moves() { return this.length > 0; }

  label() {
    const { caption, moments } = this.plan;
    this.canvas.setAttribute('aria-label', `${caption}. Arrow keys look around, Enter opens it${this.moves() ? ', the space bar plays it' : ''}.`);
    this.figure.querySelector('figcaption').textContent = caption;
    this.opener = this.figure.querySelector('.tile-open');
    this.opener.setAttribute('aria-label', `Open: ${caption}`);
    this.player = this.figure.querySelector('.tile-play');
    this.player.hidden = !this.moves();
    const list = this.figure.querySelector('.moments');
    this.moments = moments.map(({ caption: text, seconds }) => {
      const button = document.createElement('button');
      button.type = 'button';
      button.textContent = text;
      button.setAttribute('aria-label', `${caption}, at ${text}`);
      button.addEventListener('click', () => this.hold(seconds));
      list.append(button);
      return { button, seconds };
    });
    this.showState();
  }

  listen() {
    this.opener.addEventListener('click', () => this.sheet.open(this));
    this.player.addEventListener('click', () => this.play(!this.plays));
    this.canvas.addEventListener('dblclick', () => this.sheet.open(this));
    this.canvas.addEventListener('keydown', (event) => this.key(event));
    this.canvas.addEventListener('pointerdown', (event) => { this.canvas.setPointerCapture(event.pointerId); });
    this.canvas.addEventListener('pointermove', (event) => {
      if (!this.canvas.hasPointerCapture(event.pointerId)) return;
      const { width, height } = this.canvas.getBoundingClientRect();
      this.sheet.turn(this, -DEGREES_OF_TILE * event.movementX / width, DEGREES_OF_TILE * event.movementY / height);
    });
  }

  key(event) {
    const keys = {
      ArrowLeft: () => this.sheet.turn(this, -5, 0), ArrowRight: () => this.sheet.turn(this, 5, 0),
      ArrowUp: () => this.sheet.turn(this, 0, 5), ArrowDown: () => this.sheet.turn(this, 0, -5),
      Enter: () => this.sheet.open(this), ' ': () => this.play(!this.plays),
    };
    const act = event.ctrlKey || event.metaKey || event.altKey ? undefined : keys[event.key];
    if (!act) return;
    event.preventDefault();
    act();
  }

  /** `on`: starts to play, in step with the other tiles. Else stops. */
  play(on) {
    if (!this.moves()) return;
    this.plays = on;
    this.held = undefined;
    if (on) this.wanted = this.sheet.clock % this.length;
    this.showState();
    this.change();
  }

  /** Shows the motion at this time and stops there. */
  hold(seconds) {
    this.plays = false;
    this.wanted = this.held = seconds;
    this.showState();
    this.change();
  }

  showState() {
    this.player.textContent = this.plays ? '❚❚' : '▶';
    this.player.setAttribute('aria-label', `${this.plays ? 'Pause' : 'Play'}: ${this.plan.caption}`);
    for (const { button, seconds } of this.moments) button.setAttribute('aria-pressed', String(seconds === this.held));
  }

  turn(around, above) {
    this.turned[0] += around;
    this.turned[1] = Math.min(Math.max(this.turned[1] + above, -80), 80);
    this.change();
  }
  face() {
    this.turned = [0, 0];
    this.change();
  }

  change() {
    this.isStale = true;
    this.sheet.wake();
  }

  see(isSeen) {
    this.isSeen = isSeen;
    if (isSeen && this.plays) this.wanted = this.sheet.clock % this.length;
    if (isSeen) this.sheet.wake();
  }

  wantsDrawing() { return this.isSeen && (this.isStale || this.plays); }

  /** Runs `act` while the tile's view is the chosen one. */
  within(act) {
    const { page } = this.sheet;
    const isNew = this.view === 0;
    if (isNew) this.view = page.wasm.add();
    page.wasm.choose(this.view);
    try {
      if (isNew) {
        for (const [name, value] of Object.entries(this.plan.settings)) page.set(name, value);
        page.set('samples', 1);  // besides the driver's own samples, as in pictures of a sheet
      }
      return act(page);
    } finally {
      page.wasm.choose(0);
    }
  }

  /** Degrees, as they are seen. */
  look(page) {
    const { yaw = 30, pitch = 5 } = this.plan.settings;
    page.set('yaw', yaw + this.turned[0]);
    page.set('pitch', Math.min(Math.max(pitch + this.turned[1], -89), 89));
  }

  /** Advances by so many seconds if it plays. */
  draw(seconds) {
    this.isStale = false;
    this.within((page) => {
      this.look(page);
      if (this.plays && this.wanted === undefined && this.time + seconds >= this.length) this.wanted = (this.time + seconds) % this.length;
      const begins = this.wanted !== undefined;
      if (begins) page.wasm.seek(this.wanted);
      const step = this.plays && !begins ? seconds : 0;
      this.time = begins ? this.wanted : this.time + step;
      this.wanted = undefined;
      const scale = Math.min(devicePixelRatio, MOST_TILE_PIXELS);
      const box = this.canvas.getBoundingClientRect();
      const width = Math.max(Math.round(box.width * scale), 16);
      const height = Math.max(Math.round(box.height * scale), 16);
      if (page.canvas.width !== width) page.canvas.width = width;
      if (page.canvas.height !== height) page.canvas.height = height;
      if (!page.wasm.frame(width, height, step)) return;
      if (this.canvas.width !== width) this.canvas.width = width;
      if (this.canvas.height !== height) this.canvas.height = height;
      this.picture.drawImage(page.canvas, 0, 0);
      ++this.drawn;
    });
  }

  /** All settings, as they are seen. */
  settings() {
    return this.within((page) => { this.look(page); return page.wasm.settings().slice(); });
  }
}
