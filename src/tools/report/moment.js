// What the predictor said at the moment that is shown.

function clearanceText(frame) {
  return Number.isNaN(frame.clearance) ? 'unknown' : metresText(frame.clearance);
}

function speedText(frame) {
  if (!frame.scene) return 'unknown';
  const {linear, angular} = frame.scene.twist;
  const turning = Math.abs(angular) >= 0.005 ? `, ${angular.toFixed(2)} rad/s` : '';
  return `${Math.hypot(...linear).toFixed(2)} m/s${turning}`;
}

function momentEntries(frame) {
  const hit = Number.isFinite(frame.ttc);
  const touched = firstTouched(frame);
  const entries = [['time to collision', ttcText(frame.ttc)]];
  if (hit)
    entries.push(['segment', frame.segment],
                 ['obstacle', obstacleText(frame.id, touched && touched.index)],
                 ['closing speed', Number.isFinite(frame.closing) ? `${frame.closing.toFixed(2)} m/s` : 'unknown']);
  entries.push(['clearance', clearanceText(frame)], ['robot', speedText(frame)]);
  return entries;
}

/** Words for what is wrong; the first of each reason, as the recording has it. */
function whyItems(report, frame) {
  const words = Object.fromEntries((report.bag.reasons || []).map((r) => [r.reason, r.first_message]));
  return reasonNames(report, frame.reason).map(
    (name) => element('li', {title: words[name] || ''}, name));
}

function fillMoment(report, frame) {
  const why = whyItems(report, frame);
  byId('moment').replaceChildren(
    element('div', {class: 'clock', id: 'clock'}, secondsText(frame.t, 3)),
    element('div', {class: 'stamp'}, new Date(1000 * (report.bag.start + frame.t)).toISOString().replace('T', ' ')),
    chip(frame.level),
    element('dl', {}, ...momentEntries(frame).flatMap(([name, value]) => [
      element('dt', {}, name), element('dd', {'data-moment': name}, value)])),
    ...(why.length ? [element('ul', {class: 'why'}, ...why)] : []));
}
