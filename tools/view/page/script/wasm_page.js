// The functions of page.cpp, in JavaScript's types.

/** Where numbers lie in ViewNumbers. */
const NUMBERS = ['stepNsOfBone', 'substeps', 'bones', 'triangles', 'assetBytes', 'drawn', 'asleep', 'levels', 'time',
  'tipErrorSource', 'tipRms', 'tipMax', 'headX', 'headY', 'headZ', 'headQx', 'headQy', 'headQz', 'headQw'];

export class WasmPage {
  constructor(module) {
    this.module = module;
  }

  /** Throws what the function says went wrong. */
  check(name, types = [], values = []) {
    const problem = this.module.ccall(name, 'string', types, values);
    if (problem) throw new Error(problem);
  }

  start() { this.check('coif_view_start'); }

  /** An asset's bytes. Whatever is wrong with them, what is shown stays. */
  open(bytes, how = 'coif_view_open') {
    const room = this.module.ccall('coif_view_room', 'number', ['number'], [bytes.length]);
    this.module.HEAPU8.set(bytes, room);
    this.check(how);
  }

  /** In place of what is shown, which goes on. The settings are the asset's. */
  replace(bytes) { this.open(bytes, 'coif_view_replace'); }

  /** Another view of what is shown: its number. The page's own is 0. */
  add() { return this.module.ccall('coif_view_add', 'number', [], []); }
  /** From here on everything here is about this view. */
  choose(view) { this.module.ccall('coif_view_choose', null, ['number'], [view]); }
  /** The next frame is drawn, whatever was on the canvas. */
  redraw() { this.module.ccall('coif_view_redraw', null, [], []); }
  /** To so many seconds into the motion that plays. */
  seek(seconds) { this.check('coif_view_seek', ['number'], [seconds]); }
  /** A clip's keys, clip_bytes() in C++, for what is opened from now on. */
  clip(bytes) { this.open(bytes, 'coif_view_clip'); }

  lose() { this.module.ccall('coif_view_lose', null, [], []); }
  restore() { this.check('coif_view_restore'); }
  restart() { this.check('coif_view_restart'); }

  controls() { return JSON.parse(this.module.ccall('coif_view_controls', 'string', [], [])); }

  /** JSON of what the view's colours mean. */
  legend() { return this.module.ccall('coif_view_legend', 'string', [], []); }

  /** A view of the settings. Not to be kept: memory moves when it grows. */
  settings() {
    const count = this.module.ccall('coif_view_setting_count', 'number', [], []);
    const begin = this.module.ccall('coif_view_settings', 'number', [], []) / 4;
    return this.module.HEAPF32.subarray(begin, begin + count);
  }

  numbers() {
    const begin = this.module.ccall('coif_view_numbers', 'number', [], []) / 4;
    return Object.fromEntries(NUMBERS.map((name, i) => [name, this.module.HEAPF32[begin + i]]));
  }

  /** Goes on by so many seconds, in a canvas of so many pixels; true where something new is on it. */
  frame(width, height, seconds) {
    this.check('coif_view_frame', ['number', 'number', 'number'], [width, height, seconds]);
    return Boolean(this.module.ccall('coif_view_has_drawn', 'boolean', [], []));
  }

  /** How hair moves, as the asset came: AssetMotion::json(). */
  motion() { return JSON.parse(this.module.ccall('coif_view_motion', 'string', [], [])); }
  /** What was changed of it, as a recipe's "dynamics". */
  dynamics() { return JSON.parse(this.module.ccall('coif_view_dynamics', 'string', [], [])); }
  /** [place, value] in place of the asset's own resistances (`which` 0) or damping ratios (1); none: its own. */
  curve(which, points) {
    const bytes = new Uint8Array(Float64Array.from(points.flat()).buffer);
    this.module.ccall('coif_view_curve', null, ['number', 'array', 'number'], [which, bytes, points.length]);
  }
  /** What is set of how hair moves is what the asset was cooked with; the recipe says it, or does not have to. */
  accept(recipeSaysIt) { this.module.ccall('coif_view_accept', null, ['boolean'], [recipeSaysIt]); }

  grab(x, y) { return Boolean(this.module.ccall('coif_view_grab', 'boolean', ['number', 'number'], [x, y])); }
  drag(across, down) { this.module.ccall('coif_view_drag', null, ['number', 'number'], [across, down]); }
  turn(across, down) { this.module.ccall('coif_view_turn', null, ['number', 'number'], [across, down]); }
  release() { this.module.ccall('coif_view_release', null, [], []); }
}
