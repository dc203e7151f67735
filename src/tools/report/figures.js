// What the recording comes to, at the top of the page. The numbers are those of summary.json.

function figure(title, value, ...details) {
  return element('div', {class: 'figure'}, element('h2', {}, title),
                 element('p', {class: 'value', 'data-figure': title}, value),
                 ...details.map((detail) => element('p', {}, detail)));
}

/** A link to a moment [s]. */
function momentLink(t, text = secondsText(t)) {
  return element('a', {href: `#t=${Number(t.toFixed(6))}`}, text);
}

/** The level whose sign the verdict has. */
function verdictLevel(bag, parameters) {
  if (bag.state !== 'predicted') return LEVEL_OF_STATE[bag.state];
  return bag.smallest_time_to_collision.time_to_collision <= parameters.warn_time ? 2 : 1;
}

function sentence(words) {
  return `${words[0].toUpperCase()}${words.slice(1)}.`;
}

/** What there is to say of --fail-under; nothing where it is kept. */
function limitText({bag, fail_under: limit, max_unknown: most}) {
  if (bag.limit_broken) return `Limit broken: a time to collision is under ${limit} s.`;
  const unproven = limit !== null && !(bag.unknown_percent <= most);
  return unproven && `Limit not proven: more than ${most} % of the time is unknown.`;
}

function fillHeader(report) {
  const {bag} = report;
  document.title = `${nameOf(bag)} - collision report`;
  byId('bag').textContent = nameOf(bag);
  byId('all-bags').hidden = !report.several;
  byId('verdict').replaceChildren(chip(verdictLevel(bag, report.parameters), sentence(report.verdict)));
  showText('partial', bag.partial && (bag.evaluations
    ? `Partial: only ${secondsText(report.seconds)} of ${secondsText(report.window_seconds)} were ` +
      'analysed. What follows says nothing of the rest.'
    : 'Partial: interrupted before its begin, nothing was analysed.'));
  showText('limit', limitText(report));
  showText('problem', bag.problem);
  byId('program').textContent = report.program + (report.thinned
    ? '. The replay shows fewer moments away from approaches, or all through where there are very ' +
      'many; frames.csv has every one.' : '');
}

function ttcFigure(bag) {
  const worst = bag.smallest_time_to_collision;
  if (!worst)
    return figure('Smallest time to collision', bag.state === 'unknown' ? 'unknown' : 'none',
                  bag.state === 'unknown' ? 'too little could be evaluated'
                                          : 'no contact was ever predicted');
  const who = obstacleText(worst.obstacle_id, worst.obstacle_index);
  return figure('Smallest time to collision', ttcText(worst.time_to_collision),
                element('span', {}, 'at ', momentLink(worst.elapsed), `, segment ${worst.segment}, obstacle ${who}`));
}

function clearanceFigure(report) {
  const smallest = report.bag.smallest_clearance;
  const frame = nearestFrame(report.frames);
  const words = smallest < 0 ? 'below 0: so deep inside each other' : 'from the footprint to an obstacle';
  if (!frame || smallest === null)
    return figure('Smallest clearance', report.bag.state === 'unknown' ? 'unknown' : 'none', 'no obstacle was seen');
  return figure('Smallest clearance', metresText(smallest),
                element('span', {}, 'at ', momentLink(frame.t), `, ${words}`));
}

function approachFigure(report) {
  const {bag} = report;
  const some = bag.events_with_contact ? `${bag.events_with_contact} with contact`
                                       : 'none of them with contact';
  return figure('Approaches', bag.events, bag.events ? some : 'nothing came nearer than warn_time',
                ...(bag.unknown_percent > 0.05 ? ['as far as it could be told'] : []));
}

function dataFigure(bag) {
  return figure('Data quality', percentText(100 - bag.unknown_percent) + ' usable',
                `${percentText(bag.unknown_percent)} of the time unknown`,
                `${bag.usable_evaluations} of ${bag.evaluations} evaluations usable` +
                (bag.silences ? `, ${bag.silences} silence${bag.silences > 1 ? 's' : ''}` : ''));
}

/** How long the recording was at each level, as a bar and in words. */
function levelsFigure(report) {
  const seconds = report.bag.seconds_at_level;
  const total = Object.values(seconds).reduce((a, b) => a + b, 0) || 1;
  const order = ['CLEAR', 'WARN', 'CRITICAL', 'UNKNOWN'];
  const bar = element('div', {class: 'bar'});
  const shares = element('ul', {class: 'shares'});
  for (const name of order) {
    const level = LEVELS.indexOf(name);
    if (seconds[name] > 0) {
      const part = element('span', {title: name});
      part.style.setProperty('--chip', colourOf(LOOK_OF_LEVEL[level]));
      part.style.flexGrow = seconds[name] / total;
      if (level === 0) part.style.backgroundImage = 'repeating-linear-gradient(135deg, transparent 0 4px, #0008 4px 6px)';
      bar.append(part);
    }
    const share = element('span', {'data-seconds': name}, secondsText(seconds[name], 1));
    shares.append(element('li', {}, chip(level), ' ', share, ` (${percentText(100 * seconds[name] / total)})`));
  }
  const made = element('div', {class: 'figure levels'}, element('h2', {}, 'Time at each level'), bar, shares);
  return made;
}

function fillFigures(report) {
  const {bag} = report;
  if (!bag.evaluations) return;
  byId('figures').replaceChildren(ttcFigure(bag), clearanceFigure(report), approachFigure(report),
                                  dataFigure(bag), levelsFigure(report));
}

/** What kept the predictor from telling, or degraded its answers. */
function fillQuality(report) {
  const reasons = report.bag.reasons || [];
  byId('quality').hidden = reasons.length === 0;
  const head = element('tr', {}, element('th', {}, 'Reason'),
                       element('th', {class: 'number optional'}, 'Evaluations'),
                       element('th', {class: 'number'}, 'Share'), element('th', {}, 'First of them'));
  const rows = reasons.map((r) => element(
    'tr', {}, element('td', {}, r.reason), element('td', {class: 'number optional'}, r.evaluations),
    element('td', {class: 'number'}, percentText(r.percent)),
    element('td', {class: 'words'}, r.first_message)));
  byId('reasons').replaceChildren(element('thead', {}, head), element('tbody', {}, ...rows));
}

function fillInputs(report) {
  const {bag, parameters} = report;
  const entries = {...(bag.topics || {}), ...parameters};
  if (bag.start) entries.start = `${bag.start} s (${new Date(1000 * bag.start).toISOString()})`;
  byId('inputs').replaceChildren(...Object.entries(entries).flatMap(([name, value]) => [
    element('dt', {}, name),
    element('dd', {}, value === null ? '-' : typeof value === 'object' ? JSON.stringify(value) : value),
  ]));
}
