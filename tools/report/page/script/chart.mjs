// Charts of a report, drawn by Chart.js: hovering shows a point's values, a dragged box zooms in, the legend's buttons switch series.

import { chartData } from './chart_data.mjs';
import { numberText, valueText } from './format.mjs';
import { filledText } from './rows.mjs';
import { element } from './table.mjs';

// Bright enough for a dark page, dark enough for a light one; the shapes of points distinguish them as well.
const COLORS = ['#2f8fd8', '#e0662f', '#2aa876', '#c05fb5', '#c79a1e', '#d9486e', '#4fb3c8', '#8f7be0', '#a5744a', '#7fa832', '#d98cae', '#5d86a8'];
const SHAPES = ['circle', 'rect', 'triangle', 'rectRot', 'rectRounded', 'star'];
const GREY = '#8a93a3';  // everything that is not data
const FONT = { family: 'system-ui, sans-serif', size: 12.5 };

const colorOf = (one) => (one.style === 'dashed' ? GREY : COLORS[one.color % COLORS.length]);
const shapeOf = (one) => SHAPES[one.color % SHAPES.length];
const isHollow = (one) => one.color % (2 * SHAPES.length) >= SHAPES.length;
const hasShapes = (one) => one.style !== 'dashed' && one.style !== 'bare';

function dataset(one) {
  const color = colorOf(one);
  return {
    label: one.name, data: one.points, hidden: !one.isOn, showLine: one.style !== 'points', borderColor: color, borderWidth: 1.9, clip: 10,
    borderDash: one.style === 'dashed' ? [6, 5] : [], pointStyle: shapeOf(one), pointRadius: hasShapes(one) ? 4 : 0, pointHoverRadius: 7,
    pointBorderColor: color, pointBackgroundColor: isHollow(one) ? 'transparent' : color, pointHoverBackgroundColor: color,
  };
}

/** Ticks at 1, 2 and 5 of every decade, or only at powers of ten if there are many. */
function logTicks(low, high) {
  const first = Math.floor(Math.log10(low)), last = Math.ceil(Math.log10(high)), step = 1 + Math.floor((last - first) / 12);
  const ticks = [];
  for (let decade = first; decade <= last; decade += step) {
    for (const digit of last - first <= 3 ? [1, 2, 5] : [1]) ticks.push(Number(`${digit}e${decade}`));
  }
  return ticks;
}

/** `drawn`: all values on the axis, including lines across the chart; `wanted`: ticks, or nothing. */
function scaleOf(axis, drawn, wanted) {
  const scale = {
    type: axis.log ? 'logarithmic' : 'linear', beginAtZero: !axis.log, title: { display: true, text: axis.label, font: FONT }, grid: {},
    ticks: { callback: (value) => String(Number(value.toPrecision(6))), maxRotation: 0, autoSkip: !axis.log && !wanted, font: FONT },
  };
  if (axis.log || wanted) {
    scale.afterBuildTicks = (built) => {
      const within = (wanted ?? logTicks(built.min, built.max)).filter((value) => value >= built.min && value <= built.max);
      if (within.length > 1) built.ticks = within.map((value) => ({ value }));
    };
  }
  const margin = axis.log ? 1.2 : 1;
  const least = Math.min(...drawn) / margin, most = Math.max(...drawn) * margin;
  return axis.log ? { ...scale, min: least, max: most } : { ...scale, suggestedMin: least, suggestedMax: most };
}

/** Draws lines across the chart with their names, rings around marked points, and the box that is being dragged. */
const marks = {
  id: 'marks',
  afterDatasetsDraw(chart, _, { lines, ink }) {
    const { ctx, chartArea: area } = chart;
    ctx.save();
    ctx.font = `12px ${FONT.family}`;
    ctx.setLineDash([2, 4]);
    ctx.strokeStyle = ctx.fillStyle = ink;
    for (const { at, label } of lines) {
      const y = chart.scales.y.getPixelForValue(at);
      if (y < area.top || y > area.bottom) continue;
      ctx.beginPath();
      ctx.moveTo(area.left, y);
      ctx.lineTo(area.right, y);
      ctx.stroke();
      ctx.textAlign = 'right';
      ctx.fillText(label, area.right - 6, y - 5);
    }
    ctx.setLineDash([]);
    chart.getSortedVisibleDatasetMetas().forEach((meta) => meta.data.forEach((point, i) => {
      if (!chart.data.datasets[meta.index].data[i].ringed) return;
      ctx.strokeStyle = chart.data.datasets[meta.index].borderColor;
      ctx.beginPath();
      ctx.arc(point.x, point.y, 8.5, 0, 2 * Math.PI);
      ctx.stroke();
    }));
    if (chart.box) {
      ctx.strokeStyle = ink;
      ctx.strokeRect(chart.box.x, chart.box.y, chart.box.width, chart.box.height);
    }
    ctx.restore();
  },
};

/** Zooms into a box that the mouse drags. `reset` or a double click ends the zoom. */
function addZoom(chart, canvas, reset) {
  let begin;
  const set = (name, from, to) => Object.assign(chart.options.scales[name], { min: from, max: to });
  const whole = Object.fromEntries(['x', 'y'].map((name) => [name, [chart.options.scales[name].min, chart.options.scales[name].max]]));
  const placeOf = (event) => {
    const at = canvas.getBoundingClientRect(), { left, right, top, bottom } = chart.chartArea;
    return { x: Math.min(Math.max(event.clientX - at.left, left), right), y: Math.min(Math.max(event.clientY - at.top, top), bottom) };
  };
  canvas.addEventListener('pointerdown', (event) => {
    if (event.pointerType === 'touch' || event.button !== 0) return;
    begin = placeOf(event);
    canvas.setPointerCapture(event.pointerId);
  });
  canvas.addEventListener('pointermove', (event) => {
    if (!begin) return;
    const end = placeOf(event);
    chart.box = { x: Math.min(begin.x, end.x), y: Math.min(begin.y, end.y), width: Math.abs(end.x - begin.x), height: Math.abs(end.y - begin.y) };
    chart.draw();
  });
  const finish = () => {
    const box = chart.box, { x, y } = chart.scales;
    begin = chart.box = undefined;
    if (box && box.width > 8 && box.height > 8) {
      const [left, right, top, bottom] = [x.getValueForPixel(box.x), x.getValueForPixel(box.x + box.width), y.getValueForPixel(box.y), y.getValueForPixel(box.y + box.height)];
      set('x', left, right);
      set('y', bottom, top);
      reset.hidden = false;
    }
    chart.update('none');
  };
  canvas.addEventListener('pointerup', finish);
  canvas.addEventListener('pointercancel', () => { begin = chart.box = undefined; chart.draw(); });
  const unzoom = () => {
    set('x', ...whole.x);
    set('y', ...whole.y);
    reset.hidden = true;
    chart.update('none');
  };
  canvas.addEventListener('dblclick', unzoom);
  reset.addEventListener('click', unzoom);
}

function sampleOf(one) {
  const canvas = element('canvas', { width: 76, height: 28, class: 'sample', 'aria-hidden': 'true' });
  const context = canvas.getContext('2d');
  context.scale(2, 2);
  context.strokeStyle = colorOf(one);
  context.fillStyle = isHollow(one) ? 'transparent' : colorOf(one);
  context.lineWidth = 1.9;
  if (one.style === 'dashed') context.setLineDash([6, 5]);
  if (one.style !== 'points') context.stroke(new Path2D('M2 7H36'));
  if (hasShapes(one)) Chart.helpers.drawPoint(context, { pointStyle: shapeOf(one), radius: 4, borderWidth: 1.9 }, 19, 7);
  return canvas;
}

/** A button for each series: a click switches it on or off, a double click shows it alone, or all again. */
function legendOf(chart, series) {
  const buttons = series.map((one) => element('button', { type: 'button', 'aria-pressed': String(one.isOn) }, sampleOf(one), one.name));
  const set = (i, isOn) => {
    chart.setDatasetVisibility(i, isOn);
    buttons[i].setAttribute('aria-pressed', String(isOn));
  };
  buttons.forEach((button, i) => {
    button.addEventListener('click', () => { set(i, !chart.isDatasetVisible(i)); chart.update('none'); });
    button.addEventListener('dblclick', () => {
      const isAlone = buttons.every((_, k) => (k === i) === chart.isDatasetVisible(k));
      buttons.forEach((_, k) => set(k, isAlone || k === i));
      chart.update('none');
    });
  });
  return element('div', { class: 'legend', role: 'group', 'aria-label': 'Series: click switches one, double click shows it alone' }, ...buttons);
}

/** The chart's points as text, for readers who cannot see it. */
function pointsTable(chart, series) {
  const rows = series.flatMap((one) => one.points.map((point) => element('tr', {}, element('td', {}, one.name),
    element('td', { class: 'number' }, numberText(point.x)), element('td', { class: 'number' }, numberText(point.y)))));
  const head = element('tr', {}, ...['series', chart.x.label, chart.y.label].map((title) => element('th', { scope: 'col' }, title)));
  return element('details', {}, element('summary', {}, 'The points as a table'),
    element('div', { class: 'table' }, element('table', {}, element('thead', {}, head), element('tbody', {}, ...rows))));
}

const drawn = [];

/** The page's present colours for everything that is not data; paper is light. */
function theme(chart) {
  const style = getComputedStyle(document.documentElement), isPaper = document.documentElement.classList.contains('paper');
  const ink = isPaper ? '#000000' : style.getPropertyValue('--text').trim(), line = isPaper ? '#cfd4da' : style.getPropertyValue('--line').trim();
  chart.options.plugins.marks.ink = ink;
  for (const scale of Object.values(chart.options.scales)) {
    Object.assign(scale.grid, { color: line, borderColor: ink });
    scale.ticks.color = scale.title.color = ink;
  }
  chart.update('none');
}

/** Draws all charts again after the colours changed to dark, light or paper. */
export function drawAgain() {
  drawn.forEach(theme);
}

function tooltipOf(spec) {
  const more = (row) => (spec.tips ?? []).map((tip) => `${tip.title}: ${valueText(row[tip.key], tip)}`);
  return {
    callbacks: {
      title: ([item]) => item?.dataset.label ?? '',
      label: ({ raw }) => [`${spec.x.label}: ${numberText(raw.x)}`, `${spec.y.label}: ${numberText(raw.y)}`, ...more(raw.row)],
    },
    filter: (item) => item.dataset.borderDash.length === 0,  // leaves out series that only join the points of others
    displayColors: false, borderColor: GREY, borderWidth: 1, bodyFont: FONT, titleFont: FONT,
  };
}

/** `spec`: a layout's "chart". */
export function drawChart(spec, report, scope) {
  const { series, lines, leftOut, ticks } = chartData(spec, report, scope);
  const title = filledText(spec.title, report, scope);
  const note = leftOut > 0 ? ` Values above ${spec.y.most} ${spec.y.unit ?? ''} are left out.` : '';
  const caption = element('figcaption', {}, filledText(spec.caption ?? '', report, scope) + note);
  if (series.length === 0) return element('figure', {}, element('h3', {}, title), element('p', { class: 'empty' }, 'no data'), caption);
  const valuesOn = (name) => series.flatMap((one) => one.points.map((point) => point[name]));
  const scales = { x: scaleOf(spec.x, valuesOn('x'), ticks), y: scaleOf(spec.y, [...valuesOn('y'), ...lines.map((line) => line.at)]) };
  const canvas = element('canvas', { role: 'img', 'aria-label': `${title}. ${caption.textContent}` });
  const reset = element('button', { type: 'button', class: 'reset', hidden: true }, 'Show all again');
  reset.hidden = true;
  const head = element('div', { class: 'head' }, element('h3', {}, title), reset);
  const box = element('div', { class: 'chart' }, canvas);
  const chart = new Chart(canvas, {
    type: 'scatter', data: { datasets: series.map(dataset) }, plugins: [marks],
    options: {
      animation: false, responsive: true, maintainAspectRatio: false, devicePixelRatio: Math.max(2, window.devicePixelRatio),
      interaction: { mode: 'nearest', intersect: false }, scales,
      plugins: { legend: { display: false }, marks: { lines, ink: GREY }, tooltip: tooltipOf(spec) },
    },
  });
  theme(chart);
  drawn.push(chart);
  addZoom(chart, canvas, reset);
  return element('figure', {}, head, box, legendOf(chart, series), caption, pointsTable(spec, series));
}
