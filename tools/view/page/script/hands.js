// Mouse, fingers and keys: looking around, and shaking the head.

const DEGREES_OF_CANVAS = 220;  // of a drag from one side to the other
const RADIANS_OF_CANVAS = 3;
const ZOOM_OF_STEP = 1.1;

const clamp = (value, low, high) => Math.min(Math.max(value, low), high);

/** `page`: { wasm, controls, get(name), set(name, value), control(name) }. */
export class Hands {
  constructor(canvas, page) {
    this.canvas = canvas;
    this.page = page;
    this.pointers = new Map();
    this.action = null;
    canvas.addEventListener('pointerdown', (event) => this.down(event));
    canvas.addEventListener('pointermove', (event) => this.move(event));
    for (const end of ['pointerup', 'pointercancel']) canvas.addEventListener(end, (event) => this.up(event));
    canvas.addEventListener('contextmenu', (event) => event.preventDefault());
    canvas.addEventListener('wheel', (event) => this.wheel(event), { passive: false });
    canvas.addEventListener('dblclick', () => page.look(30, 5, 0.9));
    canvas.addEventListener('keydown', (event) => this.key(event));
  }

  place(event) {
    const box = this.canvas.getBoundingClientRect();
    return [(event.clientX - box.left) / box.width, (event.clientY - box.top) / box.height];
  }

  down(event) {
    this.canvas.setPointerCapture(event.pointerId);
    this.canvas.focus({ preventScroll: true });
    this.pointers.set(event.pointerId, this.place(event));
    if (this.pointers.size === 2) {
      this.page.wasm.release();
      this.action = 'pinch';
      return;
    }
    const holds = this.page.wasm.grab(...this.place(event));
    const turns = event.shiftKey || event.button === 2;
    this.action = !holds ? 'orbit' : turns ? 'turn' : 'drag';
    this.canvas.dataset.action = this.action;
  }

  move(event) {
    const before = this.pointers.get(event.pointerId);
    if (!before) return;
    const now = this.place(event);
    const spread = this.spread();
    this.pointers.set(event.pointerId, now);
    const across = now[0] - before[0];
    const down = now[1] - before[1];
    if (this.action === 'pinch') return this.zoom(this.spread() / spread);
    if (this.action === 'drag') this.page.wasm.drag(across, down);
    if (this.action === 'turn') this.page.wasm.turn(RADIANS_OF_CANVAS * across, RADIANS_OF_CANVAS * down);
    if (this.action === 'orbit') this.orbit(-DEGREES_OF_CANVAS * across, DEGREES_OF_CANVAS * down);
    this.page.wake();
  }

  up(event) {
    this.pointers.delete(event.pointerId);
    if (this.pointers.size > 0) return;
    this.page.wasm.release();
    this.action = null;
    delete this.canvas.dataset.action;
    this.page.wake();
  }

  /** How far two fingers are apart, in shares of the canvas; 1 for a single one. */
  spread() {
    const [a, b] = [...this.pointers.values()];
    return b ? Math.max(Math.hypot(a[0] - b[0], a[1] - b[1]), 1e-3) : 1;
  }

  orbit(around, above) {
    const yaw = this.page.get('yaw') + around;
    this.page.set('yaw', yaw - 360 * Math.round(yaw / 360));
    this.page.set('pitch', clamp(this.page.get('pitch') + above, -89, 89));
  }

  zoom(factor) {
    this.page.set('zoom', clamp(this.page.get('zoom') * factor, 0.3, 8));
  }

  wheel(event) {
    event.preventDefault();
    this.zoom(Math.exp(-0.0015 * clamp(event.deltaY, -400, 400)));
  }

  key(event) {
    const toggle = (name) => this.page.set(name, this.page.get(name) ? 0 : 1);
    const direction = () => this.page.set('component', this.page.get('component') === 6 ? 0 : 6);
    const nextView = () => this.page.set('view', (this.page.get('view') + 1) % this.page.control('view').words.split('|').length);
    const keys = {
      ArrowLeft: () => this.orbit(-5, 0), ArrowRight: () => this.orbit(5, 0),
      ArrowUp: () => this.orbit(0, 5), ArrowDown: () => this.orbit(0, -5),
      '+': () => this.zoom(ZOOM_OF_STEP), '=': () => this.zoom(ZOOM_OF_STEP), '-': () => this.zoom(1 / ZOOM_OF_STEP),
      ' ': () => this.page.play(), r: () => this.page.restart(),
      b: () => toggle('bones'), c: () => toggle('colliders'), d: direction, v: nextView,
      1: () => this.page.look(0, 5), 2: () => this.page.look(90, 5), 3: () => this.page.look(180, 5), 4: () => this.page.look(30, 5),
    };
    const act = event.ctrlKey || event.metaKey || event.altKey ? undefined : keys[event.key];
    if (!act) return;
    event.preventDefault();
    act();
    this.page.controls?.show();
  }
}
