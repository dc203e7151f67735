// The replay: the footprint and what is around it from above, in the footprint's frame with its x
// axis to the right, as RViz shows it.

const NEAREST_VIEW = 0.25;
const FARTHEST_VIEW = 16;

/** Largest of the smaller three quarters. */
function mostlyWithin(values) {
  const sorted = [...values].sort((a, b) => a - b);
  return sorted[Math.floor(0.75 * (sorted.length - 1))];
}

/** How far [m] from the footprint's frame things happen that matter: what is near, and its ghosts. */
function viewRadius(report) {
  const body = reach(report.footprint) || 0.5;
  const scenes = report.frames.filter((frame) => frame.scene);
  const near = scenes.filter((frame) => frame.ttc <= report.parameters.warn_time);
  const distances = near.map((frame) => {
    const touched = firstTouched(frame);
    const pose = poseAfter(frame.scene.twist, frame.ttc);
    const ghost = Math.hypot(...pose.position) + body;
    return touched ? Math.max(ghost, Math.hypot(...touched.position) + touched.radius) : ghost;
  });
  const others = scenes.map((frame) => Math.min(6 * body, ...frame.scene.obstacles.map(
    (o) => Math.hypot(...o.position) + o.radius)));
  const wanted = distances.length ? mostlyWithin(distances) : mostlyWithin([4 * body, ...others]);
  return 1.1 * Math.min(40 * body, Math.max(2.5 * body, wanted));
}

class SceneView extends Brush {
  constructor(canvas, report) {
    super();
    this.canvas = canvas;
    this.report = report;
    this.radius = viewRadius(report);  // [m] from the middle to the nearer edge
    this.magnification = 1;
    this.unit = reach(report.footprint) || 0.5;  // [m] that widths and dashes are multiples of
  }

  /** By a factor; above 1 is nearer. */
  zoom(factor) {
    this.magnification = Math.min(FARTHEST_VIEW,
                                  Math.max(NEAREST_VIEW, this.magnification * factor));
    this.draw(this.frame);
  }

  draw(frame) {
    this.frame = frame;
    const {context, width, height} = sharpContext(this.canvas);
    this.pen = context;
    this.size = [width, height];
    this.scale = this.magnification * Math.min(width, height) / 2 / this.radius;
    context.clearRect(0, 0, width, height);
    context.lineJoin = 'round';
    this.drawGrid();
    if (!frame) return;
    this.unknown = isUnknown(this.report, frame) || !frame.scene;
    if (frame.scene) this.drawScene(frame);
    else this.drawBlind();
  }

  /** Lines a round number of metres apart, and how long one is. */
  drawGrid() {
    const step = roundUp(70 / this.scale);
    const pen = this.pen;
    pen.strokeStyle = themeColour('line');
    pen.lineWidth = 0.5;
    pen.beginPath();
    for (const [axis, extent] of this.size.entries()) {
      const reachable = Math.ceil(extent / 2 / this.scale / step);
      for (let i = -reachable; i <= reachable; ++i) {
        const at = extent / 2 + i * step * this.scale;
        pen.moveTo(axis ? 0 : at, axis ? at : 0);
        pen.lineTo(axis ? this.size[0] : at, axis ? at : this.size[1]);
      }
    }
    pen.stroke();
    this.drawScaleBar(step);
  }

  drawScaleBar(step) {
    const pen = this.pen;
    const [left, bottom] = [12, this.size[1] - 12];
    pen.strokeStyle = themeColour('muted');
    pen.lineWidth = 2;
    pen.setLineDash([]);
    pen.beginPath();
    pen.moveTo(left, bottom);
    pen.lineTo(left + step * this.scale, bottom);
    pen.stroke();
    this.write(`${Number(step.toPrecision(2))} m`, left, bottom - 7, 'left', themeColour('muted'));
  }

  drawScene(frame) {
    const {scene} = frame;
    for (const obstacle of [...scene.obstacles].reverse()) this.drawObstacle(obstacle);
    this.drawFootprint(scene);
    this.drawArrow([0, 0], scene.twist.linear, themeColour('text'), 2);
    this.drawGhosts(frame);
    this.labelObstacles(scene);
    if (scene.undrawn)
      this.write(`${scene.undrawn} farther obstacles are not drawn`, this.size[0] - 12,
                 this.size[1] - 12, 'right', themeColour('muted'));
  }

  /** Nothing is known but the footprint. */
  drawBlind() {
    const pen = this.pen;
    pen.fillStyle = hatching(pen, colourOf('unknown', 0.3));
    pen.fillRect(0, 0, ...this.size);
    this.path(this.report.footprint);
    this.stroke('unknown');
    const words = reasonNames(this.report, this.frame.reason).join(', ') || 'UNKNOWN';
    this.write(`UNKNOWN: ${words}`, this.size[0] / 2, 30, 'center', themeColour('text'), 15);
  }

  drawFootprint(scene) {
    this.path(scene.footprint);
    this.pen.fillStyle = colourOf('irrelevant', 0.25);
    this.pen.fill();
    const many = scene.footprint.length > 16;
    scene.footprint.forEach((start, i) => {
      const end = scene.footprint[(i + 1) % scene.footprint.length];
      const look = lookOf(scene.segments[i], this.report.parameters,
                          this.unknown ? 'unknown' : 'free');
      this.path([start, end], false);
      this.stroke(look);
      if (!many || look !== 'free') this.numberSegment(start, end, i);
    });
  }

  /** Inside, beside the middle of the segment; where there is room. */
  numberSegment(start, end, i) {
    const length = Math.hypot(end[0] - start[0], end[1] - start[1]) * this.scale;
    if (length < 18 || this.unit * this.scale < 38) return;
    const middle = this.toScreen([(start[0] + end[0]) / 2, (start[1] + end[1]) / 2]);
    const centre = this.toScreen([0, 0]);
    const away = Math.hypot(centre[0] - middle[0], centre[1] - middle[1]) || 1;
    const at = middle.map((m, axis) => m + 11 * (centre[axis] - m) / away);
    this.write(String(i), at[0], at[1] + 4, 'center', themeColour('muted'), 11);
  }

  drawObstacle(obstacle) {
    const look = lookOf(obstacle.ttc, this.report.parameters,
                        this.unknown ? 'unknown' : 'irrelevant');
    this.outline(obstacle);
    this.pen.fillStyle = colourOf(look, 0.25);
    this.pen.fill();
    this.stroke(look);
    this.drawArrow(obstacle.position, obstacle.velocity, themeColour('text'), 1.3);
  }

  /** Ids of those that matter, and of all when there are few. */
  labelObstacles(scene) {
    const few = scene.obstacles.length <= 8;
    for (const obstacle of scene.obstacles) {
      if (!few && !Number.isFinite(obstacle.ttc)) continue;
      const [x, y] = this.toScreen(obstacle.position);
      const above = Math.max(obstacle.radius * this.scale,
                             ...verticesOf(obstacle).map((v) => y - this.toScreen(v)[1])) + 6;
      this.write(obstacleText(obstacle.id, obstacle.index), x, y - above, 'center',
                 themeColour('text'), 12);
    }
  }

  /** Footprint and obstacle at the moment of contact, and the point where they touch: on the body
      now, and then. */
  drawGhosts(frame) {
    if (!Number.isFinite(frame.ttc)) return;
    const {scene} = frame;
    const look = lookOf(frame.ttc, this.report.parameters, 'later');
    const pose = poseAfter(scene.twist, frame.ttc);
    const touched = firstTouched(frame);
    if (frame.ttc > 0) {
      if (Math.hypot(...pose.position) + Math.abs(pose.sin) > 0.02 * this.unit) {
        this.path(scene.footprint.map((v) => posed(pose, v)));
        this.strokeGhost(look);
      }
      if (touched) {
        this.outline(obstacleAfter(touched, frame.ttc));
        this.strokeGhost(look);
      }
      this.dot(posed(pose, scene.contact), look);
    }
    this.dot(scene.contact, look);
  }
}
