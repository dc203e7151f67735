// Small pictures that say what lines and cells mean.

/** What the lines of the scene mean, drawn in small. */
function fillLegend(list) {
  const entries = [
    ['critical', 'contact within critical_time'], ['warn', 'contact within warn_time'],
    ['later', 'contact later, within the horizon'], ['free', 'a segment that nothing touches'],
    ['unknown', 'cannot tell'], ['irrelevant', 'an obstacle that touches nothing first'],
    ['ghost', 'robot and obstacle at the moment of contact'], ['arrow', 'one second of motion'],
  ];
  fillSamples(list, entries, drawSample);
}

/** A small picture, drawn once it is on the page, and words for each entry. */
function fillSamples(list, entries, draw) {
  list.replaceChildren(...entries.map(([, words]) => element('li', {}, element('canvas'), words)));
  entries.forEach(([look], i) => draw(list.children[i].firstChild, look));
}

function drawSample(canvas, look) {
  const {context: pen, width, height} = sharpContext(canvas);
  const style = styles[look] || {width: 0.03, dash: look === 'ghost' ? 0.1 : 0, gap: 0.07};
  pen.strokeStyle = styles[look] ? colourOf(look) : themeColour('text');
  pen.lineWidth = 1.2 + 35 * style.width;
  pen.setLineDash(style.dash ? [50 * style.dash, 50 * style.gap] : []);
  pen.beginPath();
  pen.moveTo(1, height / 2);
  pen.lineTo(width - 1, height / 2);
  if (look === 'arrow') {
    pen.moveTo(width - 7, height / 2 - 4);
    pen.lineTo(width - 1, height / 2);
    pen.lineTo(width - 7, height / 2 + 4);
  }
  pen.stroke();
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
