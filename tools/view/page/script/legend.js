// The legend: the meaning of a view's colours.

let legendShown = '';

/** `text`: {"title", "colors": [{"color", "text"}]} as JSON; an empty title hides `box`. */
export function showLegend(box, text) {
  if (text === legendShown) return;
  legendShown = text;
  const { title, colors } = JSON.parse(text);
  const heading = document.createElement('b');
  heading.textContent = title;
  const entries = colors.map((entry) => {
    const swatch = document.createElement('i');
    swatch.style.background = entry.color;
    const line = document.createElement('li');
    line.append(swatch, entry.text);
    return line;
  });
  const list = document.createElement('ul');
  list.append(...entries);
  box.replaceChildren(heading, ...(colors.length > 0 ? [list] : []));
  box.hidden = title === '';
}
