// How levels look: the styles of the markers in RViz, which come with the data. They differ in
// width, dashes, signs and words, not in colour alone.

const LEVELS = ['UNKNOWN', 'CLEAR', 'WARN', 'CRITICAL'];  // by CollisionWarning's numbers
const LOOK_OF_LEVEL = ['unknown', 'free', 'warn', 'critical'];
const SIGN_OF_LEVEL = ['?', '\u2713', '!', '\u2715'];

/** By the state that summary.json gives a recording. */
const LEVEL_OF_STATE = {contact: 3, predicted: 2, none: 1, unknown: 0};

let styles = {};  // of every look: {rgb, width, dash, gap}

/** CSS colour of a look. */
function colourOf(look, opacity = 1) {
  return `rgba(${styles[look].rgb.join(',')},${opacity})`;
}

/** The look of a time to collision: Infinity and NaN are `otherwise`. */
function lookOf(ttc, parameters, otherwise) {
  if (!Number.isFinite(ttc)) return otherwise;
  if (ttc <= parameters.critical_time) return 'critical';
  return ttc <= parameters.warn_time ? 'warn' : 'later';
}

/** A level's sign and name, or other words in its look. */
function chip(level, text = LEVELS[level]) {
  const made = element('span', {class: 'chip', 'data-sign': SIGN_OF_LEVEL[level]}, text);
  made.style.setProperty('--chip', colourOf(LOOK_OF_LEVEL[level]));
  return made;
}

/** A colour of the style sheet, which dark mode changes. */
function themeColour(name) {
  return getComputedStyle(document.documentElement).getPropertyValue(`--${name}`).trim();
}

/** Hatching, which says "unknown" wherever it is. */
function hatching(context, colour) {
  const ratio = window.devicePixelRatio || 1;
  const tile = document.createElement('canvas');
  tile.width = tile.height = Math.round(8 * ratio);
  const pen = tile.getContext('2d');
  pen.strokeStyle = colour;
  pen.lineWidth = 1.6 * ratio;
  const size = tile.width;
  pen.beginPath();
  for (const shift of [-size, 0, size]) {
    pen.moveTo(shift, size);
    pen.lineTo(shift + size, 0);
  }
  pen.stroke();
  return context.createPattern(tile, 'repeat');
}
