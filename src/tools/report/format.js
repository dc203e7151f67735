// Numbers and small pieces of the page. Text is always set as text, never as markup: names in a
// recording may be anything.

/** A time [s] in digits that a person can read. */
function secondsText(value, digits = 2) {
  return `${value.toFixed(digits)} s`;
}

/** A time to collision [s]: Infinity is none within the horizon, NaN is not known. */
function ttcText(value) {
  if (Number.isNaN(value)) return 'unknown';
  if (value === Infinity) return 'none';
  return value <= 0 ? '0 s: contact' : secondsText(value);
}

/** A length [m]; Infinity is none, NaN or null not known. */
function metresText(value) {
  if (value === null || Number.isNaN(value)) return 'unknown';
  return value === Infinity ? 'none' : `${value.toFixed(3)} m`;
}

/** A share of a whole in percent; never "0.0 %" for what is there. */
function percentText(percent) {
  if (percent > 0 && percent < 0.1) return '< 0.1 %';
  return `${percent.toFixed(1)} %`;
}

/** An obstacle by its id, else by its place in the message; both null: none. */
function obstacleText(id, index) {
  if (id !== null && id !== undefined) return String(id);
  return index === null || index === undefined ? '-' : `[${index}]`;
}

function byId(id) {
  return document.getElementById(id);
}

/** A new element with attributes and children, which are elements or text. */
function element(tag, attributes = {}, ...children) {
  const made = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) made.setAttribute(name, value);
  made.append(...children.map((child) => (child instanceof Node ? child : String(child))));
  return made;
}

/** Shows an element with a text, or leaves it hidden without one. */
function showText(id, text) {
  byId(id).hidden = !text;
  byId(id).textContent = text || '';
}

/** What a report is about: a recording, or one footprint in it. */
function nameOf(bag) {
  return bag.footprint ? `${bag.bag} [${bag.footprint}]` : bag.bag;
}
