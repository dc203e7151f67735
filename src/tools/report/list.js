// The list of several recordings, the nearest to a contact first.

const report = JSON.parse(byId('data').textContent);
styles = report.styles;

const ORDER = ['contact', 'predicted', 'unknown', 'none'];

/** Contacts first, then by time to collision, then those that cannot be told from those without. */
function compare(a, b) {
  const rank = ORDER.indexOf(a.state) - ORDER.indexOf(b.state);
  const ttc = (bag) => bag.smallest_time_to_collision?.time_to_collision ?? Infinity;
  return rank || (ttc(a) === ttc(b) ? 0 : ttc(a) - ttc(b));
}

function bagRow(bag) {
  const worst = bag.smallest_time_to_collision;
  const cells = [
    [element('a', {href: bag.page}, nameOf(bag)), 'words'],
    [chip(LEVEL_OF_STATE[bag.state], bag.state), ''],
    [worst ? ttcText(worst.time_to_collision) : bag.state === 'unknown' ? 'unknown' : 'none', 'number'],
    [metresText(bag.smallest_clearance ?? NaN), 'number optional'],
    [bag.events ?? '-', 'number'],
    [bag.seconds === undefined ? '-' : secondsText(bag.seconds, 1), 'number optional'],
    [bag.unknown_percent === undefined ? '-' : percentText(bag.unknown_percent), 'number'],
    [[bag.partial ? 'partial' : '', bag.problem || ''].filter(Boolean).join(': '), 'words optional'],
  ];
  return element('tr', {}, ...cells.map(([cell, look]) => element('td', {class: look}, cell)));
}

function fillList() {
  const titles = [['Recording', ''], ['Found', ''], ['Smallest TTC', 'number'],
                  ['Clearance', 'number optional'], ['Approaches', 'number'],
                  ['Length', 'number optional'], ['Unknown', 'number'], ['', 'optional']];
  const head = element('tr', {}, ...titles.map(([title, look]) => element('th', {class: look}, title)));
  const rows = [...report.bags].sort(compare).map(bagRow);
  byId('bags').replaceChildren(element('thead', {}, head), element('tbody', {}, ...rows));
}

/** "2 of 5 with contact, 1 that cannot be told" */
function fillVerdict() {
  const count = (state) => report.bags.filter((bag) => bag.state === state).length;
  const parts = [[count('contact'), 'with contact'], [count('predicted'), 'with a contact predicted'],
                 [count('none'), 'without'], [count('unknown'), 'that cannot be told']];
  const what = report.bags.some((bag) => bag.footprint) ? 'footprints in recordings' : 'recordings';
  byId('verdict').textContent = `${report.bags.length} ${what}: ` +
    parts.filter(([number]) => number > 0).map(([number, words]) => `${number} ${words}`).join(', ');
  const partial = report.bags.filter((bag) => bag.partial).length;
  showText('partial', partial > 0 && `Partial: ${partial} of them were not analysed to their end.`);
}

fillVerdict();
fillList();
byId('program').textContent = report.program;
document.documentElement.dataset.ready = 'yes';
