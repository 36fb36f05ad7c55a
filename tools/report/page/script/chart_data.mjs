// Turns a layout's chart into the points of its series.

import { filledText, namesOf, rowsOf, valueAt } from './rows.mjs';

const LARGEST = 1e300;

const isDrawn = (value, axis) => Number.isFinite(value) && Math.abs(value) <= LARGEST && (!axis.log || value > 0);

const valueOn = (row, axis) => {
  const value = row[axis.key];
  return typeof value === 'number' ? value * (axis.scale ?? 1) : NaN;
};

/** Keeps the worst of several points at one x: the largest. One without a number is worse than all. */
function worstPoints(points) {
  const worst = new Map();
  for (const point of points) {
    const before = worst.get(point.x);
    const isWorse = !before || Number.isNaN(point.y) || point.y > before.y;
    if (isWorse && !(before && Number.isNaN(before.y))) worst.set(point.x, point);
  }
  return [...worst.values()];
}

function pointsOf(rows, of, chart) {
  const x = { ...chart.x, key: of.x ?? chart.x.key }, y = { ...chart.y, key: of.y ?? chart.y.key };
  let points = rows.map((row) => ({ x: valueOn(row, x), y: valueOn(row, y), row, ringed: of.ring !== undefined && row[of.ring] === true }));
  if (chart.of_several === 'worst') points = worstPoints(points);
  points = points.filter((point) => isDrawn(point.x, x) && isDrawn(point.y, y)).sort((a, b) => a.x - b.x);
  const shown = points.filter((point) => !(point.y > (y.most ?? Infinity)));
  return { points: shown, leftOut: points.length - shown.length };
}

/** The series of one entry of the layout: one for each value of its key "by", or a single one with a name. */
function seriesOf(of, chart, report, scope) {
  const rows = rowsOf(of, report, scope);
  if (of.by === undefined) return [{ name: filledText(of.name, report, scope), of, rows }];
  const colors = of.color_by ? namesOf(rowsOf({ rows: of.rows }, report, scope), of.color_by) : [];
  return namesOf(rows, of.by).map((name) => {
    const those = rows.filter((row) => row[of.by] === name);
    const color = of.color_by ? colors.indexOf(those[0][of.color_by]) : undefined;
    return { name: String(name), of, rows: those, color, isOn: of.on === undefined || those[0][of.on] === true };
  });
}

/** The lines across the chart that are near the drawn points; a line with "rows" stands for one line per record. */
function linesOf(chart, series, report, scope) {
  const drawn = series.flatMap((one) => one.points.map((point) => point.y)).filter((y) => y > 0);
  const least = Math.min(...drawn), most = Math.max(...drawn);
  return (chart.lines ?? []).flatMap((line) => {
    const rows = line.rows ? rowsOf(line, report, scope) : [{}];
    return rows.map((row) => ({
      at: typeof line.at === 'number' ? line.at : row[line.at] ?? valueAt(line.at, report),
      label: filledText(line.label, report, { ...scope, ...row }),
    })).filter(({ at }) => Number.isFinite(at) && (!line.near || (at > 0.1 * least && at < 2 * most)));
  });
}

/** {series: [{name, points, style, color, isOn}], lines, leftOut, ticks}. Leaves out series without points. */
export function chartData(chart, report, scope) {
  let leftOut = 0;
  const series = chart.series.flatMap((of) => seriesOf(of, chart, report, scope)).map((one, place) => {
    const made = pointsOf(one.rows, one.of, chart);
    leftOut += made.leftOut;
    return { name: one.name, style: one.of.style ?? 'line', color: one.color ?? place, isOn: one.isOn ?? true, points: made.points };
  }).filter((one) => one.points.length > 0);
  const ticks = chart.x.ticks ? [...new Set(series.flatMap((one) => one.points.map((point) => point.x)))].sort((a, b) => a - b) : undefined;
  return { series, lines: linesOf(chart, series, report, scope), leftOut, ticks };
}
