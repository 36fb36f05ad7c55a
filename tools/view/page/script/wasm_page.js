// The functions of page.cpp, in JavaScript's types.

/** Indices of the numbers in ViewNumbers. */
const NUMBERS = ['stepNsOfBone', 'substeps', 'bones', 'triangles', 'assetBytes', 'drawn', 'asleep', 'levels', 'time',
  'tipErrorSource', 'tipRms', 'tipMax', 'headX', 'headY', 'headZ', 'headQx', 'headQy', 'headQz', 'headQw'];

export class WasmPage {
  constructor(module) {
    this.module = module;
  }

  /** Throws the error that the function reports. */
  check(name, types = [], values = []) {
    const problem = this.module.ccall(name, 'string', types, values);
    if (problem) throw new Error(problem);
  }

  start() { this.check('coif_view_start'); }

  /** Opens an asset's bytes. If they are bad, the shown asset stays. */
  open(bytes, how = 'coif_view_open') {
    const room = this.module.ccall('coif_view_room', 'number', ['number'], [bytes.length]);
    this.module.HEAPU8.set(bytes, room);
    this.check(how);
  }

  /** Opens it in place of the shown asset, whose motion continues. The settings are the new asset's. */
  replace(bytes) { this.open(bytes, 'coif_view_replace'); }

  /** Adds a view of the shown asset and returns its number. The page's own view is 0. */
  add() { return this.module.ccall('coif_view_add', 'number', [], []); }
  /** Chooses the view that all functions apply to from now on. */
  choose(view) { this.module.ccall('coif_view_choose', null, ['number'], [view]); }
  /** Draws the next frame in any case. */
  redraw() { this.module.ccall('coif_view_redraw', null, [], []); }
  /** Goes to so many seconds into the playing motion. */
  seek(seconds) { this.check('coif_view_seek', ['number'], [seconds]); }
  /** Sets a clip's keys (clip_bytes() in C++) for assets that are opened from now on. */
  clip(bytes) { this.open(bytes, 'coif_view_clip'); }

  /** Sets the body (body_bytes() in C++) beneath the hair of assets that are opened from now on; no bytes: none. */
  body(bytes) { this.open(bytes, 'coif_view_body'); }
  /** Sets its image of this number: RGBA, rows top to bottom. */
  bodyImage(number, width, height, pixels) {
    const room = this.module.ccall('coif_view_room', 'number', ['number'], [pixels.length]);
    this.module.HEAPU8.set(pixels, room);
    this.module.ccall('coif_view_body_image', null, ['number', 'number', 'number'], [number, width, height]);
  }

  lose() { this.module.ccall('coif_view_lose', null, [], []); }
  restore() { this.check('coif_view_restore'); }
  restart() { this.check('coif_view_restart'); }

  controls() { return JSON.parse(this.module.ccall('coif_view_controls', 'string', [], [])); }

  /** JSON of the view's legend. */
  legend() { return this.module.ccall('coif_view_legend', 'string', [], []); }

  /** A view of the settings. Do not keep it: memory moves when it grows. */
  settings() {
    const count = this.module.ccall('coif_view_setting_count', 'number', [], []);
    const begin = this.module.ccall('coif_view_settings', 'number', [], []) / 4;
    return this.module.HEAPF32.subarray(begin, begin + count);
  }

  numbers() {
    const begin = this.module.ccall('coif_view_numbers', 'number', [], []) / 4;
    return Object.fromEntries(NUMBERS.map((name, i) => [name, this.module.HEAPF32[begin + i]]));
  }

  /** Advances by so many seconds, in a canvas of so many pixels. Returns true if something new was drawn. */
  frame(width, height, seconds) {
    this.check('coif_view_frame', ['number', 'number', 'number'], [width, height, seconds]);
    return Boolean(this.module.ccall('coif_view_has_drawn', 'boolean', [], []));
  }

  /** The asset's own motion: AssetMotion::json(). */
  motion() { return JSON.parse(this.module.ccall('coif_view_motion', 'string', [], [])); }
  /** Its changes, as a recipe's "dynamics". */
  dynamics() { return JSON.parse(this.module.ccall('coif_view_dynamics', 'string', [], [])); }
  /** Replaces the asset's resistances (`which` 0) or damping ratios (1) by points [place, value]; without points: its own. */
  curve(which, points) {
    const bytes = new Uint8Array(Float64Array.from(points.flat()).buffer);
    this.module.ccall('coif_view_curve', null, ['number', 'array', 'number'], [which, bytes, points.length]);
  }
  /** The present settings are those of the asset's cook. `recipeSaysIt`: its recipe contains them. */
  accept(recipeSaysIt) { this.module.ccall('coif_view_accept', null, ['boolean'], [recipeSaysIt]); }

  grab(x, y) { return Boolean(this.module.ccall('coif_view_grab', 'boolean', ['number', 'number'], [x, y])); }
  drag(across, down) { this.module.ccall('coif_view_drag', null, ['number', 'number'], [across, down]); }
  turn(across, down) { this.module.ccall('coif_view_turn', null, ['number', 'number'], [across, down]); }
  release() { this.module.ccall('coif_view_release', null, [], []); }
}
