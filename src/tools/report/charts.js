// Time to collision over time, and the strip with a row for each segment. Both are uPlot charts with
// the same time axis.

const AXIS_WIDTH = 62;
const CHART_HEIGHT = 240;
const ZOOMED = 20;  // [s] that are seen at once
const NONE_LANE = 1.13;  // where "none" is drawn, as a multiple of the horizon

const axisStyle = () => ({
  stroke: () => themeColour('muted'),
  grid: {stroke: () => themeColour('line'), width: 0.5},
  ticks: {stroke: () => themeColour('line'), width: 1, size: 5},
  font: '12px system-ui, "DejaVu Sans", sans-serif',
});

const timeAxis = () => ({...axisStyle(), values: (u, ticks) => ticks.map((t) => `${t} s`), space: 70,
                           size: 30});

/** A rectangle of the plot in canvas pixels, cut off at its edges; undefined when outside. */
function plotRectangle(u, t0, t1, y0, y1) {
  const {left, top, width, height} = u.bbox;
  const clamp = (value, low, size) => Math.min(low + size, Math.max(low, value));
  const x0 = clamp(u.valToPos(t0, 'x', true), left, width);
  const x1 = clamp(u.valToPos(t1, 'x', true), left, width);
  const bottom = clamp(u.valToPos(y0, 'y', true), top, height);
  const roof = clamp(u.valToPos(y1, 'y', true), top, height);
  return x1 > x0 && bottom > roof ? [x0, roof, Math.max(x1 - x0, 1), bottom - roof] : undefined;
}

function fill(u, style, ...rectangle) {
  const visible = plotRectangle(u, ...rectangle);
  if (!visible) return;
  u.ctx.fillStyle = style;
  u.ctx.fillRect(...visible);
}

/** The least of 1, 2, 5, 10, 20, ... that is not smaller. */
function roundUp(value) {
  const power = 10 ** Math.floor(Math.log10(value));
  return [1, 2, 5, 10].map((n) => n * power).find((s) => s >= value * (1 - 1e-9));
}

/** What both charts have: seeking by a click, the line of now, and one zoom for all. */
class Charts {
  constructor(report, seek) {
    this.report = report;
    this.seek = seek;
    this.t = 0;
    this.charts = [ttcChart(this, byId('ttc')), stripChart(this, byId('strip'))];
    for (const u of this.charts) this.addNow(u);
    new ResizeObserver(() => this.fit()).observe(byId('ttc'));
  }

  /** Where the page is now; a zoomed chart goes along. */
  show(t) {
    this.t = t;
    const {min, max} = this.charts[0].scales.x;
    if (t < min - 1e-6 || t > max + 1e-6) this.look(t, max - min);
    for (const u of this.charts) this.placeNow(u);
  }

  /** So many seconds around t. */
  look(t, seconds) {
    const [begin, end] = timeRange(this.report);
    const min = Math.max(begin, Math.min(t - seconds / 2, end - seconds));
    this.charts[0].setScale('x', {min, max: Math.min(end, min + seconds)});
  }

  /** Near to this moment, or back to the whole. */
  toggleZoom() {
    const [begin, end] = timeRange(this.report);
    const {min, max} = this.charts[0].scales.x;
    const zoomed = max - min < 0.99 * (end - begin);
    this.look(this.t, zoomed ? end - begin : Math.min(ZOOMED, (end - begin) / 2));
  }

  fit(width = byId('ttc').clientWidth) {
    for (const u of this.charts)
      if (width > 0 && u.width !== width) u.setSize({width, height: u.height});
  }

  redraw() {
    for (const u of this.charts) u.redraw(false, true);
  }

  addNow(u) {
    u.now = element('div', {class: 'now'});
    u.over.append(u.now);
    this.placeNow(u);
  }

  placeNow(u) {
    if (!u.now) return;
    const left = u.valToPos(this.t, 'x');
    u.now.hidden = !(left >= 0 && left <= u.over.clientWidth);
    u.now.style.left = `${left}px`;
  }

  /** Options of uPlot that both charts share. */
  common(height, hooks) {
    return {
      width: Math.max(byId('ttc').clientWidth, 200), height,
      legend: {show: false},
      cursor: {y: false, points: {show: false}, drag: {x: true, y: false, dist: 5}},
      hooks: {
        ...hooks,
        init: [(u) => this.listen(u)],
        setScale: [(u, key) => { if (key === 'x') this.zoomed(u); }],
        setSize: [(u) => this.placeNow(u)],
      },
    };
  }

  listen(u) {
    let pressed = 0;
    u.over.addEventListener('mousedown', (event) => { pressed = event.clientX; });
    u.over.addEventListener('click', (event) => {
      if (Math.abs(event.clientX - pressed) < 5)
        this.seek(u.posToVal(event.clientX - u.over.getBoundingClientRect().left, 'x'));
    });
  }

  zoomed(u) {
    this.placeNow(u);
    for (const other of this.charts || [])
      if (other !== u && (other.scales.x.min !== u.scales.x.min || other.scales.x.max !== u.scales.x.max))
        other.setScale('x', {min: u.scales.x.min, max: u.scales.x.max});
  }
}

/** [0, the recording's end]; a little more for a recording of one moment. */
function timeRange(report) {
  const last = report.frames.length ? report.frames[report.frames.length - 1].t : 0;
  return [0, Math.max(report.seconds, last, 0.1)];
}

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

/** The whole recording, unless zoomed in. */
function whole(report) {
  const [begin, end] = timeRange(report);
  return (u, min, max) => (min === null || max === null || max <= min || u.data[0].length < 2 ||
      (min <= u.data[0][0] && max >= u.data[0][u.data[0].length - 1])
    ? [begin, end] : [Math.max(min, begin), Math.min(max, end)]);
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

function stripChart(charts, parent) {
  const {report} = charts;
  const rows = Math.max(0, ...report.frames.map((f) => (f.scene ? f.scene.segments.length : 0)));
  const rowHeight = Math.max(4, Math.min(22, 300 / (rows + 1)));
  const cells = cellRuns(report, rows);
  const times = report.frames.map((frame) => frame.t);
  const options = charts.common(Math.round(rowHeight * (rows + 1)) + 46,
                                {drawClear: [(u) => drawCells(u, report, cells)]});
  return new uPlot({
    ...options,
    scales: {x: {time: false, range: whole(report)}, y: {range: () => [0, rows + 1]}},
    axes: [timeAxis(), stripAxis(rows, rowHeight)],
    series: [{}, {show: false}],
  }, [times, times.map(() => 0)], parent);
}

/** The level is the uppermost row, then segment 0. */
function stripAxis(rows, rowHeight) {
  const every = rowHeight >= 14 ? 1 : Math.ceil(14 / rowHeight);
  const shown = [...Array(rows).keys()].filter((i) => i % every === 0);
  const place = (i) => rows - i - 0.5;
  return {
    ...axisStyle(), size: AXIS_WIDTH, grid: {show: false}, ticks: {show: false},
    splits: () => [...shown.map(place), rows + 0.5].sort((a, b) => a - b),
    values: (u, ticks) => ticks.map((y) => (y > rows ? 'level' : `segm. ${Math.round(rows - y - 0.5)}`)),
  };
}

/** For each row the stretches of equal look: {row, look, begin, end}. */
function cellRuns(report, rows) {
  const runs = [];
  for (let row = 0; row < rows; ++row) {
    let open = {row, look: 'unknown', begin: 0, end: report.frames[0].t};
    runs.push(open);
    report.frames.forEach((frame, i) => {
      const end = i + 1 < report.frames.length ? report.frames[i + 1].t : timeRange(report)[1];
      const ttc = frame.scene ? frame.scene.segments[row] : NaN;
      const look = lookOf(ttc, report.parameters, ttc === Infinity ? 'free' : 'unknown');
      if (open.look === look) open.end = end;
      else runs.push(open = {row, look, begin: frame.t, end});
    });
  }
  return runs;
}

// Share of a row's height, so that looks differ in size as well as in colour.
const CELL_HEIGHT = {critical: 0.94, warn: 0.68, later: 0.42, free: 0.12, unknown: 0.94};

function drawCells(u, report, cells) {
  const rows = u.scales.y.max - 1;
  const draw = (look, begin, end, middle) => {
    const half = CELL_HEIGHT[look] / 2;
    const style = look === 'unknown' ? u.hatched : colourOf(look);
    fill(u, style, begin, end, middle - half, middle + half);
  };
  u.hatched = hatching(u.ctx, colourOf('unknown'));
  for (const run of report.levels)
    draw(LOOK_OF_LEVEL[run.level], run.begin, run.end, rows + 0.5);
  for (const cell of cells) draw(cell.look, cell.begin, cell.end, rows - cell.row - 0.5);
}

/** What the cells of the strip mean. */
function fillStripKey(list) {
  const entries = [['critical', 'within critical_time'], ['warn', 'within warn_time'],
                   ['later', 'later'], ['free', 'none'], ['unknown', 'unknown']];
  fillSamples(list, entries, drawCellSample);
}

function drawCellSample(canvas, look) {
  const {context: pen, width, height} = sharpContext(canvas);
  const tall = CELL_HEIGHT[look] * height;
  pen.fillStyle = look === 'unknown' ? hatching(pen, colourOf(look)) : colourOf(look);
  pen.fillRect(0, (height - tall) / 2, width, tall);
}
