// Time to collision over time.

const CHART_HEIGHT = 240;
const NONE_LANE = 1.13;  // where "none" is drawn, as a multiple of the horizon

function ttcChart(charts, parent) {
  const {report} = charts;
  const {horizon} = report.parameters;
  const times = report.frames.map((frame) => frame.t);
  const known = report.frames.map((frame) => (Number.isFinite(frame.ttc) ? frame.ttc : null));
  const none = report.frames.map((frame) => (frame.ttc === Infinity ? NONE_LANE * horizon : null));
  const line = (stroke, width) => ({stroke, width, spanGaps: false,
                                    points: {show: times.length < 400, size: 4, fill: stroke}});
  const options = charts.common(CHART_HEIGHT, {
    drawClear: [(u) => drawBands(u, report)],
    draw: [(u) => drawTruth(u, report), (u) => drawEventNumbers(u, report)],
  });
  return new uPlot({
    ...options,
    scales: {x: {time: false, range: whole(report)}, y: {range: () => [0, 1.24 * horizon]}},
    axes: [timeAxis(), ttcAxis(report)],
    series: [{}, line(() => themeColour('text'), 2), line(() => colourOf('free'), 3)],
  }, [times, known, none], parent);
}

function ttcAxis(report) {
  const {horizon, warn_time: warn, critical_time: critical} = report.parameters;
  const step = roundUp(horizon / 6);
  const limits = [0, critical, warn, horizon].filter((t, i, all) => !i || t > all[i - 1]);
  const rounds = [...Array(Math.ceil(horizon / step)).keys()].map((i) => i * step)
    .filter((t) => limits.every((limit) => Math.abs(t - limit) > 0.11 * horizon));
  const splits = [...rounds, ...limits].sort((a, b) => a - b);
  return {
    ...axisStyle(), size: AXIS_WIDTH,
    splits: () => [...splits, NONE_LANE * horizon],
    values: (u, ticks) => ticks.map(
      (t) => (t > horizon ? 'none' : `${Number(t.toFixed(2))} s`)),
  };
}

/** The levels' bands, and hatching where it is not known. */
function drawBands(u, report) {
  const {horizon, warn_time: warn, critical_time: critical} = report.parameters;
  const [begin, end] = timeRange(report);
  for (const [look, from, to] of [['critical', 0, critical], ['warn', critical, warn],
                                  ['later', warn, horizon]])
    fill(u, colourOf(look, 0.2), begin, end, from, to);
  const hatched = hatching(u.ctx, colourOf('unknown', 0.85));
  for (const run of report.levels)
    if (run.level === 0) fill(u, hatched, run.begin, run.end, 0, 2 * horizon);
}

/** The time that was left until each contact: what a right prediction would have said. */
function drawTruth(u, report) {
  const {horizon} = report.parameters;
  const {left, top, width, height} = u.bbox;
  const pen = u.ctx;
  pen.save();
  pen.beginPath();
  pen.rect(left, top, width, height);
  pen.clip();
  pen.strokeStyle = themeColour('accent');
  pen.lineWidth = 1.5 * (window.devicePixelRatio || 1);
  pen.setLineDash([7, 6]);
  for (const event of report.events.filter((e) => e.contact)) {
    pen.beginPath();
    pen.moveTo(u.valToPos(event.worst - horizon, 'x', true), u.valToPos(horizon, 'y', true));
    pen.lineTo(u.valToPos(event.worst, 'x', true), u.valToPos(0, 'y', true));
    pen.stroke();
  }
  pen.restore();
}

/** The number of each approach above its worst moment, as the table has it; where there is room. */
function drawEventNumbers(u, report) {
  const ratio = window.devicePixelRatio || 1;
  const pen = u.ctx;
  pen.font = `${12 * ratio}px system-ui, "DejaVu Sans", sans-serif`;
  pen.textAlign = 'center';
  pen.fillStyle = themeColour('text');
  let free = -Infinity;
  report.events.forEach((event, i) => {
    const x = u.valToPos(event.worst, 'x', true);
    const half = pen.measureText(String(i + 1)).width / 2 + 3 * ratio;
    if (x - half < free || x < u.bbox.left || x > u.bbox.left + u.bbox.width) return;
    free = x + half;
    pen.fillText(String(i + 1), x, u.bbox.top - 4 * ratio);
    pen.fillRect(x - ratio / 2, u.bbox.top - 2 * ratio, ratio, 5 * ratio);
  });
}
