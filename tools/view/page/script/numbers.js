// The strip of numbers below the picture.

const sizeText = (bytes) => (bytes < 1e6 ? `${Math.round(bytes / 1024)} KB` : `${(bytes / (1 << 20)).toFixed(1)} MB`);

const TIPS = 'Tips of the hair against its exact motion, in the worst of the ten motions without wind: root mean square, and the most there is; '
  + "shares of a chain's length, as the asset was measured when it was cooked, ";
const TIP_TITLES = [  // by TipErrorSource
  `${TIPS}at this rate with these sub-steps`,
  `${TIPS}at a slower rate with sub-steps no shorter than these`,
  'Drafts are not measured: cook it as games get it',
  'This asset was not measured when it was cooked',
  'What was measured is the solver coif',
  "What was measured is how hair moves by the asset's own numbers",
  'What was measured is finer than this rate with its sub-steps',
];

function tipError(n) {
  const percent = (share) => `${Number((100 * share).toPrecision(2))} %`;
  const known = `${['', '\u2264 '][n.tipErrorSource]}${percent(n.tipRms)}, at most ${percent(n.tipMax)}`;
  return ['tip error', n.tipErrorSource > 1 ? '-' : known, TIP_TITLES[n.tipErrorSource]];
}

/** Writes into `strip` the numbers `n` of WasmPage.numbers(), and the pictures per second. */
export function showNumbers(strip, n, rate) {
  const cost = n.stepNsOfBone > 0 ? `${n.stepNsOfBone.toFixed(0)} ns` : '-';
  const numbers = [
    ['a bone and sub-step', cost, 'In a crowd of 64 heads, in this browser'],
    ['bones', n.bones], ['sub-steps', n.substeps], ['triangles', n.triangles.toLocaleString('en')],
    tipError(n), ['asset', sizeText(n.assetBytes)], n.asleep ? ['at rest', ''] : ['pictures a second', rate.toFixed(0)],
  ];
  strip.replaceChildren(...numbers.map(([what, value, title = '']) => {
    const cell = document.createElement('span');
    cell.title = title;
    const strong = document.createElement('b');
    strong.textContent = value;
    cell.append(strong, ` ${what}`);
    return cell;
  }));
}
