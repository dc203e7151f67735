// Which moment is shown, and time going on.

class Player {
  /** \param show is called with a frame whenever another one is to be shown */
  constructor(frames, end, show) {
    this.frames = frames;
    this.end = end;  // [s]
    this.show = show;
    this.speed = 1;
    this.t = 0;
    this.playing = false;
  }

  frame() {
    return this.frames[frameAt(this.frames, this.t)];
  }

  seek(t) {
    this.t = Math.min(this.end, Math.max(0, t));
    this.show(this.frame(), this.t);
  }

  /** So many frames on. */
  step(count) {
    this.pause();
    const place = frameAt(this.frames, this.t) + count;
    this.seek(this.frames[Math.min(this.frames.length - 1, Math.max(0, place))].t);
  }

  /** To a moment, and stay there. */
  jump(t) {
    this.pause();
    this.seek(t);
  }

  toggle() {
    if (this.playing) return this.pause();
    this.playing = true;
    if (this.t >= this.end - 1e-6) this.t = 0;
    this.last = performance.now();
    requestAnimationFrame((now) => this.tick(now));
    this.seek(this.t);
  }

  pause() {
    if (!this.playing) return;
    this.playing = false;
    this.seek(this.t);
  }

  tick(now) {
    if (!this.playing) return;
    const t = this.t + this.speed * Math.max(0, now - this.last) / 1000;
    this.last = now;
    if (t >= this.end) this.playing = false;
    else requestAnimationFrame((next) => this.tick(next));
    this.seek(t);
  }
}
