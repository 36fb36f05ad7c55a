// The visitor's tuning of the motion: two curves beside the sliders, and the recipe of all changes.

import { element } from './controls.js';
import { CurveEditor } from './curve.js';

/** The recipe's keys that the WebAssembly program writes, since some of them depend on each other. */
export const MOTION_KEYS = ['preset', 'liveliness', 'resistance', 'damping_ratio', 'friction', 'air_follow', 'gravity_scale', 'angle_limit'].map((key) => `dynamics.${key}`);
const MOTION_CONTROLS = ['preset', 'liveliness', 'gravity_scale', 'friction', 'air_follow', 'angle_limit'];

const CURVES = [
  { name: 'resistance', label: 'Stiffness', top: 1, most: 1, power: 1 / 3, marks: [0, 0.001, 0.01, 0.1, 0.5, 1],
    scale: '0 to 1, cube-root scale', hint: 'Pull to the modelled shape, per step of 1/60 s. Heights are cube roots, so that soft hair has room.' },
  { name: 'damping_ratio', label: 'Damping', top: 2, most: 10, power: 1 / 2, marks: [0, 0.1, 0.5, 1, 2, 5, 10],
    scale: 'of critical, square-root scale', hint: 'Share of what would keep hair from swinging past where it rests. Heights are square roots.' },
];
const HOW_TO = 'Drag points. Double click or Enter adds one, on a point or Delete removes it; arrow keys move it.';

export class Tuning {
  /** `page`: the Page, with an asset open. */
  constructor(page) {
    this.page = page;
    this.drawn = {};
    this.editors = CURVES.map((about, which) => this.build(about, which));
    this.takeOwn();
  }

  build(about, which) {
    const editor = new CurveEditor(about, (points) => this.draw(which, points));
    const reset = element('button', { type: 'button', class: 'reset', title: 'As it came', 'aria-label': `${about.label}: as it came` }, '↺');
    reset.addEventListener('click', () => { this.draw(which, null); this.page.changed(about.name); });
    editor.node.prepend(element('div', { class: 'row head', title: `${about.hint} ${HOW_TO}` }, element('span', { class: 'what' }, about.label),
                                element('span', { class: 'unit' }, about.scale), reset));
    return editor;
  }

  /** Adds the curves to the panel, behind the slider of liveliness. Leaves out rows for hair that does not move. */
  enter(controls) {
    const row = (name) => controls.rows.find((r) => r.control.name === name);
    for (const name of MOTION_CONTROLS) {
      if (!this.own.moves && row(name)) row(name).line.hidden = true;
    }
    if (!this.own.moves || !row('liveliness')) return;
    row('liveliness').line.after(...this.editors.map((editor) => editor.node));
    this.editors[0].node.after(element('p', { class: 'help' }, HOW_TO));
    this.offerPreset(row('preset'));
  }

  /** Disables the choice of presets if the hair has numbers, which only a cook can replace by a preset. */
  offerPreset(row) {
    const select = row.line.querySelector('select');
    select.options[0].disabled = this.own.preset;
    if (this.own.preset || this.page.live) return;
    select.disabled = true;
    row.line.title = 'This hair has numbers of its own, which only a cook can leave out: coif view SOURCE';
    row.line.after(element('p', { class: 'help' }, 'To choose a kind in their place: ', element('code', {}, 'coif view SOURCE')));
  }

  /** Shows the asset's curves, unless the visitor has drawn others. */
  takeOwn() {
    this.own = this.page.wasm.motion();
    if (!this.own.moves) return;
    this.editors.forEach((editor, which) => {
      const { points, bones } = this.own[CURVES[which].name];
      editor.show(this.drawn[which] ?? points, bones);
      this.mark(which);
    });
  }

  mark(which) { this.editors[which].node.classList.toggle('changed', Boolean(this.drawn[which])); }

  /** Null: the asset's own. */
  draw(which, points) {
    this.drawn[which] = points && points.map((point) => [...point]);
    this.page.wasm.curve(which, points ?? []);
    if (!points) this.editors[which].show(this.own[CURVES[which].name].points);
    if (which === 0 && !this.drawn[1]) this.editors[1].show(this.page.wasm.dynamics().damping_ratio ?? this.own.damping_ratio.points);
    this.mark(which);
    if (!points) return;
    if (which === 1) this.page.reset('liveliness');  // which sets the same for all of the hair
    this.page.changed(CURVES[which].name);
  }

  /** A slider was moved. */
  changed(name) {
    if (name === 'liveliness' && this.drawn[1]) this.draw(1, null);
    if (name === 'preset' && this.drawn[0]) this.draw(0, null);
  }

  /** The note in the recipe's dialog; '': none. */
  note() {
    const dynamics = this.page.wasm.dynamics();
    const springs = dynamics.source === 'curves' ? " The file's springs give way to the curve, and the bones at their ends and their limits go with them." : '';
    if (this.page.live || Object.keys(dynamics).length === 0) return springs.trim();
    const conditioned = this.own.conditioned ? ' This asset was: the page adds as much damping as it got.' : '';
    return 'The page changes bones by the formulas that the cook uses. Beyond that a cook chooses sub-steps and twist anew, the model too '
      + `where the recipe leaves it open, and may damp chains that would not move the same way twice.${conditioned}${springs} What "patches" says of some hair alone still holds there, and not here.`;
  }
}
