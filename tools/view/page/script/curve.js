// A curve from root to tip, whose points are dragged or moved by keys. A height is a power of the value, so that small values look different.

const PLOT = { width: 276, height: 132, left: 34, right: 10, top: 12, bottom: 20 };
const LEAST_GAP = 0.01;  // between places
const KEY_STEP = 0.02, PLACE_STEP = 0.01, FARTHER = 5;  // shares of the height and of the chain; factor with Shift or by pages
const PIECES_OF_LINE = 12;  // between two points: a line that is straight in values is curved here

const within = (value, low, high) => Math.min(Math.max(value, low), high);
const digits = (value, count = 3) => Number(value.toPrecision(count));

function drawn(name, attributes, ...children) {
  const made = document.createElementNS('http://www.w3.org/2000/svg', name);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
  made.append(...children);
  return made;
}

/** The curve's value as in recipes: linear between points, constant beyond them. */
export function curveAt(points, place) {
  if (place <= points[0][0]) return points[0][1];
  for (let i = 1; i < points.length; ++i) {
    const [[from, low], [to, high]] = [points[i - 1], points[i]];
    if (place <= to) return low + (place - from) / (to - from) * (high - low);
  }
  return points[points.length - 1][1];
}

/** `about`: { name, label, hint, top, most, power, marks }: values up to `top` are drawn, values up to `most` are allowed; a line marks each of `marks`.
 *  `changed(points)` is called after each change by the visitor. */
export class CurveEditor {
  constructor(about, changed) {
    this.about = about;
    this.changed = changed;
    this.points = [];
    this.dots = [];
    this.node = document.createElement('div');
    this.node.className = 'curve';
    this.node.id = `curve-${about.name}`;
    this.svg = drawn('svg', { viewBox: `0 0 ${PLOT.width} ${PLOT.height}`, role: 'group', 'aria-label': `${about.label}, a curve from root to tip. ${about.hint}` });
    this.node.append(this.svg);
    this.grid = drawn('g', { class: 'grid', 'aria-hidden': 'true' });
    this.faint = drawn('g', { class: 'dots', 'aria-hidden': 'true' });
    this.area = drawn('path', { class: 'area' });
    this.line = drawn('path', { class: 'line' });
    this.handles = drawn('g', {});
    this.told = drawn('text', { class: 'told', 'aria-hidden': 'true' });
    this.svg.append(this.grid, this.faint, this.area, this.line, this.handles, this.told);
    this.svg.addEventListener('dblclick', (event) => this.double(event));
  }

  /** `points` and `dots` are [place, value]; dots are bones, drawn behind the curve. */
  show(points, dots = this.dots) {
    this.dots = dots;
    this.points = points.map(([place, value]) => [place, value]);
    this.top = Math.max(this.about.top, ...this.points.map((p) => p[1]), ...dots.map((p) => p[1]));
    this.drawGrid();
    this.faint.replaceChildren(...dots.map(([place, value]) => drawn('circle', { cx: this.x(place), cy: this.y(value), r: 2.2 })));
    if (this.handles.childNodes.length !== this.points.length) this.drawHandles();  // otherwise keeps them: one may be held or have the focus
    this.drawCurve();
  }

  x(place) { return PLOT.left + place * (PLOT.width - PLOT.left - PLOT.right); }
  height(value) { return (value / this.top) ** this.about.power; }
  y(value) { return PLOT.height - PLOT.bottom - this.height(value) * (PLOT.height - PLOT.top - PLOT.bottom); }
  valueOf(height) { return this.top * within(height, 0, 1) ** (1 / this.about.power); }

  /** Place and height of a mouse or a finger, 0..1 in the plot. */
  under(event) {
    const box = this.svg.getBoundingClientRect();
    const scale = PLOT.width / box.width;
    const x = (event.clientX - box.left) * scale, y = (event.clientY - box.top) * scale;
    return [within((x - PLOT.left) / (PLOT.width - PLOT.left - PLOT.right), 0, 1),
            within((PLOT.height - PLOT.bottom - y) / (PLOT.height - PLOT.top - PLOT.bottom), 0, 1)];
  }

  drawGrid() {
    const lines = this.about.marks.filter((value) => value <= this.top).flatMap((value) => [
      drawn('line', { x1: PLOT.left, x2: PLOT.width - PLOT.right, y1: this.y(value), y2: this.y(value) }),
      drawn('text', { x: PLOT.left - 5, y: this.y(value) + 3, class: 'value' }, String(value)),
    ]);
    const base = PLOT.height - 6;
    this.grid.replaceChildren(...lines, drawn('text', { x: PLOT.left, y: base }, 'root'),
                              drawn('text', { x: PLOT.width - PLOT.right, y: base, class: 'end' }, 'tip'));
  }

  drawCurve() {
    const places = [0];
    const ends = [[0, 0], ...this.points, [1, 0]].map((p) => p[0]);
    for (let i = 1; i < ends.length; ++i) {
      for (let k = 1; k <= PIECES_OF_LINE; ++k) places.push(ends[i - 1] + k / PIECES_OF_LINE * (ends[i] - ends[i - 1]));
    }
    const path = places.map((place, i) => `${i ? 'L' : 'M'}${this.x(place).toFixed(1)} ${this.y(curveAt(this.points, place)).toFixed(1)}`).join('');
    this.line.setAttribute('d', path);
    this.area.setAttribute('d', `${path}L${this.x(1)} ${this.y(0)}L${this.x(0)} ${this.y(0)}Z`);
    this.handles.childNodes.forEach((handle, i) => this.place(handle, i));
    this.tell(this.held ?? this.focused());
  }

  drawHandles() {
    this.handles.replaceChildren(...this.points.map((_, i) => {
      const handle = drawn('g', { class: 'point', tabindex: 0, role: 'slider', 'aria-orientation': 'vertical', 'aria-valuemin': 0 },
                           drawn('circle', { r: 13, class: 'reach' }), drawn('circle', { r: 5 }));
      handle.addEventListener('pointerdown', (event) => this.grab(event, i));
      handle.addEventListener('keydown', (event) => this.key(event, i));
      handle.addEventListener('focus', () => this.tell(i));
      handle.addEventListener('blur', () => this.tell(null));
      return handle;
    }));
  }

  place(handle, i) {
    const [place, value] = this.points[i];
    handle.setAttribute('transform', `translate(${this.x(place)} ${this.y(value)})`);
    const said = { 'aria-valuemax': this.about.most, 'aria-valuenow': digits(value), 'aria-valuetext': `at ${Math.round(100 * place)} % of the chain: ${digits(value)}`,
                   'aria-label': `${this.about.label}, point ${i + 1} of ${this.points.length}` };
    for (const [name, text] of Object.entries(said)) handle.setAttribute(name, text);
  }

  focused() {
    const at = [...this.handles.childNodes].indexOf(document.activeElement);
    return at < 0 ? null : at;
  }

  /** Shows a point's values beside it; null: shows nothing. */
  tell(i) {
    this.told.textContent = '';
    if (i === null || !this.points[i]) return;
    const [place, value] = this.points[i];
    const isLeft = place < 0.5;
    this.told.textContent = `${digits(value)} at ${Math.round(100 * place)} %`;
    this.told.setAttribute('x', this.x(place) + (isLeft ? 10 : -10));
    this.told.setAttribute('y', Math.max(this.y(value) - 9, 11));
    this.told.setAttribute('text-anchor', isLeft ? 'start' : 'end');
  }

  /** Limits a point to places between its neighbours and to the value's range. */
  move(i, place, value) {
    const low = i > 0 ? this.points[i - 1][0] + LEAST_GAP : 0;
    const high = i + 1 < this.points.length ? this.points[i + 1][0] - LEAST_GAP : 1;
    this.points[i] = [digits(within(place, low, high), 4), digits(within(value, 0, this.about.most), 4)];
    this.drawCurve();
    this.changed(this.points);
  }

  grab(event, i) {
    if (event.button !== 0) return;
    event.preventDefault();
    const handle = this.handles.childNodes[i];
    handle.focus({ preventScroll: true });
    handle.setPointerCapture(event.pointerId);
    const [place, height] = this.under(event);
    const off = [this.points[i][0] - place, this.height(this.points[i][1]) - height];
    let hasMoved = false;
    const follow = (moved) => {
      const [toPlace, toHeight] = this.under(moved);
      if (!hasMoved && toPlace === place && toHeight === height) return;
      hasMoved = true;
      this.held = i;
      this.move(i, toPlace + off[0], this.valueOf(toHeight + off[1]));
    };
    const end = () => {
      this.held = null;
      for (const name of ['pointermove', 'pointerup', 'pointercancel']) handle.removeEventListener(name, name === 'pointermove' ? follow : end);
    };
    handle.addEventListener('pointermove', follow);
    handle.addEventListener('pointerup', end);
    handle.addEventListener('pointercancel', end);
  }

  double(event) {
    event.preventDefault();
    const handle = event.target.closest('.point');
    if (handle) return this.remove([...this.handles.childNodes].indexOf(handle));
    const [place, height] = this.under(event);
    this.add(place, this.valueOf(height));
  }

  add(place, value) {
    if (this.points.some((point) => Math.abs(point[0] - place) < LEAST_GAP)) return;
    const after = this.points.findIndex((point) => point[0] > place);
    const i = after < 0 ? this.points.length : after;
    this.points.splice(i, 0, [digits(place, 4), digits(value, 4)]);
    this.drawHandles();
    this.drawCurve();
    this.handles.childNodes[i].focus({ preventScroll: true });
    this.changed(this.points);
  }

  remove(i) {
    if (this.points.length <= 1) return;
    this.points.splice(i, 1);
    this.drawHandles();
    this.drawCurve();
    this.handles.childNodes[Math.min(i, this.points.length - 1)].focus({ preventScroll: true });
    this.changed(this.points);
  }

  /** Adds a point half way to the next one, or behind the last point half way to the one before. */
  addBeside(i) {
    const [a, b] = i + 1 < this.points.length ? [i, i + 1] : [i - 1, i];
    const place = this.points.length === 1 ? (this.points[0][0] < 0.5 ? 1 : 0) : (this.points[a][0] + this.points[b][0]) / 2;
    this.add(place, curveAt(this.points, place));
  }

  key(event, i) {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const far = event.shiftKey ? FARTHER : 1;
    const [place, value] = this.points[i];
    const up = (steps) => this.move(i, place, this.valueOf(this.height(value) + steps * KEY_STEP));
    const along = (steps) => this.move(i, place + steps * PLACE_STEP, value);
    const keys = {
      ArrowUp: () => up(far), ArrowDown: () => up(-far), ArrowLeft: () => along(-far), ArrowRight: () => along(far),
      PageUp: () => up(FARTHER), PageDown: () => up(-FARTHER), Home: () => up(-1 / KEY_STEP), End: () => up(1 / KEY_STEP),
      Enter: () => this.addBeside(i), Delete: () => this.remove(i), Backspace: () => this.remove(i),
    };
    if (!keys[event.key]) return;
    event.preventDefault();
    event.stopPropagation();
    keys[event.key]();
  }
}
