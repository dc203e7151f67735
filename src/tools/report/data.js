// The data of the page, from the arrays that frame_json.hpp describes.

const FINE = 1e-4;  // what lengths and rates of a scene are multiples of

/** null is none, "?" is not known. */
function limitless(value) {
  if (value === null) return Infinity;
  return value === '?' ? NaN : value;
}

function toObstacle([index, id, ttc, x, y, vx, vy, radius, ax = 0, ay = 0, growth = 0, outline = []]) {
  return {
    index, id, ttc: limitless(ttc),
    position: [x * FINE, y * FINE], velocity: [vx * FINE, vy * FINE],
    acceleration: [ax * FINE, ay * FINE], radius: radius * FINE, growth: growth * FINE,
    outline: outline.map(([px, py]) => [px * FINE, py * FINE]),
  };
}

function toScene([twist, contact, segments, obstacles, undrawn, footprint]) {
  return {
    twist: {linear: [twist[0] * FINE, twist[1] * FINE], angular: twist[2] * FINE},
    contact: contact.map((c) => c * FINE),
    segments: segments.map(limitless),
    obstacles: obstacles.map(toObstacle),
    undrawn,
    footprint: footprint.map(([x, y]) => [x * FINE, y * FINE]),
  };
}

/** An evaluation: t [s] since the begin of the window; scene is null where nothing was predicted. */
function toFrame([t, level, ttc, clearance, closing, segment, id, reason, scene]) {
  return {
    t, level, ttc: limitless(ttc), clearance: limitless(clearance), closing: limitless(closing),
    segment, id, reason, scene: scene && toScene(scene),
  };
}

/** Everything that the page shows. `seconds` is how much of the recording was analysed. */
function readReport() {
  const report = JSON.parse(byId('data').textContent);
  styles = report.styles;
  report.frames = report.frames.map(toFrame);
  report.seconds = report.bag.seconds || 0;
  report.levels = report.levels.map(([begin, level], i, all) => ({
    begin, level, end: i + 1 < all.length ? all[i + 1][0] : report.seconds,
  }));
  const given = report.parameters.footprint;
  const first = report.frames.find((frame) => frame.scene);
  report.footprint = given || (first ? first.scene.footprint : []);
  return report;
}

/** Place of the last frame at or before t; the first one before it. */
function frameAt(frames, t) {
  let low = 0;
  let high = frames.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (frames[middle].t <= t + 1e-6) low = middle + 1;
    else high = middle;
  }
  return Math.max(0, low - 1);
}

/** The frame with the smallest clearance; undefined where none is known. */
function nearestFrame(frames) {
  const known = frames.filter((frame) => Number.isFinite(frame.clearance));
  return known.reduce((best, frame) => (frame.clearance < best.clearance ? frame : best), known[0]);
}

/** When [s] it was nearest to a contact; without one, where nothing was known if that is the
    verdict, else when it was nearest to anything. */
function worstMoment(report) {
  const {smallest_time_to_collision: worst, state} = report.bag;
  if (worst) return worst.elapsed;
  const unknown = report.frames.find((frame) => isUnknown(report, frame));
  if (state === 'unknown' && unknown) return unknown.t;
  return (nearestFrame(report.frames) || report.frames[0]).t;
}

/** Names of the reasons in a mask. */
function reasonNames(report, mask) {
  return Object.entries(report.reason_names)
    .filter(([bit]) => (mask & bit) !== 0)
    .map(([, name]) => name);
}

/** Whether the inputs keep the predictor from telling; while a level settles they do not. */
function isUnknown(report, frame) {
  return (frame.reason & report.unknown_reasons) !== 0;
}
