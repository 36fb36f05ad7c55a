// How the head moves when the page opens: what `coif view --motion` put into it.

/** What `text` says, {"motion": name, "keys": base64 of a clip}; '' where nobody has filled it in. Gives the clip to `wasm`. */
export function takeMotion(wasm, text) {
  if (!text.startsWith('{')) return '';
  const { motion, keys } = JSON.parse(text);
  if (!keys) return motion;
  wasm.clip(Uint8Array.from(atob(keys), (c) => c.charCodeAt(0)));
  document.getElementById('hint').textContent += ` The clip is ${motion}.`;
  return 'clip';
}

/** Of an asset that was opened just now. */
export function beginMotion(page) {
  if (!page.motion) return;
  page.set('motion', page.motion);
  page.set('plays', 1);
}
