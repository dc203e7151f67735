// Puts the page together. The files of this folder are joined into one script; each declares
// functions that the others use.

/** The moment that an address asks for; undefined without one. */
function momentOfAddress(address) {
  const match = /^#t=(-?[0-9.]+(?:e-?[0-9]+)?)$/.exec(new URL(address).hash);
  return match && Number.isFinite(Number(match[1])) ? Number(match[1]) : undefined;
}

class Page {
  constructor(report) {
    this.report = report;
    this.scene = new SceneView(byId('scene'), report);
    this.player = new Player(report.frames, timeRange(report)[1],
                             (frame, t) => this.show(frame, t));
    const jump = (t) => this.player.jump(t);
    this.charts = new Charts(report, jump);
    fillEvents(report, jump);
    fillLegend(byId('legend'));
    fillStripKey(byId('strip-key'));
    byId('truth-hint').hidden = !report.events.some((event) => event.contact);
    byId('scrub').max = this.player.end;
    this.listen();
    this.open();
  }

  /** At the address's moment, else the worst. */
  open() {
    this.player.seek(momentOfAddress(location.href) ?? worstMoment(this.report));
  }

  show(frame, t) {
    if (frame !== this.frame) {
      this.frame = frame;
      this.scene.draw(frame);
      fillMoment(this.report, frame);
      markEvent(this.report, frame.t);
    }
    this.charts.show(t);
    byId('scrub').value = t;
    byId('play').textContent = this.player.playing ? 'Pause' : 'Play';
    byId('previous-event').disabled = nextEvent(this.report.events, t, -1) === undefined;
    byId('next-event').disabled = nextEvent(this.report.events, t, 1) === undefined;
    this.noteAddress(t);
  }

  /** Little by little: browsers limit how often an address may change. */
  noteAddress(t) {
    if (this.noting) clearTimeout(this.noting);
    if (this.player.playing) return;
    this.noting = setTimeout(() => history.replaceState(null, '', `#t=${Number(t.toFixed(6))}`), 200);
  }

  /** Also to where the address is already: what is shown may have moved on since. */
  follow(address) {
    const asked = momentOfAddress(address);
    if (asked !== undefined) this.player.jump(asked);
  }

  goToEvent(direction) {
    const moment = nextEvent(this.report.events, this.player.t, direction);
    if (moment !== undefined) this.player.jump(moment);
  }

  redraw() {
    this.scene.draw(this.frame);
    this.charts.redraw();
    fillLegend(byId('legend'));
    fillStripKey(byId('strip-key'));
  }

  listen() {
    const {player} = this;
    const clicks = {
      'play': () => player.toggle(), 'back': () => player.step(-1), 'forward': () => player.step(1),
      'previous-event': () => this.goToEvent(-1), 'next-event': () => this.goToEvent(1),
      'worst': () => player.jump(worstMoment(this.report)),
      'zoom': () => this.charts.toggleZoom(),
      'nearer': () => this.scene.zoom(1.25), 'farther': () => this.scene.zoom(0.8),
    };
    for (const [id, action] of Object.entries(clicks)) byId(id).addEventListener('click', action);
    byId('scrub').addEventListener('input', () => player.jump(Number(byId('scrub').value)));
    byId('speed').addEventListener('change', () => { player.speed = Number(byId('speed').value); });
    document.addEventListener('keydown', (event) => this.key(event));
    document.querySelector('.legend').addEventListener('toggle', () => fillLegend(byId('legend')));
    window.addEventListener('hashchange', (event) => this.follow(event.newURL));
    document.addEventListener('click', (event) => {
      const link = event.target.closest('a[href^="#t="]');
      if (link) event.preventDefault();
      if (link) this.follow(link.href);
    });
    new ResizeObserver(() => this.scene.draw(this.frame)).observe(byId('scene'));
    matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => this.redraw());
    window.addEventListener('beforeprint', () => this.print(true));
    window.addEventListener('afterprint', () => this.print(false));
  }

  /** In light colours, as wide as paper. */
  print(begins) {
    document.documentElement.classList.toggle('printing', begins);
    this.player.pause();
    this.charts.fit(begins ? 700 : undefined);
    this.redraw();
  }

  key(event) {
    if (event.ctrlKey || event.altKey || event.metaKey || event.target.tagName === 'SELECT') return;
    const {player} = this;
    const second = event.shiftKey;
    const keys = {
      ' ': () => player.toggle(),
      'ArrowLeft': () => (second ? player.jump(player.t - 1) : player.step(-1)),
      'ArrowRight': () => (second ? player.jump(player.t + 1) : player.step(1)),
      'Home': () => player.jump(0), 'End': () => player.jump(player.end),
      'p': () => this.goToEvent(-1), 'n': () => this.goToEvent(1), 'w': () => player.jump(worstMoment(this.report)),
      'z': () => this.charts.toggleZoom(),
      '+': () => this.scene.zoom(1.25), '-': () => this.scene.zoom(0.8),
    };
    const button = event.target.closest('button, summary, a');
    if (!keys[event.key] || (event.key === ' ' && button)) return;
    event.preventDefault();
    keys[event.key]();
  }
}

const report = readReport();
fillHeader(report);
fillFigures(report);
fillQuality(report);
fillInputs(report);
byId('drive').hidden = report.frames.length === 0;
if (report.frames.length > 0) new Page(report);
document.documentElement.dataset.ready = 'yes';
