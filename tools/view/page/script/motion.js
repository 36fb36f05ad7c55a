// The head's motion when the page opens, from `coif view --motion`.

/** The motion in `text`, {"motion": name, "keys": base64 of a clip}; '' if the page has none. Gives the clip to `wasm`. */
export function takeMotion(wasm, text) {
  if (!text.startsWith('{')) return '';
  const { motion, keys } = JSON.parse(text);
  if (!keys) return motion;
  wasm.clip(Uint8Array.from(atob(keys), (c) => c.charCodeAt(0)));
  document.getElementById('hint').textContent += ` The clip is ${motion}.`;
  return 'clip';
}

/** Plays the motion that the page was made with, for an asset that was just opened. */
export function beginMotion(page) {
  if (!page.motion) return;
  page.set('motion', page.motion);
  page.set('plays', 1);
}
