// What the two charts, of time to collision and the strip below it, have in common: both are uPlot
// charts with the same time axis.

const AXIS_WIDTH = 62;
const ZOOMED = 20;  // [s] that are seen at once

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

/** The whole recording, unless zoomed in. */
function whole(report) {
  const [begin, end] = timeRange(report);
  return (u, min, max) => (min === null || max === null || max <= min || u.data[0].length < 2 ||
      (min <= u.data[0][0] && max >= u.data[0][u.data[0].length - 1])
    ? [begin, end] : [Math.max(min, begin), Math.min(max, end)]);
}
