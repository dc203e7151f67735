// The strip: a row for each segment of the footprint, below one for the level.

function stripChart(charts, parent) {
  const {report} = charts;
  const rows = Math.max(report.footprint.length, ...report.frames.map((f) => (f.scene ? f.scene.segments.length : 0)));
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
