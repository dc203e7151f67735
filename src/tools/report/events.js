// The table of approaches.

const WARNED = 'Warned before';
const HOW_ENDED = {clear: 'clear', unknown: 'unknown', recording_end: 'with the recording'};

/** Columns: title, cell, and what class both have. */
const EVENT_COLUMNS = [  // "optional" ones are left out where there is no room
  ['#', (event, i) => momentLink(event.worst, i + 1), ''],
  ['From', (event) => secondsText(event.begin), 'number'],
  ['To', (event) => secondsText(event.end), 'number optional'],
  ['Level', (event) => chip(event.level), ''],
  ['Smallest TTC', (event) => (event.contact ? 'contact' : secondsText(event.time_to_collision)), 'number'],
  ['at', (event) => secondsText(event.worst), 'number optional'],
  [WARNED, (event) => (event.contact ? secondsText(event.worst - event.begin) : '-'), 'number'],
  ['Segment', (event) => (event.segment < 0 ? '-' : event.segment), 'number optional'],
  ['Obstacle', (event) => obstacleText(event.obstacle_id, event.obstacle_index), 'number'],
  ['Clearance', (event) => metresText(event.closest_distance), 'number optional'],
  ['Ended', (event) => HOW_ENDED[event.ended], 'optional'],
];

/** How long it was warned before a contact is of no interest without one. */
function columnsFor(events) {
  return EVENT_COLUMNS.filter(([title]) => title !== WARNED || events.some((event) => event.contact));
}

function eventRow(event, i, columns, jump) {
  const row = element('tr', {'data-event': i}, ...columns.map(
    ([, cell, look]) => element('td', {class: look}, cell(event, i))));
  row.addEventListener('click', (click) => {
    click.preventDefault();
    jump(event.worst);
  });
  return row;
}

function fillEvents(report, jump) {
  const {events, bag} = report;
  const missing = bag.events - events.length;
  showText('events-note', events.length === 0 ? 'Nothing came nearer than warn_time.'
    : 'Click one to see its worst moment.' + (events.some((event) => event.contact)
      ? ` "${WARNED}" is how long before the contact the level was WARN or higher.` : '') +
      (missing > 0 ? ` The nearest ${events.length} of ${bag.events}; events.csv has them all.` : ''));
  const columns = columnsFor(events);
  const head = element('tr', {}, ...columns.map(([title, , look]) => element('th', {class: look}, title)));
  byId('events').hidden = events.length === 0;
  byId('events').replaceChildren(element('thead', {}, head), element(
    'tbody', {}, ...events.map((event, i) => eventRow(event, i, columns, jump))));
}

/** Marks the row of the approach that t lies in. */
function markEvent(report, t) {
  for (const row of byId('events').querySelectorAll('tbody tr')) {
    const event = report.events[row.dataset.event];
    row.classList.toggle('current', t >= event.begin - 1e-6 && t <= event.end + 1e-6);
  }
}

/** Worst moment of the approach after t, or before it with direction -1; undefined: there is none. */
function nextEvent(events, t, direction) {
  const worst = events.map((event) => event.worst)
    .filter((moment) => direction * (moment - t) > 1e-5)
    .sort((a, b) => direction * (a - b));
  return worst[0];
}
